#include "sim/io/tile_writer.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/gdal_dataset.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;

constexpr int block = 512;  // samples of a file's tile in a row and in a column

// Squares of block << square_levels samples are written one after the other, so that the rows held of their
// levels need no room for all columns.
constexpr int square_levels = 6;

// Rows that a thread reads at once where whole rows are cheapest.
constexpr int rows_at_once = 64;

GDALDataType gdal_type(SampleType samples) {
    return samples == SampleType::byte     ? GDT_Byte
           : samples == SampleType::uint16 ? GDT_UInt16
           : samples == SampleType::int16  ? GDT_Int16
                                           : GDT_Float32;
}

// Of a file: sizes of all levels, and which is the first that it holds.
struct WrittenLevels {
    std::vector<glm::ivec2> sizes;
    int first = 0;               // 1 where it holds overviews alone
    std::string made_of = {};    // where it does: of which content they are
    std::string otherwise = {};  // what can be done where the file cannot be written, behind that sentence
};

// A file that GDAL made and whose writing did not fail; closing it may.
class TiledOutput {
  public:
    TiledOutput(const fs::path& path, const AtomicFile& file, const TiledSource& source,
                const WrittenLevels& written)
        : path_(path),
          temporary_(file.temporary().string()),
          otherwise_(written.otherwise),
          first_level_(written.first) {
        const std::vector<glm::ivec2>& levels = written.sizes;
        const GDALDataType type = gdal_type(source.samples);
        const std::string predictor =
            fmt::format("PREDICTOR={}", source.samples == SampleType::float32 ? 3 : 2);
        const std::string block_x = fmt::format("BLOCKXSIZE={}", block);
        const std::string block_y = fmt::format("BLOCKYSIZE={}", block);
        const std::array<const char*, 9> options = {
            "TILED=YES",        block_x.c_str(),        block_y.c_str(),
            "COMPRESS=DEFLATE", predictor.c_str(),      "BIGTIFF=YES",
            "SPARSE_OK=TRUE",   "NUM_THREADS=ALL_CPUS", nullptr};
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
        const auto first = static_cast<std::size_t>(first_level_);
        dataset_.reset(driver->Create(temporary_.c_str(), levels[first].x, levels[first].y, 1, type,
                                      const_cast<char**>(options.data())));
        if (!dataset_) fail();
        if (first_level_ == 0) place(source);
        dataset_->SetMetadataItem(levels_item, levels_by_halves, levels_domain);
        if (!written.made_of.empty())
            dataset_->SetMetadataItem(made_of_item, written.made_of.c_str(), levels_domain);
        if (source.void_value) dataset_->GetRasterBand(1)->SetNoDataValue(*source.void_value);
        std::vector<int> factors;
        for (std::size_t i = first + 1; i < levels.size(); ++i) factors.push_back(1 << (i - first));
        CPLSetThreadLocalConfigOption("GDAL_TIFF_OVR_BLOCKSIZE", std::to_string(block).c_str());
        const CPLErr error = factors.empty() ? CE_None
                                             : dataset_->BuildOverviews(
                                                   "NONE", static_cast<int>(factors.size()), factors.data(),
                                                   0, nullptr, GDALDummyProgress, nullptr);
        CPLSetThreadLocalConfigOption("GDAL_TIFF_OVR_BLOCKSIZE", nullptr);
        if (error != CE_None) fail();
        bands_.push_back(dataset_->GetRasterBand(1));
        for (std::size_t i = first + 1; i < levels.size(); ++i) {
            bands_.push_back(dataset_->GetRasterBand(1)->GetOverview(static_cast<int>(i - first) - 1));
            if (glm::ivec2(bands_.back()->GetXSize(), bands_.back()->GetYSize()) != levels[i]) fail();
        }
    }

    bool holds(int level) const { return level >= first_level_; }

