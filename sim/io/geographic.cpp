// GeoTIFF, HGT and ESRI ASC by GDAL, the one reader of geographic formats.
#include <fmt/format.h>
#include <gdal_alg.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/gdal_dataset.h"
#include "sim/io/heightmap_formats.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;

// Fills what is not `valid`, by inverse distance (GDALFillNodata), and notes how many.
void fill_voids(const fs::path& path, Heightmap& heightmap, const std::vector<GByte>& valid) {
    const auto voids = std::count(valid.begin(), valid.end(), GByte{0});
    if (voids == 0) return;
    if (static_cast<std::size_t>(voids) == valid.size())
        throw Error(fmt::format("'{}' holds nothing but nodata, a heightmap was expected", path.string()));
    const int nx = heightmap.grid.nx;
    const int ny = heightmap.grid.ny;
    GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
    const Dataset values(memory->Create("", nx, ny, 1, GDT_Float32, nullptr));
    const Dataset mask(memory->Create("", nx, ny, 1, GDT_Byte, nullptr));
    GDALRasterBand* band = values->GetRasterBand(1);
    GDALRasterBand* mask_band = mask->GetRasterBand(1);
    std::vector<GByte> mask_values = valid;
    const std::vector<float> before = heightmap.heights;
    CPLErr error =
        band->RasterIO(GF_Write, 0, 0, nx, ny, heightmap.heights.data(), nx, ny, GDT_Float32, 0, 0);
    if (error == CE_None)
        error = mask_band->RasterIO(GF_Write, 0, 0, nx, ny, mask_values.data(), nx, ny, GDT_Byte, 0, 0);
    if (error == CE_None) error = GDALFillNodata(band, mask_band, nx + ny, 0, 0, nullptr, nullptr, nullptr);
    if (error == CE_None)
        error = band->RasterIO(GF_Read, 0, 0, nx, ny, heightmap.heights.data(), nx, ny, GDT_Float32, 0, 0);
    if (error != CE_None)
        throw Error(fmt::format("'{}': its voids cannot be filled: {}", path.string(), gdal_says()));
    const float void_value =
        before[static_cast<std::size_t>(std::find(valid.begin(), valid.end(), GByte{0}) - valid.begin())];
    for (std::size_t i = 0; i < valid.size(); ++i)
        if (valid[i] == 0 && (heightmap.heights[i] == void_value || !std::isfinite(heightmap.heights[i])))
            throw Error(fmt::format("'{}' has voids too far from any sample to be filled, fill them before",
                                    path.string()));
    heightmap.notes.push_back(fmt::format("{} void samples were filled by interpolation", voids));
}

// Throws talus::Error where GDAL cannot open the file with one of the formats' drivers.
Dataset opened(const fs::path& path) {
    std::vector<const char*> drivers;
    for (const HeightmapFormat& format : heightmap_formats())
        if (format.gdal_driver) drivers.push_back(format.gdal_driver);
    drivers.push_back(nullptr);
    Dataset dataset(static_cast<GDALDataset*>(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers.data(), nullptr, nullptr)));
    if (!dataset) throw Error(fmt::format("'{}' cannot be read: {}", path.string(), gdal_says()));
    return dataset;
}

void read_samples(const fs::path& path, GDALRasterBand& band, Heightmap& heightmap) {
    const int nx = heightmap.grid.nx;
    const int ny = heightmap.grid.ny;
    heightmap.heights.resize(heightmap.grid.count());
    // Errors on the way count too: GDAL reads some damaged files as zeros and only warns.
    CPLErrorReset();
    if (band.RasterIO(GF_Read, 0, 0, nx, ny, heightmap.heights.data(), nx, ny, GDT_Float32, 0, 0) !=
            CE_None ||
        CPLGetLastErrorType() >= CE_Failure)
        throw Error(fmt::format("'{}' cannot be read: {}", path.string(), gdal_says()));
}

// Brings the samples into the order of Talus, and takes the file's place.
void place(const RasterPlace& place, Heightmap& heightmap) {
    const int nx = heightmap.grid.nx;
    const int ny = heightmap.grid.ny;
    const auto row = [&](int number) {
        return heightmap.heights.begin() + static_cast<std::ptrdiff_t>(number) * nx;
    };
    for (int at = 0; place.south_first && at < ny / 2; ++at)
        std::swap_ranges(row(at), row(at + 1), row(ny - 1 - at));
    for (int at = 0; place.east_first && at < ny; ++at) std::reverse(row(at), row(at + 1));
    heightmap.grid.dx = place.dx_m;
    heightmap.grid.dy = place.dy_m;
    heightmap.georeference = place.georeference;
    heightmap.notes.insert(heightmap.notes.end(), place.notes.begin(), place.notes.end());
}

}  // namespace

