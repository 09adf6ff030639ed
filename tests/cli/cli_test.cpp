// The program as people and scripts run it: exit codes, sentences, files, hashes.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

namespace talus {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Outcome {
    int code = -1;
    std::string output;  // of both streams
};

class Program : public ::testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    // `before` may hold assignments of the environment.
    Outcome talus(const std::string& arguments, const std::string& before = "") const {
        const std::string command =
            "cd " + folder_.string() + " && " + before + " " TALUS_BINARY " " + arguments + " 2>&1";
        Outcome outcome;
        FILE* pipe = ::popen(command.c_str(), "r");
        std::array<char, 4096> chunk{};
        while (std::fgets(chunk.data(), chunk.size(), pipe)) outcome.output += chunk.data();
        const int status = ::pclose(pipe);
        outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        return outcome;
    }
    std::string bytes_of(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
    json report(const std::string& name) const { return json::parse(std::ifstream(path(name))); }
    std::string hash(const std::string& arguments, const std::string& before = "") const {
        const Outcome outcome = talus(arguments + " --report hash.json", before);
        EXPECT_EQ(outcome.code, 0) << outcome.output;
        return report("hash.json")["hash"];
    }
    // One sentence after the program's name, and exit code 1 or 2.
    std::string refusal(const std::string& arguments, const std::string& before = "") const {
        const Outcome outcome = talus(arguments, before);
        EXPECT_TRUE(outcome.code == 1 || outcome.code == 2) << arguments << ": " << outcome.code << "\n"
                                                            << outcome.output;
        const auto at = outcome.output.find("talus: ");
        EXPECT_NE(at, std::string::npos) << arguments << "\n" << outcome.output;
        if (at == std::string::npos) return "";
        std::string sentence = outcome.output.substr(at + 7);
        EXPECT_EQ(sentence.find('\n'), sentence.size() - 1) << sentence;
        return sentence;
    }

  private:
    fs::path folder_ = fs::temp_directory_path() / ("talus_cli_" + std::to_string(::getpid()));
};

const std::string small = "run --preset alpine --size 130x97 ";

TEST_F(Program, RunLeavesFilesThatItCanReadAgain) {
    const Outcome outcome =
        talus(small + "--ticks 40 --out a.tif --out a.exr --out a.png --out a.r16 --out a.r32 --image a.jpg");
    EXPECT_EQ(outcome.code, 1) << "a picture that cannot be written is refused before the run";
    EXPECT_FALSE(fs::exists(path("a.tif")));
    ASSERT_EQ(talus(small + "--ticks 40 --out a.tif --out a.exr --out a.png --out a.r16 --out a.r32 --image "
                            "a_view.png --report r.json")
                  .code,
              0);
    const json r = report("r.json");
    EXPECT_EQ(r["nx"], 130);
    EXPECT_EQ(r["ny"], 97);
    EXPECT_EQ(r["ticks"], 40);
    EXPECT_NEAR(r["simulated_s"], 40.0 / 60, 1e-9);
    EXPECT_GT(r["ledger"]["moved_m3"], 0);
    EXPECT_LE(r["ledger"]["closing_error_of_moved"], 1e-6);
    for (const char* key : {"device", "dx", "dy", "wall_s", "cpu_s", "hash", "height_min", "height_max"})
        EXPECT_TRUE(r.contains(key)) << key;
    for (const char* name : {"a.tif", "a.exr", "a.png", "a.r16", "a.r32"}) {
        const Outcome about = talus(std::string("info --json ") + name);
        ASSERT_EQ(about.code, 0) << about.output;
        const json j = json::parse(about.output);
        EXPECT_EQ(j["nx"], 130) << name;
        EXPECT_EQ(j["dx"], 20) << name;
        EXPECT_NEAR(j["height_max"], r["height_max"], 0.02) << name;
    }
    EXPECT_GT(fs::file_size(path("a_view.png")), 50000U);
}

TEST_F(Program, OneHashForThreadsContinuationAndReplay) {
    const std::string whole = hash(small + "--ticks 60 --journal run.journal --out whole.exr");
    for (const char* threads :
         {"LP_NUM_THREADS=0", "LP_NUM_THREADS=1", "LP_NUM_THREADS=2", "LP_NUM_THREADS=4"})
        EXPECT_EQ(hash(small + "--ticks 60", threads), whole) << threads;
    EXPECT_EQ(hash("replay run.journal"), whole);
    hash(small + "--ticks 25 --out mid.exr");
    EXPECT_EQ(hash("run --preset alpine --in mid.exr --ticks 35"), whole);
    EXPECT_EQ(hash("run --in mid.exr --ticks 35"), whole) << "the document brings its parameters";
    EXPECT_EQ(hash("run --in whole.exr --ticks 0"), whole);
    EXPECT_NE(hash(small + "--ticks 61"), whole);
}

TEST_F(Program, ConvertsWithoutLosingABit) {
    ASSERT_EQ(talus(small + "--ticks 5 --out a.exr").code, 0);
    ASSERT_EQ(talus("convert a.exr b.tif").code, 0);
    ASSERT_EQ(talus("convert b.tif c.r32").code, 0);
    ASSERT_EQ(talus("convert c.r32 d.tif").code, 0);
    const json b = json::parse(talus("info --json b.tif").output);
    const json d = json::parse(talus("info --json d.tif").output);
    EXPECT_EQ(b["hash"], d["hash"]);
    ASSERT_EQ(talus("convert a.exr e.tif --layer regolith").code, 0);
    EXPECT_LT(json::parse(talus("info --json e.tif").output)["height_max"], b["height_max"]);
    ASSERT_EQ(talus("convert b.tif f.png --range -500,4000").code, 0);
    EXPECT_NEAR(json::parse(talus("info --json f.png").output)["height_max"], b["height_max"], 0.035);
    EXPECT_EQ(report("f.png.json")["range_m"], json({-500, 4000}))
        << "--range is the range of what is written";
}

TEST_F(Program, RendersWithDepthAndViews) {
    ASSERT_EQ(talus(small + "--ticks 0 --out a.exr").code, 0);
    for (const char* view : {"shaded", "hillshade", "slope", "bands", "steps", "cells", "aspect", "contours",
                             "difference", "depth", "speed", "level", "froude"}) {
        const Outcome outcome = talus(std::string("render a.exr --size 320x180 --image v.png --depth d.exr "
                                                  "--report v.json --view ") +
                                      view);
        ASSERT_EQ(outcome.code, 0) << outcome.output;
        EXPECT_GT(report("v.json")["pixels_hit"], 10000);
    }
    for (const char* method : {"exact", "boxes", "mesh", "hybrid"}) {
        const Outcome outcome =
            talus(std::string("render a.exr --size 320x180 --report m.json --method ") + method);
        ASSERT_EQ(outcome.code, 0) << outcome.output;
        EXPECT_NEAR(report("m.json")["pixels_hit"].get<int>(), report("v.json")["pixels_hit"].get<int>(), 300)
            << method;
    }
    ASSERT_EQ(
        talus("render a.exr --size 64x48 --eye 1000,900,5000 --target 1000,900,0 --fov 40 --depth d.exr")
            .code,
        0);
    EXPECT_GT(fs::file_size(path("d.exr")), 1000U);
}

// A file in tiles is drawn as the whole is; what comes with it is made once and told.
TEST_F(Program, DrawsFilesInTiles) {
    ASSERT_EQ(talus("run --preset alpine --size 1100x900 --ticks 0 --out a.tif").code, 0);
    const Outcome tiled = talus("tile a.tif b.tif");
    ASSERT_EQ(tiled.code, 0) << tiled.output;
    EXPECT_NE(tiled.output.find("1100 x 900 samples, 4 levels"), std::string::npos) << tiled.output;
    EXPECT_TRUE(fs::exists(path("b.tif.tiles")));
    EXPECT_EQ(json::parse(talus("info --json b.tif").output)["hash"],
              json::parse(talus("info --json a.tif").output)["hash"]);
    ASSERT_EQ(
        talus("render a.tif --size 480x270 --method exact --depth a.exr --image a.png --report a.json").code,
        0);
    const std::string draw = "render b.tif --size 480x270 --tiled --set render.tolerance_px=";
    ASSERT_EQ(talus(draw + "0 --depth b.exr --report b.json").code, 0);
    EXPECT_EQ(report("a.json")["pixels_hit"], report("b.json")["pixels_hit"]);
    ASSERT_EQ(talus(draw + "2 --report c.json --image c.png").code, 0);
    EXPECT_NEAR(report("c.json")["pixels_hit"].get<double>(), report("a.json")["pixels_hit"], 300);
    EXPECT_LT(report("c.json")["tiles"]["drawn"], report("b.json")["tiles"]["drawn"]);
    EXPECT_EQ(report("c.json")["tiles"]["tolerance_px"], 2);
    ASSERT_EQ(talus("render b.tif --tiled --size 64x48 --turntable 2 --image turn.png").code, 0);
    EXPECT_TRUE(fs::exists(path("turn-0001.png")));
    ASSERT_EQ(
        talus("render b.tif --tiled --size 64x48 --texture a.png --view shaded --image draped.png").code, 0);
    // Its bounds are kept: where they are damaged or gone they are measured again.
    std::ofstream(path("b.tif.tiles")) << "not these";
    ASSERT_EQ(talus(draw + "2 --report d.json --image d.png").code, 0);
    EXPECT_EQ(report("d.json")["pixels_hit"], report("c.json")["pixels_hit"]);
    EXPECT_GT(fs::file_size(path("b.tif.tiles")), 100U);
    // A mosaic, larger than what is held as a whole: it needs overviews, which are made beside it, once.
    std::ofstream(path("big.vrt"))
        << "<VRTDataset rasterXSize=\"9000\" rasterYSize=\"1200\"><GeoTransform>0,5,0,0,0,-5</GeoTransform>"
           "<VRTRasterBand dataType=\"Float32\" band=\"1\"><SimpleSource><SourceFilename "
           "relativeToVRT=\"1\">a.tif"
           "</SourceFilename><SourceBand>1</SourceBand><SrcRect xOff=\"0\" yOff=\"0\" xSize=\"1100\" "
           "ySize=\"900\"/>"
           "<DstRect xOff=\"0\" yOff=\"0\" xSize=\"9000\" "
           "ySize=\"1200\"/></SimpleSource></VRTRasterBand></VRTDataset>";
    EXPECT_NE(talus("info big.vrt").output.find("no overviews"), std::string::npos);
    EXPECT_NE(refusal("render big.vrt --size 64x48 --image x.png", "ulimit -f 16;").find("talus tile"),
              std::string::npos);
    EXPECT_FALSE(fs::exists(path("big.vrt.ovr")));
    ASSERT_EQ(talus("render big.vrt --size 64x48 --image mosaic.png").code, 0);
    EXPECT_EQ(json::parse(talus("info --json big.vrt").output)["levels"].size(), 7U);
    const auto made_at = fs::last_write_time(path("big.vrt.ovr"));
    ASSERT_EQ(talus("render big.vrt --size 64x48 --image again.png").code, 0);
    EXPECT_EQ(fs::last_write_time(path("big.vrt.ovr")), made_at);
    EXPECT_EQ(bytes_of("again.png"), bytes_of("mosaic.png"));
    ASSERT_EQ(talus("tile big.vrt big.tif").code, 0);
    EXPECT_EQ(json::parse(talus("info --json big.tif").output)["levels"].size(), 7U);
    // Large files need no word to be drawn in tiles.
    ASSERT_EQ(talus("render big.tif --size 64x48 --report big.json --image big.png").code, 0);
    EXPECT_TRUE(report("big.json").contains("tiles"));
    EXPECT_NE(refusal("run --in big.tif --ticks 1").find("talus render"), std::string::npos);
    ASSERT_EQ(talus("tile --generate hills,700x600 --spacing 2 --relief 300 --seed 4 made.tif").code, 0);
    const json made = json::parse(talus("info --json made.tif").output);
    EXPECT_EQ(made["dx"], 2);
    EXPECT_NEAR(made["height_max"].get<double>() - made["height_min"].get<double>(), 300, 40);
}

TEST_F(Program, LaysPhotosOverTerrain) {
    ASSERT_EQ(talus("run --preset alpine --size 257x193 --ticks 0 --out a.tif --image photo.png").code, 0);
    const Outcome tiled = talus("tile a.tif ground.tif --texture photo.png photo.tif");
    ASSERT_EQ(tiled.code, 0) << tiled.output;
    EXPECT_NE(tiled.output.find("photo.tif: 1280 x 720 texels"), std::string::npos) << tiled.output;
    ASSERT_EQ(talus("tile --texture photo.tif again.tif").code, 0);
    // Where the ground lies, turned up and half as large.
    std::ofstream(path("placed.vrt"))
        << "<VRTDataset rasterXSize=\"1280\" rasterYSize=\"720\"><GeoTransform>0,2,0,0,0,2</GeoTransform>"
           "<VRTRasterBand dataType=\"Byte\" band=\"1\"><SimpleSource><SourceFilename "
           "relativeToVRT=\"1\">photo.tif</SourceFilename><SourceBand>1</SourceBand></SimpleSource>"
           "</VRTRasterBand></VRTDataset>";
    const std::string view = " --size 160x90 --image ";
    ASSERT_EQ(talus("render a.tif --texture placed.vrt" + view + "whole.png").code, 0);
    const Outcome in_tiles = talus("render a.tif --tiled --texture placed.vrt" + view + "tiled.png");
    ASSERT_EQ(in_tiles.code, 0) << in_tiles.output;
    ASSERT_EQ(talus("render a.tif --tiled" + view + "bare.png").code, 0);
    EXPECT_NE(bytes_of("tiled.png"), bytes_of("bare.png"));
    ASSERT_EQ(talus("render a.tif --tiled --texture placed.vrt" + view + "second.png").code, 0);
    EXPECT_EQ(bytes_of("second.png"), bytes_of("tiled.png"));
    // A view that does not show it.
    ASSERT_EQ(talus("render a.tif --tiled --view slope --texture placed.vrt" + view + "slope.png").code, 0);
    ASSERT_EQ(talus("render a.tif --tiled --view slope" + view + "bare_slope.png").code, 0);
    EXPECT_EQ(bytes_of("slope.png"), bytes_of("bare_slope.png"));
    // Both outputs are none of the inputs.
    const std::string before = bytes_of("photo.tif");
    refusal("tile a.tif photo.tif --texture photo.tif other.tif");
    refusal("tile a.tif other.tif --texture photo.tif a.tif");
    refusal("tile a.tif same.tif --texture photo.tif same.tif");
    refusal("tile --texture photo.tif photo.tif");
    refusal("tile --texture absent.tif b.tif");
    refusal("tile --texture ground.tif b.tif");
    refusal("tile --texture photo.tif b.png");
    refusal("tile --texture photo.tif");
    refusal("render a.tif --texture absent.tif" + view + "x.png");
    EXPECT_EQ(bytes_of("photo.tif"), before);
    EXPECT_FALSE(fs::exists(path("b.tif")));
    EXPECT_FALSE(fs::exists(path("other.tif")));
    // What cannot be read on the way is said.
    std::fstream(path("photo.tif"), std::ios::binary | std::ios::in | std::ios::out).seekp(3000)
        << std::string(before.size() - 3000, '\0');
    EXPECT_NE(refusal("render a.tif --texture placed.vrt" + view + "x.png").find("cannot be read"),
              std::string::npos);
}

TEST_F(Program, RefusesWhatCannotBeTiled) {
    ASSERT_EQ(talus("run --preset alpine --size 65x65 --ticks 0 --out a.tif").code, 0);
    for (const char* arguments : {"tile a.tif",
                                  "tile absent.tif b.tif",
                                  "tile a.tif b.png",
                                  "tile a.tif nowhere/b.tif",
                                  "tile . b.tif",
                                  "tile --generate mountains,70x70 a.tif b.tif",
                                  "tile --generate mountains b.tif",
                                  "tile --generate sea,70x70 b.tif",
                                  "tile --generate hills,1x1000000 b.tif",
                                  "tile --generate hills,70x70 --relief -1 b.tif",
                                  "tile a.tif a.tif",
                                  "tile a.tif ./a.tif",
                                  "tile a.tif b.tif --range 0,1",
                                  "render a.tif --tiled --method mesh --image b.png",
                                  "render a.tif --tiled --image nowhere/b.png",
                                  "tile --generate hills,70x70 --spacing 0 b.tif",
                                  "render a.tif --tiled --view depth --image b.png",
                                  "render a.tif --tiled --view regolith --image b.png",
                                  "render absent.tif --tiled --image b.png",
                                  "render --tiled --image b.png",
                                  "render a.tif --tiled --set tiles.gpu_mib=1 --image b.png"})
        refusal(arguments);
    EXPECT_FALSE(fs::exists(path("b.tif")));
    EXPECT_FALSE(fs::exists(path("b.png")));
    // Ctrl+C, and an end without a word: nothing stands under the name.
    std::ofstream(path("large.vrt"))
        << "<VRTDataset rasterXSize=\"60000\" rasterYSize=\"60000\"><GeoTransform>0,5,0,0,0,-5</GeoTransform>"
           "<VRTRasterBand dataType=\"Float32\" band=\"1\"><SimpleSource><SourceFilename "
           "relativeToVRT=\"1\">a.tif"
           "</SourceFilename><SourceBand>1</SourceBand><SrcRect xOff=\"0\" yOff=\"0\" xSize=\"65\" "
           "ySize=\"65\"/>"
           "<DstRect xOff=\"0\" yOff=\"0\" xSize=\"60000\" "
           "ySize=\"60000\"/></SimpleSource></VRTRasterBand></VRTDataset>";
    EXPECT_NE(refusal("tile large.vrt b.tif", "timeout --preserve-status -s INT 4").find("interrupted"),
              std::string::npos);
    EXPECT_FALSE(fs::exists(path("b.tif")));
    const auto hidden = [&] {
        return std::count_if(
            fs::directory_iterator(path("")), fs::directory_iterator(),
            [](const auto& file) { return file.path().filename().string().starts_with(".b.tif"); });
    };
    EXPECT_EQ(hidden(), 0);
    // One request that is sent twice is one.
    const std::string begun =
        "2>&1 & until ls " + path(".b.tif*") + " >/dev/null 2>&1; do sleep 0.02; done; ";
    const std::string twice = begun + "kill -TERM $!; sleep 0.05; kill -TERM $!; wait $!";
    EXPECT_NE(refusal("tile large.vrt b.tif " + twice, "exec").find("interrupted"), std::string::npos);
    EXPECT_EQ(hidden(), 0);
    // What the program was started to ignore, as under nohup, does not end it.
    const std::string hung_up = begun + "kill -HUP $!; sleep 0.5; kill -KILL $!; wait $!";
    EXPECT_EQ(talus("tile large.vrt b.tif " + hung_up, "trap '' HUP; exec").code, 137);
    EXPECT_EQ(talus("tile large.vrt b.tif", "timeout -s KILL 2").code, 137);
    EXPECT_FALSE(fs::exists(path("b.tif")));
    // What it left, where it came to that, goes with the next one.
    EXPECT_EQ(talus("tile a.tif b.tif").code, 0);
    EXPECT_EQ(hidden(), 0);
}

TEST_F(Program, SaysWhereItCrashed) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer has a report of its own";
#endif
    // A fault that comes from outside is one all the same.
    const Outcome crashed = talus(small + "--ticks 100000000", "timeout --preserve-status -s SEGV 5");
    EXPECT_EQ(crashed.code, 128 + SIGSEGV) << crashed.output;
    EXPECT_NE(crashed.output.find("talus: crashed: "), std::string::npos) << crashed.output;
    EXPECT_NE(crashed.output.find("command_line"), std::string::npos) << crashed.output;
}

