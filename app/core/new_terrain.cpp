#include "app/core/new_terrain.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "app/core/small_picture.h"
#include "sim/error.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/layers.h"
#include "sim/terrain/sea.h"

namespace talus::app {
namespace {

constexpr std::array<const char*, 9> wish_names = {
    "terrain.kind", "terrain.nx",    "terrain.ny",        "terrain.spacing_m",  "terrain.relief_m",
    "terrain.seed", "terrain.water", "water.sea_level_m", "water.wave_height_m"};

Parameters declared_wishes() {
    const Parameters all(simulation_parameters());
    std::vector<Parameter> wishes;
    wishes.reserve(wish_names.size());
    for (const char* name : wish_names) wishes.push_back(all.declaration(name));
    return Parameters(std::move(wishes));
}

Grid grid_of(const Parameters& wishes) {
    const double spacing_m = wishes.number("terrain.spacing_m");
    return {wishes.whole("terrain.nx"), wishes.whole("terrain.ny"), spacing_m, spacing_m};
}

// Whether there is a sea at its level: where nobody gave one, at 0 there is none.
bool has_sea(const Parameters& wishes) {
    return wishes.is_given("water.sea_level_m") || wishes.number("water.sea_level_m") > 0;
}

// The same ground with a sample for every pixel of a small picture.
Grid of_picture(const Grid& grid) {
    const glm::ivec2 size = small_picture_size(grid);
    return {size.x, size.y, grid.width_m() / (size.x - 1), grid.height_m() / (size.y - 1)};
}

}  // namespace

NewTerrain::NewTerrain() : wishes_(declared_wishes()) {}

void NewTerrain::set(const std::string& name, const Value& value) {
    wishes_.set(name, value);
    suggest_sea();
}

void NewTerrain::unset(const std::string& name) {
    wishes_.reset(name);
    suggest_sea();
}

// As high as the shore of what is made to have one.
void NewTerrain::suggest_sea() {
    const std::string& kind = wishes_.choice("terrain.kind");
    constexpr double shore = 0.25;  // of the relief
    wishes_.suggest("water.sea_level_m",
                    kind == "island" || kind == "coast" ? shore * wishes_.number("terrain.relief_m") : 0.0);
}

std::vector<std::string> NewTerrain::heeded() const {
    const std::string& kind = wishes_.choice("terrain.kind");
    const std::string& water = wishes_.choice("terrain.water");
    std::vector<std::string> names;
    for (const std::string name : wish_names) {
        if (name == "terrain.seed" && !has_seed(kind)) continue;
        if (name == "terrain.relief_m" && !has_relief(kind) && water != "dam" && water != "bowl") continue;
        if (name == "water.wave_height_m" && water != "wave") continue;
        names.push_back(name);
    }
    return names;
}

std::string NewTerrain::refusal() const {
    if (!failure_.empty()) return failure_;
    try {
        check_grid(grid_of(wishes_));
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

NewTerrain::Drawn NewTerrain::drawn(const Parameters& wishes) {
    const Grid grid = of_picture(grid_of(wishes));
    const double relief_m = wishes.number("terrain.relief_m");
    const double sea_level_m = wishes.number("water.sea_level_m");
    TerrainState state = bedrock_terrain(
        grid, generate_heights(grid, {wishes.choice("terrain.kind"),
                                      static_cast<std::uint32_t>(wishes.whole("terrain.seed")), relief_m}));
    const std::vector<float> heights_m = state.ground();
    state.water = generate_water(grid, heights_m,
                                 {wishes.choice("terrain.water"), relief_m, sea_level_m,
                                  wishes.number("water.wave_height_m"), StartingWater().gravity_m_per_s2});
    if (has_sea(wishes)) fill_sea(state, sea_level_m);
    std::vector<float> depths_m;
    if (!state.water.empty()) depths_m = output_of(state, "depth");
    Drawn drawn;
    drawn.size = small_picture_size(grid);
    drawn.rgba = small_picture(grid, heights_m, depths_m, drawn.size);
    return drawn;
}

bool NewTerrain::follow() {
    bool is_other = false;
    if (drawing_.valid() && drawing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        const Drawn drawn = drawing_.get();
        failure_ = drawn.failure;
        if (failure_.empty()) {
            picture_ = gpu::Texture("new terrain", gpu::Format::rgba8, drawn.size.x, drawn.size.y);
            picture_.write(picture_.whole(), std::as_bytes(std::span(drawn.rgba)));
        }
        is_other = true;
    }
    if (drawing_.valid() || (drawn_wishes_ && *drawn_wishes_ == wishes_)) return is_other;
    drawn_wishes_ = wishes_;
    drawing_ = std::async(std::launch::async, [wishes = wishes_] {
        try {
            return drawn(wishes);
        } catch (const std::exception& error) {
            return Drawn{{}, {}, error.what()};
        }
    });
    return is_other;
}

SceneRequest NewTerrain::request() const {
    SceneRequest request;
    request.preset = "blank";
    request.title = "New " + wishes_.choice("terrain.kind");
    for (const std::string& name : heeded())
        if (name != "water.sea_level_m" || has_sea(wishes_))
            request.assignments.push_back(fmt::format("{}={}", name, to_text(wishes_.value(name))));
    return request;
}

}  // namespace talus::app
