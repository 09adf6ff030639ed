#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace talus::bench {

/// What tables are made with.
struct PaperRun {
    double patch_pixels;                ///< the hybrid's choice on this device
    std::vector<std::string> terrains;  ///< of papers/terrains.h; some tables have a terrain of their own
    std::string method;                 ///< of flight and survey: rows whose name begins so alone
};

constexpr glm::ivec2 small_picture(480, 270);

// Every method over the same pictures.
void flight(const PaperRun& run);
void survey(const PaperRun& run);
void cameras(const PaperRun& run);
void changes(const PaperRun& run);

// Ammann, Génevaux & Dischler 2010.
void ammann_table_1(const PaperRun& run);
void ammann_table_2(const PaperRun& run);
void ammann_figure_4(const PaperRun& run);
void ammann_figure_5(const PaperRun& run);
void ammann_figure_6(const PaperRun& run);
void ammann_boxes(const PaperRun& run);
void ammann_figure_9(const PaperRun& run);
void ammann_figure_11(const PaperRun& run);

// Jeong & Han 2006.
void jeong_han_samples(const PaperRun& run);
void jeong_han_pictures(const PaperRun& run);

// Park & Oh 2009.
void park_oh_table_1(const PaperRun& run);
void park_oh_figure_11(const PaperRun& run);
void park_oh_figure_13(const PaperRun& run);

// Dick, Krüger & Westermann 2009.
void dick_figure_6(const PaperRun& run);
void dick_pyramid(const PaperRun& run);
void dick_footprint(const PaperRun& run);
void tiled(const PaperRun& run);
/// A high view of 8192 x 8192 samples: all methods that hold the whole, and tiles.
void tiled_8192(const PaperRun& run);
void tiled_casting(const PaperRun& run);

}  // namespace talus::bench
