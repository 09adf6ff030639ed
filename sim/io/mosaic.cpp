#include "sim/io/mosaic.h"

#include <cpl_minixml.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ogr_spatialref.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "sim/error.h"
#include "sim/io/gdal_dataset.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;

// GDAL's trees of XML, as text that a mosaic is.
class Element {
  public:
    explicit Element(const char* name) : node_(CPLCreateXMLNode(nullptr, CXT_Element, name)) {}
    ~Element() { CPLDestroyXMLNode(node_); }
    Element(const Element&) = delete;
    Element& operator=(const Element&) = delete;
    CPLXMLNode* get() const { return node_; }
    std::string text() const {
        char* serialised = CPLSerializeXMLTree(node_);
        std::string text(serialised);
        CPLFree(serialised);
        return text;
    }

  private:
    CPLXMLNode* node_;
};

CPLXMLNode* add(CPLXMLNode* parent, const char* name) {
    return CPLCreateXMLNode(parent, CXT_Element, name);
}

void add(CPLXMLNode* parent, const char* name, const std::string& value) {
    CPLCreateXMLElementAndValue(parent, name, value.c_str());
}

void attribute(CPLXMLNode* node, const char* name, const std::string& value) {
    CPLAddXMLAttributeAndValue(node, name, value.c_str());
}

// A raster of one band, made of the whole's and the patch's samples of a level as they are.
struct LevelMosaic {
    fs::path folder;
    int level = 0;
    glm::ivec2 size{0};
    std::optional<float> void_value;
    const char* type = "Float32";
};

// How a file is named in a mosaic: from its folder on where both lie in folders, so that they can be moved
// together. Links are followed to folders alone: overviews may lie beside a link.
void name_file(CPLXMLNode* node, const fs::path& folder, const fs::path& file) {
    const std::string full = file.string();
    std::error_code failed;
    const bool virtual_file = full.starts_with("/vsi");
    const fs::path lies_in = fs::weakly_canonical(fs::absolute(file).parent_path(), failed);
    attribute(node, "relativeToVRT", virtual_file || failed ? "0" : "1");
    const fs::path name =
        virtual_file || failed ? file : (lies_in / file.filename()).lexically_relative(folder);
    CPLCreateXMLNode(node, CXT_Text, name.c_str());
}

// A file's samples of the level, from sample `first` of the mosaic's on.
void add_part(CPLXMLNode* band, const LevelMosaic& mosaic, const fs::path& file, glm::ivec2 first,
              glm::ivec2 count) {
    CPLXMLNode* part = add(band, mosaic.void_value ? "ComplexSource" : "SimpleSource");
    name_file(add(part, "SourceFilename"), mosaic.folder, file);
    if (mosaic.level > 0) {
        CPLXMLNode* option = add(add(part, "OpenOptions"), "OOI");
        attribute(option, "key", "OVERVIEW_LEVEL");
        CPLCreateXMLNode(option, CXT_Text, std::to_string(mosaic.level - 1).c_str());
    }
    add(part, "SourceBand", "1");
    for (const char* const rectangle : {"SrcRect", "DstRect"}) {
        CPLXMLNode* node = add(part, rectangle);
        const glm::ivec2 offset = std::string(rectangle) == "SrcRect" ? glm::ivec2(0) : first;
        attribute(node, "xOff", std::to_string(offset.x));
        attribute(node, "yOff", std::to_string(offset.y));
        attribute(node, "xSize", std::to_string(count.x));
        attribute(node, "ySize", std::to_string(count.y));
    }
    if (mosaic.void_value) add(part, "NODATA", fmt::format("{}", *mosaic.void_value));
}

