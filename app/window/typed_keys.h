#pragma once
#include <functional>
#include <vector>

namespace talus::app {

/// Keys and letters between the window that hears them and the panels, which look at them once a frame
/// (GLFW's numbers).
class TypedKeys {
  public:
    struct Key {
        int key = 0;
        int code = 0;
        int action = 0;
        int mods = 0;
    };
    /// Where they go: the shortcuts, and the panels.
    struct To {
        std::function<void(const Key&)> shortcut;
        std::function<void(const Key&)> key;
        std::function<void(unsigned)> letter;
    };

    /// A shortcut acts at once; while somebody types it comes after what was typed before it, as Enter and
    /// Escape must.
    void hear(const Key& key, bool typing, const To& to);
    void hear_letter(unsigned letter) { heard_.push_back({{}, letter, false}); }
    /// Passes on the events since the last frame. A release after a press waits for the next frame, with all
    /// later events: otherwise panels would never see the key down. Returns whether any event waits.
    bool pass(const To& to);

  private:
    struct Heard {
        Key key;
        unsigned letter;  // 0: it is a key
        bool waits;       // its shortcut was not looked at yet
    };
    std::vector<Heard> heard_;
};

}  // namespace talus::app
