#include "app/window/input_events.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace talus::app {
namespace {

// Whether a key only makes letters: panels read the letters, and not the key.
bool makes_letters(const InputEvents::Key& key) {
    if (key.key == GLFW_KEY_LEFT_SHIFT || key.key == GLFW_KEY_RIGHT_SHIFT) return true;
    return key.key >= GLFW_KEY_SPACE && key.key <= GLFW_KEY_WORLD_2 &&
           (key.mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) == 0;
}

// What panels have got in this frame.
struct Passed {
    bool letters = false;
    bool button = false;
    bool other_key = false;
    std::vector<int> letter_keys;
};

}  // namespace

void InputEvents::hear(const Key& key, bool typing, const To& to) {
    typing = typing || std::any_of(heard_.begin(), heard_.end(), [](const Heard& one) { return one.waits; });
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
    std::vector<Heard> waiting;  // releases of letters' keys: the text behind them need not wait
    auto next = heard_.begin();
    for (; next != heard_.end(); ++next) {
        if (next->kind == Kind::letter) {
            if (passed.button || passed.other_key) break;
            passed.letters = true;
            to.letter(next->letter);
        } else if (next->kind == Kind::button) {
            if (passed.button || (next->button.down && (passed.letters || passed.other_key))) break;
            passed.button = passed.button || next->button.down;
            to.button(next->button);
        } else if (next->key.action == GLFW_RELEASE) {
            // Not Ctrl before panels saw the key that it was held for, either.
            if (passed.button || passed.other_key) break;
            if (std::find(passed.letter_keys.begin(), passed.letter_keys.end(), next->key.key) !=
                passed.letter_keys.end())
                waiting.push_back(*next);
            else
                to.key(next->key);
        } else {
            const bool other = !makes_letters(next->key);
            if (passed.button || (other && passed.letters)) break;
            if (other)
                passed.other_key = true;
            else
                passed.letter_keys.push_back(next->key.key);
            if (next->waits) to.shortcut(next->key);
            to.key(next->key);
        }
    }
    waiting.insert(waiting.end(), next, heard_.end());
    heard_ = std::move(waiting);
    return !heard_.empty();
}

}  // namespace talus::app
