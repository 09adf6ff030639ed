#pragma once
#include <chrono>
#include <thread>

namespace talus {

/// Asks again and again, as frames do, until it is true or 20 seconds have passed: how long an answer of the
/// device takes says nothing about how often one can ask meanwhile. False when the time was up.
template <typename Ask>
bool wait_until(Ask&& ask) {
    const auto start = std::chrono::steady_clock::now();
    while (!ask()) {
        if (std::chrono::steady_clock::now() - start > std::chrono::seconds(20)) return false;
        std::this_thread::yield();
    }
    return true;
}

}  // namespace talus
