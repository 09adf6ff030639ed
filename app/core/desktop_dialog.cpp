#include "app/core/desktop_dialog.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "sim/error.h"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

bool is_installed(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (!folder.empty() && ::access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
    return false;
}

std::string patterns_of(const FileQuestion& question) {
    std::string patterns;
    for (const std::string& ending : question.endings) patterns += (patterns.empty() ? "*" : " *") + ending;
    return patterns;
}

std::vector<std::string> words_for(const std::string& program, const FileQuestion& question) {
    const std::string patterns = patterns_of(question);
    if (program == "kdialog")
        return {program,        "--title",
                question.title, question.saves ? "--getsavefilename" : "--getopenfilename",
                question.near,  patterns.empty() ? "*" : patterns};
    std::vector<std::string> words = {program, "--file-selection", "--title=" + question.title,
                                      "--filename=" + question.near};
    if (question.saves) words.emplace_back("--save");
    if (!patterns.empty()) words.emplace_back("--file-filter=" + patterns);
    if (!patterns.empty()) words.emplace_back("--file-filter=*");
    return words;
}

}  // namespace

const std::string& DesktopDialog::program() {
    static const std::string found = is_installed("zenity")    ? "zenity"
                                     : is_installed("kdialog") ? "kdialog"
                                                               : "";
    return found;
}

DesktopDialog::DesktopDialog(const FileQuestion& question) {
    std::array<int, 2> ends{};
    const auto refuse = [](int failed) {
        throw Error(fmt::format("the desktop's dialog cannot be opened by {}: {}", program(),
                                std::generic_category().message(failed)));
    };
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) refuse(errno);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    std::vector<std::string> words = words_for(program(), question);
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int failed =
        ::posix_spawnp(&process_, program().c_str(), &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    pipe_ = ends[0];
    if (failed == 0) return;
    ::close(pipe_);
    refuse(failed);
}

DesktopDialog::~DesktopDialog() {
    if (process_ > 0) {
        ::kill(process_, SIGTERM);
        while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    if (pipe_ >= 0) ::close(pipe_);
}

bool DesktopDialog::is_heard() const {
    pollfd end{pipe_, POLLIN, 0};
    return ::poll(&end, 1, 0) > 0;
}

std::optional<std::string> DesktopDialog::answer() {
    std::array<char, 512> part{};
    while (is_heard()) {
        const ssize_t count = ::read(pipe_, part.data(), part.size());
        if (count < 0 && errno == EINTR) continue;
        if (count > 0) {
            said_.append(part.data(), static_cast<std::size_t>(count));
            continue;
        }
        int status = 0;
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
        // A line, where something was chosen; other programs' talk is none.
        const bool chosen = WIFEXITED(status) && WEXITSTATUS(status) == 0;
        return chosen ? said_.substr(0, said_.find('\n')) : "";
    }
    return std::nullopt;
}

}  // namespace talus::app
