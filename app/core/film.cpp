#include "app/core/film.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>

#include "app/core/outputs.h"
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

// ffmpeg's name of the film's format; empty: it is none that is written.
std::string format_of_film(const fs::path& path) {
    const std::string ending = io::ending_of(path);
    return ending == ".mp4" ? "mp4" : ending == ".mkv" ? "matroska" : ending == ".webm" ? "webm" : "";
}

}  // namespace

void check_film(const fs::path& path) {
    if (format_of_film(path).empty())
        throw Error(
            fmt::format("cannot write the film '{}': its ending must be .mp4, .mkv or .webm", path.string()));
    check_folder(path.string());
}

Film::Film(const fs::path& path, glm::ivec2 size) : path_(path), file_(path) {
    check_film(path);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw Error(fmt::format("cannot write the film '{}': {}", path_.string(),
                                std::generic_category().message(errno)));
    pipe_ = ends[1];
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    const std::string pixels = fmt::format("{}x{}", size.x, size.y);
    const std::string output = "file:" + file_.temporary().string();
    const std::string format = format_of_film(path_);
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
                                      pixels,
                                      "-framerate",
                                      "25",
                                      "-i",
                                      "-",
                                      "-vf",
                                      "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                      "-pix_fmt",
                                      "yuv420p",
                                      "-f",
                                      format,
                                      output};
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
    const std::string why =
        failed == ENOENT
            ? "there is no program ffmpeg; install it (Debian: ffmpeg), or write numbered pictures"
            : fmt::format("ffmpeg cannot be started: {}", std::generic_category().message(failed));
    throw Error(fmt::format("cannot write the film '{}': {}", path_.string(), why));
}

Film::~Film() {
    end_process();
}

bool Film::end_process() {
    close_end(pipe_);
    if (process_ < 0) return false;
    int status = 0;
    pid_t ended = 0;
    do ended = ::waitpid(process_, &status, 0);
    while (ended < 0 && errno == EINTR);
    const bool well = ended == process_ && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    process_ = -1;
    return well;
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
        throw Error(fmt::format("ffmpeg takes no more pictures for the film '{}': what it said stands above",
                                path_.string()));
}

void Film::finish() {
    if (!end_process())
        throw Error(
            fmt::format("ffmpeg could not write the film '{}': what it said stands above", path_.string()));
    file_.commit();
}

}  // namespace talus::app