    // Of a level that it holds. One thread at a time.
    void write_block(int level, glm::ivec2 at, void* samples) {
        CPLErrorReset();
        if (bands_[static_cast<std::size_t>(level - first_level_)]->WriteBlock(at.x, at.y, samples) !=
                CE_None ||
            CPLGetLastErrorType() >= CE_Failure)
            fail();
    }

    void close() {
        CPLErrorReset();
        dataset_->FlushCache(true);
        if (CPLGetLastErrorType() >= CE_Failure) fail();
        dataset_.reset();
        if (CPLGetLastErrorType() >= CE_Failure) fail();
    }

  private:
    [[noreturn]] void fail() const {
        throw Error(fmt::format("cannot write '{}': {}{}", path_.string(), gdal_says_of(temporary_, path_),
                                otherwise_));
    }

    void place(const TiledSource& source) {
        // Without a place on Earth the south-west sample, a pixel's centre, lies at (0, 0).
        const Grid& grid = source.grid;
        std::array<double, 6> transform = {-grid.dx / 2, grid.dx, 0, (grid.ny - 0.5) * grid.dy, 0, -grid.dy};
        if (source.georeference) transform = source.georeference->transform;
        dataset_->SetGeoTransform(transform.data());
        OGRSpatialReference system;
        if (!source.georeference || source.georeference->wkt.empty() ||
            system.importFromWkt(source.georeference->wkt.c_str()) != OGRERR_NONE)
            return;
        system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        dataset_->SetSpatialRef(&system);
    }

    fs::path path_;
    std::string temporary_;
    std::string otherwise_;
    int first_level_;
    Dataset dataset_;
    std::vector<GDALRasterBand*> bands_;  // from the first level on
};

// Rows of a level, one tile high, until they are written.
struct LevelRows {
    int first_column = 0;
    int columns = 0;
    int first_row = 0;
    int rows = 0;
    std::vector<float> heights;  // of block rows of so many columns

    float* row(int number) { return heights.data() + static_cast<std::ptrdiff_t>(number) * columns; }
};

class TileWriter {
  public:
    TileWriter(const TiledSource& source, TiledOutput& output, const std::vector<glm::ivec2>& levels,
               const std::function<bool(double)>& told)
        : source_(source), output_(output), levels_(levels), told_(told), held_(levels.size()) {
        const auto threads = std::max(1U, std::thread::hardware_concurrency());
        for (unsigned i = 0; i < threads; ++i) readers_.push_back(source.make_reader());
    }

    bool write() {
        const glm::ivec2 size = levels_.front();
        const int square = block << square_levels;
        for (int top = 0; top < size.y; top += square)
            for (int left = 0; left < size.x; left += square)
                for (int y = top; y < std::min(top + square, size.y); y += block) {
                    LevelRows& rows = held_.front();
                    begin(rows, 0, left, y);
                    read(rows);
                    if (stopped_) return false;
                    finish(0);
                }
        return true;
    }

  private:
    // So that rows hold those of the tiles from (x, y) on: of a square's columns, or of all.
    void begin(LevelRows& rows, int level, int x, int y) {
        const glm::ivec2 size = levels_[static_cast<std::size_t>(level)];
        const bool in_squares = level <= square_levels;
        rows.first_column = in_squares ? x : 0;
        rows.columns =
            in_squares ? std::min(block << (square_levels - level), size.x - rows.first_column) : size.x;
        rows.first_row = y;
        rows.rows = std::min(block, size.y - y);
        rows.heights.resize(static_cast<std::size_t>(rows.columns) * block);
    }

    void read(LevelRows& rows) {
        const glm::ivec2 step = source_.in_rows ? glm::ivec2(rows.columns, rows_at_once) : glm::ivec2(block);
        const glm::ivec2 size(rows.columns, rows.rows);
        const glm::ivec2 parts = (size + step - 1) / step;
        in_parallel(parts.x * parts.y, [&](std::size_t thread, int part) {
            const glm::ivec2 from = glm::ivec2(part % parts.x, part / parts.x) * step;
            const glm::ivec2 count = glm::min(step, size - from);
            std::vector<float> heights;
            readers_[thread](0, {glm::ivec2(rows.first_column, rows.first_row) + from, count}, heights);
            for (int y = 0; y < count.y; ++y)
                std::copy_n(heights.data() + static_cast<std::ptrdiff_t>(y) * count.x, count.x,
                            rows.row(from.y + y) + from.x);
            const std::lock_guard lock(telling_);
            done_ += static_cast<double>(count.x) * count.y;
            const double all = static_cast<double>(source_.grid.nx) * source_.grid.ny;
            if (told_ && !stopped_ && !told_(done_ / all)) stopped_ = true;
        });
    }

