#include <imgui.h>

#include "app/panels/panels.h"
#include "app/tools/brush_stroke.h"

namespace talus::app {
namespace {

// A dab of the whole map, with the brush's mask.
void ask_everywhere(PanelContext& context, Dab dab) {
    dab.masked = context.session.view().choice("brush.over") == "mask";
    context.requests.map = everywhere(context.session.grid(), dab);
}

}  // namespace

void draw_map_panel(PanelContext& context) {
    Session& session = context.session;
    PanelRequests& requests = context.requests;
    const Parameters& view = session.view();
    heading("Samples");
    draw_parameters(session, requests, {"map.nx", "map.ny"});
    if (button("Resample", "as many samples over the same ground"))
        requests.map = Resample{view.whole("map.nx"), view.whole("map.ny")};
    heading("Place");
    draw_parameters(session, requests, {"map.west_m", "map.south_m", "map.east_m", "map.north_m"});
    if (button("Crop", "keeps what lies between these edges"))
        requests.map = Crop{{view.number("map.west_m"), view.number("map.south_m"), view.number("map.east_m"),
                             view.number("map.north_m")}};
    ImGui::SameLine();
    if (button("Rotate by 90°", "counterclockwise, with water and edges")) requests.map = Turn{1};
    heading("Heights");
    draw_parameters(session, requests, {"map.offset_m"});
    if (button("Offset", "adds it to every height, as far as the brush's mask says")) {
        const double offset_m = view.number("map.offset_m");
        Dab dab;
        if (offset_m < 0) dab.effect = LowerDab{};
        dab.amount_m = std::abs(offset_m);
        ask_everywhere(context, dab);
    }
    draw_parameters(session, requests, {"map.scale", "map.base_m"});
    if (button("Scale", "heights above the base times the scale")) {
        Dab dab;
        dab.effect = FlattenDab{};
        dab.blend = 1 - view.number("map.scale");
        dab.target_m = view.number("map.base_m");
        ask_everywhere(context, dab);
    }
    draw_parameters(session, requests, {"map.blur_m"});
    if (button("Blur", "a Gaussian of this standard deviation"))
        requests.map = Blur{view.number("map.blur_m"), false, view.choice("brush.over") == "mask"};
    heading("Noise");
    draw_parameters(session, requests,
                    {"map.noise_m", "noise.kind", "noise.wavelength_m", "noise.octaves", "noise.gain",
                     "noise.warp", "noise.seed"});
    if (button("Add noise", "this high, as the noise brush makes it")) {
        Parameters tool = view;
        tool.set("brush.tool", std::string("noise"));
        Dab dab = tool_dab(tool, {}, 0, 0, nullptr);
        dab.amount_m = view.number("map.noise_m");
        ask_everywhere(context, dab);
    }
    heading("Another heightmap");
    draw_parameters(session, requests, {"stamp.mode", "stamp.relief_m", "stamp.zero"});
    if (button("Choose…", "a file, which becomes the stamp"))
        context.state.dialog.begin(FileDialog::Purpose::stamp, session.path());
    ImGui::SameLine();
    if (button("Blend it in", "the stamp spread over the whole map",
               session.simulation().stamp() != nullptr)) {
        Parameters tool = view;
        tool.set("brush.tool", std::string("stamp"));
        Dab dab = tool_dab(tool, {}, session.bounds().x, 0, session.simulation().stamp().get());
        // Whatever its zero is, its lowest sample comes to where the terrain's was.
        auto& placed = std::get<StampDab>(dab.effect);
        dab.target_m += placed.zero * dab.amount_m;
        const Grid& grid = session.grid();
        placed.half_m = {grid.width_m() / 2, grid.height_m() / 2};
        placed.turn_deg = 0;
        ask_everywhere(context, dab);
    }
}

}  // namespace talus::app
