#include <array>
#include <cmath>
#include <utility>

#include "render/methods/cell_bounds.h"
#include "render/methods/cell_mesh.h"
#include "render/methods/method.h"
#include "render/methods/terrain_sides.h"

namespace talus::render {
namespace {

const Parameter& cell_samples() {
    static const Parameter declared =
        whole(
            "render.ammann_cell_samples", 128, 16, 512, "",
            "Samples in a row of a cell of the method ammann, without the one that it shares with the next.")
            .labelled("Samples of a cell");
    return declared;
}

const Parameter& mesh_from() {
    static const Parameter declared =
        number("render.ammann_mesh_from_px2", 70, 0, 1e6, "px²",
               "Cells where a sample covers more than this are drawn as mesh by the method ammann: its "
               "authors' T.")
            .labelled("Mesh from");
    return declared;
}

const Parameter& precision_range() {
    static const Parameter declared =
        number("render.ammann_range", 1.3, 1e-3, 1e3, "",
               "Over how many of the terrain's diagonals the precision of the method ammann falls: its "
               "authors' k.")
            .labelled("Range");
    return declared;
}

const Parameter& level_count() {
    static const Parameter declared =
        whole("render.ammann_levels", 4, 2, 10, "", "Levels of precision of the method ammann.")
            .labelled("Levels");
    return declared;
}

struct Precision {
    int samples;
    int halvings;
};

// The authors name the steps of four levels (section 5.1), and of others the ends, which lie evenly as ratios
// in between (table 2).
Precision precision_of(int level, int levels) {
    constexpr std::array<Precision, 4> four = {{{55, 25}, {32, 15}, {16, 10}, {8, 5}}};
    if (levels == 4) return four[static_cast<std::size_t>(level)];
    const double way_down = static_cast<double>(level) / (levels - 1);
    const auto between = [&](double most, double least) {
        return static_cast<int>(std::lround(most * std::pow(least / most, way_down)));
    };
    return {between(64, 6), between(50, 5)};
}

// Of a pixel that a level drew: from the colour of rays to that of those that end earliest.
double kind_of(int level, int levels) {
    return level == 0 ? 2 : levels == 2 ? 8 : 3 + 5.0 * (level - 1) / (levels - 2);
}

// Vertices of five faces.
constexpr std::uint32_t box_vertices = 30;
constexpr std::size_t words_per_draw = 8;

class Ammann {
  public:
    // precisions: of the levels, in the place of the parameter's, if set.
    Ammann(Detail detail, bool reads_back, std::vector<Precision> precisions)
        : detail_(detail), reads_back_(reads_back), precisions_(std::move(precisions)) {}

    void draw(const Frame& frame) {
        const int count = precisions_.empty() ? static_cast<int>(own_number(frame.numbers, level_count()))
                                              : static_cast<int>(precisions_.size());
        bounds_.refresh(frame.terrain, static_cast<int>(own_number(frame.numbers, cell_samples())));
        make_room(count);
        choose(frame);
        if (reads_back_)
            list_on_host();
        else
            list_on_device(frame);
        begin_nearest(frame);
        mesh_.draw(frame, mesh_cells_, bounds_.count().x);
        for (int level = 0; level < count; ++level) draw_rays(frame, level);
        sides_.draw(frame);
    }

    MethodFigures figures() const {
        MethodFigures result;
        if (mesh_cells_.bytes() == 0) return result;
        const auto mesh = mesh_cells_.read_all<std::uint32_t>();
        const auto rays = ray_cells_.read_all<std::uint32_t>();
        result.mesh_cells = static_cast<int>(mesh[1]);
        result.triangles = static_cast<long>(mesh[0] / 3) * result.mesh_cells;
        for (std::size_t level = 0; level < rays_.size(); ++level)
            result.triangles += long{box_vertices / 3} * rays[words_per_draw * level + 1];
        result.refreshed_cells = bounds_.refreshed();
        result.bytes =
            bounds_.bytes() + mesh_.bytes() + choices_.bytes() + mesh_cells_.bytes() + ray_cells_.bytes();
        return result;
    }

  private:
    std::size_t cells() const { return static_cast<std::size_t>(bounds_.count().x) * bounds_.count().y; }

    void make_room(int levels) {
        const std::size_t rays = (words_per_draw + cells()) * levels * sizeof(std::uint32_t);
        if (ray_cells_.bytes() != rays || rays_.size() != static_cast<std::size_t>(levels)) {
            choices_ = gpu::Buffer("choices of cells", cells() * sizeof(std::uint32_t));
            mesh_cells_ = gpu::Buffer("mesh cells", (words_per_draw + cells()) * sizeof(std::uint32_t));
            ray_cells_ = gpu::Buffer("cells of rays", rays);
            ray_cells_.fill(0);
            for (int level = 0; level < levels; ++level) {
                const std::array<std::uint32_t, words_per_draw> arguments = {box_vertices};
                ray_cells_.write(words_per_draw * level * sizeof(std::uint32_t),
                                 std::as_bytes(std::span(arguments)));
            }
        }
        mesh_.resize(bounds_.cell_patches());
        const std::array<std::uint32_t, words_per_draw> arguments = {
            static_cast<std::uint32_t>(mesh_.indices_per_cell())};
        mesh_cells_.write(0, std::as_bytes(std::span(arguments)));
        if (rays_.size() == static_cast<std::size_t>(levels)) return;
        rays_.clear();
        for (int level = 0; level < levels; ++level) {
            const Precision precision = precisions_.empty() ? precision_of(level, levels)
                                                            : precisions_[static_cast<std::size_t>(level)];
            std::vector<std::string> defines = detail_defines(detail_);
            defines.push_back("SAMPLES " + std::to_string(precision.samples));
            defines.push_back("HALVINGS " + std::to_string(precision.halvings));
            rays_.emplace_back(std::vector<std::string>{"render/ammann.vert", "render/ammann.frag"}, defines);
        }
    }

