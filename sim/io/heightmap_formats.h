#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/io/heightmap.h"

namespace talus::io {

/// A format of heightmaps: a line of `heightmap_formats()`, and a file of this folder that reads and writes
/// it.
struct HeightmapFormat {
    std::string name;                  ///< as dialogs call it
    std::vector<std::string> endings;  ///< of its files, in lower case, with their dots
    Heightmap (*read)(const std::filesystem::path&, const ImportSettings&);
    /// Null: it is only read.
    void (*write)(const std::filesystem::path&, const Heightmap&, std::optional<Range>) = nullptr;
    const char* gdal_driver = nullptr;  ///< GDAL's name of it, where GDAL reads it
    bool rounds = false;                ///< writes 16-bit integers over a range
    bool headerless = false;            ///< its files say neither their size nor their byte order
};
const std::vector<HeightmapFormat>& heightmap_formats();

/// The format of a file, by its ending; null: none has it.
const HeightmapFormat* format_of(const std::filesystem::path& path);
/// Endings of the formats that are read, or written, in the table's order.
std::vector<std::string> readable_endings();
std::vector<std::string> writable_endings();
bool can_write_heightmap(const std::filesystem::path& path);

// sim/io/geographic.cpp, by GDAL
Heightmap read_geographic(const std::filesystem::path& path, const ImportSettings& settings);
void write_geotiff(const std::filesystem::path& path, const Heightmap& heightmap, std::optional<Range> range);
// sim/io/picture.cpp, by OpenImageIO
Heightmap read_picture(const std::filesystem::path& path, const ImportSettings& settings);
void write_picture(const std::filesystem::path& path, const Heightmap& heightmap, std::optional<Range> range);
// sim/io/raw.cpp
Heightmap read_raw(const std::filesystem::path& path, const ImportSettings& settings);
void write_raw(const std::filesystem::path& path, const Heightmap& heightmap, std::optional<Range> range);

}  // namespace talus::io
