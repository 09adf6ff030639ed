#include "sim/terrain/layers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "sim/error.h"
#include "sim/terrain/gauge.h"
#include "sim/terrain/ground_shape.h"
#include "sim/terrain/terrain.h"

namespace talus {
namespace {

// The second word is at most half an ulp of the first.
bool are_words(float high, float low, float most) {
    return high >= 0 && high <= most && std::abs(low) <= 6e-8F * high + 1e-44F;
}

// What no run could leave and none can go on from.
std::string refuse_water(std::span<const float> water) {
    const double speed = glm::length(water_velocity(water[0], {water[2], water[3]}));
    if (are_words(water[0], water[1], 1e7F) && speed <= 1e5) return "";
    return fmt::format(
        "water of depth {} (and {}) m that runs at {:.3g} m/s: depths must be 0 to 1e7 m, their second words "
        "below their last digit, speeds at most 1e5 m/s",
        water[0], water[1], speed);
}

std::string refuse_inundation(std::span<const float> inundation) {
    if (inundation[0] >= 0 && inundation[1] >= 0) return "";
    return fmt::format("a largest depth of {} m that came after {} s: neither can be less than 0",
                       inundation[0], inundation[1]);
}

std::string refuse_suspended(std::span<const float> load) {
    if (are_words(load[0], load[1], 1e6F)) return "";
    return fmt::format(
        "suspended solid of {} (and {}) m: it must be 0 to 1e6, its second word below its last digit",
        load[0], load[1]);
}

// More than any run brings.
constexpr float most_flow_m3 = 1e24F;
constexpr float most_wear_m = 1e12F;

std::string refuse_flow(std::span<const float> flow) {
    if (are_words(flow[0], flow[1], most_flow_m3)) return "";
    return fmt::format(
        "a flow of {} (and {}) m³: it must be 0 to {:.0e}, its second word below its last digit", flow[0],
        flow[1], most_flow_m3);
}

std::string refuse_wear(std::span<const float> worn) {
    if (are_words(worn[0], worn[1], most_wear_m) && are_words(worn[2], worn[3], most_wear_m)) return "";
    return fmt::format(
        "wear of {} (and {}) m and deposition of {} (and {}) m: they must be 0 to {:.0e}, their second words "
        "below their last digit",
        worn[0], worn[1], worn[2], worn[3], most_wear_m);
}

// What no brush could have painted.
std::string refuse_painted(std::span<const float> painted) {
    const double most_rain = description_of(PaintedNumber::rain).most;
    if (painted[0] >= 0 && painted[0] <= 1 && painted[1] >= 0 && painted[1] <= 1 && painted[2] >= 0 &&
        painted[2] <= most_rain)
        return "";
    return fmt::format(
        "hardness {}, mask {} and rain {} mm/h in one sample: hardness and mask must be 0 to 1, rain 0 to {} "
        "mm/h",
        painted[0], painted[1], painted[2], most_rain);
}

std::string refuse_land_cover(std::span<const float> cover) {
    // Where terrain was resampled, numbers are rounded.
    const auto is_within = [](float value, double most) { return value >= 0 && value <= 1.00001 * most; };
    const double most_manning = description_of(PaintedNumber::manning).most;
    const double most_infiltration = description_of(PaintedNumber::infiltration).most;
    if (is_within(cover[0], most_manning) && is_within(cover[1], 1) &&
        is_within(cover[2], most_infiltration) && is_within(cover[3], 1))
        return "";
    return fmt::format(
        "Manning's n of {} with share {} and infiltration of {} mm/h with share {} in one sample: shares "
        "must "
        "be 0 to 1, Manning's n 0 to {} and infiltration 0 to {} mm/h",
        cover[0], cover[1], cover[2], cover[3], most_manning, most_infiltration);
}

// Of what one agent took and laid down.
LayerDescription wear_by(const std::string& agent, std::vector<glm::vec4> TerrainState::*samples,
                         std::optional<DeviceLayer> Terrain::*image) {
    return {.name = "wear and deposition by " + agent,
            .numbers = {{"wear_by_" + agent, "m", true, Resampling::amount},
                        {"deposition_by_" + agent, "m", true, Resampling::amount}},
            .samples = samples,
            .image = image,
            .refusal = refuse_wear};
}

// A current that ran east runs north.
void turn_discharge(std::span<float> water) {
    const float east = water[2];
    water[2] = -water[3];
    water[3] = east;
}

template <typename Word, typename State>
std::span<Word> words_in(State& state, const LayerDescription& layer) {
    return std::visit(
        [&](auto member) -> std::span<Word> {
            auto& texels = state.*member;
            if (texels.empty()) return {};
            return {&texels.front().x, texels.size() * static_cast<std::size_t>(layer.words())};
        },
        layer.samples);
}

}  // namespace

const std::vector<LayerDescription>& layers() {
    using enum Resampling;
    static const std::vector<LayerDescription> all = {
        {.name = "bedrock", .numbers = {{"bedrock", "m", true, height}}, .samples = &TerrainState::bedrock},
        {.name = "regolith",
         .numbers = {{"regolith", "m", true, amount}},
         .samples = &TerrainState::regolith,
         .solid_word = 2},
        {.name = "water",
         .numbers = {{"water", "m", true, amount},
                     {"discharge_x", "m²/s", false, amount, "discharge.x"},
                     {"discharge_y", "m²/s", false, amount, "discharge.y"}},
         .samples = &TerrainState::water,
         .image = &Terrain::water,
         .ghosts = water_ghosts,
         .has_back = true,
         .needs = &Terrain::inundation,
         .turn = turn_discharge,
         .refusal = refuse_water},
        {.name = "inundation",
         .numbers = {{"depth_max", "m", false, amount}, {"arrival_s", "s", false, nearest}},
         .samples = &TerrainState::inundation,
         .image = &Terrain::inundation,
         .needs = &Terrain::water,
         .refusal = refuse_inundation},
        {.name = "load",
         .numbers = {{"suspended", "m", true, amount}},
         .samples = &TerrainState::suspended,
         .image = &Terrain::suspended,
         .ghosts = water_ghosts,
         .has_back = true,
         .needs = &Terrain::water,
         .refusal = refuse_suspended},
        {.name = "hardness, mask and rain",
         .numbers = {{"hardness", "", false, amount},
                     {"mask", "", false, amount},
                     {"rain", "mm/h", false, amount}},
         .samples = &TerrainState::painted,
         .image = &Terrain::painted,
         .refusal = refuse_painted},
        {.name = "roughness and infiltration",
         .numbers = {{"manning", "s/m^(1/3)", false, amount},
                     {"manning_share", "", false, amount},
                     {"infiltration", "mm/h", false, amount},
                     {"infiltration_share", "", false, amount}},
         .samples = &TerrainState::land_cover,
         .image = &Terrain::land_cover,
         .refusal = refuse_land_cover},
        {.name = "flow",
         .numbers = {{"flow", "m³", true, Resampling::flow}},
         .samples = &TerrainState::flow,
         .image = &Terrain::flow,
         .refusal = refuse_flow},
        wear_by("water", &TerrainState::worn_by_water, &Terrain::worn_by_water),
        wear_by("slopes", &TerrainState::worn_by_slopes, &Terrain::worn_by_slopes),
        wear_by("hand", &TerrainState::worn_by_hand, &Terrain::worn_by_hand),
    };
    return all;
}

int LayerDescription::words() const {
    return std::holds_alternative<std::vector<glm::vec2> TerrainState::*>(samples) ? 2 : 4;
}

std::span<float> words_of(TerrainState& state, const LayerDescription& layer) {
    return words_in<float>(state, layer);
}

std::span<const float> words_of(const TerrainState& state, const LayerDescription& layer) {
    return words_in<const float>(state, layer);
}

void make_layer(TerrainState& state, const LayerDescription& layer, std::size_t texels) {
    std::visit(
        [&](auto member) {
            auto& samples = state.*member;
            samples.assign(texels, typename std::decay_t<decltype(samples)>::value_type(0));
        },
        layer.samples);
}

std::optional<PlacedNumber> number_named(const std::string& name) {
    for (const LayerDescription& layer : layers()) {
        int word = 0;
        for (const LayerNumber& number : layer.numbers) {
            if (number.name == name) return PlacedNumber{&layer, &number, word};
            word += number.two_words ? 2 : 1;
        }
    }
    return std::nullopt;
}

std::vector<std::string> output_names() {
    std::vector<std::string> names = {"ground", "difference", "level", "depth",
                                      "slope",  "curvature",  "wear",  "deposition"};
    for (const LayerDescription& layer : layers())
        for (const LayerNumber& number : layer.numbers) names.push_back(number.name);
    return names;
}

std::vector<std::string> numbers_of_output(const std::string& name) {
    if (name == "wear" || name == "deposition")
        return {name + "_by_water", name + "_by_slopes", name + "_by_hand"};
    // The document's channel is called by its layer.
    if (name == "depth") return {"water"};
    return number_named(name) ? std::vector<std::string>{name} : std::vector<std::string>();
}

std::string output_unit(const std::string& name) {
    if (name == "slope") return "°";
    if (name == "curvature") return "1/km";
    const std::optional<PlacedNumber> number = number_named(name);
    return number ? number->number->unit : "m";
}

std::vector<float> output_of(const TerrainState& state, const std::string& name) {
    if (name == "ground") return state.ground();
    if (name == "difference") {
        const std::vector<glm::vec2> now = state.ground_words();
        std::vector<float> values(now.size());
        for (std::size_t i = 0; i < state.start.size(); ++i)
            values[i] = (now[i].x - state.start[i].x) + (now[i].y - state.start[i].y);
        return values;
    }
    if (name == "level") {
        std::vector<float> values = state.ground();
        for (std::size_t i = 0; i < state.water.size(); ++i) values[i] += state.water[i].x;
        return values;
    }
    if (name == "slope") return slopes_deg(state.grid, state.ground());
    if (name == "curvature") return curvatures_per_km(state.grid, state.ground());
    const std::vector<std::string> numbers = numbers_of_output(name);
    if (numbers.empty())
        throw Error(fmt::format("--layer '{}' is not a layer, it must be one of: {}", name,
                                fmt::join(output_names(), ", ")));
    std::vector<double> sums(state.bedrock.size());
    for (const std::string& one : numbers) {
        const PlacedNumber number = number_named(one).value();
        const std::span<const float> words = words_of(state, *number.layer);
        const auto size = static_cast<std::size_t>(number.layer->words());
        auto at = static_cast<std::size_t>(number.word);
        for (std::size_t i = 0; at < words.size(); ++i, at += size)
            sums[i] += number.number->two_words ? static_cast<double>(words[at]) + words[at + 1] : words[at];
    }
    return {sums.begin(), sums.end()};
}

}  // namespace talus
