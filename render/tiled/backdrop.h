#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "render/hits_target.h"
#include "render/redraw.h"
#include "render/shading.h"
#include "render/tiled/tiled_rays.h"
#include "render/tiled/tiled_surface.h"

namespace talus::render {

/// A picture of the terrain in the middle, while it is drawn.
struct BackdropFrame {
    const ShadeFrame& shade;
    /// Of the terrain's water along the same rays; null: it has none that is shown.
    const gpu::Texture* water_hits;
    const ShadedGround& ground;  ///< the terrain's
    std::uint64_t changes;       ///< another number where the ground may be another
    bool is_kept;                ///< the picture itself, no sample of its refinement
};

/// What stands around a terrain that was cut out of one in tiles: the rest of it, with a hole where the
/// terrain is. Both are drawn along the same rays, the nearer hit shows, and each throws its shadow on the
/// other.
class Backdrop {
  public:
    /// first: the tiled terrain's column and row of the terrain's first sample. The terrain has the spacing
    /// of the tiled one. The surface must outlive this.
    Backdrop(const TiledSurface& surface, const Grid& terrain, glm::ivec2 first);

    /// The tiled terrain's column and row of the terrain's first sample.
    glm::ivec2 first() const { return first_; }
    /// The camera in the tiled terrain's own metres.
    Camera camera_over_tiles(const Camera& camera) const;
    /// And one of those in the terrain's metres.
    Camera camera_from_tiles(const Camera& over_tiles) const;
    /// Lowest and highest of the whole, by which both are coloured.
    glm::dvec2 range_m() const { return {surface_.lowest_m(), surface_.highest_m()}; }
    /// A number for what the surface shows: another one where it looked at something else.
    std::uint64_t changes() const { return changes_; }
    void note_change() { ++changes_; }
    /// The next picture is drawn anew.
    void forget() { drawn_.reset(); }
    /// A photo in tiles over what stands around (Renderer::lay()).
    void lay(const LaidPhoto& photo) { photo_ = photo; }

    /// What colours the terrain's hits need of what stands around. Draws its shadow on them, where the
    /// settings ask for shadows; in a redraw's blocks alone, where one is given.
    Beside beside(const ShadeFrame& frame, const Redraw* redraw);
    /// Draws what stands around into the frame's target, over the terrain's colours. The surface must have
    /// looked from the same eye.
    void draw(const BackdropFrame& frame);

    /// Of the picture that is kept: the nearest hits of both.
    const gpu::Texture& hits() const { return nearest_.hits(); }
    const HitsTarget& nearest() const { return nearest_; }

  private:
    // What the kept picture was drawn from.
    struct Picture {
        Camera camera;
        ViewSettings settings;
        glm::ivec2 size{0};
        std::uint64_t tiles = 0;
        std::uint64_t ground = 0;  // that shades it
        std::uint64_t photo = 0;
        bool operator==(const Picture&) const = default;
    };

    // Where one ground shades the hits of the other: 1, else 0.
    struct Shadow {
        Shadow() = default;
        Shadow(int w, int h);
        gpu::Texture mask;
        gpu::Framebuffer buffer;
    };

    // What stands around, in a picture.
    struct Rest {
        Rest() = default;
        Rest(int w, int h);
        HitsTarget target;
        gpu::Texture colour;
        gpu::Framebuffer colour_buffer;
        Shadow shadow;  // of the terrain on it
    };

    glm::dvec3 corner_m() const;
    void resize(glm::ivec2 size);
    void shade_tiles(const BackdropFrame& frame, const ViewSettings& settings, const Rest& rest);
    void colour(const Camera& over, const ViewSettings& settings, glm::ivec2 size, const Rest& rest,
                const Redraw* redraw);
    void list_shadow_changes(glm::ivec2 size);
    void lay_over(const BackdropFrame& frame, const Rest& rest);
    Beside beside_of(glm::ivec2 first, const gpu::Texture& shadow) const;

    const TiledSurface& surface_;
    Grid terrain_;
    glm::ivec2 first_;  // the hole's patches, from these to before these
    glm::ivec2 end_;
    std::uint64_t changes_ = 0;
    TiledRays rays_;
    Shading shading_;
    LaidPhoto photo_;
    gpu::Program shades_terrain_;
    gpu::Program shades_blocks_;  // of the terrain, in listed blocks
    gpu::Program shades_tiles_;
    gpu::Program shadow_changes_;
    Redraw redraw_;
    gpu::Program lay_over_;
    gpu::Program find_nearest_;
    Rest kept_;
    Rest sample_;  // of the refinement
    HitsTarget nearest_;
    Shadow on_terrain_;
    Shadow before_;  // kept_'s, until it changed last
    gpu::Texture no_shadow_;
    std::optional<Picture> drawn_;
};

}  // namespace talus::render
