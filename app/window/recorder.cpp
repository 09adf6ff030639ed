#include "app/window/recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

#include "app/core/legend.h"
#include "app/core/picture_file.h"
#include "app/core/wall_clock.h"
#include "sim/error.h"
#include "sim/gpu/window.h"

namespace talus::app {
namespace {

// RGBA in words, rows from below, as RGB, rows from the top, of the film's size: a picture of another one
// lies in its middle, as large as fits.
std::vector<std::uint8_t> as_picture(const std::vector<float>& words, glm::ivec2 from, glm::ivec2 size) {
    std::vector<std::uint8_t> rgb(static_cast<std::size_t>(size.x) * size.y * 3);
    const double scale = std::min(static_cast<double>(size.x) / from.x, static_cast<double>(size.y) / from.y);
    const glm::ivec2 used = glm::clamp(glm::ivec2(glm::round(scale * glm::dvec2(from))), glm::ivec2(1), size);
    const glm::ivec2 corner = (size - used) / 2;
    for (int y = 0; y < used.y; ++y) {
        const std::size_t row = static_cast<std::size_t>(from.y) - 1 -
                                static_cast<std::size_t>(y) * static_cast<std::size_t>(from.y) / used.y;
        const float* source = words.data() + row * static_cast<std::size_t>(from.x);
        std::uint8_t* to = rgb.data() + (static_cast<std::size_t>(corner.y + y) * size.x + corner.x) * 3;
        for (int x = 0; x < used.x; ++x, to += 3)
            std::memcpy(to, source + static_cast<std::size_t>(x) * static_cast<std::size_t>(from.x) / used.x,
                        3);
    }
    return rgb;
}

}  // namespace

Recorder::~Recorder() {
    finish();
}

void Recorder::toggle(const Session& session, glm::ivec2 size) {
    if (film_) return end();
    if (ending_.valid() && ending_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        throw Error("the film before is being written: wait for it");
    finish();
    path_ = free_name(session, ".mp4");
    film_ = std::make_unique<LiveFilm>(path_, size);
    cost_ms_ = 0;
}

void Recorder::show(const std::vector<float>& words) {
    std::vector<std::uint8_t> rgb = as_picture(words, pixels_size_, film_->size());
    draw_legends(legends_, film_->size(), rgb);
    film_->show(std::move(rgb), asked_s_);
}

void Recorder::follow(const Session& session, const render::ViewSettings& settings,
                      const gpu::Region& region) {
    if (!film_) return;
    const double begin_s = wall_clock_s();
    try {
        if (const auto words = pixels_.poll()) show(*words);
        if (!pixels_.pending()) {
            legends_ = session.legends(settings);
            pixels_.start(gpu::copy_window(region));
            pixels_size_ = {region.width, region.height};
            asked_s_ = begin_s;
        }
    } catch (const std::exception& error) {
        message_ = error.what();
        film_.reset();
        pixels_.cancel();
        return;
    }
    cost_ms_ += 0.1 * (1000 * (wall_clock_s() - begin_s) - cost_ms_);
}

void Recorder::end() {
    if (!film_) return;
    // A film of a moment has the picture that is on its way.
    try {
        if (pixels_.pending()) show(pixels_.wait());
    } catch (const std::exception& error) {
        message_ = error.what();
        film_.reset();
        pixels_.cancel();
        return;
    }
    ending_ = std::async(std::launch::async, [film = std::shared_ptr<LiveFilm>(std::move(film_)),
                                              path = path_, now_s = wall_clock_s()] {
        try {
            film->finish(now_s);
            return fmt::format("saved the film {}, {:.1f} s", path, film->seconds());
        } catch (const std::exception& error) {
            return std::string(error.what());
        }
    });
}

std::string Recorder::state() const {
    return film_ ? fmt::format("{:.1f} s, {:.1f} ms a frame", film_->seconds(), cost_ms_) : "";
}

std::optional<std::string> Recorder::take_message() {
    if (message_) return std::exchange(message_, std::nullopt);
    if (!ending_.valid() || ending_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    return ending_.get();
}

void Recorder::finish() {
    end();
    if (ending_.valid()) message_ = ending_.get();
}

}  // namespace talus::app
