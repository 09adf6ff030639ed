#include "sim/gpu/program.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <regex>
#include <sstream>

#include "sim/gpu/debug.h"
#include "sim/gpu/embedded_text.h"
#include "sim/gpu/error.h"
#include "sim/gpu/profile.h"

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

// Drivers write "2:17(5): error: …" (Mesa) or "2(17) : error …" (NVIDIA); people want "maths/patch.glsl:17:
// …".
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

GLenum stage_of(const std::string& path) {
    if (path.ends_with(".comp")) return GL_COMPUTE_SHADER;
    if (path.ends_with(".vert")) return GL_VERTEX_SHADER;
    if (path.ends_with(".frag")) return GL_FRAGMENT_SHADER;
    throw Error(fmt::format("shader '{}' should end in .comp, .vert or .frag", path));
}

std::string shader_log(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

std::string program_log(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

void delete_shader(unsigned name) {
    glDeleteShader(name);
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

Handle<delete_shader> compile(const std::string& path, const std::vector<std::string>& defines,
                              std::string& assembled) {
    std::vector<std::string> files;
    std::string body;
    expand(path, defines, files, body);
    std::string text = "#version 450 core\n";
    for (const std::string& define : defines) text += "#define " + define + "\n";
    text += body;
    assembled += text;
    if (!kept_shaders().empty()) keep(path, text);
    Handle<delete_shader> shader(glCreateShader(stage_of(path)));
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
        forget_errors();
        throw Error(name_files(shader_log(shader), files));
    }
    return shader;
}

}  // namespace

void delete_program(unsigned name) {
    glDeleteProgram(name);
}

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

Program::Program(std::vector<std::string> paths, std::vector<std::string> defines)
    : paths_(std::move(paths)), defines_(std::move(defines)) {
    build();
}

void Program::build() {
    generation_ = folder().generation;
    Handle<delete_program> fresh(glCreateProgram());
    std::vector<Handle<delete_shader>> shaders;
    std::string text;
    for (const std::string& path : paths_) {
        shaders.push_back(compile(path, defines_, text));
        glAttachShader(fresh, shaders.back());
    }
    glLinkProgram(fresh);
    GLint ok = 0;
    glGetProgramiv(fresh, GL_LINK_STATUS, &ok);
    if (!ok) {
        forget_errors();
        throw Error(fmt::format("shaders/{}: {}", paths_.back(), program_log(fresh)));
    }
    glObjectLabel(GL_PROGRAM, fresh, static_cast<GLsizei>(paths_.back().size()), paths_.back().data());
    accesses_ = hazards::accesses_of(fresh, text);
    handle_ = std::move(fresh);
    locations_.clear();
    for (const auto& [name, value] : values_) upload(name, value);
    raise_errors();
}

void Program::use() {
    if (generation_ != folder().generation) {
        try {
            build();
        } catch (const Error& error) {
            folder().receive(fmt::format("kept the old program: {}", error.what()));
        }
    }
    glUseProgram(handle_);
    hazards::run(paths_.back(), accesses_);
}

void Program::upload(std::string_view name, const Value& value) {
    auto found = locations_.find(name);
    if (found == locations_.end()) {
        const std::string text(name);
        found = locations_.emplace(text, glGetUniformLocation(handle_, text.c_str())).first;
    }
    const GLint at = found->second;
    switch (value.kind) {
        case 1:
            glProgramUniform1fv(handle_, at, 1, value.real.data());
            break;
        case 2:
            glProgramUniform2fv(handle_, at, 1, value.real.data());
            break;
        case 3:
            glProgramUniform3fv(handle_, at, 1, value.real.data());
            break;
        case 4:
            glProgramUniform4fv(handle_, at, 1, value.real.data());
            break;
        case 5:
            glProgramUniform1iv(handle_, at, 1, value.whole.data());
            break;
        case 6:
            glProgramUniform2iv(handle_, at, 1, value.whole.data());
            break;
        default:
            glProgramUniform1ui(handle_, at, static_cast<GLuint>(value.whole[0]));
            break;
    }
}

void Program::remember(std::string_view name, const Value& value) {
    const auto found = values_.find(name);
    if (found == values_.end())
        values_.emplace(std::string(name), value);
    else
        found->second = value;
    upload(name, value);
}

void Program::set(std::string_view name, float value) {
    remember(name, {1, {value}, {}});
}
void Program::set(std::string_view name, glm::vec2 v) {
    remember(name, {2, {v.x, v.y}, {}});
}
void Program::set(std::string_view name, glm::vec3 v) {
    remember(name, {3, {v.x, v.y, v.z}, {}});
}
void Program::set(std::string_view name, glm::vec4 v) {
    remember(name, {4, {v.x, v.y, v.z, v.w}, {}});
}
void Program::set(std::string_view name, int value) {
    remember(name, {5, {}, {value}});
}
void Program::set(std::string_view name, glm::ivec2 v) {
    remember(name, {6, {}, {v.x, v.y}});
}
void Program::set(std::string_view name, unsigned value) {
    remember(name, {7, {}, {static_cast<int>(value)}});
}

void Program::dispatch(int groups_x, int groups_y, int groups_z) {
    const PassSpan timed(paths_.back());
    use();
    glDispatchCompute(static_cast<GLuint>(groups_x), static_cast<GLuint>(groups_y),
                      static_cast<GLuint>(groups_z));
    raise_errors();
}

void Program::dispatch_indirect(const Buffer& arguments, std::size_t offset) {
    const PassSpan timed(paths_.back());
    hazards::used(hazards::Kind::buffer, arguments.name(), Use::indirect, paths_.back().c_str());
    use();
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, arguments.name());
    glDispatchComputeIndirect(static_cast<GLintptr>(offset));
    raise_errors();
}

