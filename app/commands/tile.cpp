#include <fmt/format.h>

#include <filesystem>

#include "app/commands/commands.h"
#include "app/core/long_work.h"
#include "app/core/outputs.h"
#include "app/core/tiled_terrain.h"
#include "sim/error.h"
#include "sim/io/endings.h"
#include "sim/io/tile_writer.h"
#include "sim/terrain/generate.h"

namespace talus::app {
namespace {

// What is read comes once; more than a row of blocks for each thread gains nothing.
constexpr std::size_t read_memory_bytes = std::size_t{256} << 20;

io::TiledSource file_source(const TileOptions& options) {
    const io::TiledFile file(options.input, options.import);
    if (file.is_made_of(options.output))
        throw Error(fmt::format("'{}' is read from, give another name to write to", options.output));
    for (const std::string& note : file.notes()) say("note: " + note);
    return file.source();
}

io::TiledSource generated_source(const TileOptions& options) {
    if (glm::any(glm::lessThan(options.size, glm::ivec2(2))))
        throw Error(fmt::format("--generate {},{}x{} cannot be made, each side must have at least 2 samples",
                                options.kind, options.size.x, options.size.y));
    const double spacing_m = options.import.spacing_m.value_or(1);
    io::TiledSource source;
    source.grid = {options.size.x, options.size.y, spacing_m, spacing_m};
    const auto height =
        generate_sample_by_sample(source.grid, {options.kind, options.seed, options.relief_m});
    source.make_reader = [height]() -> ReadSamples {
        return [height](int, const TileSamples& samples, std::vector<float>& heights) {
            heights.resize(static_cast<std::size_t>(samples.count.x) * samples.count.y);
            std::size_t at = 0;
            for (int y = 0; y < samples.count.y; ++y)
                for (int x = 0; x < samples.count.x; ++x)
                    heights[at++] = height(samples.first.x + x, samples.first.y + y);
        };
    };
    return source;
}

}  // namespace

void tile(const TileOptions& options) {
    const std::string ending = io::ending_of(options.output);
    if (ending != ".tif" && ending != ".tiff")
        throw Error(fmt::format("cannot write '{}': its ending must be .tif or .tiff", options.output));
    check_folder(options.output);
    io::limit_read_memory(read_memory_bytes);
    const io::TiledSource source = options.input.empty() ? generated_source(options) : file_source(options);
    {
        LongWork work(fmt::format("writing '{}'", options.output));
        if (!io::write_tiled(options.output, source, [&](double share) { return work(share); }))
            throw Error(fmt::format("interrupted, '{}' was not written", options.output));
    }
    const TiledTerrain terrain = open_tiled({options.output, {}}, on_terminal());
    fmt::print("{}: {} x {} samples, {} levels, {:.1f} to {:.1f} m, {:.1f} MiB\n", options.output,
               terrain.tree.grid().nx, terrain.tree.grid().ny, terrain.tree.levels().size(), terrain.lowest_m,
               terrain.highest_m,
               static_cast<double>(std::filesystem::file_size(options.output)) / (1 << 20));
}

}  // namespace talus::app
