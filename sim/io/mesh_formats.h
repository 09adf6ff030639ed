#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sim/io/export.h"

namespace talus::io {

/// A kind of file that holds a mesh.
struct MeshFormat {
    std::string name;
    std::string ending;
    void (*write)(const std::filesystem::path&, const TerrainMesh&);
};
const std::vector<MeshFormat>& mesh_formats();

/// The one of the path's ending; null: there is none.
const MeshFormat* mesh_format_of(const std::filesystem::path& path);
std::vector<std::string> mesh_endings();

// y up: x east, z south, metres; texture coordinates as each counts them.
void write_obj(const std::filesystem::path& path, const TerrainMesh& mesh);
/// glTF 2.0, text with its numbers in it, and binary.
void write_gltf(const std::filesystem::path& path, const TerrainMesh& mesh);
void write_glb(const std::filesystem::path& path, const TerrainMesh& mesh);

}  // namespace talus::io