TEST_F(Program, RendersLargePicturesAndDrapedOnes) {
    ASSERT_EQ(talus(small + "--ticks 0 --out a.exr").code, 0);
    // Wider than a tile.
    const Outcome wide =
        talus("render a.exr --size 2100x40 --image w.png --depth w.exr --view slope --set render.samples=2");
    ASSERT_EQ(wide.code, 0) << wide.output;
    ASSERT_EQ(talus("render a.exr --size 320x180 --image plain.png").code, 0);
    ASSERT_EQ(talus("render a.exr --size 320x180 --image again.png").code, 0);
    ASSERT_EQ(talus("render a.exr --size 320x180 --image draped.png --texture plain.png").code, 0);
    const auto bytes = [&](const char* name) {
        std::ifstream file(path(name), std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    EXPECT_EQ(bytes("plain.png"), bytes("again.png"));
    EXPECT_NE(bytes("plain.png"), bytes("draped.png"));
    EXPECT_NE(refusal("render a.exr --image x.png --texture missing.jpg").find("missing.jpg"),
              std::string::npos);
    EXPECT_NE(refusal("render a.exr --image x.png --texture w.exr").find("w.exr"), std::string::npos);
    EXPECT_NE(refusal("render a.exr --image x.png --size 40000x10").find("32768"), std::string::npos);
    EXPECT_FALSE(fs::exists(path("x.png")));
}

// What every kind of act does lies where it was, whatever the number of samples.
TEST_F(Program, ReplaysAtAnotherSize) {
    hash("run --preset alpine --size 129x97 --spacing 20 --ticks 0 --journal s.journal");
    std::ofstream(path("s.journal"), std::ios::app)
        << R"({"op":"dab","mode":"raise","x_m":600,"y_m":700,"radius_m":500,"falloff":1,"amount_m":2000,"blend":0,"target_m":0,"material":"bedrock"}
{"op":"mask","from":"height","low":500,"high":5000,"fade":100,"join":"replace","inverted":false}
{"op":"mask","from":"rectangle","low":0,"high":0,"fade":60,"join":"subtract","inverted":false,"rectangle":{"west_m":1600,"south_m":900,"east_m":1900,"north_m":1100}}
{"op":"dab","mode":"noise","x_m":1500,"y_m":1000,"radius_m":900,"falloff":0.5,"amount_m":150,"blend":0,"target_m":0,"material":"bedrock","masked":true,"noise":{"kind":"ridged","wavelength_m":400,"octaves":3,"gain":0.5,"warp":0.2,"seed":4}}
{"op":"dab","mode":"ramp","x_m":200,"y_m":200,"radius_m":150,"falloff":0.3,"amount_m":0,"blend":1,"target_m":900,"material":"bedrock","way_m":[800,300],"rise_m":-300}
{"op":"stamp","piece":{"west_m":300,"south_m":400,"east_m":900,"north_m":1000}}
{"op":"dab","mode":"stamp","x_m":1800,"y_m":600,"radius_m":600,"falloff":0.5,"amount_m":800,"blend":1,"target_m":0,"material":"bedrock","stamp":{"mode":"add","half_m":[300,300],"turn_deg":30,"mirrored":true}}
{"op":"blur","deviation_m":40,"of":"ground","masked":false}
{"op":"crop","rectangle":{"west_m":0,"south_m":0,"east_m":2400,"north_m":1840}}
{"op":"turn","quarters":1}
{"op":"resample","nx":65,"ny":81}
)";
    const auto heights = [&](const std::string& more) {
        const Outcome replayed = talus("replay s.journal --out s.r32 --json " + more);
        EXPECT_EQ(replayed.code, 0) << replayed.output;
        return json::parse(replayed.output.substr(replayed.output.find('{')));
    };
    const json as_recorded = heights("");
    EXPECT_EQ(as_recorded["nx"], 65);
    EXPECT_EQ(as_recorded["ny"], 81);
    const json finer = heights("--size 257x193");
    EXPECT_EQ(finer["nx"], 129);
    EXPECT_EQ(finer["ny"], 161);
    EXPECT_NEAR(finer["height_max"], as_recorded["height_max"],
                0.03 * as_recorded["height_max"].get<double>());
    EXPECT_NEAR(finer["height_min"], as_recorded["height_min"],
                0.03 * as_recorded["height_max"].get<double>());
    refusal("replay s.journal --size 1x1");
}

// A run of every preset of erosion; one hash whatever the threads, replayed, and saved midway; the report's
// ledger closes.
TEST_F(Program, ErodesByWaterAndReportsIt) {
    const std::string rain = "run --preset rain-erosion --size 129x97 ";
    const std::string whole =
        hash(rain + "--ticks 60 --out whole.exr --journal run.journal --image rain.png");
    const json ledger = report("hash.json")["ledger"];
    EXPECT_GT(ledger["eroded_m3"], 1e3);
    EXPECT_GT(ledger["deposited_m3"], 1e2);
    EXPECT_GT(ledger["suspended_m3"], 1e2);
    EXPECT_GE(ledger["out_m3"], 0);
    EXPECT_LE(ledger["closing_error_of_eroded"], 1e-6);
    for (const char* threads : {"LP_NUM_THREADS=0", "LP_NUM_THREADS=1", "LP_NUM_THREADS=4"})
        EXPECT_EQ(hash(rain + "--ticks 60", threads), whole) << threads;
    EXPECT_EQ(hash("replay run.journal"), whole);
    hash(rain + "--ticks 25 --out mid.exr");
    EXPECT_EQ(hash("run --in mid.exr --ticks 35"), whole)
        << "the document brings load, regolith and parameters";
    for (const char* layer : {"suspended", "regolith", "depth_max", "arrival_s", "mask"})
        EXPECT_EQ(talus(std::string("convert whole.exr layer.tif --layer ") + layer).code, 0) << layer;
    EXPECT_NE(refusal("convert whole.exr layer.tif --layer silt").find("suspended"), std::string::npos);
    for (const char* preset : {"canyon", "delta", "badlands"}) {
        hash(std::string("run --preset ") + preset + " --size 97x65 --ticks 20");
        EXPECT_LE(report("hash.json")["ledger"]["closing_error_of_moved"], 1e-6) << preset;
    }
    // Someone's own ground.
    EXPECT_EQ(talus("run --preset rain-erosion --in layer.tif --ticks 2 --out own.tif").code, 0);
    refusal("run --preset rain-erosion --ticks 1 --set erosion.acceleration=0.5");
    refusal("run --preset rain-erosion --ticks 1 --set erosion.porosity=1");
}

TEST_F(Program, WritesWhatPassesSections) {
    const std::string run =
        "run --preset dam-break --size 129x97 --set water.boundary.north=wall --set "
        "water.boundary.south=wall --ticks 20 ";
    const std::string plain = hash(run);
    EXPECT_EQ(hash(run + "--section 215,0,215,480 --section 0,240,640,250 --sections lines.csv"), plain);
    std::ifstream table(path("lines.csv"));
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line, "time_s,discharge_1_m3_per_s,volume_1_m3,discharge_2_m3_per_s,volume_2_m3");
    std::getline(table, line);
    EXPECT_EQ(line, "0,,0,,0");
    int rows = 0;
    double before_s = 0;
    double volume_m3 = 0;
    for (; std::getline(table, line); ++rows) {
        std::array<double, 5> v{};
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf", &v[0], &v[1], &v[2], &v[3], &v[4]), 5)
            << line;
        volume_m3 += v[1] * (v[0] - before_s);
        before_s = v[0];
        EXPECT_NEAR(v[2], volume_m3, 1e-9 * (1 + std::abs(volume_m3)));
    }
    EXPECT_EQ(rows, 20);
    EXPECT_GT(volume_m3, 1) << "the dam's water runs east, to the right of a line north";
    EXPECT_NE(refusal(run + "--section 1,2,3").find("--section"), std::string::npos);
    EXPECT_NE(refusal(run + "--section 1,2,1e9,3").find("off the map"), std::string::npos);
    EXPECT_NE(refusal(run + "--section 1,2,1,2").find("farther apart"), std::string::npos);
    EXPECT_NE(refusal(run + "--section 1,2,300,2 --sections no/such/lines.csv").find("no/such"),
              std::string::npos);
}

