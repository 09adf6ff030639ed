#include "app/core/flight.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "sim/error.h"

namespace talus::app {
namespace {

glm::dvec3 point_of(const toml::table& key, const char* name, const std::string& path, std::size_t number) {
    const toml::array* array = key[name].as_array();
    glm::dvec3 point;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto value = array && array->size() == 3 ? (*array)[i].value<double>() : std::nullopt;
        if (!value || !std::isfinite(*value))
            throw Error(fmt::format("'{}': key {} needs {} = [x, y, z] in metres", path, number, name));
        point[static_cast<int>(i)] = *value;
    }
    return point;
}

glm::dvec3 spline(glm::dvec3 before, glm::dvec3 a, glm::dvec3 b, glm::dvec3 after, double t) {
    return 0.5 * (2.0 * a + (b - before) * t + (2.0 * before - 5.0 * a + 4.0 * b - after) * (t * t) +
                  (3.0 * a - before - 3.0 * b + after) * (t * t * t));
}

}  // namespace

std::vector<render::Camera> read_keys(const std::string& path, double fov_deg) {
    if (!std::filesystem::is_regular_file(path))
        throw Error(fmt::format("'{}' does not exist, give the path of a file of key cameras", path));
    toml::table file;
    try {
        file = toml::parse_file(path);
    } catch (const toml::parse_error& error) {
        throw Error(fmt::format("'{}' cannot be read, line {}: {}", path, error.source().begin.line,
                                error.description()));
    }
    std::vector<render::Camera> cameras;
    if (const toml::array* keys = file["key"].as_array()) {
        for (const toml::node& node : *keys) {
            const toml::table* key = node.as_table();
            if (!key) break;
            render::Camera camera;
            camera.eye = point_of(*key, "eye", path, cameras.size() + 1);
            camera.target = point_of(*key, "target", path, cameras.size() + 1);
            camera.fov_deg = fov_deg;
            for (const auto& [name, value] : *key) {
                if (name == "eye" || name == "target") continue;
                const auto fov = name == "fov_deg" ? value.value<double>() : std::nullopt;
                if (!fov)
                    throw Error(fmt::format(
                        "'{}': key {} cannot have this '{}', keys have eye, target and the number fov_deg",
                        path, cameras.size() + 1, std::string(name.str())));
                camera.fov_deg = *fov;
            }
            if (camera.eye == camera.target || !(camera.fov_deg >= 1 && camera.fov_deg <= 150))
                throw Error(
                    fmt::format("'{}': key {} needs an eye apart from its target and 1 to 150 for fov_deg",
                                path, cameras.size() + 1));
            cameras.push_back(camera);
        }
    }
    if (cameras.size() < 2) throw Error(fmt::format("'{}' needs two [[key]] tables or more", path));
    return cameras;
}

std::vector<render::Camera> fly_along(const std::vector<render::Camera>& keys, int frames) {
    std::vector<render::Camera> cameras;
    const auto last = static_cast<int>(keys.size()) - 1;
    for (int frame = 0; frame < frames; ++frame) {
        const double way = frames > 1 ? static_cast<double>(last) * frame / (frames - 1) : 0;
        const int i = std::min(static_cast<int>(way), last - 1);
        const auto key = [&](int k) -> const render::Camera& {
            return keys[static_cast<std::size_t>(std::clamp(k, 0, last))];
        };
        const double t = way - i;
        cameras.push_back({spline(key(i - 1).eye, key(i).eye, key(i + 1).eye, key(i + 2).eye, t),
                           spline(key(i - 1).target, key(i).target, key(i + 1).target, key(i + 2).target, t),
                           key(i).fov_deg + (key(i + 1).fov_deg - key(i).fov_deg) * t});
        if (cameras.back().eye == cameras.back().target)
            throw Error(fmt::format("between keys {} and {} the eye meets its target, move one of them",
                                    i + 1, i + 2));
    }
    return cameras;
}

std::vector<render::Camera> turn_around(const render::Camera& camera, glm::dvec2 middle, int frames) {
    std::vector<render::Camera> cameras;
    for (int frame = 0; frame < frames; ++frame) {
        const double angle = 2 * std::numbers::pi * frame / frames;
        const auto turned = [&](glm::dvec3 p) {
            const glm::dvec2 off = glm::dvec2(p) - middle;
            return glm::dvec3(middle.x + off.x * std::cos(angle) - off.y * std::sin(angle),
                              middle.y + off.x * std::sin(angle) + off.y * std::cos(angle), p.z);
        };
        cameras.push_back({turned(camera.eye), turned(camera.target), camera.fov_deg});
    }
    return cameras;
}

}  // namespace talus::app
