#pragma once
#include <gdal_priv.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/terrain/georeference.h"

namespace talus::io {

struct CloseDataset {
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

/// Makes GDAL ready, once, and forgets its last message. Call it before GDAL is used.
void start_gdal();

/// Opens any raster to be read. Throws talus::Error naming it.
Dataset open_raster(const std::filesystem::path& path);

/// GDAL's last message of this thread as part of a sentence.
std::string gdal_says();
/// The same of a file that is written under a hidden name, by the name that it will have.
std::string gdal_says_of(const std::filesystem::path& hidden, const std::filesystem::path& named);

/// Where a raster lies, in the order of Talus: the north row first, columns eastwards.
struct RasterPlace {
    std::optional<Georeference> georeference;  ///< none: the file says none
    double dx_m = 1;
    double dy_m = 1;
    bool south_first = false;        ///< the file's rows run northwards
    bool east_first = false;         ///< its columns run westwards
    std::vector<std::string> notes;  ///< on what was turned round or converted
};
RasterPlace place_of(GDALDataset& dataset);

}  // namespace talus::io
