#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/film.h"
#include "app/core/run_pictures.h"

namespace talus::app {

/// What a run writes on its way, at its start and every so many seconds of simulated time.
struct RecordingOptions {
    std::optional<double> every_s;   ///< unless given, a film has a picture a tick
    std::vector<std::string> files;  ///< terrain files whose names number them ("depth_%05d.tif")
    std::string layer;               ///< of single-layer files, as in Outputs
    std::string image;               ///< numbered pictures; empty: none
    std::string film;                ///< empty: none
    std::string keys;                ///< file of key cameras for pictures and film; empty: they stand still
    glm::ivec2 size{1280, 720};      ///< of pictures and film
};

/// Whether a file's name (not its folder's) numbers a series: it has one %d, or one like %05d. Throws
/// talus::Error where it has another number, or several.
bool is_series(const std::string& path);
/// The path of one of the series.
std::string one_of_series(const std::string& path, std::int64_t number);
/// Throws talus::Error, before any work is done, where such a recording cannot be made.
void check_recording(const RecordingOptions& options);

/// Writes files, pictures and a film of a run while it goes on.
class Recording {
  public:
    /// Of so many ticks from now on; writes the first of each. Options, scene and simulation must outlive it.
    /// Throws talus::Error where records are due more often than ticks end, or what is due cannot be written.
    Recording(const RecordingOptions& options, const Scene& scene, Simulation& simulation,
              const gpu::Device& device, std::int64_t ticks);
    /// After each tick: whether the next record is due.
    bool is_due() const;
    /// Writes it. Throws talus::Error where that cannot be.
    void write();
    /// After the last one. Completes the film. Throws talus::Error where that cannot be.
    void finish();
    /// How often it wrote.
    std::int64_t count() const { return count_; }
    double every_s() const { return every_s_; }

  private:
    const RecordingOptions& options_;
    Simulation& simulation_;
    io::Document document_;  // without its state
    std::int64_t start_ticks_;
    double tick_s_;
    double every_s_;
    std::int64_t count_ = 0;
    std::unique_ptr<RunPictures> pictures_;  // none: neither pictures nor a film
    std::vector<render::Camera> way_;
    std::optional<Film> film_;
};

}  // namespace talus::app