TEST_F(Program, RecordsOnItsWay) {
    const std::string run = "run --preset dam-break --size 65x49 --set time.tick_s=0.7 --ticks 10 ";
    const std::string plain = hash(run + "--out end.tif --layer water");
    // Due at 0, 2, 4 and 6 s of 7; ticks end at 2.1, 4.2 and 6.3 s.
    EXPECT_EQ(hash(run + "--every 2 --layer water --out depth_%03d.tif --out last.tif --image view_%d.png "
                         "--film-size 160x90"),
              plain);
    for (const char* name : {"depth_000.tif", "depth_003.tif", "view_0.png", "view_3.png", "last.tif"})
        EXPECT_TRUE(fs::exists(path(name))) << name;
    EXPECT_FALSE(fs::exists(path("depth_004.tif")) || fs::exists(path("view_4.png")));
    EXPECT_EQ(bytes_of("last.tif"), bytes_of("end.tif"));
    hash("run --preset dam-break --size 65x49 --set time.tick_s=0.7 --ticks 6 --out at_4.tif --layer water");
    EXPECT_EQ(bytes_of("depth_002.tif"), bytes_of("at_4.tif")) << "each is what the run was then";
    EXPECT_NE(bytes_of("view_0.png"), bytes_of("view_3.png"));
    std::ofstream(path("keys.toml")) << "[[key]]\neye = [100, -300, 300]\ntarget = [300, 200, 0]\n"
                                        "[[key]]\neye = [500, -300, 400]\ntarget = [300, 200, 0]\n";
    hash(run + "--every 7 --image fly_%d.png --keys keys.toml --film-size 160x90");
    EXPECT_NE(bytes_of("fly_0.png"), bytes_of("view_0.png"));

    // Sums of ticks round; what is due is not.
    hash(
        "run --preset still --size 16x16 --set time.tick_s=0.1 --ticks 36000 --every 60 --out s_%d.r32 "
        "--set water.on=false "
        "--set thermal.on=false");
    EXPECT_TRUE(fs::exists(path("s_60.r32")));
    EXPECT_FALSE(fs::exists(path("s_61.r32")));
    EXPECT_NE(refusal(run + "--every 2").find("--every writes nothing"), std::string::npos);
    EXPECT_NE(refusal(run + "--every 0 --image v_%d.png").find("--every 0"), std::string::npos);
    EXPECT_NE(refusal(run + "--image v_%d.png").find("--every does not say"), std::string::npos);
    EXPECT_NE(refusal(run + "--keys keys.toml").find("--keys"), std::string::npos);
    EXPECT_NE(refusal(run + "--every 1 --image v_%d.png --film-size 9x9").find("9x9"), std::string::npos);
    EXPECT_NE(refusal(run + "--every 0.5 --image v_%d.png").find("time.tick_s = 0.7"), std::string::npos);
    for (const char* name : {"v_%5d.png", "v_%d_%d.png", "v_%010d.png"})
        EXPECT_NE(refusal(run + "--every 1 --image " + name).find("cannot be numbered"), std::string::npos)
            << name;
    EXPECT_NE(refusal("replay x.journal --out d_%05d.tif").find("--every"), std::string::npos);
    // A folder's name numbers nothing; no tick, and there is the start.
    fs::create_directories(path("50%done"));
    EXPECT_EQ(
        talus(
            "run --preset dam-break --size 65x49 --ticks 0 --every 2 --out 50%done/d_%d.exr --keys keys.toml "
            "--image k_%d.png --film-size 64x64")
            .code,
        0);
    EXPECT_TRUE(fs::exists(path("50%done/d_0.exr")) && fs::exists(path("k_0.png")));
    // Documents on the way are those of runs that end there; what cannot be written takes nothing else with
    // it.
    hash(run + "--every 7 --out d_%d.exr --set water.manning=0.05");
    EXPECT_EQ(hash("run --in d_1.exr --ticks 5"),
              hash("run --preset dam-break --size 65x49 --set time.tick_s=0.7 --set "
                   "water.manning=0.05 --ticks 15"));
    fs::create_directories(path("e_1.tif"));
    EXPECT_NE(refusal(run + "--every 7 --out e_%d.tif --out kept.tif --report kept.json").find("e_1.tif"),
              std::string::npos);
    EXPECT_TRUE(fs::exists(path("kept.tif")) && fs::exists(path("kept.json")));
}

