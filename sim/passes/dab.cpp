#include "sim/passes/dab.h"

#include <fmt/format.h>

#include "sim/error.h"

namespace talus {

namespace {

template <typename Act, int number>
constexpr bool is_numbered = std::is_same_v<std::variant_alternative_t<number, DabEffect>, Act>;
static_assert(is_numbered<RaiseDab, glsl::brush_mode_raise> &&
              is_numbered<LowerDab, glsl::brush_mode_lower> &&
              is_numbered<SmoothDab, glsl::brush_mode_smooth> &&
              is_numbered<FlattenDab, glsl::brush_mode_flatten> &&
              is_numbered<RampDab, glsl::brush_mode_ramp> && is_numbered<NoiseDab, glsl::brush_mode_noise> &&
              is_numbered<TerraceDab, glsl::brush_mode_terrace> &&
              is_numbered<StampDab, glsl::brush_mode_stamp> &&
              is_numbered<ErodeDab, glsl::brush_mode_erode> && is_numbered<PathDab, glsl::brush_mode_path>);

// The alternatives, one after the other, each with its defaults.
template <std::size_t... At>
std::vector<DabEffect> all_acts(std::index_sequence<At...>) {
    return {DabEffect(std::in_place_index<At>)...};
}

const std::vector<DabEffect>& acts() {
    static const std::vector<DabEffect> all =
        all_acts(std::make_index_sequence<std::variant_size_v<DabEffect>>());
    return all;
}

}  // namespace

const std::vector<std::string>& brush_mode_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> of;
        for (const DabEffect& one : acts())
            of.emplace_back(std::visit([](const auto& act) { return act.name; }, one));
        return of;
    }();
    return names;
}

DabEffect effect_of(BrushMode mode) {
    return acts().at(static_cast<std::size_t>(mode));
}

bool has_object(const DabEffect& effect) {
    return std::visit([](const auto& one) { return HasObject<std::decay_t<decltype(one)>>; }, effect);
}

const std::vector<std::string>& material_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all = {"bedrock", "regolith", "water"};
        for (const PaintedNumberDescription& number : painted_numbers()) all.push_back(number.name);
        return all;
    }();
    return names;
}

const std::vector<std::string>& falloff_curve_names() {
    static const std::vector<std::string> names = {"smooth", "linear", "round", "sharp"};
    return names;
}

const std::vector<std::string>& noise_kind_names() {
    static const std::vector<std::string> names = {"fbm", "ridged", "billow"};
    return names;
}

const std::vector<std::string>& path_kind_names() {
    static const std::vector<std::string> names = {"road", "river", "wall", "ditch", "breach"};
    return names;
}

const std::vector<std::string>& stamp_mode_names() {
    static const std::vector<std::string> names = {"add", "higher", "lower", "replace"};
    return names;
}

namespace {

struct Check {
    template <typename Number>
    void operator()(const std::string& name, Number value, double low, double high) const {
        if (!(value >= low && value <= high))
            throw Error(fmt::format("a dab's {} cannot be {}, it must be {} to {}", name, value, low, high));
    }
    void operator()(const std::string& name, glm::dvec2 pair, double low, double high) const {
        (*this)(name + " (east)", pair.x, low, high);
        (*this)(name + " (north)", pair.y, low, high);
    }
    void operator()(const std::string& name, const std::vector<glm::dvec3>& points, double low,
                    double high) const {
        if (points.size() < 2 || points.size() > PathDab::most_points)
            throw Error(fmt::format("a dab's {} cannot be {} points, it must be 2 to {}", name, points.size(),
                                    PathDab::most_points));
        for (const glm::dvec3& point : points) {
            (*this)(name, glm::dvec2(point), low, high);
            (*this)(name + " (height)", point.z, -1e6, 1e6);
        }
    }
    template <typename Choice>
    void operator()(const std::string&, Choice, const std::vector<std::string>&) const {}
    void operator()(const std::string&, bool) const {}
};

}  // namespace

void check_dab(const Dab& dab) {
    visit_footprint(dab, Check());
    visit_own(dab, Check());
    if (dab.is_paint()) {
        const PaintedNumberDescription& number = description_of(painted_number(dab.material));
        if (!(dab.target_m >= 0 && dab.target_m <= number.most))
            throw Error(fmt::format("a dab of {} cannot paint {}, it must be 0 to {}", number.name,
                                    dab.target_m, number.most));
    }
    if (dab.masked && dab.is_paint() && dab.material == Material::mask)
        throw Error("a dab that paints the mask cannot be limited by it");
}

Dab everywhere(const Grid& grid, Dab dab) {
    dab.x_m = grid.width_m() / 2;
    dab.y_m = grid.height_m() / 2;
    dab.radius_m = grid.width_m() + grid.height_m() + grid.dx + grid.dy;
    dab.falloff = 0;
    if (auto* ramp = dab.as<RampDab>()) ramp->way_m = {0, 0};
    return dab;
}

PaintedNumber painted_number(Material material) {
    return static_cast<PaintedNumber>(static_cast<int>(material) - static_cast<int>(Material::hardness));
}

}  // namespace talus