    // Writes a level's rows, and those of coarser levels that are whole now.
    void finish(int level) {
        LevelRows& rows = held_[static_cast<std::size_t>(level)];
        if (output_.holds(level)) write(level, rows);
        if (level + 1 == static_cast<int>(levels_.size())) return;
        LevelRows& above = held_[static_cast<std::size_t>(level) + 1];
        const bool first_half = rows.first_row / block % 2 == 0;
        if (first_half && (rows.first_column == 0 || level + 1 <= square_levels))
            begin(above, level + 1, rows.first_column / 2, rows.first_row / 2);
        average(rows, above);
        const glm::ivec2 size = levels_[static_cast<std::size_t>(level)];
        const bool last_rows = !first_half || rows.first_row + rows.rows == size.y;
        const bool last_columns = level + 1 <= square_levels || rows.first_column + rows.columns == size.x;
        if (last_rows && last_columns) finish(level + 1);
    }

    void write(int level, LevelRows& rows) {
        in_parallel((rows.columns + block - 1) / block, [&](std::size_t, int tile) {
            const int from = tile * block;
            const int columns = std::min(block, rows.columns - from);
            std::vector<float> samples(static_cast<std::size_t>(block) * block);
            // Beyond the edge its sample goes on: that packs best.
            for (int y = 0; y < block; ++y) {
                const float* row = rows.row(std::min(y, rows.rows - 1)) + from;
                float* to = samples.data() + static_cast<std::ptrdiff_t>(y) * block;
                std::copy_n(row, columns, to);
                std::fill(to + columns, to + block, row[columns - 1]);
            }
            if (source_.void_value) set_voids(samples);
            const GDALDataType type = gdal_type(source_.samples);
            const int bytes = GDALGetDataTypeSizeBytes(type);
            std::vector<std::byte> packed(samples.size() * static_cast<std::size_t>(bytes));
            GDALCopyWords64(samples.data(), GDT_Float32, sizeof(float), packed.data(), type, bytes,
                            static_cast<GPtrDiff_t>(samples.size()));
            const std::lock_guard lock(writing_);
            output_.write_block(level, {rows.first_column / block + tile, rows.first_row / block},
                                packed.data());
        });
    }

    // A mean may be the number that stands for voids; it becomes the next one towards 0, or up from 0.
    void set_voids(std::vector<float>& samples) const {
        const float void_value = *source_.void_value;
        const bool whole = source_.samples != SampleType::float32;
        const float instead = void_value > 0
                                  ? (whole ? void_value - 1 : std::nextafter(void_value, 0.0F))
                                  : (whole ? void_value + 1 : std::nextafter(void_value, HUGE_VALF));
        for (float& h : samples) {
            const float held = whole ? std::round(h) : h;
            h = std::isnan(h) ? void_value : held == void_value ? instead : h;
        }
    }

    // Each sample above is the mean of those of 2 x 2 that are known.
    void average(LevelRows& rows, LevelRows& above) {
        const int first_column = rows.first_column / 2 - above.first_column;
        const int first_row = rows.first_row / 2 - above.first_row;
        in_parallel((rows.rows + 1) / 2, [&](std::size_t, int y) {
            const float* upper = rows.row(2 * y);
            const float* lower = rows.row(std::min(2 * y + 1, rows.rows - 1));
            float* to = above.row(first_row + y) + first_column;
            for (int x = 0; x < (rows.columns + 1) / 2; ++x) {
                const int left = 2 * x;
                const int right = std::min(2 * x + 1, rows.columns - 1);
                const std::array<float, 4> four = {upper[left], upper[right], lower[left], lower[right]};
                const float sum = (four[0] + four[1]) + (four[2] + four[3]);
                to[x] = std::isnan(sum) ? mean_of_known(four) : 0.25F * sum;
            }
        });
    }

