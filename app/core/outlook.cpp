#include "app/core/outlook.h"

#include <filesystem>
#include <system_error>

#include "app/core/part.h"
#include "app/core/session.h"
#include "render/tiled/tiled_renderer.h"
#include "render/view.h"
#include "sim/io/tiled_file.h"

namespace talus::app {
namespace {

// The scene's edges in metres of the whole around it.
Rectangle part_of_whole(const Session& session) {
    const glm::dvec3 corner = session.surroundings()->backdrop().camera_over_tiles({}).eye;
    return {corner.x, corner.y, corner.x + session.grid().width_m(), corner.y + session.grid().height_m()};
}

}  // namespace

std::optional<Outlook> outlook_of(const Session& session) {
    if (!session.tiles()) return std::nullopt;
    const TiledTerrain& whole = session.tiles()->terrain();
    const Surroundings* around = session.surroundings();
    return Outlook{whole.file.path().string(), whole.tree.grid(),
                   around ? around->backdrop().camera_over_tiles(session.camera()) : session.camera(),
                   session.view(), session.overflight() ? part_of(session.view()) : part_of_whole(session)};
}

bool is_over(const Session& session, const Outlook& before) {
    const Overflight* overflight = session.overflight();
    if (!overflight || !(overflight->terrain().tree.grid() == before.grid)) return false;
    const io::TiledFile& file = overflight->terrain().file;
    std::error_code ignored;
    return !std::filesystem::equivalent(file.path(), before.whole, ignored) &&
           io::is_made_of(file.path(), before.whole);
}

void look_as(Session& session, const Outlook& before) {
    for (const Parameter& one : before.view.declared()) {
        const bool not_of_tiles = session.overflight() && one.name == "render.view" &&
                                  !render::is_of_tiles(render::view_named(before.view.choice(one.name)));
        const bool stays = one.name.starts_with("render.") || one.name.starts_with("camera.");
        if (stays && before.view.is_given(one.name) && !not_of_tiles)
            session.view().set(one.name, before.view.value(one.name));
    }
    if (session.overflight()) set_part(session.view(), before.part);
    const Surroundings* around = session.surroundings();
    session.camera() = around ? around->backdrop().camera_from_tiles(before.over_whole) : before.over_whole;
}

}  // namespace talus::app
