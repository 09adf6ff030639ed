#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/commands/commands.h"
#include "app/core/outputs.h"
#include "sim/error.h"
#include "sim/io/export.h"
#include "sim/io/mesh_formats.h"

namespace talus::app {
namespace {

io::ExportSettings settings_of(const ConvertOptions& options) {
    const std::vector<std::string>& kinds = io::export_kind_names();
    io::ExportSettings settings;
    settings.path = options.output;
    settings.range_m = options.range_m;
    settings.tiles = options.tiles;
    settings.mesh_error_m = options.mesh_error_m;
    if (!options.layer.empty()) settings.layer = options.layer;
    if (options.kind.empty()) {
        settings.kind = io::mesh_format_of(options.output) ? io::ExportKind::mesh : io::ExportKind::heightmap;
        return settings;
    }
    const auto kind = std::find(kinds.begin(), kinds.end(), options.kind);
    if (kind == kinds.end())
        throw Error(fmt::format("--for '{}' is not known, it must be one of: {}", options.kind,
                                fmt::join(kinds, ", ")));
    settings.kind = static_cast<io::ExportKind>(kind - kinds.begin());
    return settings;
}

// Of maps instead of a layer. An engine takes weights, unless values are asked for.
io::ExportSettings maps_of(const ConvertOptions& options, io::ExportSettings settings) {
    if (!options.layer.empty() || settings.tiles != glm::ivec2(1) || options.kind == "mesh" ||
        options.kind == "normal map")
        throw Error(
            "--maps are written in one piece: leave out --layer, --tiles, and --for mesh or 'normal map'");
    const bool for_engine = io::is_engine(settings.kind);
    settings.samples_for = for_engine ? settings.kind : io::ExportKind::heightmap;
    settings.kind = io::ExportKind::maps;
    settings.maps = options.maps;
    settings.weight_bits = options.weight_bits.value_or(for_engine ? 8 : 0);
    return settings;
}

}  // namespace

void convert(const ConvertOptions& options) {
    io::ExportSettings settings = settings_of(options);
    if (!options.maps.empty()) settings = maps_of(options, settings);
    if (options.weight_bits && options.maps.empty()) throw Error("--weights is of maps: name them by --maps");
    check_folder(options.output);
    const io::Document document = open_document(options.input, options.import);
    for (const std::string& note : document.notes) say("note: " + note);
    // A document stays one, with all its layers.
    if (settings.kind == io::ExportKind::heightmap && settings.tiles == glm::ivec2(1))
        return write_terrain(options.output, document, options.layer, options.range_m);
    const io::Exported exported = export_terrain(document, settings);
    for (const auto& [name, value] : exported.values) fmt::print("{}: {}\n", name, value);
}

}  // namespace talus::app
