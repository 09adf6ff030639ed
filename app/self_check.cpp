#include "app/self_check.h"

#include <fmt/format.h>

#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/gpu/error.h"
#include "sim/io/atomic_file.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

SelfCheck::Row row_of(const nlohmann::json& found) {
    SelfCheck::Row row;
    row.claim = found.at("claim");
    row.says = found.at("says");
    row.holds = found.at("holds");
    if (found.contains("error"))
        row.found = found["error"];
    else if (found.contains("figure"))
        row.found = fmt::format("{:.3g} {}, at most {:.3g}", found["figure"].get<double>(),
                                found["unit"].get<std::string>(), found["bound"].get<double>());
    else
        row.found = found.at("unit");
    return row;
}

}  // namespace

SelfCheck run_self_check() {
    const fs::path talus = fs::read_symlink("/proc/self/exe");
    const fs::path report = fs::temp_directory_path() / fmt::format("talus_verify_{}.json", ::getpid());
    std::error_code ignored;
    fs::remove(report, ignored);
    // It says with its exit code whether all claims hold; whether it came to its end, the report tells.
    const int code = std::system(
        fmt::format("'{}' verify --json '{}' > /dev/null 2>&1", talus.string(), report.string()).c_str());
    if (!fs::exists(report, ignored))
        throw Error(fmt::format(
            "'{} verify' ended with {} before it had checked all: run it in a terminal to see why",
            talus.string(), code));
    const nlohmann::json found = nlohmann::json::parse(read_text(report));
    fs::remove(report, ignored);
    SelfCheck check;
    check.device = found.at("device");
    check.holds = found.at("holds");
    for (const nlohmann::json& row : found.at("claims")) check.rows.push_back(row_of(row));
    return check;
}

}  // namespace talus
