#include "app/core/sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "sim/error.h"
#include "sim/io/document.h"
#include "sim/io/raster_values.h"
#include "sim/terrain/stamp_shapes.h"
#include "sim/terrain/state_hash.h"

namespace talus::app {
namespace {

// The terrain in a file, and how to find it again.
std::pair<Source, TerrainState> read_source(const std::string& path, const std::string& import_guess) {
    TerrainState state = io::open_document(path, io::import_settings_from(import_guess)).state;
    Source source{std::filesystem::absolute(path).string(), import_guess, state_hash(state)};
    return {std::move(source), std::move(state)};
}

void check_same(const Source& recorded, const Source& found) {
    if (recorded.hash != found.hash)
        throw Error(fmt::format(
            "'{}' holds what has hash {:016x} where the journal found {:016x}: it has changed since",
            recorded.path, found.hash, recorded.hash));
}

std::shared_ptr<const Stamp> stamp_in(const TerrainState& state) {
    return std::make_shared<Stamp>(stamp_of(state.grid, state.ground()));
}

}  // namespace

Import read_import(const std::string& path, const io::ImportSettings& import) {
    auto [source, state] = read_source(path, to_text(import));
    return {source, std::make_shared<TerrainState>(std::move(state))};
}

ChooseStamp shelf_stamp(const std::string& name) {
    auto stamp = std::make_shared<Stamp>(shaped_stamp(name));
    const std::uint64_t hash = bytes_hash(std::as_bytes(std::span(stamp->heights)));
    return {{stamp_shelf + name, "", hash}, {}, std::move(stamp)};
}

ChooseStamp read_stamp(const std::string& path, const io::ImportSettings& import) {
    const auto [source, state] = read_source(path, to_text(import));
    return {source, {}, stamp_in(state)};
}

ReadRaster read_raster(const std::string& number, const std::string& path, const Grid& grid,
                       const std::optional<Georeference>& georeference) {
    const std::string& name = painted_number_named(number).name;
    io::RasterValues read = io::read_raster_values(path, grid, georeference);
    const std::uint64_t hash = bytes_hash(std::as_bytes(std::span(read.values)));
    return {{name,
             {std::filesystem::absolute(path).string(), "", hash},
             std::make_shared<const std::vector<float>>(std::move(read.values))},
            std::move(read.notes)};
}

void read_sources(Operation& operation, const Simulation& simulation, bool as_recorded) {
    if (auto* import = std::get_if<Import>(&operation)) {
        auto [source, state] = read_source(import->source.path, import->source.import_guess);
        check_same(import->source, source);
        import->state = std::make_shared<TerrainState>(std::move(state));
    } else if (auto* made = std::get_if<ChooseStamp>(&operation);
               made && made->source.path.starts_with(stamp_shelf)) {
        ChooseStamp again = shelf_stamp(made->source.path.substr(stamp_shelf.size()));
        check_same(made->source, again.source);
        made->stamp = std::move(again.stamp);
    } else if (auto* choose = std::get_if<ChooseStamp>(&operation); choose && !choose->source.path.empty()) {
        const auto [source, state] = read_source(choose->source.path, choose->source.import_guess);
        check_same(choose->source, source);
        choose->stamp = stamp_in(state);
    } else if (auto* take = std::get_if<TakeRaster>(&operation)) {
        const ReadRaster found = read_raster(take->number, take->source.path, simulation.terrain().grid(),
                                             simulation.moment_state().georeference);
        if (as_recorded) check_same(take->source, found.take.source);
        take->values = found.take.values;
    }
}

void rescale(Operation& operation, glm::dvec2 ratio) {
    const auto scaled = [](int count, double by) {
        return std::max(min_samples, 1 + static_cast<int>(std::lround((count - 1) * by)));
    };
    if (auto* to = std::get_if<Resample>(&operation)) {
        *to = {scaled(to->nx, ratio.x), scaled(to->ny, ratio.y)};
    } else if (auto* import = std::get_if<Import>(&operation); import && import->state) {
        const Grid& grid = import->state->grid;
        import->state = std::make_shared<TerrainState>(
            resampled(*import->state, scaled(grid.nx, ratio.x), scaled(grid.ny, ratio.y)));
    }
}

}  // namespace talus::app
