// Every shader as a driver gets it, with its includes and defines, is GLSL for the reference compiler too
// (glslangValidator, where TALUS_GLSLANG names it: ./dev check).
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "app/claims/arithmetic.h"
#include "render/ground_depth.h"
#include "render/outline.h"
#include "render/overview.h"
#include "render/renderer.h"
#include "render/tiled/tiled_renderer.h"
#include "render/view_range.h"
#include "sim/gpu/context.h"
#include "sim/gpu/embedded_text.h"
#include "sim/gpu/shader_text.h"
#include "sim/passes/stamp_image.h"
#include "sim/passes/thermal.h"
#include "sim/simulation.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"

namespace talus::shaders_test {
namespace {

namespace fs = std::filesystem;

const Grid grid{70, 66, 10, 10};

// Water and sediment over roughness and infiltration that differ from place to place.
void cover_land(Simulation& simulation) {
    Dab dab;
    dab.x_m = dab.y_m = 300;
    dab.radius_m = 150;
    dab.blend = 0.5;
    dab.target_m = 0.5;
    for (const Material material : {Material::manning, Material::infiltration}) {
        dab.material = material;
        simulation.apply(dab);
        for (const bool erodes : {false, true})
            for (const double order : {1, 2}) {
                simulation.apply(SetParameter{"erosion.on", erodes});
                simulation.apply(SetParameter{"water.order", order});
                simulation.apply(Ticks{1});
            }
    }
}

// A little of everything that the simulation does.
void simulate_everything(Simulation& simulation) {
    Dab dab;
    dab.x_m = dab.y_m = 300;
    dab.radius_m = 150;
    dab.amount_m = 2;
    dab.blend = 0.5;
    dab.target_m = 0.5;
    simulation.apply(ChooseStamp{{}, {100, 100, 300, 300}, nullptr});
    for (const Material material :
         {Material::bedrock, Material::water, Material::hardness, Material::mask, Material::rain}) {
        dab.material = material;
        simulation.apply(dab);
    }
    dab.material = Material::bedrock;
    for (int mode = 0; mode < 10; ++mode) {
        dab.effect = effect_of(static_cast<BrushMode>(mode));
        simulation.apply(dab);
    }
    for (std::size_t source = 0; source < mask_source_names().size(); ++source)
        simulation.apply(
            MakeMask{static_cast<MaskSource>(source), 0, 40, 5, MaskJoin::replace, false, {0, 0, 300, 200}});
    simulation.follow_sections({{{0, 100}, {300, 300}}});
    for (const char* assignment :
         {"water.rain=100", "water.rain_over=mask", "water.order=1", "erosion.on=true", "erosion.over=mask",
          "thermal.wet_deg=20", "water.manning=0", "water.order=2", "erosion.on=false", "water.manning=0.03",
          "water.infiltration=5", "water.boundary.west=wave", "water.boundary.east=inflow", "water.inflow=5",
          "water.inflow_over=conveyance", "erosion.over=everywhere"}) {
        Parameters changed = simulation.parameters();
        changed.set_assignment(assignment);
        const std::string name = std::string(assignment).substr(0, std::string(assignment).find('='));
        simulation.apply(SetParameter{name, changed.value(name)});
        simulation.apply(Ticks{1});
    }
    simulation.apply(PlaceSpring{400, 400, 3});
    simulation.apply(Ticks{1});
    cover_land(simulation);
    simulation.ledger();
}

// A grey photo over a ground, as a picture from this eye needs it.
class GreyPhoto {
  public:
    GreyPhoto(const Grid& ground, const render::Camera& camera, bool covers_all = false)
        : surface_(photo_tree({40, 40}, ground, place_), std::vector<TileBounds>(1), 2),
          laid_{&surface_, place_, 1, covers_all} {
        const TileId all = {surface_.tree().top_level(), 0, 0};
        std::vector<PhotoTexel> texels;
        with_smaller_pictures(
            [](int, const TileSamples& samples, std::vector<PhotoTexel>& read) {
                read.assign(static_cast<std::size_t>(samples.count.x) * samples.count.y,
                            {128, 128, 128, 255});
            },
            render::PhotoSurface::halvings)(all.level, render::PhotoSurface::samples_of(surface_.tree(), all),
                                            texels);
        surface_.put(all, texels);
        surface_.look(laid_.camera_over(ground, camera), {64, 48}, 1);
    }
    const render::LaidPhoto& laid() const { return laid_; }

