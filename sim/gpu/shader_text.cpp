#include "sim/gpu/shader_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <regex>
#include <sstream>

#include "sim/error.h"
#include "sim/gpu/embedded_text.h"

namespace talus::gpu {
namespace {

namespace fs = std::filesystem;

struct Folder {
    fs::path root;
    unsigned generation = 1;
    fs::file_time_type newest{};
    std::function<void(const std::string&)> receive = [](const std::string& message) {
        fmt::print(stderr, "{}\n", message);
    };
};

Folder& folder() {
    static Folder instance;
    return instance;
}

fs::file_time_type newest_below(const fs::path& root) {
    fs::file_time_type newest = fs::file_time_type::min();  // the type's zero lies in the future
    // Editors replace files while we look: what vanishes is skipped.
    std::error_code gone;
    for (fs::recursive_directory_iterator at(root, gone), end; !gone && at != end; at.increment(gone)) {
        std::error_code failed;
        const fs::file_time_type time = at->last_write_time(failed);
        if (!failed && at->is_regular_file(failed) && !failed) newest = std::max(newest, time);
    }
    return newest;
}

std::string load_text(const std::string& path) {
    if (!folder().root.empty()) {
        std::ifstream file(folder().root / path, std::ios::binary);
        if (!file)
            throw Error(fmt::format("shader '{}' is not in the folder {}", path, folder().root.string()));
        return {std::istreambuf_iterator<char>(file), {}};
    }
    const auto found = embedded_shaders().find(path);
    if (found == embedded_shaders().end()) throw Error(fmt::format("shader '{}' was not built in", path));
    return std::string(found->second);
}

// The path that an #include names: in double quotes, or by a define whose value it is. Empty: none.
std::string included_path(const std::string& line, const std::vector<std::string>& defines) {
    const auto first = line.find('"');
    const auto last = line.rfind('"');
    if (first != std::string::npos && last > first) return line.substr(first + 1, last - first - 1);
    const std::string name = line.substr(std::min(line.find_first_not_of(' ', 8), line.size())) + ' ';
    const auto define = std::find_if(defines.begin(), defines.end(),
                                     [&](const std::string& one) { return one.starts_with(name); });
    return define == defines.end() ? "" : define->substr(name.size());
}

// Expands includes. #line directives carry a number per file, so that messages can be led back to it.
void expand(const std::string& path, const std::vector<std::string>& defines, std::vector<std::string>& files,
            std::string& out) {
    const auto number = files.size();
    files.push_back(path);
    out += fmt::format("#line 1 {}\n", number);
    std::istringstream lines(load_text(path));
    std::string line;
    for (int at = 1; std::getline(lines, line); ++at) {
        if (!line.starts_with("#include")) {
            out += line + '\n';
            continue;
        }
        const std::string included = included_path(line, defines);
        if (included.empty())
            throw Error(fmt::format("{}:{}: #include needs a path in double quotes", path, at));
        if (std::find(files.begin(), files.end(), included) == files.end())
            expand(included, defines, files, out);
        out += fmt::format("#line {} {}\n", at + 1, number);
    }
}

fs::path& kept_shaders() {
    static fs::path folder;
    return folder;
}

// sim/brush.comp becomes sim_brush.1a2b3c4d.comp: one file for each set of defines.
void keep(const std::string& path, const std::string& text) {
    std::string name = path;
    std::replace(name.begin(), name.end(), '/', '_');
    name.insert(name.rfind('.'), fmt::format(".{:08x}", std::hash<std::string>()(text) & 0xffffffffU));
    std::ofstream(kept_shaders() / name, std::ios::binary) << text;
}

}  // namespace

void use_shader_folder(const fs::path& root) {
    if (!fs::is_directory(root / "maths"))
        throw Error(fmt::format(
            "--shader-dir '{}' is not a folder of Talus shaders: it has no folder 'maths'", root.string()));
    folder().root = root;
    folder().newest = newest_below(root);
    ++folder().generation;
}

void use_built_in_shaders() {
    folder().root.clear();
    ++folder().generation;
}

bool poll_shader_folder() {
    Folder& watched = folder();
    if (watched.root.empty()) return false;
    const auto newest = newest_below(watched.root);
    if (newest == watched.newest) return false;
    watched.newest = newest;
    ++watched.generation;
    return true;
}

void keep_assembled_shaders(const fs::path& folder) {
    kept_shaders() = folder;
}

void on_shader_message(std::function<void(const std::string&)> receive) {
    folder().receive = std::move(receive);
}

void report_shader(const std::string& message) {
    folder().receive(message);
}

unsigned shader_generation() {
    return folder().generation;
}

ShaderText shader_text(const std::string& path, const std::vector<std::string>& defines) {
    ShaderText shader;
    std::string body;
    expand(path, defines, shader.files, body);
    shader.text = "#version 450 core\n";
    for (const std::string& define : defines) shader.text += "#define " + define + "\n";
    shader.text += body;
    if (!kept_shaders().empty()) keep(path, shader.text);
    return shader;
}

std::string name_files(const std::string& log, const std::vector<std::string>& files) {
    static const std::regex place(R"(^(\d+)(?::(\d+)\(\d+\)|\((\d+)\)) ?: ?)");
    std::istringstream lines(log);
    std::string line;
    std::string out;
    while (std::getline(lines, line)) {
        std::smatch match;
        if (std::regex_search(line, match, place)) {
            const std::size_t file = std::stoul(match[1]);
            const std::string at = match[2].matched ? match[2] : match[3];
            if (file < files.size())
                line = fmt::format("shaders/{}:{}: {}", files[file], at, std::string(match.suffix()));
        }
        if (line.find_first_not_of(" \r\n\t") != std::string::npos) out += (out.empty() ? "" : "\n") + line;
    }
    return out;
}

}  // namespace talus::gpu
