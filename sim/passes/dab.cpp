#include "sim/passes/dab.h"

#include <fmt/format.h>

#include "sim/gpu/error.h"
#include "sim/passes/dab_fields.h"

namespace talus {

const std::vector<std::string>& brush_mode_names() {
    static const std::vector<std::string> names = {"raise", "lower",   "smooth", "flatten", "ramp",
                                                   "noise", "terrace", "stamp",  "erode"};
    return names;
}

const std::vector<std::string>& material_names() {
    static const std::vector<std::string> names = {"bedrock",  "regolith", "water",
                                                   "hardness", "mask",     "rain"};
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
    template <typename Choice>
    void operator()(const std::string&, Choice, const std::vector<std::string>&) const {}
    void operator()(const std::string&, bool) const {}
};

}  // namespace

void check_dab(const Dab& dab) {
    visit_footprint(dab, Check());
    for (std::size_t mode = 0; mode < brush_mode_names().size(); ++mode)
        visit_own(dab, static_cast<BrushMode>(mode), Check());
    if (dab.is_paint() && !(dab.target_m >= 0 && dab.target_m <= most_painted(painted_layer(dab.material))))
        throw Error(fmt::format("a dab of {} cannot paint {}, it must be 0 to {}",
                                material_names()[static_cast<std::size_t>(dab.material)], dab.target_m,
                                most_painted(painted_layer(dab.material))));
    if (dab.masked && dab.is_paint() && dab.material == Material::mask)
        throw Error("a dab that paints the mask cannot be limited by it");
}

Dab everywhere(const Grid& grid, Dab dab) {
    dab.x_m = grid.width_m() / 2;
    dab.y_m = grid.height_m() / 2;
    dab.radius_m = grid.width_m() + grid.height_m() + grid.dx + grid.dy;
    dab.falloff = 0;
    dab.way_m = {0, 0};
    return dab;
}

PaintedLayer painted_layer(Material material) {
    return static_cast<PaintedLayer>(static_cast<int>(material) - static_cast<int>(Material::hardness));
}

}  // namespace talus