// The band of a level; the mosaic's size becomes the root's.
CPLXMLNode* add_band(CPLXMLNode* root, const LevelMosaic& mosaic, const fs::path& whole, const Patch& patch) {
    attribute(root, "rasterXSize", std::to_string(mosaic.size.x));
    attribute(root, "rasterYSize", std::to_string(mosaic.size.y));
    CPLXMLNode* band = add(root, "VRTRasterBand");
    attribute(band, "dataType", mosaic.type);
    attribute(band, "band", "1");
    if (mosaic.void_value) add(band, "NoDataValue", fmt::format("{}", *mosaic.void_value));
    add_part(band, mosaic, whole, {0, 0}, mosaic.size);
    const glm::ivec2 first(patch.rectangle.first.x >> mosaic.level, patch.rectangle.first.y >> mosaic.level);
    const glm::ivec2 count = halved_levels(patch.rectangle.count)[static_cast<std::size_t>(mosaic.level)];
    add_part(band, mosaic, patch.path, first, count);
    return band;
}

void add_place(CPLXMLNode* root, GDALDataset& whole) {
    if (const OGRSpatialReference* system = whole.GetSpatialRef()) {
        char* wkt = nullptr;
        system->exportToWkt(&wkt);
        CPLXMLNode* node = add(root, "SRS");
        attribute(node, "dataAxisToSRSAxisMapping",
                  fmt::format("{}", fmt::join(system->GetDataAxisToSRSAxisMapping(), ",")));
        CPLCreateXMLNode(node, CXT_Text, wkt ? wkt : "");
        CPLFree(wkt);
    }
    std::array<double, 6> transform{};
    if (whole.GetGeoTransform(transform.data()) == CE_None)
        add(root, "GeoTransform", fmt::format("{}", fmt::join(transform, ", ")));
}

// Numbers of all of these types are floats of this one.
const char* type_of_mosaic(GDALRasterBand& band) {
    const GDALDataType type = band.GetRasterDataType();
    const bool fits = type == GDT_Byte || type == GDT_UInt16 || type == GDT_Int16 || type == GDT_Float32;
    return fits ? "Float32" : "Float64";
}

std::string level_name(std::size_t level) {
    return fmt::format("level_{}.vrt", level);
}

void write_text(const fs::path& path, const fs::path& as, const std::string& text) {
    std::ofstream file(as);
    if (!file.write(text.data(), static_cast<std::streamsize>(text.size())).flush())
        throw Error(fmt::format("cannot write '{}': {}", path.string(), std::strerror(errno)));
}

}  // namespace

void write_mosaic(const TiledFile& raster, const Patch& patch, const MosaicPlace& place) {
    const Dataset dataset = open_raster(raster.path());
    LevelMosaic mosaic{
        place.parts, 0, {}, raster.source().void_value, type_of_mosaic(*dataset->GetRasterBand(1))};
    for (std::size_t level = 1; level < raster.levels().size(); ++level) {
        mosaic.level = static_cast<int>(level);
        mosaic.size = raster.levels()[level];
        const Element root("VRTDataset");
        add_band(root.get(), mosaic, raster.path(), patch);
        write_text(place.parts / level_name(level), place.parts / level_name(level), root.text());
    }
    mosaic.level = 0;
    mosaic.size = raster.levels().front();
    mosaic.folder = place.path.parent_path();
    const Element root("VRTDataset");
    add_place(root.get(), *dataset);
    if (raster.level_places() == LevelPlaces::by_halves) {
        CPLXMLNode* metadata = add(root.get(), "Metadata");
        attribute(metadata, "domain", levels_domain);
        CPLXMLNode* item = add(metadata, "MDI");
        attribute(item, "key", levels_item);
        CPLCreateXMLNode(item, CXT_Text, levels_by_halves);
    }
    CPLXMLNode* band = add_band(root.get(), mosaic, raster.path(), patch);
    for (std::size_t level = 1; level < raster.levels().size(); ++level) {
        CPLXMLNode* overview = add(band, "Overview");
        name_file(add(overview, "SourceFilename"), mosaic.folder, place.parts / level_name(level));
        add(overview, "SourceBand", "1");
    }
    write_text(place.path, place.as, root.text());
}

}  // namespace talus::io