// With a program in ffmpeg's place that keeps what it is given.
TEST_F(Program, FilmsByFfmpeg) {
    const std::string run = "run --preset dam-break --size 65x49 --film-size 160x90 --ticks 4 ";
    const auto be_ffmpeg = [&](const std::string& script) {
        fs::create_directories(path("bin"));
        std::ofstream(path("bin/ffmpeg")) << "#!/bin/sh\n" << script;
        fs::permissions(path("bin/ffmpeg"), fs::perms::owner_all);
    };
    const std::string with = "PATH=" + path("bin") + ":$PATH";
    be_ffmpeg("for last; do :; done\ncat > \"${last#file:}\"\n");
    EXPECT_EQ(hash(run + "--film out.mp4", with), hash(run));
    EXPECT_EQ(fs::file_size(path("out.mp4")), 5U * 160 * 90 * 3)
        << "a picture at the start and after each tick";
    const std::string before = bytes_of("out.mp4");

    // What fails leaves what was there.
    be_ffmpeg("cat > /dev/null\nexit 3\n");
    EXPECT_NE(refusal(run + "--film out.mp4", with).find("'out.mp4'"), std::string::npos);
    be_ffmpeg("exit 1\n");
    EXPECT_NE(refusal(run + "--film out.mp4", with).find("'out.mp4'"), std::string::npos);
    EXPECT_EQ(bytes_of("out.mp4"), before);
    for (const fs::directory_entry& entry : fs::directory_iterator(path("")))
        EXPECT_NE(entry.path().filename().string().front(), '.') << "left behind: " << entry.path();
    EXPECT_NE(refusal(run + "--film out.mp4", "PATH=/nowhere").find("no program ffmpeg"), std::string::npos);
    EXPECT_NE(refusal(run + "--film out.gif", with).find(".mp4"), std::string::npos);
    EXPECT_NE(refusal(run + "--film no/such/out.mp4", with).find("no/such"), std::string::npos);
}

