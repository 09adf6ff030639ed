#include <fmt/format.h>
#include <imgui.h>

#include "app/core/part.h"
#include "app/panels/panels.h"

namespace talus::app {
namespace {

// Of a terrain in tiles: which part is worked in.
void draw_choice_of_part(PanelContext& context) {
    const Session& session = context.session;
    bool& choosing = context.state.choosing_part;
    heading("The part to work in");
    if (button(choosing ? "Drag over the ground…" : "Draw it",
               "a rectangle, by the next drag over the ground"))
        choosing = !choosing;
    draw_parameters(session, context.requests, {"map.west_m", "map.south_m", "map.east_m", "map.north_m"});
    const Grid& grid = session.grid();
    const gpu::Region samples = samples_in(grid, part_of(session.view()));
    const bool fits = is_terrain_size(samples.width, samples.height);
    text_line(fmt::format("{} × {} samples, {} × {} km", samples.width, samples.height,
                          figure((samples.width - 1) * grid.dx / 1000, 3),
                          figure((samples.height - 1) * grid.dy / 1000, 3)));
    if (!fits) ImGui::TextWrapped("Each side must have %d to %d samples.", min_samples, max_samples);
    if (button("Cut it out", "becomes the scene, in its place; the rest stands around it", fits))
        context.requests.open = request_for_part(session);
}

// Of a scene that was cut out: back into its place.
void draw_way_back(PanelContext& context) {
    const Session& session = context.session;
    const std::string whole = session.scene().document.cut_out->path.string();
    heading("Cut out of");
    ImGui::TextWrapped("%s", whole.c_str());
    if (has_backdrop_switch(session)) draw_parameters(session, context.requests, {"tiles.backdrop"});
    heading("Put back");
    draw_parameters(session, context.requests, {"map.feather_m"});
    if (button("Put back…",
               "writes what changed as a patch, and a mosaic over both; the file itself stays as it is",
               !context.work.busy()))
        context.state.dialog.begin_put_back(session);
    heading("The whole");
    if (button("Fly over the whole", "closes this scene; what is not saved is asked for"))
        context.requests.open = request_for_whole(session);
}

}  // namespace

bool has_backdrop_switch(const Session& session) {
    const Scene& scene = session.scene();
    if (session.overflight()) return false;
    return scene.unready ||
           (scene.whole && (session.surroundings() || !session.view().toggle("tiles.backdrop")));
}

bool has_cut_out_panel(const Session& session) {
    return session.overflight() || session.scene().document.cut_out;
}

void draw_cut_out_panel(PanelContext& context) {
    if (context.session.overflight())
        draw_choice_of_part(context);
    else
        draw_way_back(context);
}

}  // namespace talus::app