    static float mean_of_known(const std::array<float, 4>& four) {
        float sum = 0;
        float known = 0;
        for (const float h : four) {
            if (std::isnan(h)) continue;
            sum += h;
            known += 1;
        }
        return sum / known;  // of none: not a number
    }

    // Does parts 0 to count - 1, each told the number of its thread.
    template <typename Part>
    void in_parallel(int count, const Part& part) {
        std::atomic<int> next = 0;
        std::exception_ptr failure;
        std::mutex failing;
        const auto work = [&](std::size_t thread) {
            try {
                for (int i = next++; i < count && !stopped_; i = next++) part(thread, i);
            } catch (...) {
                const std::lock_guard lock(failing);
                if (!failure) failure = std::current_exception();
                next = count;
            }
        };
        std::vector<std::thread> threads;
        for (std::size_t i = 1; i < readers_.size() && static_cast<int>(i) < count; ++i)
            threads.emplace_back(work, i);
        work(0);
        for (std::thread& thread : threads) thread.join();
        if (failure) std::rethrow_exception(failure);
    }

    const TiledSource& source_;
    TiledOutput& output_;
    const std::vector<glm::ivec2>& levels_;
    const std::function<bool(double)>& told_;
    std::vector<ReadSamples> readers_;
    std::vector<LevelRows> held_;  // by level
    std::mutex writing_;
    std::mutex telling_;
    std::atomic<bool> stopped_ = false;
    double done_ = 0;
};

// Down to one that is a single tile, and more where they are asked for.
std::vector<glm::ivec2> levels_to_write(const TiledSource& source, std::size_t least_levels) {
    std::vector<glm::ivec2> levels = halved_levels({source.grid.nx, source.grid.ny});
    const auto single = std::find_if(levels.begin(), levels.end(), [](glm::ivec2 size) {
        return size.x <= block / 2 && size.y <= block / 2;
    });
    if (single != levels.end()) {
        const auto enough = static_cast<std::size_t>(single - levels.begin()) + 1;
        levels.resize(std::min(std::max(enough, least_levels), levels.size()));
    }
    return levels;
}

bool write_levels(const fs::path& path, const TiledSource& source, const WrittenLevels& levels,
                  const std::function<bool(double)>& told) {
    start_gdal();
    std::optional<AtomicFile> file;
    try {
        file.emplace(path);
    } catch (const Error& error) {
        throw Error(error.what() + levels.otherwise);
    }
    TiledOutput output(path, *file, source, levels);
    if (!TileWriter(source, output, levels.sizes, told).write()) return false;
    output.close();
    file->commit();
    return true;
}

}  // namespace

bool write_tiled(const fs::path& path, const TiledSource& source, const std::function<bool(double)>& told,
                 std::size_t least_levels) {
    return write_levels(path, source, {levels_to_write(source, least_levels)}, told);
}

bool write_overviews(const TiledFile& raster, const std::function<bool(double)>& told) {
    const TiledSource source = raster.stored();
    return write_levels(overviews_path(raster.path()), source,
                        {levels_to_write(source, 2), 1, raster.content_mark(),
                         "; 'talus tile' writes a file elsewhere that has overviews"},
                        told);
}

void remove_overviews(const fs::path& raster) {
    start_gdal();
    const fs::path path = overviews_path(raster);
    Dataset overviews(static_cast<GDALDataset*>(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr)));
    const bool are_own = overviews && overviews->GetMetadataItem(made_of_item, levels_domain);
    overviews.reset();
    std::error_code ignored;
    if (are_own) fs::remove(path, ignored);
}

}  // namespace talus::io
