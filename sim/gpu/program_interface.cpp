#include "sim/gpu/program_interface.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <sstream>

#include "sim/error.h"

namespace talus::gpu {
namespace {

// The text without the branches of #ifdef and #ifndef that its defines leave out. What stands under #if
// stays: which of its branches holds is not known here.
std::string active_lines(std::string_view text) {
    std::istringstream lines{std::string(text)};
    std::set<std::string> defined;
    struct Branch {
        bool known;
        bool active;
    };
    std::vector<Branch> branches;
    std::string kept_lines;
    std::string line;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string word;
        std::string name;
        words >> word >> name;
        const bool active = std::all_of(branches.begin(), branches.end(),
                                        [](const Branch& b) { return !b.known || b.active; });
        if (word == "#version") defined.clear();  // another shader begins
        if (word == "#ifdef" || word == "#ifndef")
            branches.push_back({true, defined.contains(name) == (word == "#ifdef")});
        else if (word == "#if")
            branches.push_back({false, true});
        else if (word == "#else" && !branches.empty())
            branches.back().active = !branches.back().active;
        else if (word == "#endif" && !branches.empty())
            branches.pop_back();
        else if (active && word == "#define")
            defined.insert(name);
        else if (active)
            kept_lines += line + '\n';
    }
    return kept_lines;
}

bool is_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Finds from the qualifiers (readonly, writeonly) of a name's declarations whether shaders read or write it.
// All declarations count, in whichever branch. Throws talus::Error if there is none: a declaration must stand
// in one line, as "image2D name" or "buffer Name".
void read_qualifiers(const std::string& text, Place& place) {
    const std::string declared = (place.use == Use::storage ? "buffer " : "image2D ") + place.name;
    bool found = false;
    place.reads = place.writes = false;
    for (auto at = text.find(declared); at != std::string::npos; at = text.find(declared, at + 1)) {
        const auto behind = at + declared.size();
        if (behind < text.size() && is_letter(text[behind])) continue;
        const auto line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
        const std::string_view before = std::string_view(text).substr(line, at - line);
        if (before.find("//") != std::string_view::npos) continue;
        found = true;
        place.reads = place.reads || before.find("writeonly") == std::string_view::npos;
        place.writes = place.writes || before.find("readonly") == std::string_view::npos;
    }
    if (!found) throw Error(fmt::format("a shader should declare '{}' in one line", declared));
}

// Types of places that no call here binds.
bool is_unknown_place(GLint type) {
    constexpr std::array types = {GL_IMAGE_1D,
                                  GL_IMAGE_3D,
                                  GL_IMAGE_CUBE,
                                  GL_IMAGE_2D_ARRAY,
                                  GL_INT_IMAGE_2D,
                                  GL_UNSIGNED_INT_IMAGE_2D,
                                  GL_SAMPLER_1D,
                                  GL_SAMPLER_3D,
                                  GL_SAMPLER_CUBE,
                                  GL_SAMPLER_2D_ARRAY,
                                  GL_SAMPLER_2D_SHADOW,
                                  GL_INT_SAMPLER_2D,
                                  GL_UNSIGNED_INT_SAMPLER_2D};
    return std::find(types.begin(), types.end(), type) != types.end();
}

// Its active resources, by name.
std::vector<std::string> resources(unsigned program, GLenum kind) {
    GLint count = 0;
    GLint longest = 0;
    glGetProgramInterfaceiv(program, kind, GL_ACTIVE_RESOURCES, &count);
    glGetProgramInterfaceiv(program, kind, GL_MAX_NAME_LENGTH, &longest);
    std::vector<std::string> names;
    for (GLint i = 0; i < count; ++i) {
        std::string name(static_cast<std::size_t>(longest), '\0');
        GLsizei length = 0;
        glGetProgramResourceName(program, kind, static_cast<GLuint>(i), longest, &length, name.data());
        name.resize(static_cast<std::size_t>(length));
        names.push_back(name);
    }
    return names;
}

}  // namespace

std::vector<Place> places_of(unsigned program, std::string_view text) {
    std::vector<Place> places;
    const std::string active = active_lines(text);
    unsigned images = 0;
    unsigned samplers = 0;
    for (const std::string& name : resources(program, GL_UNIFORM)) {
        constexpr GLenum wanted = GL_TYPE;
        const GLuint index = glGetProgramResourceIndex(program, GL_UNIFORM, name.c_str());
        GLint type = 0;
        glGetProgramResourceiv(program, GL_UNIFORM, index, 1, &wanted, 1, nullptr, &type);
        const bool is_place = type == GL_IMAGE_2D || type == GL_SAMPLER_2D;
        if (is_unknown_place(type) || (is_place && name.ends_with(']')))
            throw Error(fmt::format(
                "a shader uses '{}', which is no image2D, sampler2D, storage buffer or uniform block", name));
        if (!is_place) continue;
        Place place;
        place.use = type == GL_IMAGE_2D ? Use::image : Use::sampler;
        place.name = name;
        place.unit = type == GL_IMAGE_2D ? images++ : samplers++;
        if (place.use == Use::image) read_qualifiers(active, place);
        glProgramUniform1i(program, glGetUniformLocation(program, name.c_str()),
                           static_cast<GLint>(place.unit));
        places.push_back(place);
    }
    unsigned buffers = 0;
    for (const std::string& name : resources(program, GL_SHADER_STORAGE_BLOCK)) {
        Place place;
        place.use = Use::storage;
        place.name = name;
        place.unit = buffers++;
        read_qualifiers(active, place);
        glShaderStorageBlockBinding(
            program, glGetProgramResourceIndex(program, GL_SHADER_STORAGE_BLOCK, name.c_str()), place.unit);
        places.push_back(place);
    }
    unsigned blocks = 0;
    for (const std::string& name : resources(program, GL_UNIFORM_BLOCK)) {
        constexpr GLenum wanted = GL_BUFFER_DATA_SIZE;
        const GLuint index = glGetProgramResourceIndex(program, GL_UNIFORM_BLOCK, name.c_str());
        GLint bytes = 0;
        glGetProgramResourceiv(program, GL_UNIFORM_BLOCK, index, 1, &wanted, 1, nullptr, &bytes);
        Place place;
        place.use = Use::uniforms;
        place.name = name;
        place.unit = blocks++;
        place.bytes = static_cast<std::size_t>(bytes);
        glUniformBlockBinding(program, index, place.unit);
        places.push_back(place);
    }
    return places;
}

}  // namespace talus::gpu