Heightmap read_geographic(const fs::path& path, const ImportSettings& settings) {
    start_gdal();
    const Dataset dataset = opened(path);
    check_file_size(path, dataset->GetRasterXSize(), dataset->GetRasterYSize());
    if (dataset->GetRasterCount() < 1)
        throw Error(fmt::format("'{}' holds no band of samples", path.string()));
    GDALRasterBand* band = dataset->GetRasterBand(1);
    const GDALDataType type = band->GetRasterDataType();
    if (GDALDataTypeIsComplex(type))
        throw Error(fmt::format("'{}' holds complex numbers, heights are real", path.string()));

    Heightmap heightmap;
    heightmap.grid = {dataset->GetRasterXSize(), dataset->GetRasterYSize(), 1, 1};
    heightmap.kind = fmt::format("{}, {}", dataset->GetDriver()->GetDescription(), GDALGetDataTypeName(type));
    if (dataset->GetRasterCount() > 1)
        heightmap.notes.push_back(
            fmt::format("the file has {} bands, the first was read", dataset->GetRasterCount()));
    read_samples(path, *band, heightmap);

    int has_nodata = 0;
    const double nodata = band->GetNoDataValue(&has_nodata);
    if (has_nodata) {
        const auto void_value = static_cast<float>(nodata);
        std::vector<GByte> valid(heightmap.heights.size());
        std::transform(heightmap.heights.begin(), heightmap.heights.end(), valid.begin(), [&](float h) {
            return static_cast<GByte>(h == void_value || (std::isnan(nodata) && std::isnan(h)) ? 0 : 255);
        });
        fill_voids(path, heightmap, valid);
    }

    place(place_of(*dataset), heightmap);
    // Whole numbers that lie nowhere are a picture's brightness.
    const bool picture = (type == GDT_Byte || type == GDT_UInt16) && !heightmap.georeference && !has_nodata &&
                         !dataset->GetSpatialRef();
    if (!heightmap.georeference && !settings.spacing_m) {
        heightmap.notes.push_back("the file says no spacing, 1 m a sample was taken: --spacing sets it");
    }
    if (settings.spacing_m && heightmap.georeference) {
        heightmap.georeference.reset();
        heightmap.notes.push_back(
            "--spacing overrides the file's own, so its coordinate system no longer holds and is dropped");
    }

    if (picture)
        scale_integers(heightmap, type == GDT_Byte ? 255 : 65535, std::nullopt, settings);
    else if (GDALDataTypeIsFloating(type))
        scale_floats(heightmap, settings);
    else if (settings.range_m)
        heightmap.notes.push_back(range_unused);
    return heightmap;
}

// Of floats, so that no range is needed.
void write_geotiff(const fs::path& path, const Heightmap& heightmap, std::optional<Range>) {
    start_gdal();
    const std::string memory_path = "/vsimem/talus_out.tif";
    const int nx = heightmap.grid.nx;
    const int ny = heightmap.grid.ny;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    {
        Dataset dataset(driver->Create(memory_path.c_str(), nx, ny, 1, GDT_Float32, nullptr));
        if (!dataset) throw Error(fmt::format("cannot write '{}': {}", path.string(), gdal_says()));
        // Without a place on Earth the south-west sample, a pixel's centre, lies at (0, 0).
        std::array<double, 6> transform = {
            -heightmap.grid.dx / 2, heightmap.grid.dx, 0, (ny - 0.5) * heightmap.grid.dy, 0,
            -heightmap.grid.dy};
        if (heightmap.georeference) {
            transform = heightmap.georeference->transform;
            OGRSpatialReference system;
            if (!heightmap.georeference->wkt.empty() &&
                system.importFromWkt(heightmap.georeference->wkt.c_str()) == OGRERR_NONE) {
                system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
                dataset->SetSpatialRef(&system);
            }
        }
        dataset->SetGeoTransform(transform.data());
        std::vector<float> heights = heightmap.heights;
        const CPLErr error = dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, nx, ny, heights.data(), nx,
                                                                 ny, GDT_Float32, 0, 0);
        if (error != CE_None) throw Error(fmt::format("cannot write '{}': {}", path.string(), gdal_says()));
    }
    vsi_l_offset length = 0;
    const GByte* content = VSIGetMemFileBuffer(memory_path.c_str(), &length, FALSE);
    if (!content) throw Error(fmt::format("cannot write '{}': {}", path.string(), gdal_says()));
    try {
        write_atomically(path, std::as_bytes(std::span(content, static_cast<std::size_t>(length))));
    } catch (const Error&) {
        VSIUnlink(memory_path.c_str());
        throw;
    }
    VSIUnlink(memory_path.c_str());
}

}  // namespace talus::io
