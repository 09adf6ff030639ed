#include "sim/passes/water.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/passes/tick_series.h"
#include "sim/passes/water_schedule.h"
#include "sim/terrain/bed_beyond.h"
#include "sim/terrain/springs.h"

namespace talus {
namespace {

using uint = std::uint32_t;
struct WaterClock {
#include "sim/water_clock.glsl"
};

WaterClock read_clock(const gpu::Buffer& buffer) {
    WaterClock clock{};
    buffer.read(0, std::as_writable_bytes(std::span(&clock, 1)));
    return clock;
}

}  // namespace

Water::Water(const Terrain& terrain)
    : step_program_("sim/water_step.comp"),
      bed_program_("sim/water_bed.comp"),
      loaded_bed_program_({"sim/water_bed.comp"}, {"SEDIMENT 1"}),
      active_(terrain.tiles.count()),
      numbers_("water numbers"),
      clock_("water clock", sizeof(WaterClock)),
      activity_("water activity", static_cast<std::size_t>(terrain.tiles.count()) * sizeof(std::uint32_t)),
      speeds_("water speeds", static_cast<std::size_t>(terrain.tiles.count()) * sizeof(std::uint32_t)),
      sources_("water sources",
               static_cast<std::size_t>(terrain.tiles.count()) * glsl::tile_strips * sizeof(glm::dvec2)),
      springs_("water springs", sizeof(glm::vec4)),
      series_("water tick series", glsl::tick_series_tables * glsl::tick_series_points * sizeof(float)),
      bed_beyond_("water bed beyond", words_of_bed_beyond(terrain.grid()) * sizeof(float)),
      edge_books_("water edge books",
                  2 * static_cast<std::size_t>(terrain.grid().nx + terrain.grid().ny) * sizeof(glm::dvec2)),
      inflow_shares_(terrain.grid()),
      sediment_(terrain.grid()) {
    clock_.fill(0);
    activity_.fill(0);
    speeds_.fill(0);
    sources_.fill(0);
    edge_books_.fill(0);
    bed_beyond_.write_all(terrain.bed_beyond.empty()
                              ? std::vector<float>(words_of_bed_beyond(terrain.grid()), glsl::unknown_bed)
                              : terrain.bed_beyond);
}

gpu::Program& Water::stage_program(int stage, bool counts_flow) {
    const bool land_cover = has_land_cover(settings_);
    const bool friction = settings_.manning_s_per_m13 > 0 || land_cover;
    const bool sources = has_sources(settings_, stage);
    const bool rain_map = has_rain_map(settings_);
    const bool inflow = has_inflow(settings_);
    const bool conveyance = spreads_by_conveyance(settings_);
    const int key = settings_.order + 4 * stage + (friction ? 16 : 0) + (sources ? 32 : 0) +
                    (rain_map ? 64 : 0) + (settings_.sediment.carried ? 128 : 0) + (inflow ? 256 : 0) +
                    (counts_flow ? 512 : 0) + (land_cover ? 1024 : 0) + (conveyance ? 2048 : 0);
    auto found = stage_programs_.find(key);
    if (found == stage_programs_.end()) {
        std::vector<std::string> defines = {"ORDER " + std::to_string(settings_.order),
                                            "STAGE " + std::to_string(stage)};
        if (friction) defines.emplace_back("FRICTION 1");
        if (land_cover) defines.emplace_back("LAND_COVER 1");
        if (sources) defines.emplace_back("SOURCES 1");
        if (rain_map) defines.emplace_back("RAIN_MAP 1");
        if (inflow) defines.emplace_back("INFLOW 1");
        if (conveyance) defines.emplace_back("CONVEYANCE 1");
        if (settings_.sediment.carried) defines.emplace_back("SEDIMENT 1");
        if (counts_flow) defines.emplace_back("FLOW_MAP 1");
        found = stage_programs_.emplace(key, gpu::Program({"sim/water.comp"}, defines)).first;
    }
    return found->second;
}

// Binds those of the buffers that the program uses.
void Water::bind_buffers(gpu::Program& program) const {
    program.bind_storage("WaterActivity", activity_);
    program.bind_storage("TileList", active_.buffer);
    program.bind_storage("WaterClock", clock_);
    program.bind_storage("TileSpeeds", speeds_);
    program.bind_storage("TileSources", sources_);
    program.bind_storage("Springs", springs_);
    program.bind_storage("TickSeries", series_);
    program.bind_storage("BedBeyond", bed_beyond_);
    program.bind_storage("EdgeBooks", edge_books_);
    program.bind_storage("InflowShares", inflow_shares_.shares);
    program.bind_uniforms("WaterNumbers", numbers_);
}

gpu::Program& Water::edge_program() {
    const bool carried = settings_.sediment.carried;
    const bool conveyance = spreads_by_conveyance(settings_);
    const int key = settings_.order + (carried ? 16 : 0) + (conveyance ? 32 : 0);
    auto found = edge_programs_.find(key);
    if (found == edge_programs_.end()) {
        std::vector<std::string> defines = {"ORDER " + std::to_string(settings_.order)};
        if (carried) defines.emplace_back("SEDIMENT 1");
        if (conveyance) defines.emplace_back("CONVEYANCE 1");
        found = edge_programs_.emplace(key, gpu::Program({"sim/water_edges.comp"}, defines)).first;
    }
    return found->second;
}

void Water::begin_tick(Terrain& terrain, const WaterSettings& settings, const std::vector<Spring>& springs,
                       double tick_s, double start_s) {
    settings_ = settings;
    expected_ = 1;
    // A tick that was given up may have asked for its time.
    poll_.cancel();
    const Grid& grid = terrain.grid();
    const auto time = static_cast<float>(tick_s);
    clock_.write(0, std::as_bytes(std::span(&time, 1)));
    // A tick begins from the water alone, so that one that was saved and loaded goes on the same way.
    const std::uint32_t none = 0;
    clock_.write(offsetof(WaterClock, clock_edge_fastest), std::as_bytes(std::span(&none, 1)));

    const std::vector<float> series = tick_series(settings, grid, tick_s, start_s);
    series_.write_all(series);

    std::vector<glm::vec4> placed;
    placed.reserve(springs.size());
    for (const Spring& spring : springs) {
        const glm::ivec2 at = sample_of(grid, spring);
        placed.emplace_back(at.x, at.y, spring.rate_m3_per_s / (grid.dx * grid.dy), 0);
    }
    numbers_.set(water_numbers(grid, {terrain.tiles.columns(), terrain.tiles.rows()}, settings, tick_s,
                               springs.size(), series));
    if (settings.sediment.carried) sediment_.begin_tick(settings);
    if (!placed.empty()) {
        if (springs_.bytes() != placed.size() * sizeof(glm::vec4))
            springs_ = gpu::Buffer("water springs", placed.size() * sizeof(glm::vec4));
        springs_.write_all(placed);
    }

    terrain.tiles.list(Tiles::ground | Tiles::placed | Tiles::painted, read_, 0, 0, 1, active_);
    DeviceLayer& water = *terrain.water;
    gpu::Program& bed = terrain.suspended ? loaded_bed_program_ : bed_program_;
    bed.bind_image("water_in", water.front);
    bed.bind_image("water_out", water.back);
    bed.bind_image("bed_out", terrain.water_bed);
    bed.bind_image("ground_in", terrain.ground);
    bind_buffers(bed);
    if (terrain.suspended) {
        bed.bind_image("load_in", terrain.suspended->front);
        bed.bind_image("load_out", terrain.suspended->back);
    }
    bed.dispatch_indirect(active_.buffer);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
    if (spreads_by_conveyance(settings))
        inflow_shares_.find(terrain, numbers_, clock_, settings.manning_painted);
}

void Water::substep(Terrain& terrain) {
    bind_buffers(step_program_);
    step_program_.dispatch(1);
    gpu::barrier({gpu::Use::storage, gpu::Use::indirect, gpu::Use::buffer_transfer});
    run_substep(
        settings_, [&](int stage) { fill_ghosts(terrain, stage); },
        [&](int stage) {
            count_sections(terrain, stage);
            run_stage(terrain, stage);
        },
        [&] {
            sediment_.exchange(terrain, active_.buffer, activity_, clock_, numbers_,
                               {.wear = settings_.counts_maps, .land_cover = settings_.manning_painted});
        });
}

void Water::fill_ghosts(Terrain& terrain, int stage) {
    gpu::Program& program = edge_program();
    program.set("stage", stage);
    program.bind_image("water_state", stage == 1 ? terrain.water->front : terrain.water->back);
    program.bind_image("bed", terrain.water_bed);
    if (settings_.sediment.carried) {
        program.bind_image("load_state", stage == 1 ? terrain.suspended->front : terrain.suspended->back);
        program.bind_storage("EdgeSolidBooks", sediment_.edge_books);
        program.bind_uniforms("SedimentNumbers", sediment_.numbers);
    }
    bind_buffers(program);
    terrain.tiles.bind_for_stamping(program);
    program.dispatch(1);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
}

void Water::count_sections(const Terrain& terrain, int stage) {
    sections.count(settings_.order, spreads_by_conveyance(settings_), [&](gpu::Program& program) {
        program.bind_image("water_in", stage == 1 ? terrain.water->front : terrain.water->back);
        program.bind_image("bed_in", terrain.water_bed);
        bind_buffers(program);
    });
}

// The first stage writes to the back images; the second one completes the front ones in place.
void Water::run_stage(Terrain& terrain, int stage) {
    const bool counts_flow = settings_.counts_maps && terrain.flow;
    gpu::Program& program = stage_program(stage, counts_flow);
    if (counts_flow) program.bind_image("flow_map", terrain.flow->front);
    terrain.tiles.bind_for_stamping(program);
    bind_buffers(program);
    const auto bind_pair = [&](const DeviceLayer& layer, const char* in, const char* out) {
        program.bind_image(in, stage == 1 ? layer.front : layer.back);
        program.bind_image(out, stage == 1 ? layer.back : layer.front);
    };
    bind_pair(*terrain.water, "water_in", "water_out");
    if (settings_.sediment.carried) bind_pair(*terrain.suspended, "load_in", "load_out");
    program.bind_image("bed_in", terrain.water_bed);
    if (has_rain_map(settings_)) program.bind_image("painted", terrain.painted->front);
    if (has_land_cover(settings_)) program.bind_image("land_cover", terrain.land_cover->front);
    program.dispatch_indirect(active_.buffer);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
}

bool Water::advance(Terrain& terrain, int& substeps) {
    while (true) {
        if (!poll_.pending()) {
            if (substeps <= 0) return false;
            // At most the expected number of sub-steps: surplus ones cost a little, and so does a read-back
            // of the time left.
            const int batch = std::clamp(expected_, 1, substeps);
            for (int i = 0; i < batch; ++i) substep(terrain);
            sent_ += static_cast<std::uint64_t>(batch);
            substeps -= batch;
            poll_.start(clock_, 2 * sizeof(float));
        }
        const auto clock = poll_.poll();
        if (!clock) return false;
        const float left_s = (*clock)[0];
        const float dt_s = (*clock)[1];
        if (left_s <= 0) return true;
        expected_ = static_cast<int>(std::min(64.0F, std::ceil(left_s / dt_s)));
    }
}

double Water::time_left_s() const {
    float left_s = 0;
    clock_.read(0, std::as_writable_bytes(std::span(&left_s, 1)));
    return left_s;
}

std::vector<Book> Water::books() {
    std::vector<Book> books = own_books();
    for (Book& book : sections.books()) books.push_back(std::move(book));
    return books;
}

std::vector<Book> Water::own_books() {
    return {{"water clock", &clock_,
             [](const gpu::Buffer& words, const Grid& grid, const SolidWeights&, BudgetTerms& terms) {
                 const WaterClock clock = read_clock(words);
                 const double area_m2 = grid.dx * grid.dy;
                 terms.water.rain_m3 += clock.book_rain_m * area_m2 * static_cast<double>(grid.count());
                 terms.water.springs_m3 += clock.book_springs_m * area_m2;
             }},
            {"water edges", &edge_books_,
             [](const gpu::Buffer& words, const Grid& grid, const SolidWeights&, BudgetTerms& terms) {
                 const double area_m2 = grid.dx * grid.dy;
                 for (const glm::dvec2& sample : words.read_all<glm::dvec2>()) {
                     terms.water.edges_in_m3 += sample.x * area_m2;
                     terms.water.edges_out_m3 += sample.y * area_m2;
                 }
             }},
            {"water sources", &sources_,
             [](const gpu::Buffer& words, const Grid& grid, const SolidWeights&, BudgetTerms& terms) {
                 const double area_m2 = grid.dx * grid.dy;
                 for (const glm::dvec2& strip : words.read_all<glm::dvec2>()) {
                     terms.water.losses_m3 += strip.x * area_m2;
                     terms.water.rain_m3 += strip.y * area_m2;
                 }
             }},
            sediment_.book()};
}

WaterBooks Water::read_books(const Grid& grid) {
    BudgetTerms terms;
    for (const Book& book : books()) book.add(*book.words, grid, {}, terms);
    return terms.water;
}

PassWork Water::work() const {
    const WaterClock clock = read_clock(clock_);
    return {static_cast<std::uint64_t>(clock.total_substeps), static_cast<std::uint64_t>(clock.total_listed)};
}

}  // namespace talus
