#include "app/panels/panels.h"

namespace talus::app {

bool is_from_top(const Session& session) {
    return session.view().choice("camera.mode") == "top";
}

void toggle_top_view(Session& session, PanelState& state) {
    if (is_from_top(session)) {
        session.set("camera.mode", state.mode_before_top);
        return;
    }
    state.mode_before_top = session.view().choice("camera.mode");
    session.set("camera.mode", std::string("top"));
}

}  // namespace talus::app