TEST_F(Program, WritesMapsTogether) {
    ASSERT_EQ(talus("run --preset rain-erosion --size 97x65 --ticks 20 --out a.exr").code, 0);
    const Outcome outcome = talus("convert a.exr land.png --maps flow,wear,deposition,slope");
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("flow: 0 to "), std::string::npos) << outcome.output;
    const json said = report("land.json");
    EXPECT_EQ(said["maps"].size(), 4U);
    EXPECT_EQ(said["maps"][0]["unit"], "m³");
    const json flow = json::parse(talus("info --json land_flow.png").output);
    EXPECT_NEAR(flow["height_max"].get<double>(), said["maps"][0]["high"].get<double>(),
                0.51 * said["maps"][0]["step"].get<double>());
    EXPECT_GT(flow["height_max"], 0);
    ASSERT_EQ(talus("convert a.exr weights.png --maps wear,deposition --for unreal").code, 0);
    EXPECT_EQ(report("weights.json")["maps"][2]["map"], "rest");
    EXPECT_EQ(report("weights.json")["maps"][2]["weights_sum_to"], 255);
    ASSERT_EQ(talus("convert a.exr wear.tif --layer wear_by_slopes").code, 0);
    EXPECT_NE(refusal("convert a.exr land.png --maps flow,lava").find("'lava'"), std::string::npos);
    EXPECT_NE(refusal("convert a.exr land.png --maps flow --tiles 2x2").find("--tiles"), std::string::npos);
    EXPECT_NE(refusal("convert a.exr land.png --weights 8").find("--maps"), std::string::npos);
    // Without what counts them they are 0, and that is said; a file's own heights may be told.
    EXPECT_NE(
        talus("convert land_slope.png flat.tif --maps flow,slope --range 0,900").output.find("no such layer"),
        std::string::npos);
    EXPECT_NE(refusal("convert a.exr land.png --maps flow --weights 9").find("9 bits"), std::string::npos);
    EXPECT_NE(refusal("convert a.exr land.tif --maps flow --weights 8").find(".png"), std::string::npos);
}

TEST_F(Program, RunsWithNumbersThatFollowTables) {
    std::ofstream(path("rain.csv")) << "time_s,rain_mm_per_h\n0,0\n7.5,360\n7.5,36\n20,36\n";
    std::ofstream(path("inflow.csv")) << "0 0\n10 50\n30 0\n";
    const std::string run =
        "run --preset still --size 65x49 --set terrain.spacing_m=10 --set time.tick_s=2 --set "
        "water.boundary.west=inflow ";
    const std::string drives = "--drive water.rain=rain.csv --drive water.inflow_m3_per_s=inflow.csv ";
    const std::string whole = hash(run + drives + "--time 30 --journal run.journal");
    const json water = report("hash.json")["water"];
    // It rises to 360 mm/h in 7.5 s; then 36 mm/h fall to the end.
    const double area_m2 = 65 * 49 * 100;
    const double rain_m3 = (0.5 * 7.5 * 360 + 22.5 * 36) * 1e-3 / 3600 * area_m2;
    EXPECT_NEAR(water["in_m3"].get<double>() / (rain_m3 + 0.5 * 30 * 50), 1, 1e-6);
    EXPECT_EQ(hash("replay run.journal"), whole) << "the journal holds the tables";
    fs::remove(path("rain.csv"));
    EXPECT_NE(refusal(run + drives + "--time 30").find("rain.csv"), std::string::npos);
    EXPECT_EQ(hash("replay run.journal"), whole);

    const std::string inflow = "--drive water.inflow=inflow.csv ";
    const std::string alone = hash(run + inflow + "--time 30");
    hash(run + inflow + "--time 12 --out mid.exr");
    EXPECT_EQ(hash("run --in mid.exr --time 18"), alone) << "the document goes on with its tables";
    // What is set takes the place of the table; a journal that begins so is replayed.
    const std::string set = hash("run --in mid.exr --time 18 --set water.inflow=50 --journal set.journal");
    EXPECT_NEAR(report("hash.json")["water"]["in_m3"].get<double>(), 18 * 50, 1e-3);
    EXPECT_EQ(hash("replay set.journal"), set);

    std::ofstream(path("late.csv")) << "0,1\nsoon,2\n";
    EXPECT_NE(refusal(run + "--ticks 1 --drive water.rain=late.csv").find("line 2 is 'soon,2'"),
              std::string::npos);
    EXPECT_NE(refusal(run + "--ticks 1 --drive water.rain").find("--drive"), std::string::npos);
    EXPECT_NE(refusal(run + "--ticks 1 " + inflow + inflow).find("second table"), std::string::npos);
    EXPECT_NE(refusal(run + "--ticks 1 " + inflow + "--drive water.inflow_m3_per_s=inflow.csv")
                  .find("second table"),
              std::string::npos);
    EXPECT_NE(refusal(run + "--ticks 1 --drive water.order=inflow.csv").find("water.order"),
              std::string::npos);
    EXPECT_NE(refusal(run + "--ticks 1 --drive erosion.strata_hardness=inflow.csv")
                  .find("'inflow.csv': erosion.strata_hardness"),
              std::string::npos);
    EXPECT_NE(refusal(run + "--ticks 1 --drive nothing.at_all=inflow.csv").find("nothing.at_all"),
              std::string::npos);
}

