#include <array>
#include <cmath>
#include <optional>

#include "render/methods/cell_mesh.h"
#include "render/methods/height_levels.h"
#include "render/methods/method.h"
#include "render/methods/terrain_sides.h"

namespace talus::render {
namespace {

// As many as shaders/render/clipmap_tile.glsl has room for. All have heights, however many are drawn, so that
// the eye may move away.
constexpr int most_levels = 16;
// Samples of the terrain; no ring reaches it from farther off.
constexpr double farthest_eye = 1e7;

const Parameter& ring_samples() {
    static const Parameter declared =
        choice("render.clipmap_samples", "511", {"63", "127", "255", "511"},
               "Samples in a row and a column of a level of the method clipmap: its authors' n.")
            .labelled("Samples of a level");
    return declared;
}

const Parameter& ring_levels() {
    static const Parameter declared = whole("render.clipmap_levels", 11, 2, most_levels, "",
                                            "Levels of the method clipmap, each twice as wide as the finer "
                                            "one; more where the terrain reaches "
                                            "beyond the widest.")
                                          .labelled("Levels");
    return declared;
}

// Of the pixels of a level: in turn, so that rings side by side differ.
constexpr glm::vec3 level_kinds(1, 2, 6);

// In the finest level that is drawn: 16 in a row and a column.
constexpr int most_tiles = 256;

class Clipmap {
  public:
    explicit Clipmap(Detail detail)
        : program_({"render/clipmap.vert", "render/clipmap.frag"}, detail_defines(detail)) {}

    void draw(const Frame& frame) {
        const int side = (64 << static_cast<int>(own_number(frame.numbers, ring_samples()))) - 1;
        const int levels =
            std::max(static_cast<int>(own_number(frame.numbers, ring_levels())), levels_over(frame, side));
        make_room(side, frame.terrain);
        levels_ = levels;
        const std::vector<glm::ivec2> origins = origins_around(frame);
        ring_origins_.write(0, std::as_bytes(std::span(origins)));
        follow_changes(frame.terrain);
        for (int level = 0; level < most_levels; ++level)
            follow_eye(frame.terrain, level, origins[static_cast<std::size_t>(level)]);
        list_tiles(frame);
        begin_nearest(frame);
        prepare(program_, frame);
        program_.bind_sampled("rings", rings_);
        program_.set("kinds", level_kinds);
        program_.draw_indexed_indirect(indices_, tiles_, 0, gpu::Depth::nearest);
        sides_.draw_below(frame);
    }

    MethodFigures figures() const {
        MethodFigures result;
        if (tiles_.bytes() == 0) return result;
        const auto words = tiles_.read_all<std::uint32_t>();
        result.mesh_cells = static_cast<int>(words[1]);
        result.triangles = static_cast<long>(words[0] / 3) * result.mesh_cells;
        result.bytes = heights_.bytes() + 2 * sizeof(float) * rings_.width() * rings_.height() +
                       ring_origins_.bytes() + ring_updates_.bytes() + tiles_.bytes() + indices_.bytes();
        return result;
    }

  private:
    void make_room(int side, const Terrain& terrain) {
        const glm::ivec2 samples(terrain.grid().nx, terrain.grid().ny);
        if (side == side_ && samples == samples_) return;
        side_ = side;
        samples_ = samples;
        rings_ = gpu::Texture("rings", gpu::Format::rg32f, side, side * most_levels);
        tiles_ = gpu::Buffer("tiles of rings",
                             (8 + std::size_t{most_tiles} * most_levels) * sizeof(std::uint32_t));
        indices_ = cell_indices((side + 1) / 16);
        held_.fill(std::nullopt);
        changed_ = std::make_unique<TileList>(terrain.tiles.count());
        read_ = {};
    }

    static glm::dvec2 eye_of(const Frame& frame) {
        const Grid& grid = frame.terrain.grid();
        return glm::clamp(glm::dvec2(grid.column_of(frame.camera.eye.x), grid.row_of(frame.camera.eye.y)),
                          glm::dvec2(-farthest_eye), glm::dvec2(farthest_eye));
    }

    // So many that the widest reaches over the terrain from the eye.
    static int levels_over(const Frame& frame, int side) {
        const Grid& grid = frame.terrain.grid();
        const glm::dvec2 eye = eye_of(frame);
        const glm::dvec2 farthest =
            glm::max(glm::abs(eye), glm::abs(eye - glm::dvec2(grid.nx - 1, grid.ny - 1)));
        int levels = 1;
        // The eye may stand a sample beside the middle, and the terrain's sides lie a sample beyond its edge.
        while (levels < most_levels &&
               (0.5 * (side - 1) - 3) * (1 << (levels - 1)) < std::max(farthest.x, farthest.y))
            ++levels;
        return levels;
    }

    // The eye in the middle, as nearly as even columns and rows allow: a finer level then ends on samples of
    // the coarser.
    std::vector<glm::ivec2> origins_around(const Frame& frame) const {
        const glm::dvec2 eye = eye_of(frame);
        std::vector<glm::ivec2> origins;
        for (int level = 0; level < most_levels; ++level) {
            const glm::dvec2 middle = eye / static_cast<double>(1 << level);
            origins.emplace_back(2 * glm::ivec2(glm::floor(0.5 * middle - 0.25 * (side_ - 1) + 0.5)));
        }
        return origins;
    }

    void prepare(gpu::Program& program, const Frame& frame) const {
        const Grid& grid = frame.terrain.grid();
        frame.pyramid.bind(program, frame.terrain);
        set_camera(program, grid, frame.camera, frame.width, frame.height);
        bind_rings(program);
        program.bind_storage("RingTiles", tiles_);
        program.set("near_m", near_plane_m(grid));
    }

