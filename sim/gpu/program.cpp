#include "sim/gpu/program.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "sim/error.h"
#include "sim/gpu/debug.h"
#include "sim/gpu/hazards.h"
#include "sim/gpu/profile.h"
#include "sim/gpu/shader_text.h"

namespace talus::gpu {
namespace {

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

Handle<delete_shader> compile(const std::string& path, const std::vector<std::string>& defines,
                              std::string& assembled) {
    const ShaderText given = shader_text(path, defines);
    assembled += given.text;
    Handle<delete_shader> shader(glCreateShader(stage_of(path)));
    const char* source = given.text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
        forget_errors();
        throw Error(name_files(shader_log(shader), given.files));
    }
    return shader;
}

// Number of the program that bound last: what another one bound before may be bound over.
std::uint64_t& binder() {
    static thread_local std::uint64_t number = 0;
    return number;
}

std::uint64_t next_number() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

}  // namespace

void delete_program(unsigned name) {
    glDeleteProgram(name);
}

Program::Program(std::vector<std::string> paths, std::vector<std::string> defines)
    : number_(next_number()), paths_(std::move(paths)), defines_(std::move(defines)) {
    build();
}

void Program::build() {
    generation_ = shader_generation();
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
    std::vector<Place> places = places_of(fresh, text);
    // While running, shaders from a folder may use what this program is given, and nothing else.
    if (handle_ != 0)
        for (const Place& one : places)
            if (!given_.contains(one.name))
                throw Error(fmt::format("shaders/{} uses '{}', which the program does not give it",
                                        paths_.back(), one.name));
    places_ = std::move(places);
    handle_ = std::move(fresh);
    locations_.clear();
    for (const auto& [name, value] : values_) upload(name, value);
    raise_errors();
}

void Program::follow_files() {
    if (generation_ == shader_generation()) return;
    try {
        build();
    } catch (const Error& error) {
        report_shader(fmt::format("kept the old program: {}", error.what()));
    }
}

Place* Program::place(Use use, std::string_view name) {
    follow_files();
    if (!given_.contains(name)) given_.emplace(name);
    const auto found = std::find_if(places_.begin(), places_.end(),
                                    [&](const Place& one) { return one.use == use && one.name == name; });
    if (found == places_.end()) return nullptr;
    // Another program's objects are bound in this one's places.
    if (binder() != number_)
        for (Place& one : places_) one.bound = false;
    binder() = number_;
    found->bound = true;
    return &*found;
}

void Program::bind_image(std::string_view name, const Texture& texture) {
    Place* const at = place(Use::image, name);
    if (!at) return;
    at->object = texture.name();
    texture.bind_image(at->unit,
                       at->writes ? (at->reads ? Access::read_write : Access::write) : Access::read);
}

void Program::bind_sampled(std::string_view name, const Texture& texture) {
    Place* const at = place(Use::sampler, name);
    if (!at) return;
    at->object = texture.name();
    texture.bind_sampled(at->unit);
}

void Program::bind_storage(std::string_view name, const Buffer& buffer) {
    Place* const at = place(Use::storage, name);
    if (!at) return;
    at->object = buffer.name();
    buffer.bind_storage(at->unit);
}

void Program::bind_uniforms(std::string_view name, const Buffer& buffer) {
    Place* const at = place(Use::uniforms, name);
    if (!at) return;
    // Drivers differ in whether a std140 block's size includes its padding to 16 bytes.
    at->bound = buffer.bytes() >= at->bytes && buffer.bytes() < at->bytes + 16;
    if (!at->bound)
        throw Error(fmt::format(
            "shaders/{} has {} bytes of '{}', but {} were bound there: both must declare the same",
            paths_.back(), at->bytes, name, buffer.bytes()));
    at->object = buffer.name();
    buffer.bind_uniforms(at->unit);
}

void Program::use() {
    follow_files();
    for (const Place& one : places_)
        if (!one.bound || binder() != number_)
            throw Error(fmt::format("shaders/{} is run without its {} '{}'", paths_.back(),
                                    one.use == Use::storage    ? "buffer"
                                    : one.use == Use::uniforms ? "uniforms"
                                    : one.use == Use::sampler  ? "texture"
                                                               : "image",
                                    one.name));
    glUseProgram(handle_);
    hazards::run(paths_.back(), places_);
    for (Place& one : places_) one.bound = false;
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

}  // namespace

void Program::draw_fullscreen(Depth depth) {
    const PassSpan timed(paths_.back());
    use();
    hazards::draws(paths_.back());
    with_vertex_array(0, [&] { with_depth(depth, [] { glDrawArrays(GL_TRIANGLES, 0, 3); }); });
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
