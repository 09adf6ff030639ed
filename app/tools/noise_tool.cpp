#include "app/tools/tools.h"

namespace talus::app {
namespace {

void add_noise(const ToolUse& use, Dab& dab) {
    const Parameters& p = use.parameters;
    if (use.inverted) dab.amount_m = -dab.amount_m;
    dab.effect = NoiseDab{p.choice_as<int>("noise.kind"), p.number("noise.wavelength_m"),
                          p.whole("noise.octaves"),       p.number("noise.gain"),
                          p.number("noise.warp"),         static_cast<std::uint32_t>(p.whole("noise.seed"))};
}

}  // namespace

Tool noise_tool() {
    return {
        .name = "noise",
        .icon = "1,9 3,4 5,12 7,5 9,11 11,3 13,12 15,7",
        .how_to = "Ctrl turns it around, Shift smooths.",
        .shape = add_noise,
        .settings = {"brush.rate_m_per_s", "noise.kind", "noise.wavelength_m", "noise.octaves", "noise.gain",
                     "noise.warp", "noise.seed"},
        .strength = "brush.rate_m_per_s",
        .parameters = {
            choice("noise.kind", noise_kind_names()[static_cast<std::size_t>(NoiseDab().kind)],
                   noise_kind_names(),
                   "Noise brush and noise over the whole map: fbm, rolling; ridged, crests; billow, hollows.")
                .labelled("Noise")
                .choices_labelled({"Rolling (fBm)", "Ridged", "Billow"}),
            number("noise.wavelength_m", NoiseDab().wavelength_m, 1e-2, 1e6, "m",
                   "Size of its largest features; unless set, it follows the terrain's size."),
            whole("noise.octaves", NoiseDab().octaves, 1, 16, "", "How many times finer detail is added.")
                .labelled("Octaves"),
            number("noise.gain", NoiseDab().gain, 0, 1, "", "Height of finer detail against the coarser one.")
                .labelled("Detail"),
            number("noise.warp", NoiseDab().warp, 0, 2, "",
                   "How much the plane is bent first, in wavelengths: ridges wind.")
                .labelled("Winding"),
            whole("noise.seed", static_cast<int>(NoiseDab().seed), 0, 1000000, "",
                  "Another seed gives other noise.")}};
}

}  // namespace talus::app
