#include "sim/io/tiled_file.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "sim/error.h"
#include "sim/io/endings.h"
#include "sim/io/gdal_dataset.h"
#include "sim/terrain/state_hash.h"
#include "sim/tiled/void_filling.h"

namespace talus::io {

namespace fs = std::filesystem;

namespace {

// Samples that a coarsest level may have for its voids to be filled.
constexpr std::int64_t most_filled = std::int64_t{1} << 24;

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

std::shared_ptr<GDALDataset> shared_raster(const fs::path& path) {
    return {open_raster(path).release(), CloseDataset()};
}

GDALRasterBand* band_of(GDALDataset& dataset, int level) {
    GDALRasterBand* band = dataset.GetRasterBand(1);
    return level == 0 ? band : band->GetOverview(level - 1);
}

// Whether a level's samples are half of the ones before, to within the rounding that writers of overviews do.
bool halves(glm::ivec2 finer, glm::ivec2 coarser) {
    const auto half = [](int fine, int coarse) {
        return coarse >= 1 && std::abs(2 * coarse - fine) <= 2 && (coarse < fine || fine == 1);
    };
    return half(finer.x, coarser.x) && half(finer.y, coarser.y);
}

std::vector<glm::ivec2> levels_of(GDALDataset& dataset) {
    GDALRasterBand* band = dataset.GetRasterBand(1);
    std::vector<glm::ivec2> levels = {{band->GetXSize(), band->GetYSize()}};
    for (int i = 0; i < band->GetOverviewCount(); ++i) {
        GDALRasterBand* overview = band->GetOverview(i);
        if (!overview || !halves(levels.back(), {overview->GetXSize(), overview->GetYSize()})) break;
        levels.emplace_back(overview->GetXSize(), overview->GetYSize());
    }
    return levels;
}

bool is_float(double number) {
    return std::isnan(number) || static_cast<double>(static_cast<float>(number)) == number;
}

// What Talus has noted in a file; empty: nothing.
std::string noted_in(GDALDataset* dataset, const char* item) {
    const char* const told = dataset ? dataset->GetMetadataItem(item, levels_domain) : nullptr;
    return told ? told : "";
}

// The file in which overviews are; null: there are none.
GDALDataset* overviews_of(GDALDataset& dataset) {
    GDALRasterBand* const overview = dataset.GetRasterBand(1)->GetOverview(0);
    return overview ? overview->GetDataset() : nullptr;
}

SampleType type_of(GDALDataType type, bool scaled) {
    if (scaled) return SampleType::float32;
    return type == GDT_Byte     ? SampleType::byte
           : type == GDT_UInt16 ? SampleType::uint16
           : type == GDT_Int16  ? SampleType::int16
                                : SampleType::float32;
}

std::vector<std::string> files_of(GDALDataset& dataset) {
    std::vector<std::string> all;
    char** files = dataset.GetFileList();
    for (char** file = files; file && *file; ++file) all.emplace_back(*file);
    CSLDestroy(files);
    return all;
}

// A file as its folder tells it; size and time are -1 where it is not there.
struct Stamp {
    std::string name;
    std::int64_t size = -1;
    std::int64_t time = -1;
};

// Also of files that GDAL alone can look into (/vsizip and the like).
Stamp stamp_of(const std::string& file, const std::string& name) {
    VSIStatBufL found{};
    if (VSIStatExL(file.c_str(), &found, VSI_STAT_EXISTS_FLAG | VSI_STAT_SIZE_FLAG) != 0) return {name};
    std::error_code failed;
    const auto time = fs::last_write_time(file, failed);
    return {name, static_cast<std::int64_t>(found.st_size),
            failed ? static_cast<std::int64_t>(found.st_mtime)
                   : static_cast<std::int64_t>(time.time_since_epoch().count())};
}

// Calls `visit` for each file that a raster is made of, parts of mosaics too, once; until that returns true.
// A mosaic lists its direct parts alone, but levels of its own too, which list the same parts again.
bool any_part(GDALDataset& dataset, const std::function<bool(const std::string&)>& visit,
              std::set<std::string>& visited) {
    const std::vector<std::string> files = files_of(dataset);
    return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
        std::error_code failed;
        const fs::path full = fs::weakly_canonical(file, failed);
        if (!visited.insert(failed ? file : full.string()).second) return false;
        if (visit(file)) return true;
        if (ending_of(file) != ".vrt" || file == dataset.GetDescription()) return false;
        const Dataset inner(static_cast<GDALDataset*>(
            GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr)));
        return inner && any_part(*inner, visit, visited);
    });
}

