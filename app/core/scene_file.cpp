#include "app/core/scene_file.h"

#include <fmt/format.h>

#include <utility>

#include "app/core/app_parameters.h"
#include "app/core/session.h"
#include "sim/error.h"
#include "sim/events.h"
#include "sim/preset.h"

namespace talus::app {

bool is_scene(const std::string& path) {
    return is_preset_file(path);
}

bool can_be_scene(const Session& session) {
    return session.scene().document.kind == "generated" && session.simulation().stands_on_its_first_terrain();
}

std::string scene_text(const std::string& title, const Session& session) {
    if (!can_be_scene(session))
        throw Error(
            "a scene generates its terrain, and this one came from a file or was reshaped: save it as a "
            "document");
    // One table, for a section stands once in it, whoever its parameters belong to.
    Parameters all(all_parameters());
    for (const Parameters* some : {&session.simulation().parameters(), &session.view()})
        for (const Parameter& one : some->declared())
            if (some->is_given(one.name) && !one.of_machine) all.set(one.name, some->value(one.name));
    // The scene begins before its events, and before tables moved anything.
    const JournalStart& start = session.scene().start;
    std::vector<Event> events = session.simulation().events();
    Parameters begun(all_parameters());
    from_toml(start.parameters, "the start of the scene", begun);
    const auto as_begun = [&](const std::string& name) {
        if (begun.is_given(name))
            all.set(name, begun.value(name));
        else
            all.reset(name);
    };
    for (Event& event : events)
        if (std::exchange(event.done, false) && !event.breach) as_begun(parameter_of(event));
    for (const Drive& drive : session.simulation().drives()) as_begun(drive.parameter);
    return preset_text(title, to_toml(all), events);
}

}  // namespace talus::app
