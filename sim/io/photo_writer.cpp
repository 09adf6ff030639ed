#include "sim/io/photo_writer.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal_utils.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/gdal_dataset.h"
#include "sim/io/photo_file.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;

// A side of the smallest overview is no longer.
constexpr int smallest_overview = 512;

// Of the work, until overviews are made.
constexpr double share_of_copy = 0.6;

// Holds for this thread while it lives.
class Setting {
  public:
    Setting(const char* name, const char* value) : name_(name) { CPLSetThreadLocalConfigOption(name, value); }
    ~Setting() { CPLSetThreadLocalConfigOption(name_, nullptr); }
    Setting(const Setting&) = delete;
    Setting& operator=(const Setting&) = delete;

  private:
    const char* name_;
};

// What GDAL tells of a part of the work.
struct Telling {
    const std::function<bool(double)>& told;
    double from;
    double share;
    bool stopped = false;

    static int tell(double done, const char*, void* data) {
        auto& telling = *static_cast<Telling*>(data);
        telling.stopped = telling.stopped || !telling.told(telling.from + telling.share * done);
        return telling.stopped ? FALSE : TRUE;
    }
};

Dataset copied(GDALDataset& photo, const fs::path& path, Telling& telling) {
    std::vector<const char*> words = {"-of", "GTiff"};
    for (const char* option : {"TILED=YES", "BLOCKXSIZE=512", "BLOCKYSIZE=512", "INTERLEAVE=PIXEL",
                               "COMPRESS=DEFLATE", "PREDICTOR=2", "BIGTIFF=YES", "NUM_THREADS=ALL_CPUS"})
        words.insert(words.end(), {"-co", option});
    if (photo.GetRasterBand(1)->GetColorTable()) words.insert(words.end(), {"-expand", "rgba"});
    words.push_back(nullptr);
    GDALTranslateOptions* options = GDALTranslateOptionsNew(const_cast<char**>(words.data()), nullptr);
    GDALTranslateOptionsSetProgress(options, Telling::tell, &telling);
    Dataset copy(static_cast<GDALDataset*>(GDALTranslate(path.c_str(), &photo, options, nullptr)));
    GDALTranslateOptionsFree(options);
    return copy;
}

bool add_overviews(GDALDataset& copy, Telling& telling) {
    std::vector<int> factors;
    for (int longest = std::max(copy.GetRasterXSize(), copy.GetRasterYSize()); longest > smallest_overview;
         longest = (longest + 1) / 2)
        factors.push_back(factors.empty() ? 2 : 2 * factors.back());
    return factors.empty() || copy.BuildOverviews("RMS", static_cast<int>(factors.size()), factors.data(), 0,
                                                  nullptr, Telling::tell, &telling) == CE_None;
}

}  // namespace

bool write_photo(const fs::path& photo, const fs::path& path, const std::function<bool(double)>& told) {
    check_colours(photo);
    const Dataset source = open_raster(photo);
    AtomicFile file(path);
    const auto check = [&](bool well, const Telling& telling) {
        if (!telling.stopped && (!well || CPLGetLastErrorType() >= CE_Failure))
            throw Error(fmt::format("cannot write '{}' of '{}': {}", path.string(), photo.string(),
                                    gdal_says_of(file.temporary(), path)));
        return !telling.stopped;
    };
    const Setting mask("GDAL_TIFF_INTERNAL_MASK", "YES");
    const Setting tiles("GDAL_TIFF_OVR_BLOCKSIZE", "512");
    const Setting threads("GDAL_NUM_THREADS", "ALL_CPUS");
    CPLErrorReset();
    Telling copying{told, 0, share_of_copy};
    Dataset copy = copied(*source, file.temporary(), copying);
    if (!check(copy != nullptr, copying)) return false;
    Telling averaging{told, share_of_copy, 1 - share_of_copy};
    const bool averaged = add_overviews(*copy, averaging);
    if (!check(averaged, averaging)) return false;
    copy->FlushCache(true);
    copy.reset();
    check(true, averaging);
    file.commit();
    return true;
}

}  // namespace talus::io
