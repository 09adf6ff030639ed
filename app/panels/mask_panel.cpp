#include <imgui.h>

#include "app/panels/panels.h"

namespace talus::app {
namespace {

void ask(PanelContext& context, Operation operation) {
    context.requests.acts.emplace_back(
        [operation = std::move(operation)](Session& session) { session.apply(operation); });
}

}  // namespace

void draw_mask_panel(PanelContext& context) {
    const Parameters& view = context.session.view();
    ImGui::TextWrapped(
        "The mask says where brushes act (over = mask, on the left), where it rains (Water) and what erodes "
        "(Erosion). Paint it with the tool mask, or make it here.");
    if (choice_button("Show the mask", view.choice("render.view") == "mask", "the view of the mask", 0))
        context.session.set("render.view",
                            std::string(view.choice("render.view") == "mask" ? "shaded" : "mask"));
    heading("Out of the terrain");
    draw_parameters(context.session, context.requests,
                    {"mask.from", "mask.low", "mask.high", "mask.fade", "mask.join", "mask.inverted"});
    if (button("Make the mask", "by what stands above"))
        ask(context, MakeMask{view.choice_as<MaskSource>("mask.from"), view.number("mask.low"),
                              view.number("mask.high"), view.number("mask.fade"),
                              view.choice_as<MaskJoin>("mask.join"), view.toggle("mask.inverted")});
    heading("Change it");
    if (button("Invert", "1 becomes 0, and 0 becomes 1"))
        ask(context, MakeMask{MaskSource::itself, 0, 0, 0, MaskJoin::replace, true});
    ImGui::SameLine();
    if (button("Everywhere", "1 everywhere")) ask(context, MakeMask{MaskSource::everything});
    ImGui::SameLine();
    if (button("Nowhere", "0 everywhere"))
        ask(context, MakeMask{MaskSource::everything, 0, 0, 0, MaskJoin::replace, true});
    draw_parameters(context.session, context.requests, {"mask.blur_m"});
    if (button("Blur the mask")) ask(context, Blur{view.number("mask.blur_m"), true, false});
}

}  // namespace talus::app
