#include <fmt/format.h>

#include "sim/io/atomic_file.h"
#include "sim/io/mesh_formats.h"

namespace talus::io {

void write_obj(const std::filesystem::path& path, const TerrainMesh& mesh) {
    // As most programs read it: y up, so north is -z; v counts from the bottom.
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out,
                   "# {} vertices, {} triangles; samples lie {:.3g} m above or below it on average, {:.3g} m "
                   "at most; metres, x east, y up, z south; u, v over the whole map\n",
                   mesh.positions.size(), mesh.indices.size() / 3, mesh.mean_m, mesh.farthest_m);
    for (const glm::vec3& p : mesh.positions) fmt::format_to(out, "v {:.9g} {:.9g} {:.9g}\n", p.x, p.z, -p.y);
    for (const glm::vec2& t : mesh.texture_places) fmt::format_to(out, "vt {:.7g} {:.7g}\n", t.x, 1 - t.y);
    for (const glm::vec3& n : mesh.normals) fmt::format_to(out, "vn {:.5g} {:.5g} {:.5g}\n", n.x, n.z, -n.y);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        fmt::format_to(out, "f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", mesh.indices[i] + 1,
                       mesh.indices[i + 1] + 1, mesh.indices[i + 2] + 1);
    write_atomically(path, std::string_view(text.data(), text.size()));
}

}  // namespace talus::io