constexpr const char* overviews_ending = ".ovr";

// A file that the raster is made of, and overviews beside it.
struct Part {
    Stamp file;  // its name: where it lies, seen from the raster's folder
    Stamp overviews;
};

std::vector<Part> parts_of(GDALDataset& dataset, const fs::path& folder) {
    std::vector<Part> parts;
    std::set<std::string> visited;
    std::set<std::string> listed;
    const auto stamp = [&](const std::string& file) {
        // GDAL lists overviews of the raster itself, of its parts not.
        const bool is_beside =
            file.ends_with(overviews_ending) &&
            listed.contains(file.substr(0, file.size() - std::string(overviews_ending).size()));
        listed.insert(file);
        if (is_beside) return false;
        std::error_code failed;
        const fs::path full = fs::weakly_canonical(file, failed);
        parts.push_back({stamp_of(file, failed ? file : full.lexically_relative(folder).string()),
                         stamp_of(file + overviews_ending, "")});
        return false;
    };
    any_part(dataset, stamp, visited);
    return parts;
}

enum class Overviewed { no, yes };

std::string words_of(const std::vector<Part>& parts, Overviewed overviewed) {
    std::string words;
    const auto add = [&](const Stamp& stamp) {
        words += stamp.size < 0 ? fmt::format("{} absent\n", stamp.name)
                                : fmt::format("{} {} {}\n", stamp.name, stamp.size, stamp.time);
    };
    for (const Part& part : parts) {
        add(part.file);
        if (overviewed == Overviewed::yes) add(part.overviews);
    }
    return words;
}

// A copy of files, or new names for them, changes nothing that overviews are made of.
std::string content_mark_of(const std::vector<Part>& parts) {
    std::vector<std::int64_t> sizes;
    sizes.reserve(parts.size());
    for (const Part& part : parts) sizes.push_back(part.file.size);
    return fmt::format("{:016x}", bytes_hash(std::as_bytes(std::span(sizes))));
}

// Whether overviews that say what they were made of say this, and no part is newer.
bool are_made_of(GDALDataset& overviews, const std::vector<Part>& parts) {
    const std::string mark = noted_in(&overviews, made_of_item);
    if (mark.empty()) return true;
    const std::int64_t made = stamp_of(overviews.GetDescription(), "").time;
    return mark == content_mark_of(parts) &&
           std::all_of(parts.begin(), parts.end(), [&](const Part& part) { return part.file.time <= made; });
}

}  // namespace

// What readers of one file share.
struct TiledFile::Reading {
    fs::path path;
    std::vector<glm::ivec2> levels;
    LevelPlaces places = LevelPlaces::by_count;
    bool south_first = false;
    bool east_first = false;
    std::optional<float> void_value;
    float scale = 1;
    float offset_m = 0;
    // The coarsest level, its voids filled; empty where no voids are declared, or it is too large.
    std::vector<float> coarsest;

    // A level's samples; all lie within the level.
    void read_within(GDALDataset& dataset, int level, const TileSamples& samples, float* heights) const {
        const glm::ivec2 size = levels[static_cast<std::size_t>(level)];
        const glm::ivec2 count = samples.count;
        glm::ivec2 first = samples.first;
        if (east_first) first.x = size.x - first.x - count.x;
        if (south_first) first.y = size.y - first.y - count.y;
        // Errors on the way count too: GDAL reads some damaged files as zeros and only warns.
        CPLErrorReset();
        GDALRasterBand* band = band_of(dataset, level);
        if (!band ||
            band->RasterIO(GF_Read, first.x, first.y, count.x, count.y, heights, count.x, count.y,
                           GDT_Float32, 0, 0) != CE_None ||
            CPLGetLastErrorType() >= CE_Failure)
            throw Error(fmt::format("'{}' cannot be read: {}", path.string(), gdal_says()));
        const std::size_t all = static_cast<std::size_t>(count.x) * count.y;
        for (int row = 0; east_first && row < count.y; ++row)
            std::reverse(heights + static_cast<std::ptrdiff_t>(row) * count.x,
                         heights + static_cast<std::ptrdiff_t>(row + 1) * count.x);
        for (int row = 0; south_first && row < count.y / 2; ++row)
            std::swap_ranges(heights + static_cast<std::ptrdiff_t>(row) * count.x,
                             heights + static_cast<std::ptrdiff_t>(row + 1) * count.x,
                             heights + static_cast<std::ptrdiff_t>(count.y - 1 - row) * count.x);
        if (void_value)
            for (std::size_t i = 0; i < all; ++i)
                if (heights[i] == *void_value || std::isnan(heights[i])) heights[i] = unknown;
        for (std::size_t i = 0; i < all; ++i) {
            if (!std::isfinite(heights[i]) && !(void_value && std::isnan(heights[i])))
                throw Error(fmt::format(
                    "'{}' holds samples that are not finite numbers, declare them as nodata or mend them",
                    path.string()));
            heights[i] = offset_m + scale * heights[i];
        }
    }

