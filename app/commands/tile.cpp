#include <fmt/format.h>

#include <filesystem>

#include "app/commands/commands.h"
#include "app/core/long_work.h"
#include "app/core/outputs.h"
#include "app/core/tiled_terrain.h"
#include "sim/error.h"
#include "sim/io/endings.h"
#include "sim/io/tile_writer.h"

namespace talus::app {
namespace {

// What is read comes once; more than a row of blocks for each thread gains nothing.
constexpr std::size_t read_memory_bytes = std::size_t{256} << 20;

}  // namespace

void tile(const TileOptions& options) {
    const std::string ending = io::ending_of(options.output);
    if (ending != ".tif" && ending != ".tiff")
        throw Error(fmt::format("cannot write '{}': its ending must be .tif or .tiff", options.output));
    check_folder(options.output);
    io::limit_read_memory(read_memory_bytes);
    const io::TiledFile input(options.input, options.import);
    for (const std::string& note : input.notes()) say("note: " + note);
    {
        LongWork work(fmt::format("writing '{}'", options.output));
        if (!io::write_tiled(options.output, input.source(), [&](double share) { return work(share); }))
            throw Error(fmt::format("interrupted, '{}' was not written", options.output));
    }
    const TiledTerrain terrain = open_tiled(options.output, {});
    fmt::print("{}: {} x {} samples, {} levels, {:.1f} to {:.1f} m, {:.1f} MiB\n", options.output,
               terrain.tree.grid().nx, terrain.tree.grid().ny, terrain.tree.levels().size(), terrain.lowest_m,
               terrain.highest_m,
               static_cast<double>(std::filesystem::file_size(options.output)) / (1 << 20));
}

}  // namespace talus::app
