#include "sim/gpu/hazards.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "sim/gpu/error.h"

namespace talus::gpu::hazards {
namespace {

struct Object {
    std::string label;
    std::uint64_t stored = 0;  // number of the run that stored into it last; 0: none did
    std::string by;
};

struct Book {
    bool kept = false;
    std::uint64_t now = 0;
    std::array<std::uint64_t, use_count> ordered{};  // number of the run before the last barrier
    std::map<std::pair<Kind, unsigned>, Object> objects;
    std::map<unsigned, unsigned> images;
    std::map<unsigned, unsigned> samplers;
    std::map<unsigned, unsigned> storages;
    std::vector<unsigned> targets;
};

bool by_default() {
#ifdef NDEBUG
    return std::getenv("TALUS_HAZARDS") != nullptr;
#else
    return true;
#endif
}

Book fresh_book(bool kept) {
    Book fresh;
    fresh.kept = kept;
    return fresh;
}

// Of the context that is current on the thread.
Book& book() {
    static thread_local Book the = fresh_book(by_default());
    return the;
}

std::string name_of(Use use) {
    constexpr std::array<const char*, use_count> names = {
        "as an image",           "through a sampler", "as storage",
        "as indirect arguments", "as indices",        "by a texture's call",
        "by a buffer's call",    "as a pixel buffer", "as a target"};
    return names[static_cast<unsigned>(use)];
}

void check(Kind kind, unsigned name, Use use, std::string_view by) {
    Book& b = book();
    const auto found = b.objects.find({kind, name});
    if (found == b.objects.end() || found->second.stored == 0) return;
    const Object& object = found->second;
    if (b.ordered[static_cast<unsigned>(use)] >= object.stored) return;
    throw Error(
        fmt::format("{} uses the {} '{}' {} after {} stored into it, without a barrier for that between them",
                    by, kind == Kind::texture ? "texture" : "buffer", object.label, name_of(use), object.by));
}

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

unsigned bound_at(const std::map<unsigned, unsigned>& places, unsigned place) {
    const auto found = places.find(place);
    return found == places.end() ? 0 : found->second;
}

}  // namespace

void keep(bool on) {
    book() = fresh_book(on);
}

void context_made() {
    book() = fresh_book(book().kept);
}

bool kept() {
    return book().kept;
}

void made(Kind kind, unsigned name, const std::string& label) {
    if (kept()) book().objects[{kind, name}] = {label, 0, {}};
}

void bound_image(unsigned unit, unsigned texture) {
    if (kept()) book().images[unit] = texture;
}

void bound_sampler(unsigned unit, unsigned texture) {
    if (kept()) book().samplers[unit] = texture;
}

void bound_storage(unsigned index, unsigned buffer) {
    if (kept()) book().storages[index] = buffer;
}

void bound_targets(const std::vector<unsigned>& textures) {
    if (kept()) book().targets = textures;
}

std::vector<Access> accesses_of(unsigned program, std::string_view text) {
    std::vector<Access> accesses;
    if (!kept()) return accesses;
    const auto add = [&](Use use, const std::string& binding, const std::string& words) {
        const bool only_read = words.find("readonly") != std::string::npos || use == Use::sampler;
        const bool only_written = words.find("writeonly") != std::string::npos;
        accesses.push_back({use, static_cast<unsigned>(std::stoul(binding)), !only_written, !only_read});
    };
    static const std::regex declaration(
        R"(layout\(binding = (\d+)(?:, (\w+))?\)([a-z ]*?)(?:uniform([a-z ]*?)(image2D|sampler2D)\s+(\w+)|buffer\s+(\w+)))");
    const std::string all = active_lines(text);
    for (std::sregex_iterator at(all.begin(), all.end(), declaration), end; at != end; ++at) {
        const std::smatch& match = *at;
        if (match[7].matched) {
            const std::string block = match[7];
            if (glGetProgramResourceIndex(program, GL_SHADER_STORAGE_BLOCK, block.c_str()) !=
                GL_INVALID_INDEX)
                add(Use::storage, match[1], match[3]);
        } else if (glGetUniformLocation(program, match[6].str().c_str()) >= 0) {
            add(match[5] == "image2D" ? Use::image : Use::sampler, match[1], match[3].str() + match[4].str());
        }
    }
    return accesses;
}

void run(const std::string& program, const std::vector<Access>& accesses) {
    if (!kept()) return;
    Book& b = book();
    const auto each = [&](auto&& act) {
        for (const Access& access : accesses) {
            const bool is_buffer = access.use == Use::storage;
            const unsigned name = bound_at(is_buffer                    ? b.storages
                                           : access.use == Use::sampler ? b.samplers
                                                                        : b.images,
                                           access.binding);
            if (name != 0) act(access, is_buffer ? Kind::buffer : Kind::texture, name);
        }
    };
    // What is written is ordered against what was written before, too.
    each([&](const Access& access, Kind kind, unsigned name) { check(kind, name, access.use, program); });
    ++b.now;
    each([&](const Access& access, Kind kind, unsigned name) {
        if (!access.writes) return;
        Object& object = b.objects[{kind, name}];
        object.stored = b.now;
        object.by = program;
    });
}

void draws(const std::string& program) {
    if (!kept()) return;
    for (const unsigned texture : book().targets) check(Kind::texture, texture, Use::framebuffer, program);
}

void used(Kind kind, unsigned name, Use use, const char* call) {
    if (kept()) check(kind, name, use, call);
}

void ordered(Use use) {
    if (kept()) book().ordered[static_cast<unsigned>(use)] = book().now;
}

}  // namespace talus::gpu::hazards
