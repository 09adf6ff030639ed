#include "render/tiled/backdrop.h"

#include <algorithm>

#include "render/view.h"

namespace talus::render {
namespace {

bool throws_shadows(const ViewSettings& settings) {
    return view_named(settings.view).natural && settings.shadows && !settings.quick;
}

// What a view shows of ground that has no layer but itself.
ViewSettings settings_around(const ViewSettings& settings) {
    ViewSettings around = settings;
    const View& view = view_named(settings.view);
    if (!view.layers.empty() || view.whole || view.detail != Detail::none) around.view = "hillshade";
    return around;
}

gpu::Program shade_program(const char* vertices, bool by_tiles) {
    return gpu::Program(
        std::vector<std::string>{vertices, "render/beside_shadow.frag"},
        by_tiles ? std::vector<std::string>{"GROUND_FILE render/tile_ground.glsl", "TILED", "HOLE"}
                 : std::vector<std::string>{"GROUND_FILE render/whole_ground.glsl", "SKIPS_WALLS"});
}

gpu::Program lay_over_program(std::vector<std::string> defines) {
    return gpu::Program(std::vector<std::string>{"render/fullscreen.vert", "render/backdrop.frag"},
                        std::move(defines));
}

}  // namespace

Backdrop::Backdrop(const TiledSurface& surface, const Grid& terrain, glm::ivec2 first)
    : surface_(surface),
      terrain_(terrain),
      first_(first),
      end_(first + glm::ivec2(terrain.nx, terrain.ny) - 1),
      rays_(first_, end_),
      shades_terrain_(shade_program("render/fullscreen.vert", true)),
      shades_blocks_(shade_program("render/block.vert", true)),
      shades_tiles_(shade_program("render/fullscreen.vert", false)),
      shadow_changes_("render/shadow_changes.comp"),
      lay_over_(lay_over_program({})),
      find_nearest_(lay_over_program({"NEAREST"})),
      no_shadow_("no shadow", gpu::Format::rgba8, 1, 1) {
    no_shadow_.fill(0);
}

// The terrain's south-west sample in the tiled one's metres.
glm::dvec3 Backdrop::corner_m() const {
    const Grid& tiles = surface_.tree().grid();
    return {first_.x * tiles.dx, (tiles.ny - first_.y - terrain_.ny) * tiles.dy, 0};
}

Camera Backdrop::camera_over_tiles(const Camera& camera) const {
    Camera over = camera;
    over.eye += corner_m();
    over.target += corner_m();
    return over;
}

Camera Backdrop::camera_from_tiles(const Camera& over_tiles) const {
    Camera camera = over_tiles;
    camera.eye -= corner_m();
    camera.target -= corner_m();
    return camera;
}

Beside Backdrop::beside_of(glm::ivec2 first, const gpu::Texture& shadow) const {
    const Grid& tiles = surface_.tree().grid();
    return {range_m(), std::max(tiles.width_m(), tiles.height_m()), first, &shadow};
}

void Backdrop::resize(glm::ivec2 size) {
    const gpu::Texture& held = kept_.colour;
    if (held.width() >= size.x && held.height() >= size.y) return;
    const int w = std::max(size.x, held.width());
    const int h = std::max(size.y, held.height());
    nearest_ = HitsTarget(w, h);
    kept_ = Rest(w, h);
    sample_ = Rest(w, h);
    on_terrain_ = Shadow(w, h);
    before_ = Shadow(w, h);
    drawn_.reset();
}

Backdrop::Shadow::Shadow(int w, int h) : mask("shadow of the other", gpu::Format::rgba8, w, h) {
    const std::array<const gpu::Texture*, 1> attached = {&mask};
    buffer = gpu::Framebuffer("shadow of the other", attached);
}

Backdrop::Rest::Rest(int w, int h)
    : target(w, h), colour("backdrop", gpu::Format::rgba8, w, h), shadow(w, h) {
    const std::array<const gpu::Texture*, 1> attached = {&colour};
    colour_buffer = gpu::Framebuffer("backdrop", attached);
}

Beside Backdrop::beside(const ShadeFrame& frame, const Redraw* redraw) {
    const glm::ivec2 size(frame.width, frame.height);
    resize(size);
    if (!throws_shadows(frame.settings)) return beside_of(first_, no_shadow_);
    gpu::Program& program = redraw ? shades_blocks_ : shades_terrain_;
    surface_.bind(program, camera_over_tiles(frame.camera), size);
    set_hole(program, first_, end_);
    program.bind_sampled("hits", frame.hits);
    program.set("sun", glm::vec3(frame.settings.sun));
    program.set("other_off_px", 0.0F);
    if (redraw) {
        redraw->draw(program, on_terrain_.buffer, gpu::Depth::none);
    } else {
        on_terrain_.buffer.bind({0, 0, size.x, size.y});
        program.draw_fullscreen();
    }
    return beside_of(first_, on_terrain_.mask);
}

void Backdrop::draw(const BackdropFrame& frame) {
    const glm::ivec2 size(frame.shade.width, frame.shade.height);
    resize(size);
    const Camera over = camera_over_tiles(frame.shade.camera);
    const ViewSettings settings = settings_around(frame.shade.settings);
    if (!frame.is_kept) {
        rays_.cast(surface_, over, size, sample_.target.framebuffer());
        if (throws_shadows(settings)) shade_tiles(frame, settings, sample_);
        colour(over, settings, size, sample_, nullptr);
        lay_over(frame, sample_);
        return;
    }
    const Picture picture{
        over, settings, size, changes_, throws_shadows(settings) ? frame.changes : 0, photo_.changes};
    if (drawn_ != picture) {
        const bool same_hits =
            drawn_ && drawn_->camera == over && drawn_->size == size && drawn_->tiles == changes_;
        const bool same_but_shadow =
            same_hits && drawn_->settings == settings && drawn_->photo == photo_.changes;
        drawn_.reset();
        if (!same_hits) rays_.cast(surface_, over, size, kept_.target.framebuffer());
        std::swap(kept_.shadow, before_);
        if (throws_shadows(settings)) shade_tiles(frame, settings, kept_);
        if (same_but_shadow) list_shadow_changes(size);
        colour(over, settings, size, kept_, same_but_shadow ? &redraw_ : nullptr);
        drawn_ = picture;
    }
    lay_over(frame, kept_);
}

// The terrain's shadow on the tiles' hits.
void Backdrop::shade_tiles(const BackdropFrame& frame, const ViewSettings& settings, const Rest& rest) {
    const glm::ivec2 size(frame.shade.width, frame.shade.height);
    set_camera(shades_tiles_, frame.ground.grid, frame.shade.camera, size.x, size.y);
    frame.ground.bind(shades_tiles_);
    shades_tiles_.bind_sampled("hits", rest.target.hits());
    shades_tiles_.set("sun", glm::vec3(settings.sun));
    shades_tiles_.set("other_off_px", static_cast<float>(surface_.off_px()));
    rest.shadow.buffer.bind({0, 0, size.x, size.y});
    shades_tiles_.draw_fullscreen();
}

// The blocks of the kept picture in which the terrain's shadow changed.
void Backdrop::list_shadow_changes(glm::ivec2 size) {
    redraw_.begin(size.x, size.y);
    redraw_.bind(shadow_changes_);
    shadow_changes_.bind_sampled("shadow_now", kept_.shadow.mask);
    shadow_changes_.bind_sampled("shadow_before", before_.mask);
    shadow_changes_.set("size", size);
    shadow_changes_.dispatch((size.x + 15) / 16, (size.y + 15) / 16);
    gpu::barrier({gpu::Use::storage});
    redraw_.list();
}

void Backdrop::colour(const Camera& over, const ViewSettings& settings, glm::ivec2 size, const Rest& rest,
                      const Redraw* redraw) {
    ShadedGround ground{surface_.tree().grid(),
                        true,
                        true,
                        false,
                        [&](gpu::Program& program) {
                            surface_.bind(program, over, size);
                            set_hole(program, first_, end_);
                        },
                        true,
                        beside_of({0, 0}, throws_shadows(settings) ? rest.shadow.mask : no_shadow_)};
    ground.photo = photo_;
    shading_.draw({over, settings, size.x, size.y, rest.target.hits(), rest.colour_buffer}, ground, redraw);
}

void Backdrop::lay_over(const BackdropFrame& frame, const Rest& rest) {
    const gpu::Region all{0, 0, frame.shade.width, frame.shade.height};
    const auto prepare = [&](gpu::Program& program) {
        program.bind_sampled("hits", frame.shade.hits);
        program.bind_sampled("water_hits", frame.water_hits ? *frame.water_hits : frame.shade.hits);
        program.bind_sampled("backdrop_hits", rest.target.hits());
        program.bind_sampled("backdrop_colours", rest.colour);
        program.set("watered", frame.water_hits ? 1 : 0);
    };
    prepare(lay_over_);
    frame.shade.target.bind(all);
    lay_over_.draw_fullscreen();
    if (!frame.is_kept) return;
    prepare(find_nearest_);
    nearest_.framebuffer().bind(all);
    find_nearest_.draw_fullscreen();
}

}  // namespace talus::render
