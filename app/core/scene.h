#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/draping.h"
#include "app/core/tiled_terrain.h"
#include "app/core/workspace.h"
#include "sim/io/document.h"
#include "sim/journal.h"
#include "sim/parameters.h"

namespace talus::app {

/// What a person asks for when starting.
struct SceneRequest {
    std::string preset;                    ///< name or path; empty: the default, alpine
    std::string input;                     ///< a heightmap or document; empty: generated
    std::optional<glm::ivec2> size;        ///< of the generated terrain
    io::ImportSettings import;             ///< its spacing holds for generated terrain too
    std::vector<std::string> assignments;  ///< section.name=value
    std::string texture;                   ///< a picture draped over the terrain; empty: none
    bool tiled = false;                    ///< in tiles, also where it could be held as a whole
    bool in_place = false;  ///< a part of what is looked at, or the whole around it: the camera stays
    std::string title;      ///< empty: the preset's, or the file's name
};

/// A terrain ready to run: where every session, live or replayed, begins.
struct Scene {
    io::Document document;
    Parameters simulation;  ///< terrain.*, time.tick_s, thermal.*
    Parameters view;        ///< render.*, brush.*, camera.*, tiles.*, time.speed, undo.*
    JournalStart start{};   ///< without the hash, which the caller takes of the state
    std::string title{};
    glm::ivec2 recorded_samples{0};  ///< of a journal's start: columns and rows that it was recorded with
    Draping draping{};
    Workspace workspace{};  ///< that the document keeps; its parameters are in `view`
    /// The terrain in tiles that is looked at. Then the document is a stand-in that nobody sees. Null: the
    /// document's terrain is.
    std::shared_ptr<const TiledTerrain> tiles{};
    /// The raster that the document's terrain was cut out of, to be shown around it. Null: there is none.
    std::shared_ptr<const TiledTerrain> whole{};
    /// What is to be made ready (open_tiled()) before it is shown, in place of a sketch, or around the
    /// terrain where `tiles.backdrop` asks for it.
    std::optional<TiledRequest> unready{};
};

/// The parameters of a scene.
struct SceneParameters {
    Parameters simulation;  ///< terrain.*, time.tick_s, thermal.*
    Parameters view;        ///< render.*, brush.*, camera.*, tiles.*, time.speed, undo.*
};
/// Those that a request sets, of a terrain that is not held as a whole. Throws talus::Error where one cannot
/// be set.
SceneParameters make_scene_parameters(const SceneRequest& request);

/// Throws talus::Error when the request cannot be met.
Scene make_scene(const SceneRequest& request);

/// The scene that a journal starts from, with its hash checked; with another size, the same ground with so
/// many samples.
Scene make_scene(const JournalFile& journal, const std::string& journal_path,
                 std::optional<glm::ivec2> size = std::nullopt);

}  // namespace talus::app
