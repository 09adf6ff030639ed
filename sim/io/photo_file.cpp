#include "sim/io/photo_file.h"

#include <fmt/format.h>
#include <gdal_utils.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/error.h"
#include "sim/io/colour_image.h"
#include "sim/io/gdal_dataset.h"
#include "sim/tiled/screen_colour.h"

namespace talus::io {

namespace fs = std::filesystem;

namespace {

// Texels a side that are read as a whole where smaller pictures are made of them.
constexpr int widest_without_overviews = 8192;

struct FreeOptions {
    void operator()(GDALTranslateOptions* options) const { GDALTranslateOptionsFree(options); }
    void operator()(GDALWarpAppOptions* options) const { GDALWarpAppOptionsFree(options); }
};

// A raster, and those that it is made of, which must outlive it.
struct Opened {
    Dataset source;
    Dataset chosen;  // its colours, and alpha, in bands of their own; null: the source has them so
    Dataset warped;  // null: it lies as the ground does

    GDALDataset& top() const { return warped ? *warped : chosen ? *chosen : *source; }
};

bool transform_of(GDALDataset& dataset, std::array<double, 6>& transform) {
    return dataset.GetGeoTransform(transform.data()) == CE_None &&
           transform[1] * transform[5] - transform[2] * transform[4] != 0;
}

std::optional<OGRSpatialReference> system_of(const std::string& wkt) {
    OGRSpatialReference system;
    if (wkt.empty() || system.importFromWkt(wkt.c_str()) != OGRERR_NONE) return std::nullopt;
    return system;
}

// Whether both are one system, or one of them is not told.
bool is_same_system(GDALDataset& photo, const Georeference& ground) {
    const std::optional<OGRSpatialReference> there = system_of(ground.wkt);
    const OGRSpatialReference* here = photo.GetSpatialRef();
    if (!there || !here) return true;
    const std::array<const char*, 2> heed = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
    return here->IsSame(&*there, heed.data()) != 0;
}

// Bands of red, green and blue, or of grey, and of alpha where there is one.
std::vector<int> colour_bands(const fs::path& path, GDALDataset& dataset) {
    std::vector<int> colours;
    std::optional<int> alpha;
    std::array<int, 3> named{};
    for (int number = 1; number <= dataset.GetRasterCount(); ++number) {
        const GDALColorInterp means = dataset.GetRasterBand(number)->GetColorInterpretation();
        if (means == GCI_AlphaBand) {
            alpha = number;
            continue;
        }
        if (means >= GCI_RedBand && means <= GCI_BlueBand) named[means - GCI_RedBand] = number;
        colours.push_back(number);
    }
    if (colours.empty() || colours.size() == 2)
        throw Error(
            fmt::format("'{}' has {} bands of colours, a photo has 1 or 3", path.string(), colours.size()));
    colours.resize(std::min<std::size_t>(colours.size(), 3));
    if (std::find(named.begin(), named.end(), 0) == named.end()) colours.assign(named.begin(), named.end());
    if (alpha) colours.push_back(*alpha);
    for (const int number : colours) {
        const GDALDataType type = dataset.GetRasterBand(number)->GetRasterDataType();
        if (type != GDT_Byte && type != GDT_UInt16)
            throw Error(fmt::format("'{}' holds {} numbers, colours of a photo have 8 or 16 bits",
                                    path.string(), GDALGetDataTypeName(type)));
    }
    return colours;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

Dataset with_bands(const fs::path& path, GDALDataset& dataset, const std::vector<std::string>& which) {
    std::vector<std::string> words = {"-of", "VRT"};
    words.insert(words.end(), which.begin(), which.end());
    const std::unique_ptr<GDALTranslateOptions, FreeOptions> options(
        GDALTranslateOptionsNew(pointers_to(words).data(), nullptr));
    Dataset chosen(static_cast<GDALDataset*>(GDALTranslate("", &dataset, options.get(), nullptr)));
    if (!chosen) throw Error(fmt::format("'{}' cannot be read: {}", path.string(), gdal_says()));
    return chosen;
}

// Null: it has these bands alone, in this order.
Dataset with_colours(const fs::path& path, GDALDataset& dataset) {
    const std::vector<int> bands = colour_bands(path, dataset);
    if (dataset.GetRasterBand(1)->GetColorTable()) return with_bands(path, dataset, {"-expand", "rgba"});
    std::vector<std::string> which;
    bool in_order = dataset.GetRasterCount() == static_cast<int>(bands.size());
    for (std::size_t i = 0; i < bands.size(); ++i) {
        in_order = in_order && bands[i] == static_cast<int>(i) + 1;
        which.insert(which.end(), {"-b", std::to_string(bands[i])});
    }
    return in_order ? nullptr : with_bands(path, dataset, which);
}

Dataset as_the_ground_lies(const fs::path& path, GDALDataset& dataset, const Georeference& ground) {
    std::vector<std::string> words = {"-of", "VRT", "-r", "bilinear", "-dstalpha"};
    if (!ground.wkt.empty()) words.insert(words.end(), {"-t_srs", ground.wkt});
    const std::unique_ptr<GDALWarpAppOptions, FreeOptions> options(
        GDALWarpAppOptionsNew(pointers_to(words).data(), nullptr));
    GDALDatasetH source = &dataset;
    Dataset warped(static_cast<GDALDataset*>(GDALWarp("", nullptr, 1, &source, options.get(), nullptr)));
    if (!warped)
        throw Error(fmt::format("'{}' cannot be brought into the terrain's coordinate system: {}",
                                path.string(), gdal_says()));
    return warped;
}

Opened open(const fs::path& path, const std::optional<Georeference>& ground) {
    Opened opened;
    opened.source = open_raster(path);
    opened.chosen = with_colours(path, *opened.source);
    std::array<double, 6> t{};
    if (!ground || !transform_of(opened.top(), t)) return opened;
    const bool lies_straight = t[1] > 0 && t[2] == 0 && t[4] == 0 && t[5] < 0;
    if (!lies_straight || !is_same_system(opened.top(), *ground))
        opened.warped = as_the_ground_lies(path, opened.top(), *ground);
    return opened;
}

int longest_side(GDALRasterBand& band) {
    return std::max(band.GetXSize(), band.GetYSize());
}

// A photo of one thread.
class PhotoReader {
  public:
    PhotoReader(const fs::path& path, const std::optional<Georeference>& ground)
        : path_(path),
          opened_(open(path, ground)),
          levels_(halved_levels({opened_.top().GetRasterXSize(), opened_.top().GetRasterYSize()})) {
        GDALDataset& top = opened_.top();
        const int count = top.GetRasterCount();
        has_alpha_ = count % 2 == 0;
        colours_ = has_alpha_ ? count - 1 : count;
        const int flags = top.GetRasterBand(1)->GetMaskFlags();
        if (has_alpha_ || (flags & GMF_ALL_VALID) != 0) return;
        // Nodata is a matter of each band: a texel is left out where all of them say so.
        const bool each = (flags & GMF_PER_DATASET) == 0;
        for (int band = 1; band <= (each ? colours_ : 1); ++band)
            masks_.push_back(top.GetRasterBand(band)->GetMaskBand());
    }

    const Opened& opened() const { return opened_; }
    glm::ivec2 texels() const { return levels_.front(); }
    bool leaves_out() const { return has_alpha_ || !masks_.empty(); }

    void read(int level, const TileSamples& samples, std::vector<PhotoTexel>& texels) {
        const glm::ivec2 size = levels_[static_cast<std::size_t>(level)];
        const glm::ivec2 from = glm::clamp(samples.first, glm::ivec2(0), size - 1);
        const glm::ivec2 to = glm::clamp(samples.first + samples.count - 1, glm::ivec2(0), size - 1);
        const glm::ivec2 count = to - from + 1;
        within_.assign(static_cast<std::size_t>(count.x) * count.y, {0, 0, 0, 255});
        read_within(level, from, count);
        texels.resize(static_cast<std::size_t>(samples.count.x) * samples.count.y);
        std::size_t at = 0;
        for (int y = 0; y < samples.count.y; ++y) {
            const int row = std::clamp(samples.first.y + y, from.y, to.y) - from.y;
            for (int x = 0; x < samples.count.x; ++x) {
                const int column = std::clamp(samples.first.x + x, from.x, to.x) - from.x;
                texels[at++] = within_[static_cast<std::size_t>(row) * count.x + column];
            }
        }
    }

  private:
    void read_within(int level, glm::ivec2 from, glm::ivec2 count) {
        GDALDataset& dataset = opened_.top();
        const glm::dvec2 ratio =
            glm::dvec2(levels_.front()) / glm::dvec2(levels_[static_cast<std::size_t>(level)]);
        GDALRasterIOExtraArg how;
        INIT_RASTERIO_EXTRA_ARG(how);
        // GDAL takes the overview that is the next finer one. The root of the mean of squares is near the
        // colour of the mean light.
        if (level > 0) how.eResampleAlg = GRIORA_RMS;
        how.bFloatingPointWindowValidity = TRUE;
        how.dfXOff = from.x * ratio.x;
        how.dfYOff = from.y * ratio.y;
        how.dfXSize = count.x * ratio.x;
        how.dfYSize = count.y * ratio.y;
        const glm::ivec2 first(how.dfXOff, how.dfYOff);
        const glm::ivec2 end = glm::min(
            glm::ivec2(glm::ceil(glm::dvec2(how.dfXOff + how.dfXSize, how.dfYOff + how.dfYSize) - 1e-6)),
            levels_.front());
        const glm::ivec2 window = end - first;
        // Grey and alpha stand for red and alpha.
        const int bands = opened_.top().GetRasterCount();
        const int apart = colours_ == 1 ? 3 : 1;
        const auto read_bands = [&](void* into, GDALDataType type) {
            const int bytes = GDALGetDataTypeSizeBytes(type);
            CPLErrorReset();
            check(dataset.RasterIO(GF_Read, first.x, first.y, window.x, window.y, into, count.x, count.y,
                                   type, bands, nullptr, 4 * bytes, GSpacing{4} * bytes * count.x,
                                   GSpacing{apart} * bytes, &how));
        };
        if (dataset.GetRasterBand(1)->GetRasterDataType() == GDT_Byte) {
            read_bands(&within_.front().r, GDT_Byte);
        } else {
            std::vector<std::array<std::uint16_t, 4>> wide(within_.size(), {0, 0, 0, 65535});
            read_bands(wide.data(), GDT_UInt16);
            const auto narrow = [](int colour) { return static_cast<std::uint8_t>((colour + 128) / 257); };
            for (std::size_t i = 0; i < within_.size(); ++i)
                within_[i] = {narrow(wide[i][0]), narrow(wide[i][1]), narrow(wide[i][2]), narrow(wide[i][3])};
        }
        if (colours_ == 1)
            for (PhotoTexel& texel : within_) texel.g = texel.b = texel.r;
        read_masks(first, window, count, how);
        if (!leaves_out()) return;
        for (PhotoTexel& texel : within_) {
            if (texel.a == 255) continue;
            const float share = static_cast<float>(texel.a) / 255.0F;
            texel = {to_screen(share * from_screen(texel.r)), to_screen(share * from_screen(texel.g)),
                     to_screen(share * from_screen(texel.b)), texel.a};
        }
    }

    void read_masks(glm::ivec2 first, glm::ivec2 window, glm::ivec2 count, GDALRasterIOExtraArg& how) {
        if (masks_.empty()) return;
        for (PhotoTexel& texel : within_) texel.a = 0;
        std::vector<std::uint8_t> covered(within_.size());
        for (GDALRasterBand* mask : masks_) {
            CPLErrorReset();
            check(mask->RasterIO(GF_Read, first.x, first.y, window.x, window.y, covered.data(), count.x,
                                 count.y, GDT_Byte, 1, count.x, &how));
            for (std::size_t i = 0; i < covered.size(); ++i)
                within_[i].a = std::max(within_[i].a, covered[i]);
        }
    }

    // Errors on the way count too: GDAL reads some damaged files as zeros and only warns.
    void check(CPLErr error) const {
        if (error != CE_None || CPLGetLastErrorType() >= CE_Failure)
            throw Error(fmt::format("'{}' cannot be read: {}", path_.string(), gdal_says()));
    }

    fs::path path_;
    Opened opened_;
    std::vector<glm::ivec2> levels_;
    int colours_ = 0;  // bands; one: grey
    bool has_alpha_ = false;
    std::vector<GDALRasterBand*> masks_;  // none, and no alpha: all is covered
    std::vector<PhotoTexel> within_;
};

}  // namespace

PhotoFile::PhotoFile(const fs::path& path, const std::optional<Georeference>& ground)
    : path_(path), ground_(ground) {
    const PhotoReader reader(path, ground);
    GDALDataset& top = reader.opened().top();
    texels_ = {top.GetRasterXSize(), top.GetRasterYSize()};
    if (std::min(texels_.x, texels_.y) < 2)
        throw Error(fmt::format("'{}' has {} x {} texels, a photo has at least 2 x 2", path.string(),
                                texels_.x, texels_.y));
    is_whole_ = !reader.leaves_out();
    GDALRasterBand& stored = *reader.opened().source->GetRasterBand(1);
    const int overviews = stored.GetOverviewCount();
    const int smallest =
        overviews > 0 ? longest_side(*stored.GetOverview(overviews - 1)) : longest_side(stored);
    if (smallest > widest_without_overviews)
        throw Error(
            fmt::format("'{0}' has no overviews to be shown as a whole: 'talus tile --texture {0} "
                        "OUT.tif' writes a file that has them",
                        path.string()));
    is_placed_ = ground && transform_of(top, transform_);
    if (is_placed_ && (ground->transform[2] != 0 || ground->transform[4] != 0))
        throw Error(fmt::format(
            "'{}' cannot be laid over a terrain that lies turned in its coordinate system", path.string()));
}

PhotoPlace PhotoFile::place_over(const Grid& ground, const std::optional<Georeference>& georeference) const {
    if (!is_placed_ || !georeference) {
        // Its edges lie on the outer samples.
        const glm::dvec2 scale = glm::dvec2(texels_) / glm::dvec2(ground.nx - 1, ground.ny - 1);
        return {glm::dvec2(-0.5), scale};
    }
    const std::array<double, 6>& g = georeference->transform;
    const std::array<double, 6>& p = transform_;
    // A ground's samples are the middles of its pixels.
    const PhotoPlace place{{(g[0] + 0.5 * g[1] - p[0]) / p[1] - 0.5, (g[3] + 0.5 * g[5] - p[3]) / p[5] - 0.5},
                           {g[1] / p[1], g[5] / p[5]}};
    const glm::dvec2 last = place.first + place.scale * glm::dvec2(ground.nx - 1, ground.ny - 1);
    if (glm::any(glm::lessThan(last, glm::dvec2(-0.5))) ||
        glm::any(glm::greaterThan(place.first, glm::dvec2(texels_) - 0.5)))
        throw Error(fmt::format("'{}' lies beside the terrain", path_.string()));
    return place;
}

bool PhotoFile::covers(const Grid& ground, const std::optional<Georeference>& georeference) const {
    const PhotoPlace place = place_over(ground, georeference);
    const glm::dvec2 last = place.first + place.scale * glm::dvec2(ground.nx - 1, ground.ny - 1);
    // A place that is stretched over the ground ends on its edge.
    constexpr double rounding = 1e-6;
    return is_whole_ && glm::all(glm::greaterThanEqual(place.first, glm::dvec2(-0.5 - rounding))) &&
           glm::all(glm::lessThanEqual(last, glm::dvec2(texels_) - 0.5 + rounding));
}

ReadTexels PhotoFile::make_reader() const {
    return [path = path_, ground = ground_, size = texels_,
            reader = std::make_shared<PhotoReader>(path_, ground_)](int level, const TileSamples& samples,
                                                                    std::vector<PhotoTexel>& texels) mutable {
        try {
            // What could not be read is looked at afresh: libtiff does not read a broken block again.
            if (!reader) reader = std::make_shared<PhotoReader>(path, ground);
            if (reader->texels() != size)
                throw Error(fmt::format("'{}' has {} x {} texels now, open it again to see it as it is",
                                        path.string(), reader->texels().x, reader->texels().y));
            reader->read(level, samples, texels);
        } catch (...) {
            reader.reset();
            throw;
        }
    };
}

void check_colours(const fs::path& path) {
    colour_bands(path, *open_raster(path));
}

bool is_photo(const fs::path& path, bool ground_is_placed) {
    start_gdal();
    const Dataset dataset(static_cast<GDALDataset*>(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr)));
    if (!dataset) return false;
    std::array<double, 6> transform{};
    return (ground_is_placed && transform_of(*dataset, transform)) ||
           std::max(dataset->GetRasterXSize(), dataset->GetRasterYSize()) > largest_picture_side;
}

}  // namespace talus::io