TEST_F(Program, RunsTheEventsOfAScene) {
    std::ofstream(path("storm.toml")) << R"(
[terrain]
kind = "flat"
nx = 65
ny = 49
spacing_m = 10
[time]
tick_s = 2
[water]
rain_mm_per_h = 100
[[event]]
at_s = 30
set = "water.rain=0"
[[event]]
at_s = 12
breach = { from_m = [100, 100], to_m = [200, 100], width_m = 30, crest_m = 0, bottom_m = -5, over_s = 20 }
)";
    const std::string whole = hash("run --preset storm.toml --time 60 --journal run.journal");
    EXPECT_NEAR(report("hash.json")["water"]["in_m3"].get<double>() / (65 * 49 * 100 * 30 * 0.1 / 3600), 1,
                1e-5);
    EXPECT_EQ(hash("replay run.journal"), whole);
    EXPECT_EQ(talus("replay run.journal --size 33x25").code, 0);
    // Saved while the breach opens; the preset's events are there already.
    hash("run --preset storm.toml --time 20 --out mid.exr");
    EXPECT_EQ(hash("run --in mid.exr --time 40"), whole);
    EXPECT_EQ(hash("run --preset storm.toml --in mid.exr --time 40"), whole);
    // Saved after an event: the preset sets its number again, and then the event does.
    hash("run --preset storm.toml --time 40 --out late.exr");
    hash("run --preset storm.toml --in late.exr --time 20");
    EXPECT_LT(report("hash.json")["water"]["in_m3"].get<double>(), 1);
    std::ofstream(path("late.toml")) << "[[event]]\nat_s = 1\nset = \"water.lava=0\"\n";
    EXPECT_NE(refusal("run --preset late.toml --ticks 1").find("preset late: the event at 1 s is wrong"),
              std::string::npos);
}

TEST_F(Program, RunsOverRastersOfRoughnessAndInfiltration) {
    const auto write = [&](const std::string& name, const std::string& west, const std::string& east) {
        std::ofstream file(path(name));
        file << "ncols 65\nnrows 49\nxllcorner 0\nyllcorner 0\ncellsize 10\nnodata_value -1\n";
        for (int row = 0; row < 49; ++row)
            for (int column = 0; column < 65; ++column)
                file << (column < 32 ? west : east) << (column < 64 ? ' ' : '\n');
    };
    write("n.asc", "0.1", "-1");
    write("sand.asc", "0", "400");
    const std::string run =
        "run --preset still --size 65x49 --set terrain.spacing_m=10 --set time.tick_s=2 --set "
        "water.rain=100 ";
    const std::string rasters = "--raster manning=n.asc --raster infiltration=sand.asc ";
    const std::string plain = hash(run + "--time 60");
    const Outcome noted =
        talus(run + rasters + "--time 60 --out a.exr --journal run.journal --report r.json");
    EXPECT_EQ(noted.code, 0) << noted.output;
    EXPECT_NE(noted.output.find("'n.asc' says nothing at 1617 of 3185 samples"), std::string::npos)
        << noted.output;
    EXPECT_NE(report("r.json")["hash"], plain);
    EXPECT_EQ(hash("replay run.journal"), report("r.json")["hash"]);
    // The document holds them, and what it holds can be written and taken again.
    hash("run --in a.exr --ticks 0 --layer manning --out n.tif");
    EXPECT_EQ(hash("run --in a.exr --ticks 5"), hash("run --in a.exr --ticks 5 --raster manning=n.asc"));
    hash("run --in a.exr --ticks 0 --layer infiltration --out sand.tif");
    EXPECT_EQ(hash(run + "--raster manning=n.asc --raster infiltration=sand.tif --time 60"),
              report("r.json")["hash"]);
    // At another number of samples rasters are laid anew.
    EXPECT_EQ(talus("replay run.journal --size 33x25").code, 0);

    write("n.asc", "0.1", "41");
    EXPECT_NE(refusal(run + rasters + "--ticks 1").find("holds a manning of 41, it must be 0 to 1"),
              std::string::npos);
    EXPECT_NE(refusal("replay run.journal").find("changed since"), std::string::npos);
    fs::remove(path("n.asc"));
    EXPECT_NE(refusal(run + rasters + "--ticks 1").find("n.asc"), std::string::npos);
    EXPECT_NE(refusal(run + "--ticks 1 --raster manning").find("--raster"), std::string::npos);
    EXPECT_NE(refusal(run + "--ticks 1 --raster water.manning=n.asc").find("infiltration"),
              std::string::npos);
}

TEST_F(Program, RunsWaterWithGaugesSpringsAndItsReport) {
    const std::string dam = "run --preset dam-break --size 129x97 ";
    const std::string whole = hash(dam +
                                   "--ticks 60 --out whole.exr --journal run.journal "
                                   "--gauge 200,240 --gauge 300,250 --spring 500,200,40 --image dam.png");
    const json water = report("hash.json")["water"];
    EXPECT_GT(water["initial_m3"], 1e5);
    EXPECT_NEAR(water["in_m3"].get<double>(), 60 * 0.025 * 40, 0.01);
    EXPECT_LE(std::abs(water["drift_relative"].get<double>()), 1e-9);
    EXPECT_GE(water["min_depth"], 0);
    EXPECT_GT(water["max_speed"], 1);
    EXPECT_GE(water["substeps"], 60);
    EXPECT_GT(water["active_tiles_mean"], 0);
    EXPECT_GT(water["final_m3"], water["initial_m3"]);
    std::ifstream table(path("gauges.csv"));
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line, "time_s,level_1_m,depth_1_m,speed_1_m_per_s,level_2_m,depth_2_m,speed_2_m_per_s");
    int rows = 0;
    while (std::getline(table, line)) ++rows;
    EXPECT_EQ(rows, 61) << "the start and every tick";
    for (const char* threads : {"LP_NUM_THREADS=0", "LP_NUM_THREADS=1", "LP_NUM_THREADS=4"})
        EXPECT_EQ(hash(dam + "--ticks 60 --spring 500,200,40", threads), whole) << threads;
    EXPECT_EQ(hash("replay run.journal"), whole);
    hash(dam + "--ticks 25 --spring 500,200,40 --out mid.exr");
    EXPECT_EQ(hash("run --in mid.exr --ticks 35"), whole)
        << "the document brings water, springs and parameters";
    // Its water alone, and its level.
    ASSERT_EQ(talus("convert whole.exr depth.tif --layer water").code, 0);
    EXPECT_EQ(json::parse(talus("info --json depth.tif").output)["height_min"], 0);
    // First order is another answer; every edge can be set.
    EXPECT_NE(hash(dam + "--ticks 60 --set water.order=1"), whole);
    for (const char* kind : {"wall", "open", "level", "inflow", "wave", "periodic"})
        for (const char* edge : {"north", "south", "west", "east"})
            ASSERT_EQ(
                talus(std::string("run --preset still --size 40x30 --ticks 3 --set water.sea_level=2 --set "
                                  "water.inflow=5 --set water.boundary.") +
                      edge + "=" + kind)
                    .code,
                0);
    EXPECT_NE(refusal("run --preset still --ticks 1 --gauge 1e7,0").find("gauge at"), std::string::npos);
    EXPECT_NE(refusal("run --preset still --ticks 1 --gauge 5").find("--gauge"), std::string::npos);
    EXPECT_NE(refusal("run --preset still --ticks 1 --spring 1,1,-4").find("rate"), std::string::npos);
    EXPECT_NE(refusal("run --preset still --ticks 1 --spring -1,1,4").find("off the map"), std::string::npos);
    refusal("run --preset still --ticks 1 --set water.boundary.north=sideways");
    refusal("run --preset still --ticks 1 --set water.order=3");
    refusal("run --preset still --ticks 1 --set water.rain=nan");
}

