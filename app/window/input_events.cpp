#include "app/window/input_events.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

namespace talus::app {
namespace {

bool is_shift(int key) {
    return key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT;
}

bool is_modifier(int key) {
    return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}

// Whether a key only makes letters: panels read the letters, and not the key.
bool makes_letters(const InputEvents::Key& key) {
    if ((key.mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0) return false;
    const bool keypad =
        key.key >= GLFW_KEY_KP_0 && key.key <= GLFW_KEY_KP_EQUAL && key.key != GLFW_KEY_KP_ENTER;
    return (key.key >= GLFW_KEY_SPACE && key.key <= GLFW_KEY_WORLD_2) || keypad ||
           key.key == GLFW_KEY_UNKNOWN;
}

bool contains(const std::vector<int>& keys, int key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

// What panels have got in this frame.
struct Passed {
    bool letters = false;
    bool button = false;     // was pressed
    bool other_key = false;  // that makes no letters, nor is a modifier
    std::vector<int> pressed = {};
    std::vector<int> released = {};
    std::vector<int> released_buttons = {};

    // Whether a key can be pressed in the same frame.
    bool leaves_room_for(const InputEvents::Key& key) const {
        if (button || other_key || contains(released, key.key)) return false;
        return !letters || makes_letters(key) || is_shift(key.key);
    }
    bool leaves_room_for(const InputEvents::Button& one) const {
        return !letters && !button && !other_key && !contains(released_buttons, one.button);
    }
};

}  // namespace

void InputEvents::hear(const Key& key, bool typing, const To& to) {
    typing = typing || clicked_ || std::any_of(heard_.begin(), heard_.end(), [](const Heard& one) {
                 return one.waits || (one.kind == Kind::button && one.button.down);
             });
    const bool presses = key.action != GLFW_RELEASE;
    if (presses && !typing) to.shortcut(key);
    Heard heard;
    heard.key = key;
    heard.waits = presses && typing;
    heard_.push_back(heard);
}

void InputEvents::hear_letter(unsigned letter) {
    Heard heard;
    heard.kind = Kind::letter;
    heard.letter = letter;
    heard_.push_back(heard);
}

void InputEvents::hear_button(const Button& button) {
    Heard heard;
    heard.kind = Kind::button;
    heard.button = button;
    heard_.push_back(heard);
}

bool InputEvents::pass(const To& to) {
    Passed passed;
    // Only the frame after a click tells whether the click was into a field.
    const bool settles = std::exchange(clicked_, false);
    std::vector<Heard> waiting;  // releases of letters' keys: the text behind them need not wait
    auto next = heard_.begin();
    for (; next != heard_.end(); ++next) {
        const Key& key = next->key;
        if (next->kind == Kind::letter) {
            if (settles || passed.button || passed.other_key) break;
            passed.letters = true;
            to.letter(next->letter);
        } else if (next->kind == Kind::button) {
            const Button& button = next->button;
            if (button.down ? !passed.leaves_room_for(button) : passed.button) break;
            clicked_ = clicked_ || button.down;
            passed.button = passed.button || button.down;
            if (!button.down) passed.released_buttons.push_back(button.button);
            to.button(button);
        } else if (key.action == GLFW_RELEASE) {
            // Not Ctrl before panels saw the key that it was held for, either.
            if (passed.button || passed.other_key) break;
            if (contains(passed.pressed, key.key)) {
                if (!makes_letters(key) && !is_shift(key.key)) break;
                waiting.push_back(*next);
                continue;
            }
            passed.released.push_back(key.key);
            to.key(key);
        } else {
            // Panels repeat keys that are held by their own clock.
            const bool repeats = key.action == GLFW_REPEAT;
            if (settles || (!repeats && !passed.leaves_room_for(key))) break;
            if (!repeats) passed.pressed.push_back(key.key);
            passed.other_key = passed.other_key || (!repeats && !makes_letters(key) && !is_modifier(key.key));
            if (next->waits) to.shortcut(key);
            to.key(key);
        }
    }
    waiting.insert(waiting.end(), next, heard_.end());
    heard_ = std::move(waiting);
    return !heard_.empty();
}

}  // namespace talus::app
