// The tables and figures of the papers that Talus stands on, made again: each a file of out/papers, from
// which tests/bench/plot_papers.sh draws docs/papers. docs/papers.md says what came out.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "sim/error.h"
#include "tests/bench/measure.h"
#include "tests/bench/papers/tables.h"
#include "tests/bench/papers/terrains.h"

namespace talus::bench {
namespace {

struct NamedTable {
    std::string name;
    void (*make)(const PaperRun&);
};

const std::vector<NamedTable>& paper_tables() {
    static const std::vector<NamedTable> tables = {{"ammann_table_1", ammann_table_1},
                                                   {"ammann_table_2", ammann_table_2},
                                                   {"ammann_figure_4", ammann_figure_4},
                                                   {"ammann_figure_5", ammann_figure_5},
                                                   {"ammann_figure_6", ammann_figure_6},
                                                   {"ammann_figure_9", ammann_figure_9},
                                                   {"ammann_figure_11", ammann_figure_11},
                                                   {"jeong_han_samples", jeong_han_samples},
                                                   {"jeong_han_pictures", jeong_han_pictures},
                                                   {"park_oh_table_1", park_oh_table_1},
                                                   {"park_oh_figure_11", park_oh_figure_11},
                                                   {"park_oh_figure_13", park_oh_figure_13},
                                                   {"dick_figure_6", dick_figure_6},
                                                   {"dick_pyramid", dick_pyramid},
                                                   {"dick_footprint", dick_footprint},
                                                   {"tiled", tiled},
                                                   {"tiled_8192", tiled_8192},
                                                   {"tiled_casting", tiled_casting},
                                                   {"ammann_boxes", ammann_boxes},
                                                   {"cameras", cameras},
                                                   {"changes", changes},
                                                   {"flight", flight},
                                                   {"survey", survey}};
    return tables;
}

}  // namespace

void bench_papers(double patch_pixels, const std::string& only, const std::string& terrain,
                  const std::string& method) {
    std::string names;
    for (const NamedTable& table : paper_tables()) names += (names.empty() ? "" : ", ") + table.name;
    const auto& tables = paper_tables();
    if (!only.empty() && std::none_of(tables.begin(), tables.end(),
                                      [&](const NamedTable& table) { return table.name == only; }))
        throw Error(fmt::format("there is no table '{}', it must be one of: {}", only, names));
    PaperRun run{patch_pixels, paper_terrain_names(), method};
    const auto& known = run.terrains;
    if (!terrain.empty()) {
        if (std::find(known.begin(), known.end(), terrain) == known.end())
            throw Error(fmt::format("there is no terrain '{}', it must be one of: {}", terrain,
                                    fmt::join(known, ", ")));
        run.terrains = {terrain};
    }
    std::filesystem::create_directories("out/papers");
    for (const NamedTable& table : tables)
        if (only.empty() || only == table.name) table.make(run);
}

}  // namespace talus::bench
