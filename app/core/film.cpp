#include "app/core/film.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <utility>

#include "sim/error.h"
#include "sim/io/endings.h"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

// The end of a pipe that is to be closed.
void close_end(int& end) {
    if (end >= 0) ::close(end);
    end = -1;
}

}  // namespace

Film::Film(fs::path path, glm::ivec2 size) : path_(std::move(path)), part_(path_) {
    const std::string ending = io::ending_of(path_);
    if (ending != ".mp4" && ending != ".mkv" && ending != ".webm")
        throw Error(fmt::format("cannot write the film '{}': its ending must be .mp4, .mkv or .webm",
                                path_.string()));
    if (!fs::is_directory(fs::absolute(path_).parent_path()))
        throw Error(fmt::format("cannot write the film '{}': there is no folder '{}'", path_.string(),
                                fs::absolute(path_).parent_path().string()));
    part_.replace_extension(".part" + ending);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw Error("no pipe to ffmpeg can be opened, too many files are open");
    pipe_ = ends[1];
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    // Encoders want even sides.
    std::vector<std::string> words = {"ffmpeg",
                                      "-y",
                                      "-loglevel",
                                      "error",
                                      "-f",
                                      "rawvideo",
                                      "-pixel_format",
                                      "rgb24",
                                      "-video_size",
                                      fmt::format("{}x{}", size.x, size.y),
                                      "-framerate",
                                      "25",
                                      "-i",
                                      "-",
                                      "-vf",
                                      "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                      "-pix_fmt",
                                      "yuv420p",
                                      "file:" + part_.string()};
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int failed = ::posix_spawnp(&process_, "ffmpeg", &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    close_end(ends[0]);
    if (failed == 0) return;
    process_ = -1;
    close_end(pipe_);
    throw Error(
        fmt::format("cannot write the film '{}': there is no program ffmpeg; install it (Debian: ffmpeg), or "
                    "write numbered pictures",
                    path_.string()));
}

Film::~Film() {
    end_process();
    std::error_code ignored;
    fs::remove(part_, ignored);
}

void Film::end_process() {
    close_end(pipe_);
    if (process_ > 0) ::waitpid(process_, &status_, 0);
    process_ = -1;
}

void Film::add(const std::vector<std::uint8_t>& rgb) {
    // Should ffmpeg end, writing fails instead of ending this program.
    struct sigaction ignore {};
    struct sigaction before {};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &ignore, &before);
    std::size_t done = 0;
    while (done < rgb.size()) {
        const ssize_t written = ::write(pipe_, rgb.data() + done, rgb.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) break;
        done += static_cast<std::size_t>(written);
    }
    ::sigaction(SIGPIPE, &before, nullptr);
    if (done < rgb.size())
        throw Error(fmt::format("ffmpeg takes no more pictures for the film '{}'", path_.string()));
}

void Film::finish() {
    end_process();
    std::error_code failed;
    const bool wrote = WIFEXITED(status_) && WEXITSTATUS(status_) == 0 && fs::exists(part_, failed);
    if (wrote) fs::rename(part_, path_, failed);
    if (!wrote || failed)
        throw Error(
            fmt::format("ffmpeg could not write the film '{}': what it said stands above", path_.string()));
}

}  // namespace talus::app
