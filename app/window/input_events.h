#pragma once
#include <glm/vec2.hpp>

#include <functional>
#include <variant>
#include <vector>

namespace talus::app {

/// Keys, letters and mouse buttons in their order, between the window that hears them and the panels, which
/// look at them once a frame (GLFW's numbers).
class InputEvents {
  public:
    struct Key {
        int key = 0;
        int code = 0;
        int action = 0;
        int mods = 0;
    };
    struct Button {
        int button = 0;
        bool down = false;
        glm::dvec2 at{0};  ///< of the cursor then, in the window's coordinates
    };
    /// Where they go: the shortcuts, and the panels.
    struct To {
        std::function<void(const Key&)> shortcut;
        std::function<void(const Key&)> key;
        std::function<void(unsigned)> letter;
        std::function<void(const Button&)> button;
    };

    /// A shortcut acts at once. While somebody types, and after a click that may be into a field, it comes
    /// after what was heard before it, as Enter and Escape must.
    void hear(const Key& key, bool typing, const To& to);
    void hear_letter(unsigned letter) { heard_.push_back({letter}); }
    void hear_button(const Button& button) { heard_.push_back({button}); }
    /// Passes on the events since the last frame, as many as panels can tell apart in one: either text of any
    /// length, or one other key with its modifiers, or one press of a button. What is pressed and let go is
    /// let go in the next frame, and pressed again in the one after that: otherwise panels would not see it.
    /// Returns whether any event waits.
    bool pass(const To& to);

  private:
    struct Heard {
        std::variant<Key, unsigned, Button> event;  // a number: a letter
        bool shortcut_waits = false;
    };
    std::vector<Heard> heard_;
    bool clicked_ = false;  // in the frame before
};

}  // namespace talus::app
