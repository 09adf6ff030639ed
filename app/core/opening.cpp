#include "app/core/opening.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "app/core/tile_sketch.h"
#include "render/tiled/tiled_renderer.h"
#include "sim/error.h"
#include "sim/io/endings.h"

namespace talus::app {

void check_tiled_request(const SceneRequest& request) {
    const SceneParameters parameters = make_scene_parameters(request);
    if (!request.preset.empty())
        throw Error(
            fmt::format("--preset {} is a scene to work in, '{}' is in tiles and can only be looked at",
                        request.preset, request.input));
    for (const Parameter& one : parameters.simulation.declared())
        if (parameters.simulation.is_given(one.name))
            throw Error(
                fmt::format("{} is of a terrain to work in, '{}' is in tiles and can only be looked at",
                            one.name, request.input));
    if (parameters.view.is_given("render.method"))
        throw Error(
            "--method chooses how a terrain is drawn that is held as a whole; one in tiles has its own way");
    render::check_view_of_tiles(render::view_settings(parameters.view, parameters.simulation));
}

bool is_in_tiles(const SceneRequest& request) {
    if (request.import.window) return false;
    return request.tiled || io::ending_of(request.input) == ".vrt" ||
           (!request.input.empty() && io::is_larger_than_a_terrain(request.input));
}

namespace {

// Opens a terrain in tiles that stands around a scene; none where it cannot be shown yet.
using OpenTiles = std::function<std::optional<TiledTerrain>(const TiledRequest&)>;

void limit_memory(const Parameters& view) {
    io::limit_read_memory(static_cast<std::size_t>(view.whole("tiles.host_mib")) << 20);
    io::return_read_memory();
}

TiledRequest tiles_of(const SceneRequest& request) {
    return {request.input, request.import};
}

std::shared_ptr<const TiledTerrain> shared(TiledTerrain terrain) {
    return std::make_shared<const TiledTerrain>(std::move(terrain));
}

// Parameters of a scene in tiles.
TiledScene begin_tiled_scene(const SceneRequest& request) {
    check_tiled_request(request);
    TiledScene scene{nullptr, make_scene_parameters(request), {}};
    limit_memory(scene.parameters.view);
    return scene;
}

// What stands in for a terrain to work in where one in tiles is looked at.
Scene with_stand_in(const SceneRequest& request, TiledScene tiled) {
    io::Document stand_in;
    const Grid small{17, 17, 1, 1};
    stand_in.state = bedrock_terrain(small, std::vector<float>(small.count(), 0));
    stand_in.kind = "tiles";
    stand_in.notes = tiled.terrain->notes;
    Scene scene{std::move(stand_in), std::move(tiled.parameters.simulation),
                std::move(tiled.parameters.view)};
    scene.title = std::filesystem::path(request.input).filename().string();
    scene.draping = std::move(tiled.draping);
    scene.tiles = std::move(tiled.terrain);
    return scene;
}

// A scene to work in, and what it was cut out of, as far as that is opened.
Scene scene_with_whole(const SceneRequest& request, const OpenTiles& open) {
    Scene scene = make_scene(request);
    if (scene.draping.photo) limit_memory(scene.view);
    const auto note_all = [&](const std::vector<std::string>& notes) {
        scene.document.notes.insert(scene.document.notes.end(), notes.begin(), notes.end());
    };
    const std::optional<io::CutOut>& cut_out = scene.document.cut_out;
    if (!cut_out) return scene;
    const TiledRequest whole{cut_out->path.string(), cut_out->import};
    if (!scene.view.toggle("tiles.backdrop")) {
        scene.unready = whole;
        return scene;
    }
    try {
        limit_memory(scene.view);
        std::optional<TiledTerrain> terrain = open(whole);
        const bool is_ready = terrain && terrain->is_measured;
        if (terrain) note_all(take_whole(scene, std::move(*terrain)));
        if (!is_ready) scene.unready = whole;
    } catch (const Interrupted&) {
        throw;
    } catch (const Error& error) {
        scene.document.notes.push_back(fmt::format("what stands around is not shown: {}", error.what()));
    }
    return scene;
}

}  // namespace

std::vector<std::string> take_whole(Scene& scene, TiledTerrain terrain) {
    const io::CutOut& cut_out = *scene.document.cut_out;
    scene.whole = shared(std::move(terrain));
    if (scene.whole->file.fingerprint() == cut_out.fingerprint) return {};
    return {fmt::format("'{}' was changed since this was cut out of it", cut_out.path.string())};
}

TiledScene open_tiled_scene(const SceneRequest& request, const BeginProgress& begin_progress) {
    TiledScene scene = begin_tiled_scene(request);
    // Before long work, so that what is wrong is said at once.
    scene.draping =
        open_draping(request.texture, io::TiledFile(request.input, request.import).georeference());
    scene.terrain = shared(open_tiled(tiles_of(request), begin_progress));
    return scene;
}

Scene open_scene(const SceneRequest& request, const BeginProgress& begin_progress) {
    if (is_in_tiles(request)) return with_stand_in(request, open_tiled_scene(request, begin_progress));
    Scene scene = scene_with_whole(request, [&](const TiledRequest& tiles) {
        // Overviews of the whole are much to ask for a picture of a part: without them this throws.
        tree_of({tiles.path, tiles.import});
        return std::optional(open_tiled(tiles, begin_progress));
    });
    scene.unready.reset();
    return scene;
}

Scene open_scene_at_once(const SceneRequest& request) {
    if (!is_in_tiles(request))
        return scene_with_whole(request, [](const TiledRequest& tiles) -> std::optional<TiledTerrain> {
            const io::TiledFile file(tiles.path, tiles.import);
            // Heights between few samples do not meet the scene's.
            if (needs_overviews(file)) return std::nullopt;
            if (std::optional<TiledTerrain> ready = ready_of(file)) return ready;
            return sketch_of(file);
        });
    TiledScene tiled = begin_tiled_scene(request);
    const TiledRequest tiles = tiles_of(request);
    const io::TiledFile file(tiles.path, tiles.import);
    tiled.draping = open_draping(request.texture, file.georeference());
    std::optional<TiledTerrain> ready = ready_of(file);
    tiled.terrain = shared(ready ? std::move(*ready) : sketch_of(file));
    Scene scene = with_stand_in(request, std::move(tiled));
    if (!scene.tiles->is_measured) scene.unready = tiles;
    return scene;
}

}  // namespace talus::app
