#include "app/core/tile_waiting.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>
#include <utility>

#include "sim/error.h"

namespace talus::app {
namespace {

constexpr std::chrono::seconds longest_wait(20);

}  // namespace

void wait_for_tiles(const std::filesystem::path& file, const std::function<std::size_t()>& look) {
    auto end = std::chrono::steady_clock::now() + longest_wait;
    std::size_t before = 0;
    for (std::size_t missing = look(); missing > 0; missing = look()) {
        const auto now = std::chrono::steady_clock::now();
        if (missing != std::exchange(before, missing)) end = now + longest_wait;
        if (now > end)
            throw Error(fmt::format("'{}' gave no tile for {} s, and {} are missing in the picture",
                                    file.string(), longest_wait.count(), missing));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

}  // namespace talus::app
