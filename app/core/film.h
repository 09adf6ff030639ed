#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "sim/io/atomic_file.h"

namespace talus::app {

/// Throws talus::Error where no film can be written there: its ending must be .mp4, .mkv or .webm, its folder
/// must be there.
void check_film(const std::filesystem::path& path);

/// A film that the program ffmpeg writes, of 25 pictures a second. Until it is finished, the path holds what
/// was there before.
class Film {
  public:
    /// Throws talus::Error as check_film() does, and where ffmpeg cannot be started.
    Film(const std::filesystem::path& path, glm::ivec2 size);
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    /// The next picture: rows of RGB from the top, of the size. Throws talus::Error where ffmpeg takes no
    /// more.
    void add(const std::vector<std::uint8_t>& rgb);
    /// Waits for ffmpeg. Throws talus::Error where it could not write the film.
    void finish();

  private:
    // Waits for the process. True: it ended well.
    bool end_process();

    std::filesystem::path path_;
    io::AtomicFile file_;
    int pipe_ = -1;
    int process_ = -1;
};

}  // namespace talus::app
