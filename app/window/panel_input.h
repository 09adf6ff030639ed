#pragma once
#include <array>
#include <functional>

#include "app/window/input_events.h"

struct GLFWwindow;

namespace talus::app {

/// What a window hears of keyboard and mouse buttons, passed on to ImGui in the order that it came in.
class PanelInput {
  public:
    /// `shortcut` is called with each key that is pressed, see InputEvents::hear.
    PanelInput(GLFWwindow* window, std::function<void(const InputEvents::Key&)> shortcut);

    PanelInput(const PanelInput&) = delete;
    PanelInput& operator=(const PanelInput&) = delete;

    void hear_key(const InputEvents::Key& key, bool typing) { events_.hear(key, typing, to_); }
    void hear_letter(unsigned letter) { events_.hear_letter(letter); }
    void hear_button(int button, int action);
    /// Between ImGui's backend's new frame and ImGui's own. Returns whether any event waits for the next one.
    bool pass();
    /// Whether panels have yet to see events that were heard: until then nobody knows whose a click is.
    bool waits() const { return waits_; }

  private:
    GLFWwindow* window_;
    InputEvents::To to_;
    InputEvents events_;
    bool waits_ = false;
    std::array<bool, 5> down_{};  // buttons, as panels know them
};

}  // namespace talus::app