    // Those beside the level are its edge's.
    void read(GDALDataset& dataset, int level, const TileSamples& samples,
              std::vector<float>& heights) const {
        const glm::ivec2 last = levels[static_cast<std::size_t>(level)] - 1;
        const glm::ivec2 from = glm::clamp(samples.first, glm::ivec2(0), last);
        const glm::ivec2 to = glm::clamp(samples.first + samples.count - 1, glm::ivec2(0), last);
        const glm::ivec2 count = to - from + 1;
        heights.resize(static_cast<std::size_t>(samples.count.x) * samples.count.y);
        if (count == samples.count) return read_within(dataset, level, samples, heights.data());
        std::vector<float> within(static_cast<std::size_t>(count.x) * count.y);
        read_within(dataset, level, {from, count}, within.data());
        std::size_t at = 0;
        for (int y = 0; y < samples.count.y; ++y)
            for (int x = 0; x < samples.count.x; ++x) {
                const glm::ivec2 place = glm::clamp(samples.first + glm::ivec2(x, y), from, to) - from;
                heights[at++] = within[static_cast<std::size_t>(place.y) * count.x + place.x];
            }
    }

    void fill_coarsest(const TileSamples& samples, std::vector<float>& heights) const {
        const glm::ivec2 size = levels.back();
        std::size_t at = 0;
        for (int y = 0; y < samples.count.y; ++y)
            for (int x = 0; x < samples.count.x; ++x, ++at) {
                if (!std::isnan(heights[at])) continue;
                const glm::ivec2 place =
                    glm::clamp(samples.first + glm::ivec2(x, y), glm::ivec2(0), size - 1);
                if (coarsest.empty())
                    throw Error(fmt::format(
                        "'{}' has voids and no small overview to fill them from: 'talus tile' writes a file "
                        "that has overviews",
                        path.string()));
                heights[at] = coarsest[static_cast<std::size_t>(place.y) * size.x + place.x];
            }
    }

    // Gives samples that are not known the height of the next coarser level.
    void fill(GDALDataset& dataset, int level, const TileSamples& samples,
              std::vector<float>& heights) const {
        if (std::none_of(heights.begin(), heights.end(), [](float h) { return std::isnan(h); })) return;
        if (level + 1 == static_cast<int>(levels.size())) return fill_coarsest(samples, heights);
        const glm::dvec2 ratio = places == LevelPlaces::by_halves
                                     ? glm::dvec2(2)
                                     : glm::dvec2(levels[static_cast<std::size_t>(level)]) /
                                           glm::dvec2(levels[static_cast<std::size_t>(level) + 1]);
        const auto place_of_sample = [&](glm::dvec2 sample) { return (sample + 0.5) / ratio - 0.5; };
        TileSamples coarser;
        coarser.first = glm::floor(place_of_sample(samples.first));
        coarser.count =
            glm::ivec2(glm::floor(place_of_sample(samples.first + samples.count - 1))) + 2 - coarser.first;
        std::vector<float> above;
        read(dataset, level + 1, coarser, above);
        fill(dataset, level + 1, coarser, above);
        fill_voids_from(above, coarser.count, heights, samples.count, [&](glm::ivec2 sample) {
            return place_of_sample(samples.first + sample) - glm::dvec2(coarser.first);
        });
    }
};

// Samples that are not known stay so.
ReadSamples TiledFile::reader_of(const std::shared_ptr<const Reading>& reading) {
    return [reading, own = shared_raster(reading->path)](int level, const TileSamples& samples,
                                                         std::vector<float>& heights) {
        reading->read(*own, level, samples, heights);
    };
}

