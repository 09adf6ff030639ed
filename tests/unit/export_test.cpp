// What other programs get: the values that are to be typed there give the heights back, tiles meet, meshes
// keep their error.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/colour_image.h"
#include "sim/io/export.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/reshape.h"

namespace talus::export_test {
namespace {

namespace fs = std::filesystem;

class Export : public testing::Test {
  protected:
    Export() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    fs::path path(const std::string& name) const { return folder_ / name; }

    static io::Document hills(int nx, int ny) {
        const Grid grid{nx, ny, 12.5, 10};
        io::Document document;
        document.state = bedrock_terrain(grid, generate_heights(grid, {"hills", 3, 640}));
        for (glm::vec2& height : document.state.bedrock) height.x -= 170;
        document.state.georeference = Georeference{"", {1000, 12.5, 0, 2000, 0, -10}};
        return document;
    }

  private:
    // Of its own: tests run beside each other.
    fs::path folder_ =
        fs::path(testing::TempDir()) /
        (std::string("talus_export_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

std::vector<std::uint16_t> integers_in(const fs::path& path) {
    const std::string bytes = io::read_text(path);
    std::vector<std::uint16_t> values(bytes.size() / 2);
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

// The heights that an engine is to show: the ground with the samples that it takes, rows from the north.
std::vector<float> expected(const io::Document& document, int nx, int ny) {
    return resampled(document.state, nx, ny).ground();
}

std::map<std::string, double> typed(const io::Exported& exported) {
    std::map<std::string, double> values;
    for (const auto& [name, value] : exported.values) values[name] = std::atof(value.c_str());
    return values;
}

TEST_F(Export, UnrealsValuesGiveTheHeightsBackWithinHalfAStep) {
    const io::Document document = hills(300, 410);
    io::ExportSettings settings;
    settings.kind = io::ExportKind::unreal;
    settings.path = path("land.r16");
    const io::Exported exported = export_terrain(document, settings);
    ASSERT_EQ(exported.tile_samples, glm::ivec2(253, 505));
    const std::vector<std::uint16_t> values = integers_in(settings.path);
    const std::vector<float> heights = expected(document, 253, 505);
    ASSERT_EQ(values.size(), heights.size());
    auto t = typed(exported);
    const double step_m = t["Scale Z"] / 128 / 100;
    double worst = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        // Landscape Technical Guide: (value - 32768) / 128 * scale, in centimetres.
        const double centimetres = t["Location Z"] + (values[i] - 32768.0) / 128 * t["Scale Z"];
        worst = std::max(worst, std::abs(centimetres / 100 - heights[i]));
    }
    EXPECT_LE(worst, 0.5001 * step_m + 1e-4);
    EXPECT_LT(step_m, 0.02);
    EXPECT_NEAR(t["Scale X"] / 100 * 252, document.state.grid.width_m(), 1e-5);
    EXPECT_NEAR(t["Scale Y"] / 100 * 504, document.state.grid.height_m(), 1e-5);
    EXPECT_TRUE(fs::exists(path("land.r16.txt")));
}

TEST_F(Export, UnitysTilesCountFromTheSouthAndMeet) {
    const io::Document document = hills(500, 480);
    io::ExportSettings settings;
    settings.kind = io::ExportKind::unity;
    settings.path = path("terrain.raw");
    settings.tiles = {2, 2};
    const io::Exported exported = export_terrain(document, settings);
    ASSERT_EQ(exported.tile_samples, glm::ivec2(257));
    const std::vector<float> heights = expected(document, 513, 513);
    auto t = typed(exported);
    EXPECT_EQ(t["Resolution"], 257);
    EXPECT_NEAR(t["Terrain Width"], document.state.grid.width_m() / 2, 1e-4);
    EXPECT_NEAR(t["Terrain Length"], document.state.grid.height_m() / 2, 1e-4);
    double worst = 0;
    for (int tile_y = 0; tile_y < 2; ++tile_y)
        for (int tile_x = 0; tile_x < 2; ++tile_x) {
            const auto values = integers_in(
                path("terrain_x" + std::to_string(tile_x) + "_y" + std::to_string(tile_y) + ".raw"));
            ASSERT_EQ(values.size(), 257U * 257);
            for (int z = 0; z < 257; ++z)
                for (int x = 0; x < 257; ++x) {
                    // Unity: row 0 is at z = 0, the south; a height is value / 65535 of the terrain's.
                    const double height = t["Position Y"] + values[static_cast<std::size_t>(z) * 257 + x] /
                                                                65535.0 * t["Terrain Height"];
                    const int row = 512 - (256 * tile_y + z);
                    worst = std::max(
                        worst,
                        std::abs(height - heights[static_cast<std::size_t>(row) * 513 + 256 * tile_x + x]));
                }
        }
    EXPECT_LE(worst, 0.5001 * t["Terrain Height"] / 65535 + 1e-4);
}

TEST_F(Export, GodotsRangeGivesTheHeightsBack) {
    const io::Document document = hills(260, 200);
    io::ExportSettings settings;
    settings.kind = io::ExportKind::godot;
    settings.path = path("terrain.r16");
    const io::Exported exported = export_terrain(document, settings);
    // One spacing both ways: 12.5 m, where rows were 10 m apart.
    ASSERT_EQ(exported.tile_samples, glm::ivec2(260, 160));
    EXPECT_NEAR(exported.spacing_m.y / exported.spacing_m.x, 1, 0.01);
    double low = 0;
    double high = 0;
    for (const auto& [name, value] : exported.values)
        if (name == "r16_range") {
            ASSERT_EQ(std::sscanf(value.c_str(), "%lf, %lf", &low, &high), 2);
        }
    const std::vector<std::uint16_t> values = integers_in(settings.path);
    const std::vector<float> heights = expected(document, 260, 160);
    for (std::size_t i = 0; i < values.size(); ++i)
        ASSERT_NEAR(low + values[i] / 65535.0 * (high - low), heights[i],
                    0.5001 * (high - low) / 65535 + 1e-4);
}

TEST_F(Export, TilesShareTheirEdgesAndTheirRangeAndStandWhereTheyWere) {
    const io::Document document = hills(100, 75);
    io::ExportSettings settings;
    settings.path = path("t.png");
    settings.tiles = {3, 2};
    const io::Exported exported = export_terrain(document, settings);
    EXPECT_EQ(exported.files.size(), 6U);
    const auto columns = io::split_samples(100, 3);
    const auto rows = io::split_samples(75, 2);
    const std::vector<float> heights = document.state.ground();
    const double step = (exported.range_m.y - exported.range_m.x) / 65535;
    for (std::size_t y = 0; y < 2; ++y)
        for (std::size_t x = 0; x < 3; ++x) {
            const io::Heightmap tile =
                io::read_heightmap(path("t_x" + std::to_string(x) + "_y" + std::to_string(y) + ".png"), {});
            ASSERT_EQ(tile.grid.nx, columns[x].second);
            ASSERT_EQ(tile.grid.ny, rows[y].second);
            for (int r = 0; r < tile.grid.ny; ++r)
                for (int c = 0; c < tile.grid.nx; ++c)
                    ASSERT_NEAR(
                        tile.heights[static_cast<std::size_t>(r) * tile.grid.nx + c],
                        heights[static_cast<std::size_t>(rows[y].first + r) * 100 + columns[x].first + c],
                        0.5001 * step + 1e-4);
            EXPECT_DOUBLE_EQ(tile.georeference->transform[0], 1000 + 12.5 * columns[x].first);
            EXPECT_DOUBLE_EQ(tile.georeference->transform[3], 2000 - 10.0 * rows[y].first);
        }
    EXPECT_EQ(columns[0].first + columns[0].second - 1, columns[1].first);
    EXPECT_EQ(columns[2].first + columns[2].second, 100);
}

TEST_F(Export, AMeshHasFewerTrianglesWithinItsErrorAndKeepsItsBorder) {
    // Smooth, as triangles can be: fBm of few octaves at this spacing.
    io::Document document = hills(40, 30);
    for (glm::vec2& height : document.state.bedrock) height *= 0.1F;
    document.state = resampled(document.state, 157, 117);
    io::Heightmap heightmap;
    heightmap.grid = document.state.grid;
    heightmap.heights = document.state.ground();
    const std::size_t all = 2U * 156 * 116;
    std::size_t before = all + 1;
    for (const double error_m : {0.0, 0.1, 1.0}) {
        const io::TerrainMesh mesh = simplified_mesh(heightmap, error_m);
        const std::size_t triangles = mesh.indices.size() / 3;
        EXPECT_LE(mesh.error_m, error_m);
        EXPECT_LE(mesh.mean_m, error_m);
        EXPECT_GE(mesh.farthest_m, mesh.mean_m);
        EXPECT_LE(mesh.farthest_m, 6 * error_m);
        EXPECT_LT(triangles, before) << error_m;
        before = triangles;
        // The border's samples are all there.
        const auto on_border = [&](const glm::vec3& p) { return p.x == 0 || p.y == 0; };
        EXPECT_EQ(std::count_if(mesh.positions.begin(), mesh.positions.end(), on_border), 157 + 117 - 1);
        // Seen from above it covers the rectangle, once.
        double area = 0;
        double folded = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::dvec3 a = mesh.positions[mesh.indices[i]];
            const glm::dvec3 b = mesh.positions[mesh.indices[i + 1]];
            const glm::dvec3 c = mesh.positions[mesh.indices[i + 2]];
            const double twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
            area += twice / 2;
            folded += std::max(-twice, 0.0) / 2;
        }
        // meshoptimizer looks at angles in space, not from above: a sliver may fold.
        EXPECT_LT(folded / area, 0.002) << error_m;
        EXPECT_NEAR(area / (heightmap.grid.width_m() * heightmap.grid.height_m()), 1, 1e-6) << error_m;
    }
    EXPECT_LT(before, all / 5);

    io::ExportSettings settings;
    settings.kind = io::ExportKind::mesh;
    settings.path = path("hills.obj");
    settings.mesh_error_m = 1;
    io::export_terrain(document, settings);
    const std::string obj = io::read_text(settings.path);
    EXPECT_NE(obj.find("\nv "), std::string::npos);
    std::size_t faces = 0;
    for (std::size_t at = obj.find("\nf "); at != std::string::npos; at = obj.find("\nf ", at + 1)) ++faces;
    EXPECT_EQ(faces, before);
}

// What another program finds in a glTF file.
struct FoundMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texture_places;
    std::vector<unsigned> indices;
};

template <typename Value>
std::vector<Value> values_of(const tinygltf::Model& model, int number) {
    const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(number));
    const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
    std::vector<Value> values(accessor.count);
    std::memcpy(values.data(), model.buffers.at(0).data.data() + view.byteOffset, view.byteLength);
    return values;
}

FoundMesh read_gltf(const std::filesystem::path& path) {
    tinygltf::TinyGLTF reader;
    tinygltf::Model model;
    std::string errors;
    std::string warnings;
    const bool read = path.extension() == ".glb"
                          ? reader.LoadBinaryFromFile(&model, &errors, &warnings, path.string())
                          : reader.LoadASCIIFromFile(&model, &errors, &warnings, path.string());
    EXPECT_TRUE(read && errors.empty() && warnings.empty()) << path << errors << warnings;
    const tinygltf::Primitive& triangles = model.meshes.at(0).primitives.at(0);
    const auto& bounds = model.accessors.at(static_cast<std::size_t>(triangles.attributes.at("POSITION")));
    FoundMesh found{values_of<glm::vec3>(model, triangles.attributes.at("POSITION")),
                    values_of<glm::vec3>(model, triangles.attributes.at("NORMAL")),
                    values_of<glm::vec2>(model, triangles.attributes.at("TEXCOORD_0")),
                    values_of<unsigned>(model, triangles.indices)};
    for (const glm::vec3& place : found.positions)
        for (int k = 0; k < 3; ++k) {
            EXPECT_GE(place[k], bounds.minValues.at(static_cast<std::size_t>(k)));
            EXPECT_LE(place[k], bounds.maxValues.at(static_cast<std::size_t>(k)));
        }
    return found;
}

TEST_F(Export, MeshesInTilesMeetAndKnowWhereTheyLie) {
    io::Document document = hills(60, 40);
    // A spacing that no float has.
    document.state.grid.dx = 27.3;
    for (glm::vec2& height : document.state.bedrock) height *= 0.1F;
    const Grid& grid = document.state.grid;
    io::Heightmap whole;
    whole.grid = grid;
    whole.heights = document.state.ground();
    io::ExportSettings settings;
    settings.kind = io::ExportKind::mesh;
    settings.mesh_error_m = 0.5;
    settings.tiles = {3, 2};
    for (const char* name : {"hills.glb", "hills.gltf"}) {
        settings.path = path(name);
        const io::Exported exported = io::export_terrain(document, settings);
        ASSERT_EQ(exported.files.size(), 6U);
        double area = 0;
        std::map<std::pair<long, long>, std::set<float>> heights;
        for (const std::filesystem::path& file : exported.files) {
            const FoundMesh mesh = read_gltf(file);
            ASSERT_FALSE(mesh.positions.empty());
            for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
                // y up, z south.
                const glm::vec3& p = mesh.positions[i];
                const long column = std::lround(p.x / grid.dx);
                const long row = std::lround(p.z / grid.dy) + grid.ny - 1;
                heights[{column, row}].insert(p.y);
                EXPECT_EQ(p.x, static_cast<float>(static_cast<double>(column) * grid.dx));
                EXPECT_EQ(p.y, whole.heights.at(static_cast<std::size_t>(row * grid.nx + column)));
                const glm::dvec3 normal =
                    ground_normal(whole, static_cast<int>(column), static_cast<int>(row));
                EXPECT_NEAR(glm::distance(glm::dvec3(mesh.normals[i]), {normal.x, normal.z, -normal.y}), 0,
                            1e-6);
                EXPECT_NEAR(mesh.texture_places[i].x, (static_cast<double>(column) + 0.5) / grid.nx, 1e-6);
                EXPECT_NEAR(mesh.texture_places[i].y, (static_cast<double>(row) + 0.5) / grid.ny, 1e-6);
            }
            for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
                const glm::dvec3 a = mesh.positions.at(mesh.indices[i]);
                const glm::dvec3 b = mesh.positions.at(mesh.indices[i + 1]);
                const glm::dvec3 c = mesh.positions.at(mesh.indices[i + 2]);
                // Counterclockwise from above, where east is right and south is down.
                area += ((c.x - a.x) * (b.z - a.z) - (b.x - a.x) * (c.z - a.z)) / 2;
            }
        }
        EXPECT_NEAR(area / (grid.width_m() * grid.height_m()), 1, 1e-6);
        for (const auto& [place, found] : heights) EXPECT_EQ(found.size(), 1U);
        // A seam: the same bits on both sides, all samples of it.
        const int seam_column = (grid.nx - 1) / 3;
        const auto seam = [&](const char* tile, bool east) {
            const fs::path file = path(std::string("hills_") + tile + fs::path(name).extension().string());
            const FoundMesh mesh = read_gltf(file);
            const auto x = static_cast<float>(seam_column * grid.dx);
            std::set<std::tuple<float, float, float>> places;
            for (const glm::vec3& p : mesh.positions)
                if (std::abs(p.x - x) < grid.dx / 2) places.insert({p.x, p.y, p.z});
            float edge = mesh.positions.front().x;
            for (const glm::vec3& p : mesh.positions) edge = east ? std::max(edge, p.x) : std::min(edge, p.x);
            EXPECT_EQ(edge, x) << tile;
            return places;
        };
        const auto west_side = seam("x0_y0", true);
        EXPECT_EQ(west_side, seam("x1_y0", false));
        EXPECT_EQ(west_side.size(), static_cast<std::size_t>((grid.ny - 1) / 2 + 1));
    }
    // The same numbers as text.
    settings.tiles = glm::ivec2(1);
    settings.path = path("one.obj");
    io::export_terrain(document, settings);
    const std::string obj = io::read_text(settings.path);
    settings.path = path("one.glb");
    io::export_terrain(document, settings);
    const FoundMesh mesh = read_gltf(settings.path);
    const glm::vec3& p = mesh.positions.front();
    const glm::vec2& t = mesh.texture_places.front();
    EXPECT_NE(obj.find(fmt::format("\nv {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z)), std::string::npos);
    EXPECT_NE(obj.find(fmt::format("\nvt {:.7g} {:.7g}\n", t.x, 1 - t.y)), std::string::npos);
}

TEST_F(Export, ANormalMapIsTheSlope) {
    io::Heightmap plane;
    plane.grid = {20, 30, 2, 4};
    // Rises half a metre a metre eastwards and falls a quarter northwards.
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 20; ++x) plane.heights.push_back(0.5F * 2 * x - 0.25F * 4 * (29 - y));
    io::write_normal_map(path("normal.png"), plane, {0, 20}, {0, 30});
    const io::ColourImage image = io::read_colour_image(path("normal.png"));
    const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.5, 0.25, 1));
    for (const std::size_t pixel : {0U, 19U, 20U * 15 + 7, 599U})
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(image.rgba[4 * pixel + k], (0.5 + 0.5 * normal[static_cast<int>(k)]) * 255, 1);
}

