#include "sim/io/heightmap_formats.h"
#include "sim/io/endings.h"

#include <algorithm>

namespace talus::io {

const std::vector<HeightmapFormat>& heightmap_formats() {
    static const std::vector<HeightmapFormat> formats = {
        {.name = "GeoTIFF",
         .endings = {".tif", ".tiff"},
         .read = read_geographic,
         .write = write_geotiff,
         .gdal_driver = "GTiff"},
        {.name = "SRTM", .endings = {".hgt"}, .read = read_geographic, .gdal_driver = "SRTMHGT"},
        {.name = "ESRI ASCII grid", .endings = {".asc"}, .read = read_geographic, .gdal_driver = "AAIGrid"},
        {.name = "ESRI BIL", .endings = {".bil"}, .read = read_geographic, .gdal_driver = "EHdr"},
        {.name = "mosaic", .endings = {".vrt"}, .read = read_geographic, .gdal_driver = "VRT"},
        {.name = "EXR", .endings = {".exr"}, .read = read_picture, .write = write_picture},
        {.name = "PNG of 16 bits",
         .endings = {".png"},
         .read = read_picture,
         .write = write_picture,
         .rounds = true},
        {.name = "raw integers",
         .endings = {".r16"},
         .read = read_raw,
         .write = write_raw,
         .rounds = true,
         .headerless = true},
        {.name = "raw floats", .endings = {".r32"}, .read = read_raw, .write = write_raw, .headerless = true},
        {.name = "raw", .endings = {".raw"}, .read = read_raw, .headerless = true},
    };
    return formats;
}

namespace {

std::vector<std::string> endings_where(bool (*wanted)(const HeightmapFormat&)) {
    std::vector<std::string> endings;
    for (const HeightmapFormat& format : heightmap_formats())
        if (wanted(format)) endings.insert(endings.end(), format.endings.begin(), format.endings.end());
    return endings;
}

}  // namespace

const HeightmapFormat* format_of(const std::filesystem::path& path) {
    const std::string ending = ending_of(path);
    for (const HeightmapFormat& format : heightmap_formats())
        if (std::find(format.endings.begin(), format.endings.end(), ending) != format.endings.end())
            return &format;
    return nullptr;
}

std::vector<std::string> readable_endings() {
    return endings_where([](const HeightmapFormat&) { return true; });
}

std::vector<std::string> writable_endings() {
    return endings_where([](const HeightmapFormat& format) { return format.write != nullptr; });
}

bool can_write_heightmap(const std::filesystem::path& path) {
    const HeightmapFormat* format = format_of(path);
    return format && format->write;
}

}  // namespace talus::io