TiledFile::TiledFile(const fs::path& path, const ImportSettings& settings) : path_(path) {
    const Dataset dataset = open_raster(path);
    const int nx = dataset->GetRasterXSize();
    const int ny = dataset->GetRasterYSize();
    if (dataset->GetRasterCount() < 1)
        throw Error(fmt::format("'{}' holds no band of samples", path.string()));
    if (nx < min_samples || ny < min_samples)
        throw Error(fmt::format("'{}' holds {} x {} samples, each side must have at least {}", path.string(),
                                nx, ny, min_samples));
    GDALRasterBand* band = dataset->GetRasterBand(1);
    const GDALDataType type = band->GetRasterDataType();
    if (GDALDataTypeIsComplex(type))
        throw Error(fmt::format("'{}' holds complex numbers, heights are real", path.string()));
    kind_ = fmt::format("{}, {}", dataset->GetDriver()->GetDescription(), GDALGetDataTypeName(type));
    if (dataset->GetRasterCount() > 1)
        notes_.push_back(fmt::format("the file has {} bands, the first was read", dataset->GetRasterCount()));

    auto reading = std::make_shared<Reading>();
    reading->path = path;
    reading->levels = levels_ = levels_of(*dataset);
    stored_samples_ = type_of(type, false);
    const int bands = dataset->GetRasterCount();
    const double stored_void = band->GetNoDataValue();
    why_no_overviews_ = bands > 1                ? fmt::format("it has {} bands", bands)
                        : band->GetColorTable()  ? "its numbers are colours of a table"
                        : !is_float(stored_void) ? "no float is its number for nodata"
                                                 : "";
    const fs::path folder = fs::weakly_canonical(path).parent_path();
    const std::vector<Part> parts = parts_of(*dataset, folder);
    parts_ = words_of(parts, Overviewed::yes);
    content_mark_ = content_mark_of(parts);
    GDALDataset* const beside = overviews_of(*dataset);
    if (beside) overviews_ = Overviews::some;
    if (beside && !are_made_of(*beside, parts)) {
        overviews_ = Overviews::outdated;
        reading->levels.resize(1);
        levels_.resize(1);
    }
    int has_nodata = 0;
    const double nodata = band->GetNoDataValue(&has_nodata);
    constexpr double largest = std::numeric_limits<float>::max();
    if (has_nodata)
        reading->void_value =
            static_cast<float>(std::isfinite(nodata) ? std::clamp(nodata, -largest, largest) : nodata);

    const RasterPlace place = place_of(*dataset);
    notes_.insert(notes_.end(), place.notes.begin(), place.notes.end());
    reading->south_first = place.south_first;
    reading->east_first = place.east_first;
    const bool by_halves = noted_in(dataset.get(), levels_item) == levels_by_halves ||
                           noted_in(beside, levels_item) == levels_by_halves;
    if (by_halves && !place.south_first && !place.east_first)
        reading->places = level_places_ = LevelPlaces::by_halves;
    source_.grid = {nx, ny, place.dx_m, place.dy_m};
    source_.georeference = place.georeference;
    if (settings.spacing_m) {
        source_.grid.dx = source_.grid.dy = *settings.spacing_m;
        source_.georeference.reset();
        if (place.georeference)
            notes_.emplace_back(
                "--spacing overrides the file's own, so its coordinate system no longer holds and is "
                "dropped");
    } else if (!place.georeference) {
        notes_.emplace_back("the file says no spacing, 1 m a sample was taken: --spacing sets it");
    }

    const Grid& grid = source_.grid;
    if (!(grid.dx > 0) || !(grid.dy > 0) || !std::isfinite(grid.dx) || !std::isfinite(grid.dy))
        throw Error(fmt::format("'{}' has a spacing of {} x {} m, it must be positive: --spacing sets it",
                                path.string(), grid.dx, grid.dy));

    // Whole numbers that lie nowhere are a picture's brightness.
    const bool picture = (type == GDT_Byte || type == GDT_UInt16) && !place.georeference && !has_nodata &&
                         !dataset->GetSpatialRef();
    if (settings.range_m && GDALDataTypeIsFloating(type))
        throw Error(fmt::format(
            "'{}' holds floats, and --range spreads only whole numbers of rasters in tiles", path.string()));
    if (picture) {
        Range range(0, std::max(source_.grid.width_m(), source_.grid.height_m()) / 8);
        if (settings.range_m)
            range = *settings.range_m;
        else
            notes_.push_back(fmt::format(
                "heights guessed as 0 to {:.6g} m, an eighth of the longer side: --range lo,hi sets them",
                range.y));
        reading->offset_m = static_cast<float>(range.x);
        reading->scale = static_cast<float>((range.y - range.x) / (type == GDT_Byte ? 255 : 65535));
    } else if (settings.range_m) {
        notes_.emplace_back(range_unused);
    }
    source_.samples = type_of(type, picture);
    int scaled = 0;
    int moved = 0;
    const bool as_they_stand = band->GetScale(&scaled) == 1 && band->GetOffset(&moved) == 0;
    plain_heights_ = !picture && as_they_stand && !place.south_first && !place.east_first;
    if (reading->void_value) source_.void_value = *reading->void_value;
    int block_x = 0;
    int block_y = 0;
    band->GetBlockSize(&block_x, &block_y);
    source_.in_rows = block_x >= nx;

    const glm::ivec2 size = levels_.back();
    if (has_nodata && static_cast<std::int64_t>(size.x) * size.y <= most_filled) {
        std::vector<float>& coarsest = reading->coarsest;
        reading->read(*dataset, static_cast<int>(levels_.size()) - 1, {glm::ivec2(0), size}, coarsest);
        if (!fill_voids_by_means(coarsest, size))
            throw Error(fmt::format("'{}' holds nothing but nodata, heights were expected", path.string()));
    }
    const auto hash_with = [&](const std::string& words) {
        const std::string told =
            fmt::format("{}{} {} {} {}", words, reading->scale, reading->offset_m, has_nodata, nodata);
        return bytes_hash(std::as_bytes(std::span(told)));
    };
    fingerprint_ = hash_with(words_of(parts, Overviewed::no));
    levels_fingerprint_ = hash_with(parts_);
    reading_ = reading;
    source_.make_reader = [reading] { return reader_of(reading); };
}

