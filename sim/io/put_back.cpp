#include "sim/io/put_back.h"

#include <cpl_minixml.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <deque>
#include <fstream>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/endings.h"
#include "sim/io/gdal_dataset.h"
#include "sim/io/tile_writer.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;

// Samples a side of what a patch is made of: a file's tiles.
constexpr int patch_tile = 512;

// A terrain in its place in the whole.
struct Placed {
    TileSamples where;
    std::vector<float> heights;  // what is put back
    std::vector<bool> changed;   // whether that is another than the whole's
    std::int64_t changes = 0;
    glm::ivec2 low{0};  // of the whole's samples, the first and the last that changed
    glm::ivec2 high{0};
};

// How much of the work counts so many metres from the nearest edge: 0 on it, 1 from the feather's width on,
// with no kink (Hermite's cubic).
double share_of_work(double from_edge_m, double feather_m) {
    if (from_edge_m >= feather_m) return 1;
    const double x = from_edge_m / feather_m;
    return x * x * (3 - 2 * x);
}

// Metres to the nearest of the cut-out's edges beyond which the whole goes on.
double from_edge_m(const Grid& whole, const TileSamples& where, glm::ivec2 sample) {
    double nearest = HUGE_VAL;
    const glm::ivec2 last = where.count - 1;
    const glm::ivec2 end = where.first + where.count;
    if (where.first.x > 0) nearest = std::min(nearest, sample.x * whole.dx);
    if (where.first.y > 0) nearest = std::min(nearest, sample.y * whole.dy);
    if (end.x < whole.nx) nearest = std::min(nearest, (last.x - sample.x) * whole.dx);
    if (end.y < whole.ny) nearest = std::min(nearest, (last.y - sample.y) * whole.dy);
    return nearest;
}

Placed placed(const Document& document, const TiledFile& whole, double feather_m) {
    const Grid& grid = document.state.grid;
    const std::optional<glm::ivec2> first = first_sample_in(whole, grid, document.state.georeference);
    if (!first)
        throw Error(fmt::format(
            "the terrain was turned or resampled since it was cut out of '{}', so its samples have no "
            "place there any more: undo that to put it back",
            whole.path().string()));
    Placed in;
    in.where = {*first, {grid.nx, grid.ny}};
    in.heights = document.state.ground();
    in.changed.resize(in.heights.size());
    in.low = whole.levels().front();
    std::vector<float> before;
    whole.make_reader()(0, in.where, before);
    std::size_t at = 0;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x, ++at) {
            float& height = in.heights[at];
            if (height == before[at]) continue;
            const double share = share_of_work(from_edge_m(whole.grid(), in.where, {x, y}), feather_m);
            if (share < 1) height = static_cast<float>(glm::mix<double>(before[at], height, share));
            if (height == before[at]) continue;
            in.changed[at] = true;
            ++in.changes;
            in.low = glm::min(in.low, *first + glm::ivec2(x, y));
            in.high = glm::max(in.high, *first + glm::ivec2(x, y));
        }
    if (in.changes == 0)
        throw Error(
            fmt::format("nothing is to be put back: the ground is that of '{}'", whole.path().string()));
    return in;
}

// The tiles around what changed: their levels' samples are means of theirs alone.
TileSamples patch_rectangle(const Placed& in, const TiledFile& whole) {
    const int align = std::max(patch_tile, 1 << (whole.levels().size() - 1));
    const glm::ivec2 size = whole.levels().front();
    const glm::ivec2 end = glm::min((in.high / align + 1) * align, size);
    glm::ivec2 first = in.low / align * align;
    // So large that there is a sample on each level.
    for (int axis = 0; axis < 2; ++axis)
        if (end[axis] - first[axis] < align) first[axis] = std::max(first[axis] - align, 0);
    return {first, end - first};
}

