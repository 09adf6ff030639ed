#include "app/core/part.h"

#include <fmt/format.h>

#include "sim/error.h"

namespace talus::app {

Rectangle part_of(const Parameters& view) {
    return {view.number("map.west_m"), view.number("map.south_m"), view.number("map.east_m"),
            view.number("map.north_m")};
}

void set_part(Parameters& view, const Rectangle& part) {
    view.set("map.west_m", part.west_m);
    view.set("map.south_m", part.south_m);
    view.set("map.east_m", part.east_m);
    view.set("map.north_m", part.north_m);
}

SceneRequest request_for_part(const Session& session) {
    const Grid& g = session.grid();
    const gpu::Region samples = samples_in(g, part_of(session.view()));
    if (!is_terrain_size(samples.width, samples.height))
        throw Error(fmt::format("a part of {} x {} samples cannot be worked in, each side must have {} to {}",
                                samples.width, samples.height, min_samples, max_samples));
    const int last_row = samples.y + samples.height - 1;
    const glm::dvec2 south_west(samples.x * g.dx, (g.ny - 1 - last_row) * g.dy);
    const glm::dvec2 north_east((samples.x + samples.width - 1) * g.dx, (g.ny - 1 - samples.y) * g.dy);
    SceneRequest request;
    request.input = session.request().input;
    request.import = session.request().import;
    request.in_place = true;
    request.import.window = io::window_of(session.overflight()->terrain().file, south_west, north_east);
    return request;
}

SceneRequest request_for_whole(const Session& session) {
    const io::CutOut& cut_out = *session.scene().document.cut_out;
    SceneRequest request;
    request.input = cut_out.path.string();
    request.import = cut_out.import;
    request.tiled = true;
    request.in_place = true;
    return request;
}

}  // namespace talus::app
