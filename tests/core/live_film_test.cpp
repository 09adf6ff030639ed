// Films of what is shown: as long as it was shown, with a program in ffmpeg's place that keeps what it is
// given.
#include "app/core/live_film.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "sim/error.h"

namespace talus::live_film_test {
namespace {

namespace fs = std::filesystem;

constexpr glm::ivec2 size(6, 4);

class LiveFilms : public testing::Test {
  protected:
    LiveFilms() : folder_(fs::temp_directory_path() / ("talus_film_" + std::to_string(getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        path_before_ = std::getenv("PATH");
    }
    ~LiveFilms() override {
        setenv("PATH", path_before_.c_str(), 1);
        fs::remove_all(folder_);
    }
    // A shell script in ffmpeg's place.
    void be_ffmpeg(const std::string& script) {
        const fs::path program = folder_ / "ffmpeg";
        std::ofstream(program) << "#!/bin/sh\n" << script;
        fs::permissions(program, fs::perms::owner_all);
        setenv("PATH", (folder_.string() + ":" + path_before_).c_str(), 1);
    }
    void keep_all() { be_ffmpeg("for last; do :; done\ncat > \"${last#file:}\"\n"); }
    std::string film() const { return (folder_ / "film.mp4").string(); }
    // The first byte of each picture of the film.
    std::string pictures() const {
        std::ifstream file(film(), std::ios::binary);
        const std::string all((std::istreambuf_iterator<char>(file)), {});
        constexpr std::size_t bytes = 3UL * size.x * size.y;
        EXPECT_EQ(all.size() % bytes, 0U);
        std::string firsts;
        for (std::size_t i = 0; i < all.size(); i += bytes) firsts += all[i];
        return firsts;
    }

    fs::path folder_;
    std::string path_before_;
};

std::vector<std::uint8_t> picture(char letter) {
    return std::vector<std::uint8_t>(3UL * size.x * size.y, static_cast<std::uint8_t>(letter));
}

TEST_F(LiveFilms, ShowEachPictureAsLongAsItWasShown) {
    keep_all();
    app::LiveFilm live(film(), size);
    live.show(picture('a'), 10);
    live.show(picture('b'), 10.2);   // five pictures later
    live.show(picture('c'), 10.21);  // shorter than one of the film
    live.show(picture('d'), 10.24);
    live.show(picture('e'), 100);  // nothing new for a minute and a half: two seconds of it
    live.finish(100.4);
    EXPECT_EQ(pictures(),
              "aaaaa"
              "c" +
                  std::string(50, 'd') + std::string(10, 'e'));
    EXPECT_DOUBLE_EQ(live.seconds(), 66 / 25.0);
}

TEST_F(LiveFilms, OfOneMomentHaveAPicture) {
    keep_all();
    app::LiveFilm live(film(), size);
    live.show(picture('a'), 3);
    live.finish(3);
    EXPECT_EQ(pictures(), "a");
}

// The window never waits for ffmpeg, and the film is as long all the same.
TEST_F(LiveFilms, LeaveOutWhatFfmpegCannotFollow) {
    be_ffmpeg("sleep 1\nfor last; do :; done\ncat > \"${last#file:}\"\n");
    const glm::ivec2 large(640, 480);
    app::LiveFilm live(film(), large);
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < 100; ++i) live.show(std::vector<std::uint8_t>(3UL * large.x * large.y), 0.04 * i);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(800));
    live.finish(4);
    EXPECT_EQ(fs::file_size(film()) / (3UL * large.x * large.y), 100U);
}

TEST_F(LiveFilms, ThatFailLeaveWhatWasThere) {
    std::ofstream(film()) << "before";
    be_ffmpeg("exit 1\n");
    {
        app::LiveFilm live(film(), size);
        const auto fill = [&] {
            for (int i = 0; i < 400; ++i) {
                live.show(picture('a'), 0.04 * i);
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
            live.finish(20);
        };
        EXPECT_THROW(fill(), Error);
    }
    // One that is given up.
    keep_all();
    app::LiveFilm(film(), size).show(picture('a'), 0);
    std::ifstream file(film());
    std::string text;
    file >> text;
    EXPECT_EQ(text, "before");
    setenv("PATH", "/nowhere", 1);
    EXPECT_THROW(app::LiveFilm(film(), size), Error);
}

}  // namespace
}  // namespace talus::live_film_test