TiledSource patch_source(const TiledFile& whole, const Placed& in, const TileSamples& rectangle) {
    TiledSource source;
    source.grid = {rectangle.count.x, rectangle.count.y, whole.grid().dx, whole.grid().dy};
    source.georeference = place_of(whole);
    std::array<double, 6>& t = source.georeference->transform;
    t[0] += t[1] * rectangle.first.x + t[2] * rectangle.first.y;
    t[3] += t[4] * rectangle.first.x + t[5] * rectangle.first.y;
    source.void_value = whole.source().void_value;
    source.make_reader = [&whole, &in, rectangle]() -> ReadSamples {
        return [&in, rectangle, read = whole.source().make_reader()](int, const TileSamples& samples,
                                                                     std::vector<float>& heights) {
            const glm::ivec2 first = rectangle.first + samples.first;
            read(0, {first, samples.count}, heights);
            const glm::ivec2 from = glm::max(first, in.where.first);
            const glm::ivec2 to = glm::min(first + samples.count, in.where.first + in.where.count);
            for (int y = from.y; y < to.y; ++y)
                for (int x = from.x; x < to.x; ++x) {
                    const glm::ivec2 own = glm::ivec2(x, y) - in.where.first;
                    const std::size_t at = static_cast<std::size_t>(own.y) * in.where.count.x + own.x;
                    if (in.changed[at])
                        heights[static_cast<std::size_t>(y - first.y) * samples.count.x + (x - first.x)] =
                            in.heights[at];
                }
        };
    };
    return source;
}

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
    fs::path path;
    int level = 0;
    glm::ivec2 size{0};
    std::optional<float> void_value;
};

