#pragma once
#include <string>
#include <vector>

#include "render/hits_target.h"
#include "render/methods/method.h"
#include "render/pyramid.h"
#include "tests/bench/papers/terrains.h"

namespace talus::bench {

/// A method with its parameters, and what tables call it.
struct Entry {
    std::string name;
    render::Method method;
    render::OwnNumbers numbers = {};
};
Entry entry(const std::string& method, const render::OwnNumbers& numbers = {}, const std::string& name = "");
/// A method that tells the steps of its rays.
Entry steps_of(const std::string& method);
/// Ammann et al. 2010, with their k and T.
Entry ammann(double k, double t);
/// choice: of render.clipmap_samples.
Entry clipmap(int choice, int levels, const std::string& name);

/// A terrain on the device, at a size of picture.
class PaperEasel {
  public:
    PaperEasel(const PaperTerrain& terrain, glm::ivec2 size, double patch_pixels);

    /// Waits for the device.
    void draw(const Entry& entry, const render::Camera& camera);
    std::vector<float> distances(const Entry& entry, const render::Camera& camera);
    std::vector<float> details(const Entry& entry, const render::Camera& camera);
    /// Median milliseconds of each, turn by turn. What threads make is made before.
    std::vector<double> time_ms(const std::vector<Entry>& entries, const render::Camera& camera, int rounds);

    Terrain& terrain() { return terrain_; }
    render::Pyramid& pyramid() { return pyramid_; }

  private:
    Terrain terrain_;
    render::Pyramid pyramid_;
    glm::ivec2 size_;
    double patch_pixels_;
    render::HitsTarget target_;
};

}  // namespace talus::bench
