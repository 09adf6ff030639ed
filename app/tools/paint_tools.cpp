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
            .icon = "8,1 12,7 13,10 11,13 8,14 5,13 3,10 4,7 8,1",
            .how_to = "Ctrl takes water away.",
            .shape = water,
            .settings = {"brush.rate_m_per_s"},
            .strength = "brush.rate_m_per_s"};
}

Tool rain_tool() {
    return {.name = "rain",
            .icon = "3,8 1,6 3,3 6,3 9,1 12,3 15,5 13,8 3,8; 5,10 4,14; 8,10 7,14; 11,10 10,14",
            .how_to = wipes,
            .shape = rain,
            .settings = {"brush.rain_mm_per_h", "brush.blend_per_s"},
            .strength = "brush.blend_per_s"};
}

Tool hardness_tool() {
    return {.name = "hardness",
            .icon = "4,2 12,2 15,6 8,14 1,6 4,2; 1,6 15,6",
            .how_to = wipes,
            .shape = hardness,
            .settings = {"brush.value", "brush.blend_per_s"},
            .strength = "brush.blend_per_s"};
}

Tool roughness_tool() {
    return {
        .name = "roughness",
        .icon = "3,14 2,7; 5,14 6,5; 8,14 8,3; 11,14 10,5; 13,14 14,7",
        .how_to =
            "Manning's n of the ground that water flows over. Ctrl gives it back to that of the panel Water.",
        .shape = roughness,
        .settings = {"brush.manning", "brush.blend_per_s"},
        .strength = "brush.blend_per_s"};
}

Tool infiltration_tool() {
    return {.name = "infiltration",
            .icon = "1,5 15,5; 5,2 5,14; 3,11 5,14 7,11; 11,2 11,14; 9,11 11,14 13,11",
            .how_to = "Water that the ground takes in. Ctrl gives it back to that of the panel Water.",
            .shape = infiltration,
            .settings = {"brush.infiltration_mm_per_h", "brush.blend_per_s"},
            .strength = "brush.blend_per_s"};
}

Tool mask_tool() {
    return {.name = "mask",
            .icon = "8,1 13,3 15,8 13,13 8,15 3,13 1,8 3,3 8,1; 8,1 8,15; 8,5 11,5; 8,8 13,8; 8,11 11,11",
            .how_to = wipes,
            .shape = mask,
            .settings = {"brush.value", "brush.blend_per_s"},
            .strength = "brush.blend_per_s",
            .limited_by_mask = false};
}

}  // namespace talus::app