// A file's samples of the level, from sample `first` of the mosaic's on.
void add_part(CPLXMLNode* band, const LevelMosaic& mosaic, const fs::path& file, glm::ivec2 first,
              glm::ivec2 count) {
    CPLXMLNode* part = add(band, mosaic.void_value ? "ComplexSource" : "SimpleSource");
    std::error_code failed;
    const fs::path from = fs::weakly_canonical(fs::absolute(mosaic.path), failed).parent_path();
    const fs::path to = fs::weakly_canonical(fs::absolute(file), failed);
    CPLXMLNode* name = add(part, "SourceFilename");
    attribute(name, "relativeToVRT", "1");
    CPLCreateXMLNode(name, CXT_Text, to.lexically_relative(from).c_str());
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
CPLXMLNode* add_band(CPLXMLNode* root, const LevelMosaic& mosaic, const fs::path& whole,
                     const PutBack& done) {
    attribute(root, "rasterXSize", std::to_string(mosaic.size.x));
    attribute(root, "rasterYSize", std::to_string(mosaic.size.y));
    CPLXMLNode* band = add(root, "VRTRasterBand");
    attribute(band, "dataType", "Float32");
    attribute(band, "band", "1");
    if (mosaic.void_value) add(band, "NoDataValue", fmt::format("{}", *mosaic.void_value));
    add_part(band, mosaic, whole, {0, 0}, mosaic.size);
    const glm::ivec2 first(done.rectangle.first.x >> mosaic.level, done.rectangle.first.y >> mosaic.level);
    const glm::ivec2 count = halved_levels(done.rectangle.count)[static_cast<std::size_t>(mosaic.level)];
    add_part(band, mosaic, done.patch, first, count);
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

fs::path level_path(const PutBack& done, std::size_t level) {
    return done.patch.parent_path() / fmt::format("level_{}.vrt", level);
}

// The whole and the patch as one raster. GDAL could make up the levels of a mosaic, but only those of sizes
// that are powers of two fall on the parts' own samples; so each is a mosaic of its own.
std::string mosaic_text(const TiledFile& whole, const PutBack& done, const LevelMosaic& mosaic) {
    const Element root("VRTDataset");
    if (mosaic.level > 0) {
        add_band(root.get(), mosaic, whole.path(), done);
        return root.text();
    }
    const Dataset dataset(static_cast<GDALDataset*>(
        GDALOpenEx(whole.path().c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr)));
    if (!dataset) throw Error(fmt::format("'{}' cannot be read: {}", whole.path().string(), gdal_says()));
    add_place(root.get(), *dataset);
    if (whole.level_places() == LevelPlaces::by_halves) {
        CPLXMLNode* metadata = add(root.get(), "Metadata");
        attribute(metadata, "domain", levels_domain);
        CPLXMLNode* item = add(metadata, "MDI");
        attribute(item, "key", levels_item);
        CPLCreateXMLNode(item, CXT_Text, levels_by_halves);
    }
    CPLXMLNode* band = add_band(root.get(), mosaic, whole.path(), done);
    for (std::size_t level = 1; level < whole.levels().size(); ++level) {
        CPLXMLNode* overview = add(band, "Overview");
        CPLXMLNode* name = add(overview, "SourceFilename");
        attribute(name, "relativeToVRT", "1");
        const fs::path path = level_path(done, level);
        CPLCreateXMLNode(name, CXT_Text, (path.parent_path().filename() / path.filename()).c_str());
        add(overview, "SourceBand", "1");
    }
    return root.text();
}

void check_names(const TiledFile& whole, const PutBackSettings& settings, const fs::path& patch) {
    if (ending_of(settings.mosaic) != ".vrt")
        throw Error(
            fmt::format("cannot put back into '{}': a mosaic's name ends in .vrt", settings.mosaic.string()));
    for (const fs::path& file : {settings.mosaic, patch})
        if (whole.is_made_of(file))
            throw Error(
                fmt::format("'{}' is a part of what the terrain was cut out of, and stays as it is: give "
                            "the mosaic another name",
                            file.string()));
}

void write_text(const fs::path& path, const fs::path& as, const std::string& text) {
    std::ofstream file(as);
    if (!file.write(text.data(), static_cast<std::streamsize>(text.size())).flush())
        throw Error(fmt::format("cannot write '{}': {}", path.string(), std::strerror(errno)));
}

// A folder that goes again where nothing was put into it.
class PartsFolder {
  public:
    explicit PartsFolder(fs::path path) : path_(std::move(path)) {
        std::error_code failed;
        fs::create_directory(path_, failed);
        if (failed)
            throw Error(fmt::format("cannot make the folder '{}': {}", path_.string(), failed.message()));
    }
    ~PartsFolder() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    PartsFolder(const PartsFolder&) = delete;
    PartsFolder& operator=(const PartsFolder&) = delete;

  private:
    fs::path path_;
};

// All that can fail comes before anything is in its place: the mosaic that was there may be of the patch
// before.
bool write_files(const TiledFile& whole, const PutBack& done, const fs::path& path, const TiledSource& patch,
                 const std::function<bool(double)>& told) {
    const PartsFolder folder(done.patch.parent_path());
    std::deque<AtomicFile> mosaics;
    for (std::size_t level = 0; level < whole.levels().size(); ++level) {
        const LevelMosaic mosaic{level == 0 ? path : level_path(done, level), static_cast<int>(level),
                                 whole.levels()[level], whole.source().void_value};
        const AtomicFile& file = mosaics.emplace_front(mosaic.path);
        write_text(mosaic.path, file.temporary(), mosaic_text(whole, done, mosaic));
    }
    if (!write_tiled(done.patch, patch, told, whole.levels().size())) return false;
    for (AtomicFile& mosaic : mosaics) mosaic.commit();
    return true;
}

}  // namespace

std::optional<PutBack> put_back(const Document& document, const PutBackSettings& settings,
                                const std::function<bool(double)>& told) {
    if (!document.cut_out)
        throw Error(
            "the terrain was not cut out of a larger one (--window), so it has no place to be put back into");
    if (!(settings.feather_m >= 0) || !std::isfinite(settings.feather_m))
        throw Error(
            fmt::format("a feather of {} m cannot be used, it must be 0 or more", settings.feather_m));
    const TiledFile whole(document.cut_out->path, document.cut_out->import);
    if (!whole.holds_plain_heights())
        throw Error(fmt::format(
            "'{}' holds numbers that are not heights as they stand, or begins in the south or east: "
            "cut the terrain out of what 'talus tile' makes of it",
            whole.path().string()));
    PutBack done;
    done.patch = fs::path(settings.mosaic).replace_extension(".parts") / "patch.tif";
    check_names(whole, settings, done.patch);
    const Placed in = placed(document, whole, settings.feather_m);
    done.changed = in.changes;
    done.rectangle = patch_rectangle(in, whole);
    if (!write_files(whole, done, settings.mosaic, patch_source(whole, in, done.rectangle), told))
        return std::nullopt;
    return done;
}

}  // namespace talus::io
