#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/claims/claims.h"
#include "app/commands/commands.h"
#include "app/core/report.h"
#include "sim/error.h"
#include "sim/io/atomic_file.h"

namespace talus::app {
namespace {

nlohmann::ordered_json row_of(const claims::Verdict& verdict) {
    nlohmann::ordered_json row;
    row["claim"] = verdict.name;
    row["says"] = verdict.says;
    // JSON has no infinity.
    if (std::isfinite(verdict.finding.figure)) row["figure"] = verdict.finding.figure;
    row["bound"] = verdict.finding.bound;
    row["unit"] = verdict.finding.unit;
    if (!verdict.error.empty()) row["error"] = verdict.error;
    row["seconds"] = verdict.seconds;
    row["holds"] = verdict.holds();
    return row;
}

// Those that were asked for, in their order.
std::vector<claims::Claim> chosen(const std::vector<std::string>& only) {
    if (only.empty()) return claims::claims();
    std::vector<claims::Claim> some;
    for (const std::string& name : only) {
        const auto found = std::find_if(claims::claims().begin(), claims::claims().end(),
                                        [&](const claims::Claim& claim) { return claim.name == name; });
        if (found == claims::claims().end()) {
            std::vector<std::string> names;
            for (const claims::Claim& claim : claims::claims()) names.push_back(claim.name);
            throw Error(
                fmt::format("--only '{}' is no claim, it must be one of: {}", name, fmt::join(names, "; ")));
        }
        some.push_back(*found);
    }
    return some;
}

}  // namespace

void verify(const VerifyOptions& options) {
    const std::vector<claims::Claim> wanted = chosen(options.only);
    const gpu::Context context(options.gpu);
    const std::string device = gpu::describe(context.device());
    fmt::print("{}\n", device);
    nlohmann::ordered_json report;
    report["device"] = device;
    report["complete"] = false;
    const auto write_report = [&] {
        if (!options.json.empty()) io::write_atomically(options.json, report.dump(2) + "\n");
    };
    // What was found is there also where the driver ends the program half way.
    write_report();
    report["claims"] = nlohmann::json::array();
    int broken = 0;
    const std::size_t count = wanted.size();
    for (std::size_t i = 0; i < count; ++i) {
        const claims::Claim& claim = wanted[i];
        say(fmt::format("[{:<20}] {} of {}: {}", std::string(20 * i / count, '='), i + 1, count, claim.name));
        const claims::Verdict verdict = verdict_on(claim);
        broken += verdict.holds() ? 0 : 1;
        const std::string found = !verdict.error.empty()
                                      ? verdict.error
                                      : fmt::format("{:>9.3g} {}, at most {:.3g}", verdict.finding.figure,
                                                    verdict.finding.unit, verdict.finding.bound);
        fmt::print("{}  {:<18} {}  ({:.1f} s)\n", verdict.holds() ? "pass" : "FAIL", verdict.name, found,
                   verdict.seconds);
        std::fflush(stdout);
        report["claims"].push_back(row_of(verdict));
        write_report();
    }
    report["holds"] = broken == 0;
    report["complete"] = true;
    write_report();
    if (broken == 0) return;
    throw Error(fmt::format(
        "{} of {} claims do not hold on this device: look for a newer driver, and report it with the "
        "file that --json writes",
        broken, count));
}

}  // namespace talus::app