TEST_F(Program, ListsPresetsAndParameters) {
    EXPECT_EQ(json::parse(talus("presets --json").output).size(), 13U);
    EXPECT_GT(json::parse(talus("parameters --json").output).size(), 20U);
    EXPECT_NE(talus("parameters").output.find("thermal.repose_deg = 33 °"), std::string::npos);
    EXPECT_EQ(talus("--version").code, 0);
    EXPECT_EQ(talus("run --help").code, 0);
}

TEST_F(Program, RefusesInOneSentence) {
    std::ofstream(path("bad.toml")) << "[thermal]\nrepose_deg = 120.0\n";
    std::ofstream(path("unknown.toml")) << "[thermal]\nspeed = 120.0\n";
    std::ofstream(path("bad.journal")) << "{}\n";
    EXPECT_EQ(refusal("run --preset bad.toml"),
              "preset bad: thermal.repose_deg = 120 is out of range, it must be 1 to 80 °\n");
    EXPECT_EQ(refusal("run --preset unknown.toml"),
              "preset unknown: there is no parameter 'thermal.speed', 'talus parameters' lists them\n");
    EXPECT_EQ(
        refusal("run --preset nothing"),
        "there is no preset 'nothing', use one of: alpine, badlands, blank, canyon, dam-break, delta, flood, "
        "island, rain-erosion, slopes, still, thacker, waves, or a file ending in .toml\n");
    refusal("run --in missing.tif");
    refusal("run --size 1x50 --ticks 1");
    refusal("run --size 9000x9000 --ticks 1");
    refusal("run --size big --ticks 1");
    refusal("run --ticks -3");
    refusal("run --ticks many");
    refusal("run --ticks 1 --time 1");
    refusal("run --set thermal.repose_deg");
    refusal("run --spacing -2 --ticks 1");
    refusal("run --spacing 0 --ticks 1");
    refusal("run --ticks 1 --set thermal.rate_m2_per_s=1e9");
    refusal("run --ticks 1 --out a.jpg");
    refusal("run --size 32x32 --ticks 1 --out /no/such/folder/a.tif");
    refusal("run --size 32x32 --ticks 1 --layer snow --out a.tif");
    refusal("render missing.tif --image a.png");
    refusal("replay bad.journal");
    refusal("replay missing.journal");
    refusal("run --gpu 77 --ticks 1");
    refusal("run --shader-dir /nowhere --ticks 1");
    refusal("run --ticks 99999999999999999999");
    refusal("run --time 1e14 --set time.tick_s=1e-6");
    refusal("run --in a.tif --size 32x32 --ticks 1");
    refusal("run --range 0,inf --in a.tif");
    refusal("run --ticks 1 --set thermal.rate_m2_per_s=1e12");
    std::ofstream(path("title.toml")) << "title = 5\n";
    EXPECT_EQ(refusal("run --preset title.toml"), "preset title: title must be a text in quotes\n");
    fs::create_directories(path("folder.toml"));
    refusal("run --preset folder.toml");
    ASSERT_EQ(talus("run --size 16x16 --ticks 0 --out g.tif --journal g.journal").code, 0);
    refusal("render g.tif");
    refusal("render g.tif --image g.jpg");
    refusal("render g.tif --image g.png --eye nan,0,0");
    std::ifstream start(path("g.journal"));
    std::string first;
    std::getline(start, first);
    for (
        const char* dab :
        {R"({"op":"dab","mode":"raise","x_m":1,"y_m":1,"radius_m":5,"falloff":1,"amount_m":1e39,"blend":0,"target_m":0,"material":"bedrock"})",
         R"({"op":"dab","mode":"raise","x_m":1e300,"y_m":1,"radius_m":5,"falloff":1,"amount_m":1,"blend":0,"target_m":0,"material":"bedrock"})",
         R"({"op":"set","name":"terrain.seed","value":4294967306})", R"({"op":"ticks","count":-1})",
         R"({"op":"sing"})"}) {
        std::ofstream(path("bad2.journal")) << first << "\n" << dab << "\n";
        refusal("replay bad2.journal");
    }
    refusal("fly --now");
    refusal("convert a.tif");
}

TEST_F(Program, AFullDiskLeavesTheOldFile) {
    ASSERT_EQ(talus(small + "--ticks 3 --out a.exr").code, 0);
    const std::string before = json::parse(talus("info --json a.exr").output)["hash"];
    // A limit on the size of files is what a full disk looks like to write().
    const std::string sentence = refusal(small + "--ticks 9 --out a.exr", "ulimit -f 16;");
    EXPECT_NE(sentence.find("a.exr"), std::string::npos) << sentence;
    EXPECT_EQ(json::parse(talus("info --json a.exr").output)["hash"], before);
    for (const auto& entry : fs::directory_iterator(path("."))) EXPECT_EQ(entry.path().filename(), "a.exr");
}

TEST_F(Program, OneOutputThatFailsTakesNoOtherWithIt) {
    fs::create_directories(path("taken.tif"));
    refusal("run --size 32x32 --ticks 1 --out a.tif --out taken.tif --out b.tif --report r.json");
    EXPECT_TRUE(fs::exists(path("a.tif")));
    EXPECT_TRUE(fs::exists(path("b.tif")));
    EXPECT_TRUE(fs::exists(path("r.json")));
}

TEST_F(Program, SaysWhyNoWindowCanOpen) {
    EXPECT_EQ(refusal("why-no-window", "DISPLAY= WAYLAND_DISPLAY=").find("no window can open"), 0U);
    EXPECT_EQ(refusal("", "DISPLAY=:93 WAYLAND_DISPLAY=").find("no window can open"), 0U);
}

TEST_F(Program, TheIssuesRealRunKeepsLedgerAndGeoreference) {
    const char* data = std::getenv("TALUS_DATA");
    if (!data) {
        std::puts("TALUS_DATA is not set: the real run was not made");
        return;
    }
    const std::string input = std::string(data) + "/bigtujunga_30m_1197x643.tif";
    ASSERT_EQ(talus("run --in " + input +
                    " --preset slopes --ticks 300 --out eroded.tif --out eroded.exr --image eroded.png "
                    "--report r.json")
                  .code,
              0);
    const json r = report("r.json");
    std::printf("ledger closes to %.3g of %.4g m3 moved\n",
                r["ledger"]["closing_error_of_moved"].get<double>(), r["ledger"]["moved_m3"].get<double>());
    EXPECT_LE(r["ledger"]["closing_error_of_moved"], 1e-6);
    EXPECT_GT(r["ledger"]["moved_m3"], 1e6);
    const json before = json::parse(talus("info --json " + input).output);
    const json after = json::parse(talus("info --json eroded.tif").output);
    EXPECT_EQ(before["geotransform"], after["geotransform"]);
    EXPECT_EQ(before["crs"], after["crs"]);
    // GDAL's own program agrees.
    ASSERT_EQ(std::system(("gdalsrsinfo -o epsg " + path("eroded.tif") + " | grep -q EPSG:32611").c_str()),
              0);
    for (const char* step : {"eroded.tif a.exr", "a.exr b.r32", "b.r32 c.tif"})
        ASSERT_EQ(talus(std::string("convert ") + step).code, 0);
    EXPECT_EQ(json::parse(talus("info --json c.tif").output)["hash"],
              json::parse(talus("info --json eroded.tif").output)["hash"]);
}