    void bind_rings(gpu::Program& program) const {
        program.bind_storage("RingOrigins", ring_origins_);
        program.set("side", side_);
        program.set("levels", levels_);
    }

    void prepare_update(gpu::Program& program, const Terrain& terrain, int level) {
        bind_rings(program);
        program.set("levels", most_levels);
        program.bind_sampled("ground", terrain.ground);
        heights_.bind(program, level);
        program.bind_image("rings", rings_);
        program.set("level", level);
    }

    void follow_changes(const Terrain& terrain) {
        if (read_ == terrain.tiles.reader_now()) return;
        const bool anew = !held_.front();
        terrain.tiles.list(Tiles::ground | Tiles::eroded, read_, 0, 0, 1, *changed_);
        heights_.refresh(terrain, most_levels, *changed_);
        if (anew) return;  // all rings are filled next
        const glm::ivec2 tiles(terrain.tiles.columns(), terrain.tiles.rows());
        bind_rings(choose_);
        choose_.bind_storage("TileList", changed_->buffer);
        choose_.bind_storage("RingUpdates", ring_updates_);
        choose_.set("tiles", tiles);
        choose_.set("patches", glm::ivec2(terrain.grid().nx - 1, terrain.grid().ny - 1));
        choose_.dispatch(most_levels);
        gpu::barrier({gpu::Use::indirect});
        for (int level = 0; level < most_levels; ++level) {
            const std::size_t at = static_cast<std::size_t>(level) * 8 * sizeof(std::uint32_t);
            prepare_update(update_tiles_, terrain, level);
            update_tiles_.bind_storage("TileList", changed_->buffer);
            update_tiles_.set("tiles", tiles);
            update_tiles_.dispatch_indirect(ring_updates_, at);
            gpu::barrier({gpu::Use::image});
            prepare_update(update_, terrain, level);
            update_.set("rectangle_first", *held_[static_cast<std::size_t>(level)]);
            update_.set("rectangle_size", glm::ivec2(side_));
            update_.dispatch_indirect(ring_updates_, at + 4 * sizeof(std::uint32_t));
            gpu::barrier({gpu::Use::image, gpu::Use::sampler});
        }
    }

    // What came into a level's ring as the eye moved: columns at one side, rows at another. The rest stays
    // where it is (Losasso & Hoppe 2004: toroidal access).
    void follow_eye(const Terrain& terrain, int level, glm::ivec2 origin) {
        std::optional<glm::ivec2>& held = held_[static_cast<std::size_t>(level)];
        const glm::ivec2 moved = held ? origin - *held : glm::ivec2(side_);
        held = origin;
        if (moved == glm::ivec2(0)) return;
        if (std::abs(moved.x) >= side_ || std::abs(moved.y) >= side_) {
            update(terrain, level, origin, glm::ivec2(side_));
            return;
        }
        const glm::ivec2 wide = glm::abs(moved);
        const glm::ivec2 first(moved.x > 0 ? origin.x + side_ - wide.x : origin.x,
                               moved.y > 0 ? origin.y + side_ - wide.y : origin.y);
        if (wide.x > 0) update(terrain, level, {first.x, origin.y}, {wide.x, side_});
        if (wide.y > 0) update(terrain, level, {origin.x, first.y}, {side_, wide.y});
    }

    void update(const Terrain& terrain, int level, glm::ivec2 first, glm::ivec2 size) {
        prepare_update(update_, terrain, level);
        update_.set("rectangle_first", first);
        update_.set("rectangle_size", size);
        update_.dispatch((size.x * size.y + 255) / 256);
        gpu::barrier({gpu::Use::image, gpu::Use::sampler});
    }

    void list_tiles(const Frame& frame) {
        const auto patches = static_cast<std::uint32_t>((side_ + 1) / 16);
        const std::array<std::uint32_t, 8> arguments = {6 * patches * patches, 0, 0, 0, 0, 0, 0, 0};
        tiles_.write(0, std::as_bytes(std::span(arguments)));
        prepare(list_, frame);
        list_.dispatch(levels_ * (most_tiles / 64));
        gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
    }

    gpu::Program program_;
    gpu::Program list_{"render/clipmap_tiles.comp"};
    gpu::Program choose_{"render/clipmap_changes.comp"};
    gpu::Program update_{"render/clipmap_update.comp"};
    gpu::Program update_tiles_{std::vector<std::string>{"render/clipmap_update.comp"}, {"TILES"}};
    TerrainSides sides_;
    HeightLevels heights_;
    int side_ = 0;
    int levels_ = 0;  // that are drawn
    glm::ivec2 samples_{0};
    gpu::Texture rings_;
    gpu::Buffer ring_origins_{"first samples of rings", most_levels * sizeof(glm::ivec2)};
    gpu::Buffer ring_updates_{"updates of rings", std::size_t{most_levels} * 8 * sizeof(std::uint32_t)};
    gpu::Buffer tiles_;
    gpu::Buffer indices_;
    std::array<std::optional<glm::ivec2>, most_levels> held_;  // first samples of what rings_ has, by level
    std::unique_ptr<TileList> changed_;
    Tiles::Reader read_;
};

}  // namespace

std::vector<Parameter> clipmap_parameters() {
    return {ring_samples(), ring_levels()};
}

std::vector<PixelKind> clipmap_kinds(const OwnNumbers&) {
    return {{level_kinds[0], "every sample; 8, 64 … apart"},
            {level_kinds[1], "samples 2, 16, 128 … apart"},
            {level_kinds[2], "samples 4, 32, 256 … apart"}};
}

Method make_clipmap(Detail detail) {
    auto clipmap = std::make_shared<Clipmap>(detail);
    return {[clipmap](const Frame& frame) { clipmap->draw(frame); },
            [clipmap] { return clipmap->figures(); }};
}

}  // namespace talus::render
