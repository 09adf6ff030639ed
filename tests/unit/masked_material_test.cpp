// Ground whose material the mask says: where it is painted, and nowhere else; and as a fresh picture has it
// after a stroke.
#include <gtest/gtest.h>

#include "render/overview.h"
#include "render/renderer.h"
#include "sim/gpu/context.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"

namespace talus::masked_material_test {
namespace {

constexpr glm::ivec2 size(160, 120);
constexpr double as_elsewhere = 0;
constexpr double snow = 6;

std::vector<std::uint8_t> picture(render::Renderer& renderer, const Terrain& terrain, double kind) {
    // From above, so that places are pixels.
    const glm::dvec3 middle(terrain.grid().width_m() / 2, terrain.grid().height_m() / 2, 0);
    const render::Camera camera{middle + glm::dvec3(0, 0, 900), middle, 50};
    render::ViewSettings settings;
    settings.numbers = {{"material.masked", kind}, {"material.snow_line_m", 1e5}};
    renderer.draw(terrain, camera, settings, size.x, size.y);
    return renderer.read_rgb(size.x, size.y);
}

std::vector<std::uint8_t> fresh_picture(const Terrain& terrain, double kind) {
    render::Renderer renderer(terrain, 8);
    return picture(renderer, terrain, kind);
}

int sum_at(const std::vector<std::uint8_t>& rgb, glm::ivec2 pixel) {
    const std::size_t at = 3 * (static_cast<std::size_t>(pixel.y) * size.x + pixel.x);
    return rgb[at] + rgb[at + 1] + rgb[at + 2];
}

Dab mask_around(glm::dvec2 place_m, double radius_m) {
    Dab dab;
    dab.material = Material::mask;
    dab.x_m = place_m.x;
    dab.y_m = place_m.y;
    dab.radius_m = radius_m;
    dab.falloff = 0.1;
    dab.blend = 1;
    dab.target_m = 1;
    return dab;
}

TEST(MaskedMaterial, IsThereWhereTheMaskIsAndNowhereElse) {
    const gpu::Context context;
    const Grid grid{129, 129, 8, 8};
    Simulation simulation(bedrock_terrain(grid, generate_heights(grid, {"hills", 3, 60})),
                          Parameters(simulation_parameters()), std::size_t{256} << 20U);
    const Terrain& terrain = simulation.terrain();
    const std::vector<std::uint8_t> bare = fresh_picture(terrain, as_elsewhere);
    EXPECT_EQ(fresh_picture(terrain, snow), bare) << "there is no mask";

    render::Renderer kept(terrain, 8);
    EXPECT_EQ(picture(kept, terrain, snow), bare);
    simulation.apply(mask_around({512, 512}, 150));
    const std::vector<std::uint8_t> covered = picture(kept, terrain, snow);
    EXPECT_EQ(covered, fresh_picture(terrain, snow)) << "what is drawn anew is what a stroke touched";
    EXPECT_EQ(fresh_picture(terrain, as_elsewhere), bare) << "nobody asked for another material";
    EXPECT_GT(sum_at(covered, size / 2), sum_at(bare, size / 2) + 150) << "snow is brighter";
    for (const glm::ivec2 corner :
         {glm::ivec2(25, 5), glm::ivec2(135, 5), glm::ivec2(25, 114), glm::ivec2(135, 114)})
        EXPECT_EQ(sum_at(covered, corner), sum_at(bare, corner));

    simulation.apply(mask_around({300, 700}, 80));
    EXPECT_EQ(picture(kept, terrain, snow), fresh_picture(terrain, snow));
    simulation.undo();
    simulation.undo();
    const std::vector<std::uint8_t> undone = picture(kept, terrain, snow);
    EXPECT_EQ(undone, fresh_picture(terrain, snow));
    EXPECT_EQ(undone, bare);
}

}  // namespace
}  // namespace talus::masked_material_test