namespace {

// OpenGL's core profile draws nothing without a vertex array, so each draw brings one. `indices` may be 0.
template <typename Draw>
void with_vertex_array(unsigned indices, Draw&& draw) {
    GLuint array = 0;
    glCreateVertexArrays(1, &array);
    if (indices != 0) glVertexArrayElementBuffer(array, indices);
    glBindVertexArray(array);
    draw();
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &array);
}

// Reversed depth: near 1, infinity 0.
template <typename Draw>
void with_depth(Depth depth, Draw&& draw) {
    if (depth == Depth::none) return draw();
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(depth == Depth::nearest ? GL_GREATER : depth == Depth::behind ? GL_EQUAL : GL_ALWAYS);
    if (depth == Depth::nearest) glEnable(GL_CULL_FACE);
    draw();
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

// Offsets into a bound buffer travel as pointers in OpenGL's interface.
const void* as_offset(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
}

}  // namespace

void Program::draw_fullscreen() {
    const PassSpan timed(paths_.back());
    use();
    hazards::draws(paths_.back());
    with_vertex_array(0, [] { glDrawArrays(GL_TRIANGLES, 0, 3); });
    raise_errors();
}

void Program::draw_indirect(const Buffer& arguments, std::size_t offset, Depth depth) {
    const PassSpan timed(paths_.back());
    hazards::used(hazards::Kind::buffer, arguments.name(), Use::indirect, paths_.back().c_str());
    use();
    hazards::draws(paths_.back());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, arguments.name());
    with_vertex_array(
        0, [&] { with_depth(depth, [&] { glDrawArraysIndirect(GL_TRIANGLES, as_offset(offset)); }); });
    raise_errors();
}

void Program::draw_points_indirect(const Buffer& arguments, std::size_t offset, Depth depth) {
    const PassSpan timed(paths_.back());
    hazards::used(hazards::Kind::buffer, arguments.name(), Use::indirect, paths_.back().c_str());
    use();
    hazards::draws(paths_.back());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, arguments.name());
    glEnable(GL_PROGRAM_POINT_SIZE);
    with_vertex_array(
        0, [&] { with_depth(depth, [&] { glDrawArraysIndirect(GL_POINTS, as_offset(offset)); }); });
    glDisable(GL_PROGRAM_POINT_SIZE);
    raise_errors();
}

void Program::draw_indexed_indirect(const Buffer& indices, const Buffer& arguments, std::size_t offset,
                                    Depth depth) {
    const PassSpan timed(paths_.back());
    hazards::used(hazards::Kind::buffer, arguments.name(), Use::indirect, paths_.back().c_str());
    use();
    hazards::draws(paths_.back());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, arguments.name());
    hazards::used(hazards::Kind::buffer, indices.name(), Use::elements, paths_.back().c_str());
    with_vertex_array(indices.name(), [&] {
        with_depth(depth, [&] { glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, as_offset(offset)); });
    });
    raise_errors();
}

}  // namespace talus::gpu
