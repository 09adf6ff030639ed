#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "sim/io/cut_out.h"
#include "sim/io/heightmap.h"
#include "sim/terrain/terrain_state.h"

namespace talus::io {

/// A terrain as files hold it.
struct Document {
    TerrainState state;
    std::string parameters;  ///< TOML; empty where the file is no Talus document
    std::string kind;
    std::vector<std::string> notes;
    std::optional<CutOut> cut_out{};  ///< of which raster it is a part; none: of none
    /// What a window keeps of it besides (app/core/workspace.h), as text; empty: nothing.
    std::string workspace{};
};

/// Whether a file is a Talus document rather than a heightmap of another kind.
bool is_document(const std::filesystem::path& path);

/// Opens a Talus document (multi-channel EXR with a channel `bedrock`) or, as bedrock, any heightmap, or the
/// window of a raster that the settings say.
Document open_document(const std::filesystem::path& path, const ImportSettings& settings);

/// Writes everything a run continues from, to the bit: a float channel for every word of every layer that is
/// there (sim/terrain/layers.h), the ground as Y for picture programs, the start that a difference counts
/// from where the ground is another one; clock, spacing, coordinate system, springs, tables, parameters, the
/// ground beyond the edges and the workspace as attributes.
void save_document(const std::filesystem::path& path, const Document& document);

}  // namespace talus::io