    void prepare(gpu::Program& program, const Frame& frame) const {
        frame.pyramid.bind(program, frame.terrain);
        set_camera(program, frame.terrain.grid(), frame.camera, frame.width, frame.height);
        bounds_.bind(program);
        program.set("near_m", near_plane_m(frame.terrain.grid()));
        program.set("levels", static_cast<int>(rays_.size()));
    }

    void choose(const Frame& frame) {
        prepare(choose_, frame);
        choose_.set("mesh_from_px", static_cast<float>(own_number(frame.numbers, mesh_from())));
        choose_.set("range", static_cast<float>(own_number(frame.numbers, precision_range())));
        choose_.bind_storage("Choices", choices_);
        choose_.dispatch(static_cast<int>((cells() + 63) / 64));
        gpu::barrier({gpu::Use::storage, gpu::Use::buffer_transfer});
    }

    void list_on_device(const Frame& frame) {
        prepare(list_, frame);
        list_.bind_storage("Choices", choices_);
        list_.bind_storage("MeshCells", mesh_cells_);
        list_.bind_storage("RayCells", ray_cells_);
        list_.dispatch(1 + static_cast<int>(rays_.size()));
        gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
    }

    void list_on_host() {
        const auto choices = choices_.read_all<std::uint32_t>();
        std::vector<std::vector<std::uint32_t>> chosen(1 + rays_.size());
        for (std::uint32_t cell = 0; cell < choices.size(); ++cell)
            if (choices[cell] < chosen.size()) chosen[choices[cell]].push_back(cell);
        const auto write = [](gpu::Buffer& buffer, std::size_t draw, std::size_t first,
                              const std::vector<std::uint32_t>& listed) {
            const auto count = static_cast<std::uint32_t>(listed.size());
            buffer.write((words_per_draw * draw + 1) * sizeof(std::uint32_t),
                         std::as_bytes(std::span(&count, 1)));
            if (count > 0) buffer.write(first * sizeof(std::uint32_t), std::as_bytes(std::span(listed)));
        };
        write(mesh_cells_, 0, words_per_draw, chosen[0]);
        for (std::size_t level = 0; level < rays_.size(); ++level)
            write(ray_cells_, level, first_cell(level), chosen[1 + level]);
    }

    // As first_ray_cell() of shaders/render/ammann_lists.glsl.
    std::size_t first_cell(std::size_t level) const {
        return words_per_draw * rays_.size() + level * cells();
    }

    void draw_rays(const Frame& frame, int level) {
        gpu::Program& program = rays_[static_cast<std::size_t>(level)];
        prepare(program, frame);
        program.bind_storage("RayCells", ray_cells_);
        program.set("first_cell", static_cast<int>(first_cell(static_cast<std::size_t>(level))));
        program.set("kind", static_cast<float>(kind_of(level, static_cast<int>(rays_.size()))));
        program.draw_indirect(ray_cells_, words_per_draw * level * sizeof(std::uint32_t),
                              gpu::Depth::nearest);
    }

    Detail detail_;
    bool reads_back_;
    std::vector<Precision> precisions_;
    CellBounds bounds_;
    CellMesh mesh_;
    TerrainSides sides_;
    gpu::Program choose_{"render/ammann_choose.comp"};
    gpu::Program list_{"render/ammann_list.comp"};
    std::vector<gpu::Program> rays_;  // by level of precision
    gpu::Buffer choices_;
    gpu::Buffer mesh_cells_;
    gpu::Buffer ray_cells_;
};

Method make(Detail detail, bool reads_back, std::vector<Precision> precisions = {}) {
    auto ammann = std::make_shared<Ammann>(detail, reads_back, std::move(precisions));
    return {[ammann](const Frame& frame) { ammann->draw(frame); }, [ammann] { return ammann->figures(); }};
}

}  // namespace

std::vector<Parameter> ammann_parameters() {
    return {cell_samples(), mesh_from(), precision_range(), level_count()};
}

std::vector<PixelKind> ammann_kinds(const OwnNumbers& numbers) {
    std::vector<PixelKind> kinds = {{1, "mesh"}};
    const int levels = static_cast<int>(own_number(numbers, level_count()));
    for (int level = 0; level < levels; ++level) {
        const Precision precision = precision_of(level, levels);
        kinds.push_back({kind_of(level, levels), "rays of " + std::to_string(precision.samples) +
                                                     " samples, " + std::to_string(precision.halvings) +
                                                     " halvings"});
    }
    return kinds;
}

Method make_ammann(Detail detail) {
    return make(detail, false);
}

Method make_ammann_of(const std::vector<glm::ivec2>& steps, bool reads_back) {
    std::vector<Precision> precisions;
    precisions.reserve(steps.size());
    for (const glm::ivec2 one : steps) precisions.push_back({one.x, one.y});
    return make(Detail::none, reads_back, std::move(precisions));
}

}  // namespace talus::render
