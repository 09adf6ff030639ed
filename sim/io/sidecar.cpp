#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/heightmap.h"
#include "sim/terrain/state_hash.h"

namespace talus::io {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

fs::path sidecar_path(const fs::path& path) {
    return path.string() + ".json";
}

std::string hash_of_file(const fs::path& path) {
    const std::string content = read_text(path);
    return fmt::format("{:016x}", bytes_hash(std::as_bytes(std::span(content))));
}

json to_json(const Georeference& georeference) {
    return {{"wkt", georeference.wkt}, {"transform", georeference.transform}};
}

}  // namespace

void write_sidecar(const fs::path& path, const Heightmap& heightmap, const std::string& sample_type,
                   std::optional<Range> range) {
    json side = {{"talus_heightmap", 1},       {"nx", heightmap.grid.nx},   {"ny", heightmap.grid.ny},
                 {"dx_m", heightmap.grid.dx},  {"dy_m", heightmap.grid.dy}, {"samples", sample_type},
                 {"hash", hash_of_file(path)}, {"byte_order", "little"},    {"rows", "north first"}};
    if (range) side["range_m"] = {range->x, range->y};
    if (heightmap.georeference) side["georeference"] = to_json(*heightmap.georeference);
    write_atomically(sidecar_path(path), side.dump(2) + "\n");
}

std::optional<Sidecar> read_sidecar(const fs::path& path, std::vector<std::string>& notes) {
    std::error_code ignored;
    if (!fs::is_regular_file(sidecar_path(path), ignored)) return std::nullopt;
    try {
        const json side = json::parse(read_text(sidecar_path(path)));
        if (!side.contains("talus_heightmap")) return std::nullopt;
        if (side.at("hash").get<std::string>() != hash_of_file(path)) {
            notes.push_back(fmt::format("'{}' was written for other content and was not used",
                                        sidecar_path(path).string()));
            return std::nullopt;
        }
        Sidecar read;
        read.dx = side.at("dx_m").get<double>();
        read.dy = side.at("dy_m").get<double>();
        read.raw = RawLayout{side.at("nx"), side.at("ny"), side.at("byte_order") == "big",
                             side.at("rows") == "south first"};
        if (side.contains("range_m")) read.range = Range(side["range_m"].at(0), side["range_m"].at(1));
        if (side.contains("georeference"))
            read.georeference =
                Georeference{side["georeference"].at("wkt"), side["georeference"].at("transform")};
        return read;
    } catch (const json::exception& error) {
        throw Error(fmt::format("'{}' is not the sidecar that Talus writes: {}", sidecar_path(path).string(),
                                error.what()));
    }
}

std::string to_text(const ImportSettings& settings) {
    json text = json::object();
    if (settings.spacing_m) text["spacing_m"] = *settings.spacing_m;
    if (settings.range_m) text["range_m"] = {settings.range_m->x, settings.range_m->y};
    if (settings.raw)
        text["raw"] = {settings.raw->nx, settings.raw->ny, settings.raw->big_endian,
                       settings.raw->south_first};
    if (settings.window)
        text["window"] = {settings.window->west, settings.window->south, settings.window->east,
                          settings.window->north};
    return text.dump();
}

ImportSettings import_settings_from(const std::string& text) {
    try {
        const json parsed = json::parse(text);
        ImportSettings settings;
        if (parsed.contains("spacing_m")) settings.spacing_m = parsed["spacing_m"].get<double>();
        if (parsed.contains("range_m"))
            settings.range_m = glm::dvec2(parsed["range_m"].at(0), parsed["range_m"].at(1));
        if (parsed.contains("raw")) {
            const json& raw = parsed["raw"];
            settings.raw = RawLayout{raw.at(0), raw.at(1), raw.at(2), raw.at(3)};
        }
        if (parsed.contains("window")) {
            const json& window = parsed["window"];
            settings.window = FileWindow{window.at(0), window.at(1), window.at(2), window.at(3)};
        }
        return settings;
    } catch (const json::exception& error) {
        throw Error(fmt::format("import settings '{}' cannot be read: {}", text, error.what()));
    }
}

}  // namespace talus::io
