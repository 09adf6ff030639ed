// Tools that put something on the ground: water, and what is painted.
#include "app/tools/tools.h"

namespace talus::app {
namespace {

constexpr const char* wipes = "Ctrl wipes what was painted.";

void put(const ToolUse& use, Dab& dab, Material material) {
    dab.material = material;
    dab.effect = effect_of(use.inverted ? BrushMode::lower : BrushMode::raise);
}

void paint(const ToolUse& use, Dab& dab, Material material, const char* value) {
    put(use, dab, material);
    dab.target_m = use.inverted ? 0 : use.parameters.number(value);
}

void water(const ToolUse& use, Dab& dab) {
    put(use, dab, Material::water);
}

void rain(const ToolUse& use, Dab& dab) {
    paint(use, dab, Material::rain, "brush.rain_mm_per_h");
}

void hardness(const ToolUse& use, Dab& dab) {
    paint(use, dab, Material::hardness, "brush.value");
}

void roughness(const ToolUse& use, Dab& dab) {
    paint(use, dab, Material::manning, "brush.manning");
}

void infiltration(const ToolUse& use, Dab& dab) {
    paint(use, dab, Material::infiltration, "brush.infiltration_mm_per_h");
}

void mask(const ToolUse& use, Dab& dab) {
    paint(use, dab, Material::mask, "brush.value");
}

}  // namespace

Tool water_tool() {
    return {.name = "water",
            .how_to = "Ctrl takes water away.",
            .shape = water,
            .settings = {"brush.rate_m_per_s"},
            .strength = "brush.rate_m_per_s"};
}

Tool rain_tool() {
    return {.name = "rain",
            .how_to = wipes,
            .shape = rain,
            .settings = {"brush.rain_mm_per_h", "brush.blend_per_s"},
            .strength = "brush.blend_per_s"};
}

Tool hardness_tool() {
    return {.name = "hardness",
            .how_to = wipes,
            .shape = hardness,
            .settings = {"brush.value", "brush.blend_per_s"},
            .strength = "brush.blend_per_s"};
}

Tool roughness_tool() {
    return {
        .name = "roughness",
        .how_to =
            "Manning's n of the ground that water flows over. Ctrl gives it back to that of the panel Water.",
        .shape = roughness,
        .settings = {"brush.manning", "brush.blend_per_s"},
        .strength = "brush.blend_per_s"};
}

Tool infiltration_tool() {
    return {.name = "infiltration",
            .how_to = "Water that the ground takes in. Ctrl gives it back to that of the panel Water.",
            .shape = infiltration,
            .settings = {"brush.infiltration_mm_per_h", "brush.blend_per_s"},
            .strength = "brush.blend_per_s"};
}

Tool mask_tool() {
    return {.name = "mask",
            .how_to = wipes,
            .shape = mask,
            .settings = {"brush.value", "brush.blend_per_s"},
            .strength = "brush.blend_per_s",
            .limited_by_mask = false};
}

}  // namespace talus::app
