#include "sim/io/raster_values.h"

#include <fmt/format.h>
#include <gdal_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "sim/error.h"
#include "sim/io/gdal_dataset.h"

namespace talus::io {

namespace fs = std::filesystem;

namespace {

// Pixels in a row that is read as a whole.
constexpr int widest = 4000000;
constexpr float says_nothing = std::numeric_limits<float>::quiet_NaN();

struct FreeWarpOptions {
    void operator()(GDALWarpAppOptions* options) const { GDALWarpAppOptionsFree(options); }
};

// Errors on the way count too: GDAL reads some damaged files as zeros and only warns.
void check_read(const fs::path& path, bool succeeded) {
    if (!succeeded || CPLGetLastErrorType() >= CE_Failure)
        throw Error(fmt::format("'{}' cannot be read: {}", path.string(), gdal_says()));
}

bool is_placed(GDALDataset& raster) {
    std::array<double, 6> t{};
    return raster.GetGeoTransform(t.data()) == CE_None && t[1] * t[5] - t[2] * t[4] != 0;
}

// Where both lie on Earth.
std::vector<float> placed_values(const fs::path& path, GDALDataset& raster, const Grid& grid,
                                 const Georeference& ground) {
    std::vector<float> values(grid.count(), says_nothing);
    const Dataset over(GetGDALDriverManager()->GetDriverByName("MEM")->Create("", grid.nx, grid.ny, 1,
                                                                              GDT_Float32, nullptr));
    if (!over)
        throw Error(fmt::format("'{}' cannot be laid over the terrain: {}", path.string(), gdal_says()));
    std::array<double, 6> transform = ground.transform;
    over->SetGeoTransform(transform.data());
    // Where one says no system, both have the same.
    if (!ground.wkt.empty() && raster.GetSpatialRef()) over->SetProjection(ground.wkt.c_str());
    GDALRasterBand& band = *over->GetRasterBand(1);
    band.SetNoDataValue(says_nothing);
    band.Fill(says_nothing);
    std::array<std::string, 4> words = {"-r", "near", "-et", "0"};
    std::array<char*, 5> pointers = {words[0].data(), words[1].data(), words[2].data(), words[3].data(),
                                     nullptr};
    const std::unique_ptr<GDALWarpAppOptions, FreeWarpOptions> options(
        GDALWarpAppOptionsNew(pointers.data(), nullptr));
    GDALDatasetH source = &raster;
    CPLErrorReset();
    check_read(path, GDALWarp(nullptr, over.get(), 1, &source, options.get(), nullptr) != nullptr);
    check_read(path, band.RasterIO(GF_Read, 0, 0, grid.nx, grid.ny, values.data(), grid.nx, grid.ny,
                                   GDT_Float32, 0, 0, nullptr) == CE_None);
    return values;
}

// The nearest of `pixels` to each of `samples`, the outer ones on the outer ones.
std::vector<int> nearest_pixels(int samples, int pixels) {
    std::vector<int> nearest;
    nearest.reserve(static_cast<std::size_t>(samples));
    for (int i = 0; i < samples; ++i)
        nearest.push_back(static_cast<int>(std::lround(i * (pixels - 1.0) / (samples - 1.0))));
    return nearest;
}

// In the order of Talus: the north row first, columns eastwards.
std::vector<float> stretched_values(const fs::path& path, GDALDataset& raster, const Grid& grid) {
    const RasterPlace place = place_of(raster);
    GDALRasterBand& band = *raster.GetRasterBand(1);
    const bool is_whole = (band.GetMaskFlags() & GMF_ALL_VALID) != 0;
    const int width = raster.GetRasterXSize();
    if (width > widest)
        throw Error(fmt::format("'{}' has {} pixels in a row and no place, at most {} are read",
                                path.string(), width, widest));
    std::vector<float> row(static_cast<std::size_t>(width));
    std::vector<std::uint8_t> said(row.size(), 255);
    std::vector<int> columns = nearest_pixels(grid.nx, width);
    if (place.east_first) std::reverse(columns.begin(), columns.end());
    std::vector<int> rows = nearest_pixels(grid.ny, raster.GetRasterYSize());
    if (place.south_first) std::reverse(rows.begin(), rows.end());
    std::vector<float> values;
    values.reserve(grid.count());
    int held = -1;
    for (const int wanted : rows) {
        if (wanted != held) {
            CPLErrorReset();
            check_read(path, band.RasterIO(GF_Read, 0, wanted, width, 1, row.data(), width, 1, GDT_Float32, 0,
                                           0, nullptr) == CE_None);
            if (!is_whole)
                check_read(path, band.GetMaskBand()->RasterIO(GF_Read, 0, wanted, width, 1, said.data(),
                                                              width, 1, GDT_Byte, 0, 0, nullptr) == CE_None);
            held = wanted;
        }
        for (const int column : columns) {
            const auto at = static_cast<std::size_t>(column);
            values.push_back(said[at] != 0 ? row[at] : says_nothing);
        }
    }
    return values;
}

void scale_by_band(GDALRasterBand& band, std::vector<float>& values) {
    const double scale = band.GetScale();
    const double offset = band.GetOffset();
    if (scale == 1 && offset == 0) return;
    for (float& value : values) value = static_cast<float>(value * scale + offset);
}

}  // namespace

RasterValues read_raster_values(const fs::path& path, const Grid& grid,
                                const std::optional<Georeference>& georeference) {
    const Dataset raster = open_raster(path);
    if (raster->GetRasterCount() != 1)
        throw Error(fmt::format("'{}' has {} bands, a raster of numbers has 1", path.string(),
                                raster->GetRasterCount()));
    const bool placed = georeference && is_placed(*raster);
    RasterValues read;
    read.values =
        placed ? placed_values(path, *raster, grid, *georeference) : stretched_values(path, *raster, grid);
    scale_by_band(*raster->GetRasterBand(1), read.values);
    const auto silent =
        std::count_if(read.values.begin(), read.values.end(), [](float v) { return std::isnan(v); });
    if (static_cast<std::size_t>(silent) == read.values.size())
        throw Error(placed
                        ? fmt::format("'{}' lies beside the terrain, or holds no number there", path.string())
                        : fmt::format("'{}' holds no number", path.string()));
    if (std::any_of(read.values.begin(), read.values.end(), [](float v) { return std::isinf(v); }))
        throw Error(fmt::format("'{}' holds numbers without bounds", path.string()));
    const bool fits = raster->GetRasterXSize() == grid.nx && raster->GetRasterYSize() == grid.ny;
    if (!placed && (!fits || georeference || raster->GetSpatialRef()))
        read.notes.push_back(fmt::format(
            "'{}' and the terrain do not both say where they lie: it is stretched over the terrain",
            path.string()));
    if (silent > 0)
        read.notes.push_back(fmt::format("'{}' says nothing at {} of {} samples, which stay as they are",
                                         path.string(), silent, read.values.size()));
    return read;
}

}  // namespace talus::io
