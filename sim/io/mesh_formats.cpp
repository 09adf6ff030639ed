#include "sim/io/mesh_formats.h"

#include <algorithm>

#include "sim/io/endings.h"

namespace talus::io {

const std::vector<MeshFormat>& mesh_formats() {
    static const std::vector<MeshFormat> formats = {
        {"Wavefront OBJ", ".obj", write_obj}, {"glTF", ".gltf", write_gltf}, {"glTF", ".glb", write_glb}};
    return formats;
}

const MeshFormat* mesh_format_of(const std::filesystem::path& path) {
    const std::string ending = ending_of(path);
    const auto found = std::find_if(mesh_formats().begin(), mesh_formats().end(),
                                    [&](const MeshFormat& format) { return format.ending == ending; });
    return found == mesh_formats().end() ? nullptr : &*found;
}

std::vector<std::string> mesh_endings() {
    std::vector<std::string> endings;
    for (const MeshFormat& format : mesh_formats()) endings.push_back(format.ending);
    return endings;
}

}  // namespace talus::io