TEST_F(Program, ComparesMethodsWithTheReference) {
    ASSERT_EQ(talus(small + "--ticks 0 --out a.exr").code, 0);
    const Outcome outcome = talus("compare a.exr --size 96x54 --tolerance 0.5 --limit 0.5 --report c.json");
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    const json results = report("c.json")["results"];
    std::set<std::string> compared;
    for (const json& r : results) compared.insert(r["method"]);
    std::set<std::string> known;
    for (const json& parameter : json::parse(talus("parameters --json").output))
        if (parameter["name"] == "render.method") known = parameter["choices"].get<std::set<std::string>>();
    EXPECT_EQ(compared, known);
    EXPECT_GE(known.size(), 8U);
    for (const json& r : results) {
        const bool promises = r["method"] == "exact" || r["method"] == "hybrid";
        if (promises) {
            EXPECT_EQ(r["beyond_limit"], 0) << r["method"];
        } else {
            EXPECT_GT(r["beyond_limit"], 0) << r["method"];
        }
        EXPECT_EQ(r["frames"].size(), 12U);
        EXPECT_GT(r["cpu_ms"], 0);
    }
    std::ofstream(path("keys.toml")) << "[[key]]\neye=[0,0,900]\ntarget=[500,500,0]\n"
                                        "[[key]]\neye=[900,0,900]\ntarget=[500,500,0]\n";
    ASSERT_EQ(
        talus("compare a.exr --size 32x18 --method exact --keys keys.toml --frames 3 --report k.json").code,
        0);
    EXPECT_EQ(report("k.json")["results"][0]["frames"].size(), 3U);
    // A method's own parameters.
    std::vector<int> wrong;
    for (const char* samples : {"8", "800"}) {
        ASSERT_EQ(talus(std::string("compare a.exr --size 96x54 --method relief --report c.json --set "
                                    "render.relief_samples=") +
                        samples)
                      .code,
                  0);
        wrong.push_back(report("c.json")["results"][0]["beyond_limit"]);
    }
    EXPECT_GT(wrong[0], 4 * wrong[1]);
    ASSERT_EQ(talus("render a.exr --size 64x36 --keys keys.toml --frames 2 --image fly.png").code, 0);
    ASSERT_EQ(talus("render a.exr --size 64x36 --turntable 2 --image turn.png").code, 0);
    for (const char* file : {"fly-0000.png", "fly-0001.png", "turn-0000.png", "turn-0001.png"})
        EXPECT_GT(fs::file_size(path(file)), 100U) << file;

    EXPECT_EQ(refusal("compare a.exr --method x"),
              "--method 'x' is none, it must be one of: exact, boxes, mesh, hybrid, uniform, relief, ammann, "
              "clipmap\n");
    EXPECT_EQ(refusal("compare a.exr --tolerance -1"),
              "--tolerance -1 cannot be compared, it must be 0 to 16 pixels\n");
    std::ofstream(path("bad.toml")) << "[[key]]\neye=[0,0]\ntarget=[500,500,0]\n";
    EXPECT_EQ(refusal("compare a.exr --keys bad.toml"),
              "'bad.toml': key 1 needs eye = [x, y, z] in metres\n");
    std::ofstream(path("odd.toml")) << "[[key]]\neye=[0,0,1]\ntarget=[5,5,0]\nfov=30\n";
    EXPECT_EQ(refusal("compare a.exr --keys odd.toml"),
              "'odd.toml': key 1 cannot have this 'fov', keys have eye, target and the number fov_deg\n");
    std::ofstream(path("swap.toml")) << "[[key]]\neye=[0,0,1]\ntarget=[5,5,0]\n"
                                        "[[key]]\neye=[5,5,0]\ntarget=[0,0,1]\n";
    EXPECT_EQ(refusal("compare a.exr --keys swap.toml --frames 3"),
              "between keys 1 and 2 the eye meets its target, move one of them\n");
    EXPECT_EQ(refusal("compare a.exr --report nowhere/r.json"),
              "cannot write 'nowhere/r.json': there is no folder '" + path("nowhere") + "'\n");
    std::ofstream(path("one.toml")) << "[[key]]\neye=[0,0,1]\ntarget=[500,500,0]\n";
    EXPECT_EQ(refusal("render a.exr --keys one.toml --image f.png"),
              "'one.toml' needs two [[key]] tables or more\n");
    EXPECT_NE(refusal("render a.exr --keys none.toml --image f.png").find("'none.toml' does not exist"),
              std::string::npos);
    EXPECT_NE(refusal("render a.exr --turntable 3 --depth d.exr").find("give --image"), std::string::npos);
}

// One sign in a shader, and `verify` fails in the row that tells of it, while another holds.
TEST_F(Program, VerifyFindsTheShaderWithAWrongSign) {
    const struct {
        const char* shader;
        const char* right;
        const char* wrong;
        const char* fails;
        const char* holds;
    } cases[] = {{"maths/thermal.glsl", "(share / spacing) * along", "(share / spacing) * -along",
                  "brush and slopes", "pyramid"},
                 {"maths/water_sources.glsl", "depth = add_increment(depth, rain);",
                  "depth = add_increment(depth, -rain);", "water", "exact picture"},
                 {"maths/sediment_exchange.glsl", "before.solid.y), -metres_rock)",
                  "before.solid.y), metres_rock)", "sediment", "wet dam break"},
                 {"maths/patch.glsl", "real c1 = direction.z - (", "real c1 = direction.z + (",
                  "exact picture", "lake at rest"},
                 {"sim/ledger.comp", "stores.z += load.x + load.y", "stores.z -= load.x + load.y",
                  "ledger of rock", "ledger of water"}};
    for (const auto& c : cases) {
        const fs::path shaders = path("shaders");
        fs::remove_all(shaders);
        fs::copy(SHADER_FOLDER, shaders, fs::copy_options::recursive);
        std::ifstream in(shaders / c.shader);
        std::string text((std::istreambuf_iterator<char>(in)), {});
        const auto at = text.find(c.right);
        ASSERT_NE(at, std::string::npos) << c.shader;
        text.replace(at, std::string(c.right).size(), c.wrong);
        std::ofstream(shaders / c.shader) << text;
        const std::string only = std::string("verify --only '") + c.fails + "' --only '" + c.holds + "' ";
        const Outcome right = talus(only);
        EXPECT_EQ(right.code, 0) << right.output;
        const Outcome wrong = talus(only + "--shader-dir shaders --json found.json");
        EXPECT_EQ(wrong.code, 1) << c.shader << ": " << wrong.output;
        const json found = report("found.json");
        EXPECT_FALSE(found["claims"][0]["holds"]) << c.shader << ": " << wrong.output;
        EXPECT_TRUE(found["claims"][1]["holds"]) << c.shader << ": " << wrong.output;
        EXPECT_NE(wrong.output.find("do not hold on this device"), std::string::npos);
    }
    EXPECT_NE(refusal("verify --only rivers").find("'rivers' is no claim"), std::string::npos);
}

}  // namespace
}  // namespace talus
