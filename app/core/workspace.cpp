#include "app/core/workspace.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/error.h"

namespace talus::app {
namespace {

using nlohmann::json;

json json_of(glm::dvec2 place) {
    return {place.x, place.y};
}
glm::dvec2 place_of(const json& told) {
    return {told.at(0).get<double>(), told.at(1).get<double>()};
}

json json_of(const render::Camera& camera) {
    return {{"eye", {camera.eye.x, camera.eye.y, camera.eye.z}},
            {"target", {camera.target.x, camera.target.y, camera.target.z}},
            {"fov_deg", camera.fov_deg},
            {"parallel_m", camera.parallel_m}};
}
render::Camera camera_of(const json& told) {
    const auto point = [&](const char* name) {
        const json& numbers = told.at(name);
        return glm::dvec3(numbers.at(0).get<double>(), numbers.at(1).get<double>(),
                          numbers.at(2).get<double>());
    };
    render::Camera camera;
    camera.eye = point("eye");
    camera.target = point("target");
    camera.fov_deg = told.at("fov_deg");
    // Documents of before have none.
    camera.parallel_m = told.value("parallel_m", 0.0);
    if (!(camera.parallel_m >= 0) || camera.eye == camera.target ||
        !(camera.fov_deg > 0 && camera.fov_deg < 180))
        throw Error("a camera looks nowhere");
    return camera;
}

json json_of(const Gauge& gauge) {
    json readings = json::array();
    for (const GaugeReading& reading : gauge.readings)
        readings.push_back(
            {reading.ground_m, reading.depth_m, reading.velocity_m_per_s.x, reading.velocity_m_per_s.y});
    return {{"at_m", json_of(gauge.place_m)}, {"first_row", gauge.first_row}, {"readings", readings}};
}
Gauge gauge_of(const json& told) {
    Gauge gauge{place_of(told.at("at_m")), told.at("first_row").get<std::size_t>(), {}};
    for (const json& one : told.at("readings"))
        gauge.readings.push_back({one.at(0), one.at(1), {one.at(2).get<double>(), one.at(3).get<double>()}});
    return gauge;
}

json json_of(const PlacedSection& one) {
    return {{"from_m", json_of(one.section.from_m)},
            {"to_m", json_of(one.section.to_m)},
            {"heights_m", json_of(one.heights_m)},
            {"first_row", one.first_row},
            {"volumes_m3", one.volumes_m3}};
}
PlacedSection section_of(const json& told) {
    PlacedSection one;
    one.section = {place_of(told.at("from_m")), place_of(told.at("to_m"))};
    one.heights_m = place_of(told.at("heights_m"));
    one.first_row = told.at("first_row");
    one.volumes_m3 = told.at("volumes_m3").get<std::vector<double>>();
    return one;
}

template <typename Things>
json list_of(const Things& things) {
    json list = json::array();
    for (const auto& thing : things) list.push_back(json_of(thing));
    return list;
}

}  // namespace

const render::Camera& camera_named(const std::vector<NamedCamera>& cameras, const std::string& name) {
    const auto found = std::find_if(cameras.begin(), cameras.end(),
                                    [&](const NamedCamera& one) { return one.name == name; });
    if (found != cameras.end()) return found->camera;
    std::vector<std::string> names;
    names.reserve(cameras.size());
    for (const NamedCamera& one : cameras) names.push_back(one.name);
    throw Error(names.empty() ? fmt::format("there is no camera '{}': this scene keeps none", name)
                              : fmt::format("there is no camera '{}', it must be one of: {}", name,
                                            fmt::join(names, ", ")));
}

std::string workspace_text(const Workspace& workspace) {
    json told = {{"parameters", workspace.parameters}};
    if (workspace.camera) told["camera"] = json_of(*workspace.camera);
    for (const NamedCamera& one : workspace.cameras) {
        json camera = json_of(one.camera);
        camera["name"] = one.name;
        told["cameras"].push_back(std::move(camera));
    }
    if (!workspace.gauges.empty())
        told["gauges"] = {{"times_s", workspace.gauge_times_s}, {"all", list_of(workspace.gauges)}};
    if (!workspace.sections.empty())
        told["sections"] = {{"times_s", workspace.section_times_s}, {"all", list_of(workspace.sections)}};
    if (!workspace.path_m.empty()) told["path_m"] = list_of(workspace.path_m);
    if (!workspace.panel.empty()) told["panel"] = workspace.panel;
    told["panels_shown"] = workspace.panels_shown;
    // Names of cameras are typed by hand: what is no UTF-8 must not stop a save.
    return told.dump(-1, ' ', false, json::error_handler_t::replace);
}

Workspace workspace_from(const std::string& text) {
    Workspace workspace;
    try {
        const json told = json::parse(text);
        workspace.parameters = told.value("parameters", std::vector<std::string>());
        if (told.contains("camera")) workspace.camera = camera_of(told.at("camera"));
        for (const json& one : told.value("cameras", json::array()))
            workspace.cameras.push_back({one.at("name"), camera_of(one)});
        if (told.contains("gauges")) {
            workspace.gauge_times_s = told.at("gauges").at("times_s").get<std::vector<double>>();
            for (const json& one : told.at("gauges").at("all")) workspace.gauges.push_back(gauge_of(one));
        }
        if (told.contains("sections")) {
            workspace.section_times_s = told.at("sections").at("times_s").get<std::vector<double>>();
            for (const json& one : told.at("sections").at("all"))
                workspace.sections.push_back(section_of(one));
        }
        for (const json& one : told.value("path_m", json::array())) workspace.path_m.push_back(place_of(one));
        workspace.panel = told.value("panel", std::string());
        workspace.panels_shown = told.value("panels_shown", true);
    } catch (const json::exception& error) {
        throw Error(fmt::format("the workspace is none that Talus wrote: {}", error.what()));
    }
    return workspace;
}

Workspace without_rows(Workspace workspace) {
    workspace.gauge_times_s.clear();
    workspace.section_times_s.clear();
    for (Gauge& gauge : workspace.gauges) gauge = {gauge.place_m, 0, {}};
    for (PlacedSection& one : workspace.sections) one = {one.section, one.heights_m, 0, {}, 0};
    return workspace;
}

std::vector<std::string> kept_assignments(const Parameters& view) {
    std::vector<std::string> kept;
    for (const Parameter& one : view.declared())
        if (view.is_given(one.name) && !one.of_machine)
            kept.push_back(fmt::format("{}={}", one.name, to_text(view.value(one.name))));
    return kept;
}

}  // namespace talus::app
