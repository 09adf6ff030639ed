#include "render/shading.h"

#include <algorithm>
#include <array>

#include "render/blocks.h"
#include "render/grain.h"

namespace talus::render {
namespace {

// As the shaders of views call the layers that they show.
constexpr std::array<const char*, 3> layer_samplers = {"layer", "second_layer", "third_layer"};

// Whether the mask says what the ground is made of.
bool is_made_by_mask(const ViewSettings& settings) {
    const std::vector<ViewNumber>& numbers = view_named(settings.view).numbers;
    return std::any_of(numbers.begin(), numbers.end(), [&](const ViewNumber& one) {
        return one.uniform == "masked_kind" && one.in(settings) > 0;
    });
}

}  // namespace

Shading::Shading() : grain_(grain_texture()) {}

void Shading::drape(int width, int height, std::span<const std::byte> rgba) {
    drape_ = gpu::Texture();
    if (rgba.empty()) return;
    int levels = 1;
    while (std::max(width, height) >> levels > 0) ++levels;
    drape_ = gpu::Texture("drape", gpu::Format::srgb8, width, height, levels);
    drape_.write(drape_.whole(), rgba);
    drape_.filter(gpu::Wrap::edge);
}

double extent_m(const ShadedGround& ground) {
    return ground.beside ? ground.beside->extent_m : std::max(ground.grid.width_m(), ground.grid.height_m());
}

ShadedGround shaded_ground(const Terrain& terrain, const Pyramid& pyramid, const SkyView& sky,
                           const std::string& view) {
    const View& shown = view_named(view);
    ShadedGround ground{terrain.grid(), false, has_what_it_shows(shown, terrain), true,
                        [&terrain, &pyramid, &sky, &shown](gpu::Program& program) {
                            bind_layers(program, terrain, shown);
                            program.bind_sampled("sky_share", sky.share());
                            pyramid.bind(program, terrain);
                        }};
    ground.has_mask = terrain.painted.has_value();
    return ground;
}

void bind_layers(gpu::Program& program, const Terrain& terrain, const View& view) {
    program.bind_sampled("solid", terrain.solid.front);
    program.bind_sampled("start", terrain.difference_start());
    // What is absent is not read; another texture stands in for it.
    int layers_there = 0;
    for (std::size_t i = 0; i < layer_samplers.size(); ++i) {
        const bool has = i < view.layers.size() && terrain.*view.layers[i];
        program.bind_sampled(layer_samplers[i], has ? (terrain.*view.layers[i])->front : terrain.ground);
        layers_there |= has ? 1 << i : 0;
    }
    program.set("layers_there", layers_there);
    program.bind_sampled("painted", terrain.painted ? terrain.painted->front : terrain.ground);
    program.bind_sampled("water", terrain.water ? terrain.water->front : terrain.ground);
}

bool has_what_it_shows(const View& view, const Terrain& terrain) {
    return view.layers.empty() || std::any_of(view.layers.begin(), view.layers.end(),
                                              [&](auto layer) { return (terrain.*layer).has_value(); });
}

void set_numbers(gpu::Program& program, const ViewSettings& settings) {
    program.set("gravity", static_cast<float>(settings.gravity_m_per_s2));
    for (const ViewNumber& number : view_named(settings.view).numbers)
        program.set(number.uniform.c_str(), static_cast<float>(number.in(settings)));
}

gpu::Program& Shading::program_of(const View& view, const ViewSettings& settings, bool sky,
                                  const ShadedGround& ground) {
    std::vector<std::string> defines = {"VIEW_FILE render/views/" + view.name + ".glsl"};
    defines.emplace_back(ground.tiled ? "GROUND_FILE render/tile_ground.glsl"
                                      : "GROUND_FILE render/whole_ground.glsl");
    if (ground.tiled) defines.emplace_back("TILED");
    if (ground.has_hole) defines.emplace_back("HOLE");
    if (ground.beside) defines.emplace_back("BESIDE");
    if (view.natural) defines.emplace_back("NATURAL");
    if (view.sky_too) defines.emplace_back("SKY_TOO");
    if (sky) {
        defines.emplace_back("SKY");
    } else if (view.natural) {
        if (!gpu::filters_along()) defines.emplace_back("FILTERS_ROUND");
        if (settings.shadows && !settings.quick) defines.emplace_back("SHADOWS");
        if (ground.has_mask && is_made_by_mask(settings)) defines.emplace_back("MASKED");
        if (settings.occlusion && ground.has_sky_share && !ground.beside) defines.emplace_back("OCCLUSION");
        if (ground.photo.surface)
            defines.insert(defines.end(), ground.photo.covers_all
                                              ? std::initializer_list<std::string>{"PHOTO", "PHOTO_COVERS"}
                                              : std::initializer_list<std::string>{"PHOTO"});
        else if (drape_.width() > 0)
            defines.emplace_back("DRAPED");
    } else if (!ground.has_layer) {
        defines.emplace_back("ABSENT");
    }
    std::string key;
    for (const std::string& define : defines) key += define + " ";
    const auto found = programs_.find(key);
    if (found != programs_.end()) return found->second;
    return programs_
        .emplace(key,
                 gpu::Program(std::vector<std::string>{"render/block.vert", "render/shade.frag"}, defines))
        .first->second;
}

void Shading::draw(const ShadeFrame& frame, const ShadedGround& ground, const Redraw* redraw) {
    const Grid& grid = ground.grid;
    const View& view = view_named(frame.settings.view);
    const auto prepare = [&](gpu::Program& program) {
        program.bind_sampled("hits", frame.hits);
        program.bind_sampled("grain", grain_);
        program.bind_sampled("drape", drape_);
        set_camera(program, grid, frame.camera, frame.width, frame.height);
        ground.bind(program);
        if (ground.photo.surface) ground.photo.surface->bind(program, ground.photo.place.scale);
        program.set("sun", glm::vec3(frame.settings.sun));
        program.set("extent_m", static_cast<float>(extent_m(ground)));
        if (ground.beside) {
            program.set("beside_range_m", glm::vec2(ground.beside->range_m));
            program.set("beside_first", glm::vec2(ground.beside->first));
            program.bind_sampled("beside_shadow", *ground.beside->shadow);
        }
        set_numbers(program, frame.settings);
    };
    const bool skips_sky = !redraw && !view.sky_too;
    if (!redraw) list_.make(frame.hits, frame.width, frame.height, ground.has_hole);
    gpu::Program& coloured = program_of(view, frame.settings, false, ground);
    if (redraw) {
        prepare(coloured);
        redraw->draw(coloured, frame.target, gpu::Depth::none);
        return;
    }
    gpu::Program& nothing = skips_sky ? program_of(view, frame.settings, true, ground) : coloured;
    const glm::ivec2 size(frame.width, frame.height);
    prepare(nothing);
    draw_blocks(nothing, frame.target, size, list_.nothing(), gpu::Depth::none);
    prepare(coloured);
    draw_blocks(coloured, frame.target, size, list_.something(), gpu::Depth::none);
}

}  // namespace talus::render