  private:
    PhotoPlace place_{glm::dvec2(-0.5), glm::dvec2(0.5)};
    render::PhotoSurface surface_;
    render::LaidPhoto laid_;
};

// Every view by every method, with every choice of shading, of ground without and with layers.
void draw_everything(Terrain& terrain) {
    render::Renderer renderer(terrain, 8);
    const render::Camera camera = render::overview(grid, 0, 300);
    const std::vector<std::uint8_t> picture(4 * 4 * 4, 200);
    const GreyPhoto photo(grid, camera);
    for (const render::MethodEntry& method : render::methods())
        for (const char* view : {"shaded", "steps", "cells"}) {
            render::ViewSettings settings;
            settings.method = method.name;
            settings.view = view;
            renderer.draw(terrain, camera, settings, 64, 48);
            renderer.refine(terrain, 2);
        }
    for (const render::View& view : render::views())
        for (int choice = 0; choice < (view.natural ? 24 : 1); ++choice) {
            render::ViewSettings settings;
            settings.view = view.name;
            settings.shadows = (choice & 1) == 0;
            settings.occlusion = (choice & 2) == 0;
            settings.quick = (choice & 4) != 0;
            settings.numbers["material.masked"] = choice % 3;
            if ((choice & 8) != 0) renderer.drape(4, 4, std::as_bytes(std::span(picture)));
            renderer.lay((choice & 16) != 0 ? photo.laid() : render::LaidPhoto());
            renderer.draw(terrain, camera, settings, 64, 48, {glm::dvec2(300), 50});
        }
    const render::Camera map = render::top_view(grid, 300);
    for (const char* view : {"shaded", "steps", "cells"}) {
        render::ViewSettings settings;
        settings.view = view;
        renderer.draw(terrain, map, settings, 64, 48);
        terrain.tiles.mark_all();
        renderer.draw(terrain, map, settings, 64, 48);
    }
    for (const render::View& view : render::views()) {
        if (!render::scale_end_of(view)) continue;
        render::ViewSettings settings;
        settings.view = view.name;
        render::ViewRange().start(terrain, settings);
    }
}

// What terrain in tiles is drawn with.
void draw_tiles() {
    const TileTree tree(grid, 16, halved_levels({grid.nx, grid.ny}));
    render::TiledSurface surface(tree, std::vector<TileBounds>(tree.count()), 4);
    const TileId coarsest = {tree.top_level(), 0, 0};
    const glm::ivec2 count = tree.samples_of(coarsest).count;
    surface.put(coarsest, std::vector<float>(static_cast<std::size_t>(count.x) * count.y));
    const std::vector<std::uint32_t> picture(4, 0xff808080U);
    const render::Camera camera = render::overview(grid, 0, 300);
    surface.look(camera, {64, 48}, 1);
    const GreyPhoto photo(grid, camera);
    for (const render::View& view : render::views())
        for (int choice = 0; choice < (view.natural ? 6 : 1); ++choice) {
            if (!render::is_of_tiles(view)) continue;
            render::TiledRenderer renderer;
            render::ViewSettings settings;
            settings.view = view.name;
            settings.shadows = (choice & 1) == 0;
            if ((choice & 2) != 0) renderer.drape(2, 2, std::as_bytes(std::span(picture)));
            if ((choice & 4) != 0) renderer.lay(photo.laid());
            renderer.draw(surface, camera, settings, 64, 48);
            render::Outline().draw(renderer.colours(), renderer.hits(), grid, camera, {64, 48},
                                   {100, 100, 300, 300}, {0, 0, 690, 650});
        }
    const render::Camera map = render::top_view(grid, 300);
    surface.look(map, {64, 48}, 1);
    render::TiledRenderer renderer;
    for (const char* view : {"shaded", "steps"}) {
        render::ViewSettings settings;
        settings.view = view;
        renderer.draw(surface, map, settings, 64, 48);
    }
}

// What stands around a terrain that was cut out of one in tiles.
void draw_backdrop() {
    const TileTree tree(grid, 16, halved_levels({grid.nx, grid.ny}));
    render::TiledSurface surface(tree, std::vector<TileBounds>(tree.count()), 4);
    const TileId coarsest = {tree.top_level(), 0, 0};
    const glm::ivec2 count = tree.samples_of(coarsest).count;
    surface.put(coarsest, std::vector<float>(static_cast<std::size_t>(count.x) * count.y));
    const Grid inner{20, 20, grid.dx, grid.dy};
    TerrainState state = bedrock_terrain(inner, std::vector<float>(inner.count(), 3));
    state.water.assign(inner.count(), glm::vec4(1, 0, 0, 0));
    Terrain terrain(state);
    render::Backdrop backdrop(surface, inner, {10, 12});
    render::Renderer renderer(terrain, 8);
    renderer.stand_before(&backdrop);
    const render::Camera map = render::top_view(inner, 300);
    surface.look(backdrop.camera_over_tiles(map), {64, 48}, 1);
    renderer.draw(terrain, map, {}, 64, 48);
    const render::Camera camera = render::overview(inner, 0, 30);
    surface.look(backdrop.camera_over_tiles(camera), {64, 48}, 1);
    const GreyPhoto photo(inner, camera, true);
    const std::vector<std::uint8_t> picture(4 * 4 * 4, 200);
    for (const render::View& view : render::views())
        for (int choice = 0; choice < (view.natural ? 12 : 1); ++choice) {
            render::ViewSettings settings;
            settings.view = view.name;
            settings.shadows = (choice & 1) == 0;
            settings.occlusion = (choice & 2) == 0;
            if ((choice & 4) != 0) renderer.drape(4, 4, std::as_bytes(std::span(picture)));
            const render::LaidPhoto laid = (choice & 8) != 0 ? photo.laid() : render::LaidPhoto();
            renderer.lay(laid);
            backdrop.lay(laid);
            renderer.draw(terrain, camera, settings, 64, 48);
        }
}

TEST(Shaders, AreGlslForTheReferenceCompiler) {
    const fs::path folder = fs::temp_directory_path() / ("talus_shaders_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    {
        const gpu::Context context;
        gpu::keep_assembled_shaders(folder);
        const TerrainState dry = bedrock_terrain(grid, generate_heights(grid, {"mountains", 3, 300}));
        {
            Terrain terrain(dry);
            draw_everything(terrain);
        }
        Simulation simulation(dry, Parameters(simulation_parameters()));
        simulate_everything(simulation);
        render::Renderer renderer(simulation.terrain(), 8);
        render::Ring stamped;
        StampImage image;
        const gpu::Texture& stamp = image.of(simulation.stamp());
        stamped.radius_m = 80;
        stamped.stamp = &stamp;
        renderer.draw(simulation.terrain(), render::overview(grid, 0, 300), {}, 64, 48, stamped);
        draw_everything(simulation.terrain());
        static_cast<void>(claims::arithmetic_of_device());
        const render::GroundDepth depth;
        draw_tiles();
        draw_backdrop();
        for (const ThermalScheme scheme : {ThermalScheme::olsen, ThermalScheme::olsen_fast}) {
            ThermalSettings settings;
            settings.scheme = scheme;
            Thermal(simulation.terrain()).substep(simulation.terrain(), thermal_step(grid, settings, 1, 1));
        }
        gpu::keep_assembled_shaders({});
    }
    std::set<std::string> seen;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        seen.insert(name.substr(0, name.find('.')) + entry.path().extension().string());
    }
    if (const char* compiler = std::getenv("TALUS_GLSLANG")) {
        // Many at a time, because its start takes longer than a shader. One that keeps it busy for ever fails
        // like one that is wrong.
        const std::string said = folder.string() + "_said";
        const std::string command = "cd '" + folder.string() + "' && ls | xargs -P 2 -n 40 timeout 300 " +
                                    compiler + " >" + said + " 2>&1";
        if (std::system(command.c_str()) != 0) {
            std::system(("grep -m 20 -v '^[a-z_0-9.]*$' " + said).c_str());
            ADD_FAILURE() << "the reference compiler refuses what is said above";
        }
        fs::remove(said);
    }
    // None was forgotten.
    for (const auto& [path, text] : embedded_shaders()) {
        if (path.ends_with(".glsl") || path.ends_with(".h")) continue;
        std::string name = path;
        std::replace(name.begin(), name.end(), '/', '_');
        EXPECT_TRUE(seen.contains(name)) << path << " was never assembled";
    }
    fs::remove_all(folder);
}

}  // namespace
}  // namespace talus::shaders_test
