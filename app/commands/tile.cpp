#include <fmt/format.h>

#include <filesystem>

#include "app/commands/commands.h"
#include "app/core/long_work.h"
#include "app/core/outputs.h"
#include "app/core/tiled_terrain.h"
#include "sim/error.h"
#include "sim/io/endings.h"
#include "sim/io/photo_file.h"
#include "sim/io/photo_writer.h"
#include "sim/io/tile_writer.h"
#include "sim/terrain/generate.h"

namespace talus::app {
namespace {

// What is read comes once; more than a row of blocks for each thread gains nothing.
constexpr std::size_t read_memory_bytes = std::size_t{256} << 20;

io::TiledSource file_source(const TileOptions& options) {
    const io::TiledFile file(options.input, options.import);
    if (io::is_made_of(options.input, options.output))
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

void check_output(const std::string& output) {
    const std::string ending = io::ending_of(output);
    if (ending != ".tif" && ending != ".tiff")
        throw Error(fmt::format("cannot write '{}': its ending must be .tif or .tiff", output));
    check_folder(output);
}

double mebibytes_of(const std::string& file) {
    return static_cast<double>(std::filesystem::file_size(file)) / (1 << 20);
}

void tile_terrain(const TileOptions& options) {
    const io::TiledSource source = options.input.empty() ? generated_source(options) : file_source(options);
    {
        LongWork work(fmt::format("writing '{}'", options.output));
        if (!io::write_tiled(options.output, source, [&](double share) { return work(share); }))
            throw Error(fmt::format("interrupted, '{}' was not written", options.output));
    }
    const TiledTerrain terrain = open_tiled({options.output, {}}, on_terminal());
    fmt::print("{}: {} x {} samples, {} levels, {:.1f} to {:.1f} m, {:.1f} MiB\n", options.output,
               terrain.tree.grid().nx, terrain.tree.grid().ny, terrain.tree.levels().size(), terrain.lowest_m,
               terrain.highest_m, mebibytes_of(options.output));
}

void check_photo(const TileOptions& options) {
    check_output(options.photo_output);
    io::check_colours(options.photo);
    if (io::is_made_of(options.photo, options.photo_output))
        throw Error(fmt::format("'{}' is read from, give another name to write to", options.photo_output));
}

void tile_photo(const TileOptions& options) {
    const std::string& output = options.photo_output;
    {
        LongWork work(fmt::format("writing '{}'", output));
        if (!io::write_photo(options.photo, output, [&](double share) { return work(share); }))
            throw Error(fmt::format("interrupted, '{}' was not written", output));
    }
    const io::PhotoFile photo(output, {});
    fmt::print("{}: {} x {} texels, {:.1f} MiB\n", output, photo.texels().x, photo.texels().y,
               mebibytes_of(output));
}

}  // namespace

void tile(const TileOptions& options) {
    const bool both = !options.output.empty() && !options.photo.empty();
    std::error_code ignored;
    if (both && std::filesystem::weakly_canonical(options.output, ignored) ==
                    std::filesystem::weakly_canonical(options.photo_output, ignored))
        throw Error(fmt::format("'{}' cannot be terrain and photo at once, give them two names",
                                options.photo_output));
    if (!options.output.empty()) check_output(options.output);
    if (both && io::is_made_of(options.photo, options.output))
        throw Error(fmt::format("'{}' is the photo, give another name to write to", options.output));
    if (both && !options.input.empty() && io::is_made_of(options.input, options.photo_output))
        throw Error(fmt::format("'{}' is read from, give another name to write to", options.photo_output));
    // Before the terrain's long work.
    if (!options.photo.empty()) check_photo(options);
    io::limit_read_memory(read_memory_bytes);
    if (!options.output.empty()) tile_terrain(options);
    if (!options.photo.empty()) tile_photo(options);
}

}  // namespace talus::app