TEST_F(Export, SaysWhatGetsLost) {
    io::Document document = hills(60, 50);
    io::ExportSettings settings;
    settings.path = path("a.tif");
    EXPECT_TRUE(io::losses(document.state, settings).empty());
    document.state.water.assign(document.state.bedrock.size(), glm::vec4(1, 0, 0, 0));
    EXPECT_EQ(io::losses(document.state, settings).size(), 1U);
    settings.path = path("a.png");
    settings.range_m = io::Range(0, 100);
    const std::vector<std::string> lost = io::losses(document.state, settings);
    ASSERT_EQ(lost.size(), 3U);
    EXPECT_NE(lost[1].find("16 bits"), std::string::npos);
    EXPECT_NE(lost[2].find("cut off"), std::string::npos);
}

// What the dialog announces is what is written.
TEST_F(Export, AnnouncesTheSizesThatItWrites) {
    const io::Document document = hills(600, 300);
    for (const auto& [kind, ending] : {std::pair(io::ExportKind::unreal, ".png"),
                                       {io::ExportKind::unity, ".raw"},
                                       {io::ExportKind::godot, ".r16"}})
        for (const glm::ivec2 tiles : {glm::ivec2(1, 1), glm::ivec2(2, 1), glm::ivec2(3, 2)}) {
            io::ExportSettings settings;
            settings.kind = kind;
            settings.path = path(std::string("sizes") + ending);
            settings.tiles = tiles;
            const io::Exported exported = export_terrain(document, settings);
            // Godot's tiles need not be alike.
            if (kind == io::ExportKind::godot && tiles != glm::ivec2(1)) continue;
            const glm::ivec2 written = (exported.tile_samples - 1) * tiles + 1;
            const std::string announced = io::losses(document.state, settings).front();
            if (written == glm::ivec2(600, 300))
                EXPECT_EQ(announced.find("resampled"), std::string::npos) << announced;
            else
                EXPECT_NE(announced.find(fmt::format("takes: {} x {}", written.x, written.y)),
                          std::string::npos)
                    << announced << " where " << written.x << " x " << written.y << " were written";
        }
}

TEST_F(Export, RefusesWhatCannotBeWritten) {
    const io::Document document = hills(60, 50);
    io::ExportSettings settings;
    settings.path = path("a.jpg");
    EXPECT_THROW(io::export_terrain(document, settings), Error);
    settings.path = path("a.png");
    settings.tiles = {0, 1};
    EXPECT_THROW(io::export_terrain(document, settings), Error);
    settings.tiles = {60, 1};
    EXPECT_THROW(io::export_terrain(document, settings), Error);
    settings.kind = io::ExportKind::unity;
    EXPECT_THROW(io::export_terrain(document, settings), Error);
}

}  // namespace
}  // namespace talus::export_test
