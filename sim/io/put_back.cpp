#include "sim/io/put_back.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/endings.h"
#include "sim/io/mosaic.h"
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

void check_names(const TiledFile& whole, const PutBackSettings& settings, const fs::path& mosaic) {
    if (ending_of(settings.mosaic) != ".vrt")
        throw Error(
            fmt::format("cannot put back into '{}': a mosaic's name ends in .vrt", settings.mosaic.string()));
    if (is_made_of(whole.path(), mosaic))
        throw Error(
            fmt::format("'{}' is a part of what the terrain was cut out of, and stays as it is: give the "
                        "mosaic another name",
                        settings.mosaic.string()));
}

// A folder for the parts of one mosaic, numbered, beside those of the mosaic that it replaces. It goes again
// unless it is kept.
class PartsFolder {
  public:
    explicit PartsFolder(const fs::path& mosaic) : all_(fs::path(mosaic).replace_extension(".parts")) {
        std::error_code failed;
        fs::create_directory(all_, failed);
        int number = 1;
        while (!failed && !fs::create_directory(own_ = all_ / std::to_string(number), failed)) ++number;
        if (failed)
            throw Error(fmt::format("cannot make the folder '{}': {}", all_.string(), failed.message()));
    }
    ~PartsFolder() {
        std::error_code ignored;
        if (!kept_) fs::remove_all(own_, ignored);
        fs::remove(all_, ignored);  // where it is empty
    }
    PartsFolder(const PartsFolder&) = delete;
    PartsFolder& operator=(const PartsFolder&) = delete;

    const fs::path& path() const { return own_; }
    // The mosaic that the others belonged to is replaced.
    void keep_alone() {
        kept_ = true;
        std::error_code ignored;
        for (const fs::directory_entry& one : fs::directory_iterator(all_, ignored)) {
            const std::string name = one.path().filename().string();
            const bool numbered = !name.empty() && std::all_of(name.begin(), name.end(),
                                                               [](char c) { return c >= '0' && c <= '9'; });
            if (numbered && one.path() != own_) fs::remove_all(one.path(), ignored);
        }
    }

  private:
    fs::path all_;
    fs::path own_;
    bool kept_ = false;
};

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
    if (whole.fingerprint() != document.cut_out->fingerprint && !settings.though_changed)
        throw Error(
            fmt::format("'{}' was changed since the terrain was cut out of it: what changed there would be "
                        "taken for work and be lost; --though-changed puts it back all the same",
                        whole.path().string()));
    if (!whole.holds_plain_heights())
        throw Error(fmt::format(
            "'{}' holds numbers that are not heights as they stand, or begins in the south or east: "
            "cut the terrain out of what 'talus tile' makes of it",
            whole.path().string()));
    // Where it is a link, the mosaic stands where that leads, and its parts beside it.
    const fs::path mosaic = fs::weakly_canonical(fs::absolute(settings.mosaic));
    check_names(whole, settings, mosaic);
    const Placed in = placed(document, whole, settings.feather_m);
    // The mosaic that was there keeps its parts until the new one takes its place, which one rename does.
    AtomicFile file(mosaic);
    PartsFolder parts(mosaic);
    PutBack done;
    done.patch = parts.path() / "patch.tif";
    done.changed = in.changes;
    done.rectangle = patch_rectangle(in, whole);
    if (!write_tiled(done.patch, patch_source(whole, in, done.rectangle), told, whole.levels().size()))
        return std::nullopt;
    write_mosaic(whole, {done.patch, done.rectangle}, {mosaic, file.temporary(), parts.path()});
    if (told && !told(1)) return std::nullopt;
    file.commit();
    parts.keep_alone();
    // They are of the mosaic that was replaced.
    remove_overviews(mosaic);
    return done;
}

}  // namespace talus::io
