#include "app/core/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/core/app_parameters.h"
#include "render/view.h"
#include "sim/drives.h"
#include "sim/error.h"
#include "sim/events.h"
#include "sim/preset.h"
#include "sim/simulation_parameters.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/reshape.h"
#include "sim/terrain/state_hash.h"

namespace talus::app {
namespace {

// The values of `all` that `part` declares, given ones as given.
Parameters part_of(const Parameters& all, std::vector<Parameter> part) {
    Parameters parameters(std::move(part));
    for (const Parameter& p : parameters.declared())
        if (all.is_given(p.name)) parameters.set(p.name, all.value(p.name));
    return parameters;
}

Grid declared_grid(const Parameters& p) {
    const double spacing = p.number("terrain.spacing_m");
    return {p.whole("terrain.nx"), p.whole("terrain.ny"), spacing, spacing};
}

TerrainState generated(const Parameters& p, const Grid& grid) {
    const double relief_m = p.number("terrain.relief_m");
    const std::vector<float> heights = generate_heights(
        grid, {p.choice("terrain.kind"), static_cast<std::uint32_t>(p.whole("terrain.seed")), relief_m});
    TerrainState state = bedrock_terrain(grid, heights);
    state.water = generate_water(grid, heights,
                                 {p.choice("terrain.water"), relief_m, p.number("water.sea_level_m"),
                                  p.number("water.wave_height_m"), p.number("water.gravity_m_per_s2")});
    return state;
}

SceneParameters split(const Parameters& all) {
    std::vector<Parameter> view = render::render_parameters();
    const std::vector<Parameter> app = app_parameters();
    view.insert(view.end(), app.begin(), app.end());
    return {part_of(all, simulation_parameters()), part_of(all, view)};
}

Scene assemble(const Parameters& all, io::Document document) {
    auto [simulation, view] = split(all);
    Scene scene{std::move(document), std::move(simulation), std::move(view)};
    scene.start.parameters = to_toml(scene.simulation);
    scene.view.suggest("render.level_m", scene.simulation.number("water.sea_level_m"));
    return scene;
}

// Throws talus::Error where a table of the file cannot be followed.
void check_tables(io::Document& document, const Parameters& parameters, const std::string& file) {
    for (Drive& drive : document.state.drives) try {
            check_drive(parameters, drive);
            drive.parameter = parameters.declaration(drive.parameter).name;
        } catch (const Error& error) {
            throw Error(fmt::format("'{}': {}", file, error.what()));
        }
}

// Throws talus::Error, by what they come from, where an event cannot be.
void checked_events(const std::string& source, const Scene& scene, std::vector<Event>& events) {
    try {
        check_events(scene.simulation, scene.document.state.grid, events);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", source, error.what()));
    }
}

// Tables of the document in whose place the request sets something.
std::vector<std::string> ended_tables(const TerrainState& state, const SceneRequest& request,
                                      const Parameters& before, const Parameters& now) {
    Parameters assigned(all_parameters());
    for (const std::string& assignment : request.assignments) assigned.set_assignment(assignment);
    std::vector<std::string> ended;
    for (const Drive& drive : state.drives)
        if (assigned.is_given(drive.parameter) || now.value(drive.parameter) != before.value(drive.parameter))
            ended.push_back(drive.parameter);
    return ended;
}

// Tables end, and other inflow or waves than the document's begin now.
void begin_anew(TerrainState& state, const Parameters& before, const Parameters& now,
                const std::vector<std::string>& ended) {
    const auto has_ended = [&](const std::string& name) {
        return std::find(ended.begin(), ended.end(), name) != ended.end();
    };
    std::erase_if(state.drives, [&](const Drive& drive) { return has_ended(drive.parameter); });
    for (const Parameter& p : now.declared())
        if (p.sets_off == SetsOff::edge_clock &&
            (now.value(p.name) != before.value(p.name) || has_ended(p.name)))
            state.edges_since_s = state.clock.simulated_s;
}

// What a project keeps besides its terrain. What of it cannot be read is left out, and a note says so: the
// terrain is what counts.
Workspace take_workspace(io::Document& document, Parameters& all) {
    Workspace workspace;
    if (document.workspace.empty()) return workspace;
    try {
        workspace = workspace_from(document.workspace);
    } catch (const Error& error) {
        document.notes.push_back(
            fmt::format("view, camera, gauges and sections are not as they were saved: {}", error.what()));
    }
    for (const std::string& assignment : workspace.parameters) try {
            all.set_assignment(assignment);
        } catch (const Error& error) {
            document.notes.push_back(fmt::format("the view is not as it was saved: {}", error.what()));
        }
    return workspace;
}

// What a document was made with.
Parameters parameters_of(const io::Document& document, const std::string& file) {
    Parameters all(all_parameters());
    from_toml(document.parameters, file, all);
    return all;
}

}  // namespace

SceneParameters make_scene_parameters(const SceneRequest& request) {
    Parameters all(all_parameters());
    for (const std::string& assignment : request.assignments) all.set_assignment(assignment);
    return split(all);
}

Scene make_scene(const SceneRequest& request) {
    Parameters all(all_parameters());
    // Someone's own ground starts from the plain defaults, unless a preset is asked for by name.
    const Preset preset = find_preset(request.preset.empty() ? "alpine" : request.preset);
    if (request.input.empty()) apply_preset(preset, all);
    io::Document document;
    Workspace workspace;
    if (!request.input.empty()) {
        document = io::open_document(request.input, request.import);
        // What a document was made with holds, unless a preset was asked for by name.
        if (!document.parameters.empty()) from_toml(document.parameters, request.input, all);
        workspace = take_workspace(document, all);
        // Rock stands steeper than its scree, so that the first play keeps peaks. Documents and presets say
        // what they have.
        constexpr double stands_at_deg = 60;
        if (document.kind != "Talus document" && request.preset.empty())
            all.set("thermal.bedrock_deg", stands_at_deg);
        if (!request.preset.empty()) apply_preset(preset, all);
    }
    if (request.size && !request.input.empty())
        throw Error(
            fmt::format("--size sets generated terrain, '{}' has a size of its own: leave one of the two out",
                        request.input));
    if (request.size) {
        all.set("terrain.nx", request.size->x);
        all.set("terrain.ny", request.size->y);
    }
    if (request.import.spacing_m) all.set("terrain.spacing_m", *request.import.spacing_m);
    for (const std::string& assignment : request.assignments) all.set_assignment(assignment);
    if (request.input.empty()) {
        document.state = generated(all, declared_grid(all));
        document.kind = "generated";
    }
    Scene scene = assemble(all, std::move(document));
    scene.workspace = std::move(workspace);
    check_tables(scene.document, scene.simulation, request.input);
    if (!scene.document.parameters.empty()) {
        TerrainState& state = scene.document.state;
        const Parameters before = parameters_of(scene.document, request.input);
        scene.start.ended_tables = ended_tables(state, request, before, scene.simulation);
        begin_anew(state, before, scene.simulation, scene.start.ended_tables);
    }
    std::vector<Event>& events = scene.document.state.events;
    if (request.input.empty() || !request.preset.empty()) {
        std::vector<Event> more = events_of(preset);
        checked_events("preset " + preset.name, scene, more);
        // Those that the document has from the same preset go on; what they set, the preset has set anew.
        checked_events("'" + request.input + "'", scene, events);
        for (const Event& event : more) {
            const auto there = std::find_if(events.begin(), events.end(), [&](const Event& one) {
                return one.at_s == event.at_s && one.assignment == event.assignment &&
                       one.breach == event.breach;
            });
            if (there == events.end())
                events.push_back(event);
            else if (!there->breach)
                there->done = false;
        }
    }
    checked_events("'" + request.input + "'", scene, events);
    scene.start.events = to_text(events);
    scene.draping = open_draping(request.texture, scene.document.state.georeference);
    scene.start.input = request.input.empty() ? "" : std::filesystem::absolute(request.input).string();
    scene.start.import_guess = to_text(request.import);
    scene.title =
        request.input.empty() ? preset.title : std::filesystem::path(request.input).filename().string();
    if (request.import.window) scene.title = "a part of " + scene.title;
    if (!request.title.empty()) scene.title = request.title;
    return scene;
}

Scene make_scene(const JournalFile& journal, const std::string& journal_path,
                 std::optional<glm::ivec2> size) {
    Parameters all(all_parameters());
    from_toml(journal.start.parameters, journal_path, all);
    io::Document document;
    if (journal.start.input.empty()) {
        document.state = generated(all, declared_grid(all));
        document.kind = "generated";
    } else {
        document =
            io::open_document(journal.start.input, io::import_settings_from(journal.start.import_guess));
        check_tables(document, all, journal.start.input);
        if (!document.parameters.empty())
            begin_anew(document.state, parameters_of(document, journal.start.input), all,
                       journal.start.ended_tables);
    }
    try {
        document.state.events = events_from_text(journal.start.events);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", journal_path, error.what()));
    }
    const std::uint64_t hash = state_hash(document.state);
    if (hash != journal.start.hash)
        throw Error(fmt::format(
            "{}: starts from a terrain with hash {:016x} where {} gives {:016x}, so it was made from another "
            "file "
            "or version",
            journal_path, journal.start.hash,
            journal.start.input.empty() ? "its generator" : "'" + journal.start.input + "'", hash));
    const Grid grid = document.state.grid;
    if (size && journal.start.input.empty()) {
        const Grid other{size->x, size->y, grid.width_m() / (size->x - 1), grid.height_m() / (size->y - 1)};
        check_grid(other);
        const std::vector<Event> events = document.state.events;
        document.state = generated(all, other);
        document.state.events = events;
    } else if (size) {
        document.state = resampled(document.state, size->x, size->y);
    }
    Scene scene = assemble(all, std::move(document));
    scene.start = journal.start;
    scene.recorded_samples = {grid.nx, grid.ny};
    scene.title = "replay";
    return scene;
}

}  // namespace talus::app
