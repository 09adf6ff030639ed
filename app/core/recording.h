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

/// Whether a file's name numbers a series: it has one %d, or %05d and the like.
bool is_series(const std::string& path);
/// The name of one of the series.
std::string one_of_series(const std::string& path, std::int64_t number);
/// Throws talus::Error, before any work is done, where such a recording cannot be made.
void check_recording(const RecordingOptions& options);

class Recording {
  public:
    /// Of ticks from now on, and writes the first of each. Simulation and scene must outlive it.
    Recording(const RecordingOptions& options, const Scene& scene, Simulation& simulation,
              const gpu::Device& device, std::int64_t ticks);
    /// After each tick.
    void record();
    /// After the last one. Completes the film.
    void finish();
    std::int64_t count() const { return count_; }
    double every_s() const { return every_s_; }

  private:
    void write();

    const RecordingOptions& options_;
    const Scene& scene_;
    Simulation& simulation_;
    double start_s_;
    double every_s_;
    std::int64_t count_ = 0;
    std::unique_ptr<RunPictures> pictures_;  // none: neither pictures nor a film
    std::vector<render::Camera> way_;
    std::optional<Film> film_;
};

}  // namespace talus::app
