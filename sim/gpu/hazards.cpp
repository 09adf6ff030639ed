#include "sim/gpu/hazards.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>

#include "sim/error.h"

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
        "as an image", "through a sampler",   "as storage",         "as indirect arguments",
        "as indices",  "by a texture's call", "by a buffer's call", "as a pixel buffer",
        "as a target", "as uniforms"};
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

void bound_targets(const std::vector<unsigned>& textures) {
    if (kept()) book().targets = textures;
}

void run(const std::string& program, const std::vector<Place>& places) {
    if (!kept()) return;
    Book& b = book();
    const auto each = [&](auto&& act) {
        for (const Place& place : places)
            if (place.object != 0)
                act(place,
                    place.use == Use::storage || place.use == Use::uniforms ? Kind::buffer : Kind::texture);
    };
    // What is written is ordered against what was written before, too.
    each([&](const Place& place, Kind kind) { check(kind, place.object, place.use, program); });
    ++b.now;
    each([&](const Place& place, Kind kind) {
        if (!place.writes) return;
        Object& object = b.objects[{kind, place.object}];
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
