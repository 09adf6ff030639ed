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
    Dataset expanded;  // a table's colours as bands; null: it has none
    Dataset warped;    // null: it lies as the ground does

    GDALDataset& top() const { return warped ? *warped : expanded ? *expanded : *source; }
};

bool transform_of(GDALDataset& dataset, std::array<double, 6>& transform) {
    return dataset.GetGeoTransform(transform.data()) == CE_None && transform[1] != 0 && transform[5] != 0;
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

bool is_alpha(GDALRasterBand& band) {
    return band.GetColorInterpretation() == GCI_AlphaBand;
}

// Bands of red, green and blue.
std::array<int, 3> colour_bands(const fs::path& path, GDALDataset& dataset) {
    if (dataset.GetRasterCount() < 1)
        throw Error(fmt::format("'{}' holds no band of colours", path.string()));
    std::vector<int> colours;
    for (int number = 1; number <= dataset.GetRasterCount(); ++number) {
        GDALRasterBand& band = *dataset.GetRasterBand(number);
        if (is_alpha(band)) continue;
        const GDALDataType type = band.GetRasterDataType();
        if (type != GDT_Byte && type != GDT_UInt16)
            throw Error(fmt::format("'{}' holds {} numbers, colours of a photo have 8 or 16 bits",
                                    path.string(), GDALGetDataTypeName(type)));
        colours.push_back(number);
    }
    if (colours.size() == 1) return {colours[0], colours[0], colours[0]};
    if (colours.size() < 3)
        throw Error(
            fmt::format("'{}' has {} bands of colours, a photo has 1 or 3", path.string(), colours.size()));
    return {colours[0], colours[1], colours[2]};
}

Dataset with_colours_as_bands(const fs::path& path, GDALDataset& dataset) {
    std::array<const char*, 5> words = {"-of", "VRT", "-expand", "rgba", nullptr};
    const std::unique_ptr<GDALTranslateOptions, FreeOptions> options(
        GDALTranslateOptionsNew(const_cast<char**>(words.data()), nullptr));
    Dataset expanded(static_cast<GDALDataset*>(GDALTranslate("", &dataset, options.get(), nullptr)));
    if (!expanded) throw Error(fmt::format("'{}' cannot be read: {}", path.string(), gdal_says()));
    return expanded;
}

Dataset as_the_ground_lies(const fs::path& path, GDALDataset& dataset, const Georeference& ground) {
    std::vector<std::string> words = {"-of", "VRT", "-r", "bilinear", "-dstalpha"};
    if (!ground.wkt.empty()) words.insert(words.end(), {"-t_srs", ground.wkt});
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::unique_ptr<GDALWarpAppOptions, FreeOptions> options(
        GDALWarpAppOptionsNew(pointers.data(), nullptr));
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
    colour_bands(path, *opened.source);
    if (opened.source->GetRasterBand(1)->GetColorTable())
        opened.expanded = with_colours_as_bands(path, *opened.source);
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
          bands_(colour_bands(path, opened_.top())),
          levels_(halved_levels({opened_.top().GetRasterXSize(), opened_.top().GetRasterYSize()})) {
        GDALRasterBand* first = opened_.top().GetRasterBand(bands_[0]);
        if ((first->GetMaskFlags() & GMF_ALL_VALID) == 0) mask_ = first->GetMaskBand();
    }

    const Opened& opened() const { return opened_; }

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
        // GDAL takes the overview that is the next finer one.
        if (level > 0) how.eResampleAlg = GRIORA_Average;
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
        const int bands = is_grey() ? 1 : 3;
        const auto read_colours = [&](void* into, GDALDataType type, GSpacing step) {
            CPLErrorReset();
            check(dataset.RasterIO(GF_Read, first.x, first.y, window.x, window.y, into, count.x, count.y,
                                   type, bands, bands_.data(), step, step * count.x,
                                   GDALGetDataTypeSizeBytes(type), &how));
        };
        if (dataset.GetRasterBand(bands_[0])->GetRasterDataType() == GDT_Byte) {
            read_colours(&within_.front().r, GDT_Byte, sizeof(PhotoTexel));
        } else {
            std::vector<std::array<std::uint16_t, 3>> wide(within_.size());
            read_colours(wide.data(), GDT_UInt16, sizeof(wide.front()));
            const auto narrow = [](int colour) { return static_cast<std::uint8_t>((colour + 128) / 257); };
            for (std::size_t i = 0; i < within_.size(); ++i)
                within_[i] = {narrow(wide[i][0]), narrow(wide[i][1]), narrow(wide[i][2]), 255};
        }
        if (is_grey())
            for (PhotoTexel& texel : within_) texel.g = texel.b = texel.r;
        if (!mask_) return;
        CPLErrorReset();
        check(mask_->RasterIO(GF_Read, first.x, first.y, window.x, window.y, &within_.front().a, count.x,
                              count.y, GDT_Byte, sizeof(PhotoTexel),
                              static_cast<GSpacing>(sizeof(PhotoTexel)) * count.x, &how));
        for (PhotoTexel& texel : within_) {
            if (texel.a == 255) continue;
            const float share = static_cast<float>(texel.a) / 255.0F;
            texel = {to_screen(share * from_screen(texel.r)), to_screen(share * from_screen(texel.g)),
                     to_screen(share * from_screen(texel.b)), texel.a};
        }
    }

    // Errors on the way count too: GDAL reads some damaged files as zeros and only warns.
    void check(CPLErr error) const {
        if (error != CE_None || CPLGetLastErrorType() >= CE_Failure)
            throw Error(fmt::format("'{}' cannot be read: {}", path_.string(), gdal_says()));
    }

    bool is_grey() const { return bands_[0] == bands_[1]; }

    fs::path path_;
    Opened opened_;
    std::array<int, 3> bands_;
    std::vector<glm::ivec2> levels_;
    GDALRasterBand* mask_ = nullptr;  // null: all is covered
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

ReadTexels PhotoFile::make_reader() const {
    return [path = path_, ground = ground_, reader = std::make_shared<PhotoReader>(path_, ground_)](
               int level, const TileSamples& samples, std::vector<PhotoTexel>& texels) mutable {
        // What could not be read is looked at afresh: libtiff does not read a broken block again.
        if (!reader) reader = std::make_shared<PhotoReader>(path, ground);
        try {
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
