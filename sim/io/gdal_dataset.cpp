#include "sim/io/gdal_dataset.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <mutex>
#include <numbers>

#include "sim/error.h"

namespace talus::io {
namespace {

// Metres of a degree of longitude and of latitude on WGS 84 at a latitude (NIMA TR8350.2, radii of
// curvature).
glm::dvec2 metres_per_degree(double latitude_deg) {
    constexpr double a = 6378137.0;
    constexpr double e2 = 6.69437999014e-3;
    const double phi = latitude_deg * std::numbers::pi / 180;
    const double w2 = 1 - e2 * std::sin(phi) * std::sin(phi);
    return glm::dvec2(a * std::cos(phi) / std::sqrt(w2), a * (1 - e2) / (w2 * std::sqrt(w2))) *
           (std::numbers::pi / 180);
}

}  // namespace

void start_gdal() {
    static std::once_flag once;
    std::call_once(once, [] {
        CPLSetErrorHandler(CPLQuietErrorHandler);
        CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");
        // Each reader of a mosaic opens its parts itself: readers belong to threads.
        CPLSetConfigOption("VRT_SHARED_SOURCE", "0");
        GDALAllRegister();
    });
    CPLErrorReset();
}

Dataset open_raster(const std::filesystem::path& path) {
    start_gdal();
    Dataset dataset(static_cast<GDALDataset*>(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr)));
    if (dataset) return dataset;
    // GDAL opens what is no file too, and says nothing of a file that is not there.
    std::error_code ignored;
    const bool is_missing = !path.string().starts_with("/vsi") && !std::filesystem::exists(path, ignored);
    throw Error(fmt::format("'{}' cannot be read: {}", path.string(),
                            is_missing && CPLGetLastErrorMsg()[0] == '\0' ? "no such file" : gdal_says()));
}

std::string gdal_says() {
    std::string message = CPLGetLastErrorMsg();
    std::replace(message.begin(), message.end(), '\n', ' ');
    while (!message.empty() && (message.back() == '.' || message.back() == ' ')) message.pop_back();
    return message.empty() ? "the file is damaged or of another kind" : message;
}

std::string gdal_says_of(const std::filesystem::path& hidden, const std::filesystem::path& named) {
    std::string said = gdal_says();
    for (std::size_t at = said.find(hidden.string()); at != std::string::npos;
         at = said.find(hidden.string()))
        said.replace(at, hidden.string().size(), named.string());
    return said;
}

RasterPlace place_of(GDALDataset& dataset) {
    RasterPlace place;
    Georeference georeference;
    if (dataset.GetGeoTransform(georeference.transform.data()) != CE_None) return place;
    const int nx = dataset.GetRasterXSize();
    const int ny = dataset.GetRasterYSize();
    const OGRSpatialReference* system = dataset.GetSpatialRef();
    if (system) {
        char* wkt = nullptr;
        system->exportToWkt(&wkt);
        georeference.wkt = wkt ? wkt : "";
        CPLFree(wkt);
    }
    std::array<double, 6>& t = georeference.transform;
    if (t[5] > 0) {
        place.south_first = true;
        t[3] += t[5] * ny;
        t[0] += t[2] * ny;
        t[5] = -t[5];
        t[2] = -t[2];
        place.notes.emplace_back("the file stores its south row first, its rows were turned round");
    }
    if (t[1] < 0) {
        place.east_first = true;
        t[0] += t[1] * nx;
        t[3] += t[4] * nx;
        t[1] = -t[1];
        t[4] = -t[4];
        place.notes.emplace_back("the file's columns run westwards, they were turned round");
    }
    place.dx_m = std::hypot(t[1], t[4]);
    place.dy_m = std::hypot(t[2], t[5]);
    if (system && system->IsGeographic()) {
        const double latitude = std::clamp(t[3] + 0.5 * ny * t[5], -89.9, 89.9);
        const glm::dvec2 degree = metres_per_degree(latitude);
        place.dx_m *= degree.x;
        place.dy_m *= degree.y;
        place.notes.push_back(
            fmt::format("degrees became metres at latitude {:.3f}: {:.2f} x {:.2f} m a sample", latitude,
                        place.dx_m, place.dy_m));
    } else if (system) {
        const double unit = system->GetLinearUnits();
        place.dx_m *= unit;
        place.dy_m *= unit;
    }
    place.georeference = georeference;
    return place;
}

}  // namespace talus::io
