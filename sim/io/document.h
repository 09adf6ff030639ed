#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "sim/io/heightmap.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// A terrain as files hold it.
struct Document {
    TerrainState state;
    std::string parameters;  ///< TOML; empty where the file is no Talus document
    std::string kind;
    std::vector<std::string> notes;
};

/// Whether a file is a Talus document rather than a heightmap of another kind.
bool is_document(const std::filesystem::path& path);

/// Opens a Talus document (multi-channel EXR with a channel `bedrock`) or, as bedrock, any heightmap.
Document open_document(const std::filesystem::path& path, const ImportSettings& settings);

/// Writes everything a run continues from, to the bit: float channels bedrock and regolith, their low words
/// as bedrock_low and regolith_low, where there is water its depth as water and water_low and its discharge
/// as discharge_x and discharge_y (m²/s east and north), the ground as Y for picture programs; clock,
/// spacing, coordinate system, springs and parameters as attributes.
void save_document(const std::filesystem::path& path, const Document& document);

/// Names that a layer output can have: ground, bedrock, regolith, water (its depth), level (ground and
/// water).
std::vector<float> layer_of(const TerrainState& state, const std::string& name);

}  // namespace talus
