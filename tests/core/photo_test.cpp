// A photo over what somebody works on: where it is shown, and what happens to it as the terrain changes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "app/core/session.h"
#include "sim/gpu/context.h"
#include "sim/io/image_file.h"
#include "sim/io/tile_writer.h"

namespace talus::core_photo_test {
namespace {

namespace fs = std::filesystem;

class PhotosOfSessions : public testing::Test {
  protected:
    PhotosOfSessions() {
        fs::create_directories(folder_);
        setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1);
        io::TiledSource ground;
        ground.grid = {301, 201, 10, 10};
        ground.georeference = Georeference{"", {5000, 10, 0, 9000, 0, -10}};
        ground.make_reader = []() -> ReadSamples {
            return [](int, const TileSamples& samples, std::vector<float>& heights) {
                heights.clear();
                for (int y = 0; y < samples.count.y; ++y)
                    for (int x = 0; x < samples.count.x; ++x)
                        heights.push_back(static_cast<float>(100 * std::sin(0.03 * (samples.first.x + x)) *
                                                             std::cos(0.04 * (samples.first.y + y))));
            };
        };
        io::write_tiled(path("ground.tif"), ground, [](double) { return true; });
        std::vector<std::uint8_t> rgb(std::size_t{3} * 3010 * 2010);
        for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<std::uint8_t>((i * 31) % 256);
        io::write_rgb(path("photo.png"), 3010, 2010, rgb);
        // Beside a picture, where GDAL finds its place.
        std::ofstream(path("photo.pgw")) << "1\n0\n0\n-1\n5000.5\n8999.5\n";
        request_.input = path("ground.tif");
        request_.texture = path("photo.png");
    }
    ~PhotosOfSessions() override { fs::remove_all(folder_); }

    std::string path(const std::string& name) const { return folder_ / name; }
    static void draw(app::Session& session) {
        session.draw(render::view_settings(session.view(), session.simulation().parameters()), {320, 180},
                     {});
    }
    // Until nothing is to come.
    static void rest(app::Session& session) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        do {
            draw(session);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            ASSERT_LT(std::chrono::steady_clock::now(), end) << "frames never end";
        } while (session.has_tiles() || session.awaits_tiles());
    }

    fs::path folder_ = fs::temp_directory_path() / ("talus_photo_" + std::to_string(::getpid()));
    app::SceneRequest request_;
    gpu::Context context_;
};

TEST_F(PhotosOfSessions, RestInViewsThatDoNotShowThem) {
    app::Session session(request_, context_.device());
    ASSERT_TRUE(session.photo());
    session.camera() = {{1500, 900, 200}, {1800, 1500, 0}, 50};
    draw(session);
    EXPECT_TRUE(session.awaits_tiles() || session.has_tiles());
    session.view().set("render.view", "slope");
    EXPECT_FALSE(session.photo());
    rest(session);
    session.view().set("render.view", "shaded");
    rest(session);
    ASSERT_TRUE(session.photo());
    EXPECT_GT(session.photo()->drawn_tiles(), 3U);
    EXPECT_EQ(session.photo()->state(), "");
}

TEST_F(PhotosOfSessions, StayWhereTheyLieWhenTheTerrainIsCropped) {
    app::Session session(request_, context_.device());
    const glm::dvec2 first = session.photo()->laid().place.first;
    EXPECT_NEAR(first.x, 4.5, 1e-9);
    session.apply(Crop{{500, 400, 2500, 1800}});
    draw(session);
    ASSERT_TRUE(session.photo());
    EXPECT_NEAR(session.photo()->laid().place.first.x, first.x + 500, 1e-9);
    EXPECT_NEAR(session.photo()->laid().place.first.y, first.y + 200, 1e-9);
    session.undo();
    draw(session);
    ASSERT_TRUE(session.photo());
    EXPECT_EQ(session.photo()->laid().place.first, first);
    // Turned, the terrain lies otherwise or nowhere; either is said, and undone.
    session.apply(Turn{1});
    draw(session);
    EXPECT_TRUE(session.photo() || session.take_message());
    session.undo();
    draw(session);
    ASSERT_TRUE(session.photo());
    EXPECT_EQ(session.photo()->laid().place.first, first);
    rest(session);
}

TEST_F(PhotosOfSessions, AreSaidToLieBesideTheTerrain) {
    std::ofstream(path("photo.pgw")) << "1\n0\n0\n-1\n90000\n8999.5\n";
    app::Session session(request_, context_.device());
    EXPECT_FALSE(session.photo());
    const std::optional<std::string> told = session.take_message();
    ASSERT_TRUE(told);
    EXPECT_NE(told->find("the photo is not shown"), std::string::npos) << *told;
    rest(session);
}

}  // namespace
}  // namespace talus::core_photo_test