TiledSource TiledFile::stored() const {
    auto as_stored = std::make_shared<Reading>(*reading_);
    as_stored->south_first = as_stored->east_first = false;
    as_stored->scale = 1;
    as_stored->offset_m = 0;
    TiledSource source = source_;
    source.georeference.reset();
    source.samples = stored_samples_;
    source.make_reader = [as_stored] { return reader_of(as_stored); };
    return source;
}

bool TiledFile::has_changed() const {
    try {
        const Dataset dataset = open_raster(path_);
        const fs::path folder = fs::weakly_canonical(path_).parent_path();
        return words_of(parts_of(*dataset, folder), Overviewed::yes) != parts_;
    } catch (const std::exception&) {
        return false;
    }
}

bool is_made_of(const fs::path& raster, const fs::path& file) {
    std::set<std::string> visited;
    return any_part(
        *open_raster(raster),
        [&](const std::string& part) {
            std::error_code ignored;
            return fs::equivalent(part, file, ignored);
        },
        visited);
}

fs::path overviews_path(const fs::path& raster) {
    return raster.string() + overviews_ending;
}

ReadSamples TiledFile::make_reader() const {
    return [reading = reading_, own = shared_raster(path_)](int level, const TileSamples& samples,
                                                            std::vector<float>& heights) mutable {
        // What could not be read is looked at afresh: libtiff does not read a broken block again.
        if (!own) own = shared_raster(reading->path);
        try {
            reading->read(*own, level, samples, heights);
            reading->fill(*own, level, samples, heights);
        } catch (...) {
            own.reset();
            throw;
        }
    };
}

void limit_read_memory(std::size_t bytes) {
    GDALSetCacheMax64(static_cast<GIntBig>(bytes));
}

void return_read_memory() {
#ifdef M_MMAP_THRESHOLD
    // Blocks of rasters come and go on several threads. From the heap they leave holes, together as large as
    // all that is kept; so each has pages of its own, which go back to the system.
    constexpr int smallest_block_bytes = 128 << 10;
    mallopt(M_MMAP_THRESHOLD, smallest_block_bytes);
#endif
}

std::size_t read_memory_bytes() {
    return static_cast<std::size_t>(GDALGetCacheUsed64());
}

bool is_larger_than_a_terrain(const fs::path& path) {
    start_gdal();
    VSIStatBufL found{};
    if (VSIStatL(path.c_str(), &found) != 0 || VSI_ISDIR(found.st_mode)) return false;
    const Dataset dataset(static_cast<GDALDataset*>(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr)));
    return dataset && std::max(dataset->GetRasterXSize(), dataset->GetRasterYSize()) > max_samples;
}

}  // namespace talus::io
