#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <sstream>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/mesh_formats.h"

namespace talus::io {
namespace {

// glTF 2.0 has y up: north is -z.
std::vector<glm::vec3> y_up(const std::vector<glm::vec3>& vectors) {
    std::vector<glm::vec3> turned(vectors.size());
    std::transform(vectors.begin(), vectors.end(), turned.begin(),
                   [](glm::vec3 v) { return glm::vec3(v.x, v.z, -v.y); });
    return turned;
}

// Puts values behind those that the model's one buffer has, as a view with an accessor. Returns its place.
template <typename Value>
int add_values(tinygltf::Model& model, const std::vector<Value>& values, int target, int component,
               int type) {
    std::vector<unsigned char>& bytes = model.buffers.front().data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes.size();
    view.byteLength = values.size() * sizeof(Value);
    view.target = target;
    bytes.resize(view.byteOffset + view.byteLength);
    std::memcpy(bytes.data() + view.byteOffset, values.data(), view.byteLength);
    model.bufferViews.push_back(view);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model.bufferViews.size()) - 1;
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = values.size();
    model.accessors.push_back(accessor);
    return static_cast<int>(model.accessors.size()) - 1;
}

tinygltf::Model model_of(const TerrainMesh& mesh, const std::string& name) {
    tinygltf::Model model;
    model.asset.version = "2.0";
    model.asset.generator = "Talus";
    model.buffers.emplace_back();
    const auto add_vectors = [&](const std::vector<glm::vec3>& vectors) {
        return add_values(model, vectors, TINYGLTF_TARGET_ARRAY_BUFFER, TINYGLTF_COMPONENT_TYPE_FLOAT,
                          TINYGLTF_TYPE_VEC3);
    };
    const std::vector<glm::vec3> positions = y_up(mesh.positions);
    tinygltf::Primitive triangles;
    triangles.mode = TINYGLTF_MODE_TRIANGLES;
    triangles.material = 0;
    const int places = add_vectors(positions);
    glm::vec3 least = positions.front();
    glm::vec3 most = least;
    for (const glm::vec3& place : positions) {
        least = glm::min(least, place);
        most = glm::max(most, place);
    }
    // The standard wants bounds of positions.
    model.accessors.back().minValues = {least.x, least.y, least.z};
    model.accessors.back().maxValues = {most.x, most.y, most.z};
    triangles.attributes["POSITION"] = places;
    triangles.attributes["NORMAL"] = add_vectors(y_up(mesh.normals));
    triangles.attributes["TEXCOORD_0"] = add_values(model, mesh.texture_places, TINYGLTF_TARGET_ARRAY_BUFFER,
                                                    TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2);
    triangles.indices = add_values(model, mesh.indices, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER,
                                   TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR);
    tinygltf::Material ground;
    ground.name = "ground";
    ground.pbrMetallicRoughness.metallicFactor = 0;
    ground.pbrMetallicRoughness.roughnessFactor = 1;
    model.materials.push_back(ground);
    tinygltf::Mesh terrain;
    terrain.name = name;
    terrain.primitives.push_back(triangles);
    model.meshes.push_back(terrain);
    tinygltf::Node node;
    node.name = name;
    node.mesh = 0;
    model.nodes.push_back(node);
    tinygltf::Scene scene;
    scene.nodes.push_back(0);
    model.scenes.push_back(scene);
    model.defaultScene = 0;
    return model;
}

void write(const std::filesystem::path& path, const TerrainMesh& mesh, bool binary) {
    // A binary file says its length in 32 bits, and text holds the same numbers.
    constexpr std::size_t most_vertices = 100'000'000;
    if (mesh.positions.size() > most_vertices)
        throw Error(
            fmt::format("cannot write '{}': its {} vertices do not fit into one glTF, write it in tiles",
                        path.string(), mesh.positions.size()));
    const tinygltf::Model model = model_of(mesh, path.stem().string());
    std::ostringstream stream;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, binary))
        throw Error(fmt::format("cannot write '{}': its glTF cannot be made", path.string()));
    write_atomically(path, stream.str());
}

}  // namespace

void write_gltf(const std::filesystem::path& path, const TerrainMesh& mesh) {
    write(path, mesh, false);
}

void write_glb(const std::filesystem::path& path, const TerrainMesh& mesh) {
    write(path, mesh, true);
}

}  // namespace talus::io
