#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/core/outputs.h"
#include "app/core/scene.h"
#include "sim/gpu/context.h"

namespace talus::app {

/// Options of the command line that several commands have, as texts: they are read after parsing, so that the
/// errors are ours.
struct Texts {
    std::string file, preset, input, size, spacing, range, raw, eye, target, fov, method, view, shader_dir,
        layer, samples, tolerances, texture, window_size, tiles, window, feather, film_size;
    std::vector<std::string> assignments, gauges, springs, drives, rasters, sections;
    std::optional<int> gpu;
    bool require_hardware = false;
    bool json = false;
    bool tiled = false;

    gpu::ContextChoice context() const { return {gpu, require_hardware}; }
    // Each throws talus::Error where its texts cannot be read.
    io::ImportSettings import() const;
    std::optional<glm::dvec2> range_m() const;
    SceneRequest scene(const std::string& file_given) const;
};

/// So many numbers with a separator between them. Throws talus::Error that names the option.
std::vector<double> numbers(const std::string& option, const std::string& text, char separator,
                            std::size_t count);
/// "513x513". Throws talus::Error that names the option.
glm::ivec2 size_from(const std::string& text, const char* option = "--size");
/// "x,y,z"; none where the text is empty. Throws talus::Error that names the option.
std::optional<glm::dvec3> point_from(const char* option, const std::string& text);

/// The name and the file of "name=FILE". Throws talus::Error that names the option and the example.
std::pair<std::string, std::string> named_file(const std::string& option, const std::string& text,
                                               const std::string& example);

// Declare options that several commands have.
void add_gpu(CLI::App& app, Texts& t);
void add_texture(CLI::App& app, Texts& t);
void add_tiled(CLI::App& app, Texts& t);
void add_import(CLI::App& app, Texts& t);
void add_outputs(CLI::App& app, Texts& t, Outputs& outputs);

}  // namespace talus::app
