#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "render/measure.h"
#include "render/renderer.h"
#include "sim/terrain/grid.h"

namespace talus::claims {

/// Pictures of a terrain by a method from all places of the survey, against the surface in double (law 1).
struct SurveyError {
    render::PictureError all;  ///< sums, and the largest error
    std::array<int, 4>
        kinds{};  ///< pixels by how they were found: nothing, mesh, rays, rays that ended early
    std::vector<std::string> beyond;  ///< views with pixels that no ray within the limit agrees with
};
/// `patch_pixels`: from which size of a patch on mesh is drawn, as the device's calibration finds it.
SurveyError survey_error(const Grid& grid, const std::vector<float>& heights, const std::string& method,
                         double tolerance_px, glm::ivec2 size, double patch_pixels);

/// Texels of both pyramids that differ between one that was refreshed after each of so many dabs and one made
/// anew at the end (law 2).
std::size_t pyramid_texels_differing(const Grid& grid, int dabs);

/// Frames of a session of dabs, ticks, cameras and settings that are not, bit for bit, those drawn anew (law
/// 2).
struct KeptFrames {
    int frames = 0;
    int differing = 0;
    std::array<int, 4> drawn{};  ///< frames by what was drawn for them, as Drawn counts
};
KeptFrames kept_frames(const Grid& grid, const std::string& method, int frames, glm::ivec2 size);

}  // namespace talus::claims
