#include "app/core/self_check.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/error.h"
#include "sim/io/atomic_file.h"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

// The process that verifies; 0: none.
std::atomic<pid_t> verifying = 0;

// Runs the program to its end, with nothing on the terminal.
void run(const std::string& talus, const std::string& report) {
    posix_spawn_file_actions_t quiet;
    posix_spawn_file_actions_init(&quiet);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", O_WRONLY, 0);
    std::array<std::string, 4> given = {talus, "verify", "--json", report};
    std::array<char*, 5> words = {given[0].data(), given[1].data(), given[2].data(), given[3].data(),
                                  nullptr};
    pid_t child = 0;
    const int failed = posix_spawn(&child, words[0], &quiet, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&quiet);
    if (failed != 0) throw Error(fmt::format("'{}' cannot be run to verify this device", talus));
    verifying = child;
    int status = 0;
    waitpid(child, &status, 0);
    verifying = 0;
}

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
    run(talus.string(), report.string());
    const bool is_there = fs::exists(report, ignored);
    const nlohmann::json found = is_there ? nlohmann::json::parse(io::read_text(report)) : nlohmann::json();
    fs::remove(report, ignored);
    if (!is_there || !found.at("complete"))
        throw Error(fmt::format(
            "'{} verify' ended before it had checked all: run it in a terminal to see why", talus.string()));
    SelfCheck check;
    check.device = found.at("device");
    check.holds = found.at("holds");
    for (const nlohmann::json& row : found.at("claims")) check.rows.push_back(row_of(row));
    return check;
}

void cancel_self_check() {
    if (const pid_t child = verifying.exchange(0); child > 0) kill(child, SIGTERM);
}

}  // namespace talus::app
