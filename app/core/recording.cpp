#include "app/core/recording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "app/core/flight.h"
#include "app/core/outputs.h"
#include "sim/error.h"
#include "sim/io/endings.h"
#include "sim/io/heightmap_formats.h"
#include "sim/io/image_file.h"

namespace talus::app {
namespace {

constexpr std::int64_t most_records = 1'000'000;

const std::regex& number_pattern() {
    static const std::regex pattern("%(0([1-9]))?d");
    return pattern;
}

}  // namespace

bool is_series(const std::string& path) {
    const auto first = std::sregex_iterator(path.begin(), path.end(), number_pattern());
    return std::distance(first, std::sregex_iterator()) == 1;
}

std::string one_of_series(const std::string& path, std::int64_t number) {
    std::smatch found;
    if (!std::regex_search(path, found, number_pattern())) return path;
    const int digits = found[2].matched ? std::stoi(found[2].str()) : 1;
    return found.prefix().str() + fmt::format("{:0{}}", number, digits) + found.suffix().str();
}

void check_recording(const RecordingOptions& options) {
    const bool writes = !options.files.empty() || !options.image.empty() || !options.film.empty();
    if (options.every_s && !(*options.every_s > 0 && *options.every_s < 1e15))
        throw Error(fmt::format("--every {} cannot be, it must be more than 0 seconds", *options.every_s));
    if (options.every_s && !writes)
        throw Error(
            "--every writes nothing: give --film, or number the files of --out or --image, as in "
            "'depth_%05d.tif'");
    if (!options.every_s && (!options.files.empty() || !options.image.empty()))
        throw Error(
            fmt::format("'{}' numbers files, but --every does not say after how many seconds each is due",
                        options.files.empty() ? options.image : options.files.front()));
    if (!options.keys.empty() && options.image.empty() && options.film.empty())
        throw Error("--keys moves the camera of --film or of numbered pictures: give one of them");
    const glm::ivec2 size = options.size;
    if (size.x < 16 || size.y < 16 || size.x > 8192 || size.y > 8192)
        throw Error(fmt::format("pictures of {}x{} cannot be recorded, each side must be 16 to 8192 pixels",
                                size.x, size.y));
}

Recording::Recording(const RecordingOptions& options, const Scene& scene, Simulation& simulation,
                     const gpu::Device& device, std::int64_t ticks)
    : options_(options),
      scene_(scene),
      simulation_(simulation),
      start_s_(simulation.clock().simulated_s),
      every_s_(options.every_s.value_or(simulation.parameters().number("time.tick_s"))) {
    const double records =
        std::floor(static_cast<double>(ticks) * simulation.parameters().number("time.tick_s") / every_s_) + 1;
    if (records > most_records)
        throw Error(fmt::format("--every {} would write {:.3g} times, at most {} are written", every_s_,
                                records, most_records));
    if (!options.image.empty() || !options.film.empty()) {
        pictures_ = std::make_unique<RunPictures>(scene, simulation, device, options.size);
        if (options.keys.empty())
            way_ = {pictures_->first_look()};
        else
            way_ = fly_along(read_keys(options.keys, pictures_->first_look().fov_deg),
                             static_cast<int>(records));
    }
    if (!options.film.empty()) film_.emplace(options.film, options.size);
    write();
}

void Recording::record() {
    // Ticks need not divide what lies between records.
    const double due_s = start_s_ + static_cast<double>(count_) * every_s_;
    if (simulation_.clock().simulated_s >= due_s - 1e-9 * std::max(1.0, due_s)) write();
}

void Recording::write() {
    if (!options_.files.empty()) {
        io::Document document = scene_.document;
        document.state = simulation_.read();
        for (const std::string& file : options_.files)
            write_terrain(one_of_series(file, count_), document, options_.layer, std::nullopt);
    }
    if (pictures_) {
        const render::Camera& camera = way_[std::min(static_cast<std::size_t>(count_), way_.size() - 1)];
        const std::vector<std::uint8_t> rgb = pictures_->take(camera);
        if (!options_.image.empty())
            io::write_rgb(one_of_series(options_.image, count_), options_.size.x, options_.size.y, rgb);
        if (film_) film_->add(rgb);
    }
    ++count_;
}

void Recording::finish() {
    if (film_) film_->finish();
}

}  // namespace talus::app
