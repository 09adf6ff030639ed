#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace talus::gpu {

/// Where shader text comes from: the files built in or, after use_shader_folder(), a folder that is watched.
/// A program built from a folder follows its files: the next use after a change rebuilds it, and keeps the
/// old program when the new one does not compile.
void use_shader_folder(const std::filesystem::path& folder);

/// Back to the files built in.
void use_built_in_shaders();

/// Looks at the watched folder's files once; cheap, for the window's idle moments. True when any file
/// changed.
bool poll_shader_folder();

/// Messages of programs that could not be rebuilt go here (default: stderr), one line each: file, line,
/// message.
void on_shader_message(std::function<void(const std::string&)> receive);

/// From now on every shader is also written to this folder as the driver gets it, with its includes and
/// defines, for other compilers to look at; empty: no more.
void keep_assembled_shaders(const std::filesystem::path& folder);

/// Says it where on_shader_message() asked for it.
void report_shader(const std::string& message);

/// Rises when shaders may have changed: what was built of an older generation is built again.
unsigned shader_generation();

/// A shader as the driver gets it.
struct ShaderText {
    std::string text;                ///< with its includes and defines
    std::vector<std::string> files;  ///< below shaders/, by the numbers of its #line directives
};

/// The file below shaders/; its #includes are resolved below shaders/ too, each at most once. `defines` are
/// lines such as "NAME 1". Throws talus::Error where a file is missing.
ShaderText shader_text(const std::string& path, const std::vector<std::string>& defines);

/// A driver's messages with the names of files for their numbers: Mesa's "2:17(5): error: …" and NVIDIA's
/// "2(17) : error …" become "shaders/maths/patch.glsl:17: …".
std::string name_files(const std::string& log, const std::vector<std::string>& files);

}  // namespace talus::gpu
