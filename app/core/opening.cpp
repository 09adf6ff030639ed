#include "app/core/opening.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

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

bool is_to_be_measured(const SceneRequest& request) {
    if (request.input.empty()) return false;
    if (is_in_tiles(request)) return !is_measured(request.input, request.import);
    try {
        if (request.import.window) return !is_measured(request.input, request.import);
        const std::optional<io::CutOut> cut_out = io::cut_out_of(request.input);
        return cut_out && !is_measured(cut_out->path.string(), cut_out->import);
    } catch (const Error&) {
        // Then nothing is shown around it.
        return false;
    }
}

TiledScene open_tiled_scene(const SceneRequest& request,
                            const std::function<Progress(const std::string& path)>& begin_progress) {
    check_tiled_request(request);
    TiledScene scene{nullptr, make_scene_parameters(request), {}};
    if (!request.texture.empty()) scene.texture = io::read_colour_image(request.texture);
    io::limit_read_memory(static_cast<std::size_t>(scene.parameters.view.whole("tiles.host_mib")) << 20);
    scene.terrain =
        std::make_shared<const TiledTerrain>(open_tiled(request.input, request.import, begin_progress));
    return scene;
}

void open_whole(Scene& scene, const std::function<Progress(const std::string& path)>& begin_progress) {
    const std::optional<io::CutOut>& cut_out = scene.document.cut_out;
    if (!cut_out || !scene.view.toggle("tiles.backdrop")) return;
    std::vector<std::string>& notes = scene.document.notes;
    bool ended = false;
    const auto begin_heeded = [&](const std::string& path) -> Progress {
        return [&ended, told = begin_progress(path)](double share) {
            if (!told(share)) ended = true;
            return !ended;
        };
    };
    try {
        io::limit_read_memory(static_cast<std::size_t>(scene.view.whole("tiles.host_mib")) << 20);
        scene.whole = std::make_shared<const TiledTerrain>(
            open_tiled(cut_out->path.string(), cut_out->import, begin_heeded));
        if (scene.whole->file.fingerprint() != cut_out->fingerprint)
            notes.push_back(
                fmt::format("'{}' was changed since this was cut out of it", cut_out->path.string()));
    } catch (const Error& error) {
        if (ended) throw;
        notes.push_back(fmt::format("what stands around is not shown: {}", error.what()));
    }
}

Scene open_scene(const SceneRequest& request,
                 const std::function<Progress(const std::string& path)>& begin_progress) {
    if (!is_in_tiles(request)) {
        Scene scene = make_scene(request);
        open_whole(scene, begin_progress);
        return scene;
    }
    TiledScene opened = open_tiled_scene(request, begin_progress);
    io::Document stand_in;
    const Grid small{17, 17, 1, 1};
    stand_in.state = bedrock_terrain(small, std::vector<float>(small.count(), 0));
    stand_in.kind = "tiles";
    stand_in.notes = opened.terrain->notes;
    Scene scene{std::move(stand_in), std::move(opened.parameters.simulation),
                std::move(opened.parameters.view)};
    scene.title = std::filesystem::path(request.input).filename().string();
    scene.texture = std::move(opened.texture);
    scene.tiles = std::move(opened.terrain);
    return scene;
}

}  // namespace talus::app
