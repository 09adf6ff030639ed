#pragma once
#include <string>
#include <vector>

namespace talus::app {

/// What `talus verify` found, as the window shows it.
struct SelfCheck {
    struct Row {
        std::string claim;
        std::string says;
        std::string found;  ///< figure, unit and bound, or what was thrown
        bool holds = false;
    };
    std::string device;
    std::vector<Row> rows;
    bool holds = false;
};

/// Runs `talus verify` as a process of its own, which touches nothing of this one, and reads its findings: a
/// minute or two. Throws talus::Error when it does not run to its end.
SelfCheck run_self_check();

/// Ends the one that goes on, if any: run_self_check() throws then.
void cancel_self_check();

}  // namespace talus::app
