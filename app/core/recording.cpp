#include "app/core/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

#include "app/core/flight.h"
#include "app/core/outputs.h"
#include "sim/error.h"
#include "sim/io/image_file.h"

namespace talus::app {
namespace {

constexpr std::int64_t most_records = 1'000'000;

// How often something is due that is due first at 0 s, in so many ticks. They need not divide what lies
// between.
std::int64_t times_due(std::int64_t ticks, double tick_s, double every_s) {
    return static_cast<std::int64_t>(std::floor((static_cast<double>(ticks) + 1e-6) * tick_s / every_s)) + 1;
}

const std::regex& series_number() {
    static const std::regex pattern("%(0([1-9]))?d");
    return pattern;
}

}  // namespace

bool is_series(const std::string& path) {
    const std::string name = std::filesystem::path(path).filename().string();
    // All that looks like a number.
    static const std::regex any_number("%[0-9]*d");
    const auto numbers =
        std::distance(std::sregex_iterator(name.begin(), name.end(), any_number), std::sregex_iterator());
    if (numbers == 0) return false;
    if (numbers > 1 || !std::regex_search(name, series_number()))
        throw Error(
            fmt::format("'{}' cannot be numbered: its name must have one %d, or one like %05d", path));
    return true;
}

std::string one_of_series(const std::string& path, std::int64_t number) {
    const std::filesystem::path whole(path);
    const std::string name = whole.filename().string();
    std::smatch found;
    if (!std::regex_search(name, found, series_number())) return path;
    const int digits = found[2].matched ? std::stoi(found[2].str()) : 1;
    return (whole.parent_path() /
            (found.prefix().str() + fmt::format("{:0{}}", number, digits) + found.suffix().str()))
        .string();
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
    if (!options.film.empty()) check_film(options.film);
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
      simulation_(simulation),
      document_(scene.document),
      start_ticks_(simulation.clock().ticks),
      tick_s_(simulation.parameters().number("time.tick_s")),
      every_s_(options.every_s.value_or(tick_s_)) {
    document_.state = TerrainState();
    if (every_s_ < tick_s_)
        throw Error(fmt::format("--every {} is less than a tick, it must be at least time.tick_s = {} s",
                                every_s_, tick_s_));
    const std::int64_t records = times_due(ticks, tick_s_, every_s_);
    if (records > most_records)
        throw Error(fmt::format(
            "a record every {} s would be written {} times, at most {} are: give a larger --every", every_s_,
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

bool Recording::is_due() const {
    return times_due(simulation_.clock().ticks - start_ticks_, tick_s_, every_s_) > count_;
}

void Recording::write() {
    if (!options_.files.empty()) {
        bring_up(document_, simulation_);
        for (const std::string& file : options_.files)
            write_terrain(one_of_series(file, count_), document_, options_.layer, std::nullopt);
        document_.state = TerrainState();
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
