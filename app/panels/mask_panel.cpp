#include <imgui.h>

#include "app/panels/panels.h"

namespace talus::app {
namespace {

void ask(PanelContext& context, Operation operation) {
    context.requests.acts.emplace_back(
        [operation = std::move(operation)](Session& session) { session.apply(operation); });
}

// Empty: what the mask is made of has no numbers.
std::string unit_of(MaskSource source) {
    switch (source) {
        case MaskSource::slope:
            return "°";
        case MaskSource::curvature:
            return "1/km";
        case MaskSource::arrival:
            return "s";
        case MaskSource::flow:
            return "m³";
        case MaskSource::itself:
        case MaskSource::everything:
        case MaskSource::rectangle:
            return "";
        default:
            return "m";
    }
}

}  // namespace

void draw_mask_panel(PanelContext& context) {
    const Parameters& view = context.session.view();
    ImGui::TextWrapped(
        "The mask says where brushes act (Brush where, on the left), where it rains (Water) and what erodes "
        "(Erosion), and what the ground is made of. Paint it with the tool Mask, draw it, or make it here.");
    if (choice_button("Show the mask", view.choice("render.view") == "mask", "the view of the mask", 0))
        context.session.set("render.view",
                            std::string(view.choice("render.view") == "mask" ? "shaded" : "mask"));
    draw_button(context.state, MapDrag::mask, "Draw a rectangle",
                "between the places where a drag begins and ends; joined as below");
    heading("Out of the terrain");
    draw_parameters(context.session, context.requests, {"mask.from"});
    for (const char* name : {"mask.low", "mask.high", "mask.fade"}) {
        Parameter declared = context.session.declaration(name);
        declared.unit = unit_of(view.choice_as<MaskSource>("mask.from"));
        if (!declared.unit.empty()) draw_declared(context.session, context.requests, declared);
    }
    draw_parameters(context.session, context.requests, {"mask.join", "mask.inverted"});
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
    heading("Material");
    draw_parameters(context.session, context.requests, {"material.masked"});
}

}  // namespace talus::app
