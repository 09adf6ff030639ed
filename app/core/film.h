#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace talus::app {

/// A film that the program ffmpeg writes, of 25 pictures a second. Until it is finished there is only a file
/// with
/// `.part` before the ending, which goes away with this.
class Film {
  public:
    /// Throws talus::Error where there is no ffmpeg, or no folder to write into, or the ending is not .mp4,
    /// .mkv or .webm.
    Film(std::filesystem::path path, glm::ivec2 size);
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    /// Rows of RGB from the top. Throws talus::Error where ffmpeg takes no more.
    void add(const std::vector<std::uint8_t>& rgb);
    /// Waits for ffmpeg. Throws talus::Error where it could not write the film.
    void finish();

  private:
    void end_process();

    std::filesystem::path path_;
    std::filesystem::path part_;
    int pipe_ = -1;
    int process_ = -1;
    int status_ = 0;
};

}  // namespace talus::app
