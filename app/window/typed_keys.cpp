#include "app/window/typed_keys.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace talus::app {

void TypedKeys::hear(const Key& key, bool typing, const To& to) {
    typing = typing || std::any_of(heard_.begin(), heard_.end(), [](const Heard& one) { return one.waits; });
    const bool presses = key.action != GLFW_RELEASE;
    if (presses && !typing) to.shortcut(key);
    heard_.push_back({key, 0, presses && typing});
}

bool TypedKeys::pass(const To& to) {
    bool pressed = false;
    std::size_t passed = 0;
    for (const Heard& heard : heard_) {
        if (heard.letter != 0) {
            to.letter(heard.letter);
        } else {
            if (pressed && heard.key.action == GLFW_RELEASE) break;
            pressed = pressed || heard.key.action == GLFW_PRESS;
            if (heard.waits) to.shortcut(heard.key);
            to.key(heard.key);
        }
        ++passed;
    }
    heard_.erase(heard_.begin(), heard_.begin() + static_cast<std::ptrdiff_t>(passed));
    return !heard_.empty();
}

}  // namespace talus::app
