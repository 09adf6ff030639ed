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

// What panels have got in a frame, and so whose turn it is.
class InputFrame {
  public:
    enum class Turn {
        now,
        later,    // in the next frame, and what is behind it need not wait for that
        not_yet,  // in the next frame, with all that is behind it
    };

    // after_click: panels tell only now whether the click was into a field.
    explicit InputFrame(bool after_click) : after_click_(after_click) {}

    bool clicked() const { return clicked_; }

    Turn turn_of(unsigned) {
        if (after_click_ || clicked_ || other_key_) return Turn::not_yet;
        letters_ = true;
        return Turn::now;
    }
    Turn turn_of(const InputEvents::Button& button) {
        if (clicked_) return Turn::not_yet;
        if (!button.down) {
            released_buttons_.push_back(button.button);
            return Turn::now;
        }
        if (letters_ || other_key_ || contains(released_buttons_, button.button)) return Turn::not_yet;
        clicked_ = true;
        return Turn::now;
    }
    Turn turn_of(const InputEvents::Key& key) {
        // Panels repeat keys that are held by their own clock.
        if (key.action == GLFW_REPEAT) return after_click_ ? Turn::not_yet : Turn::now;
        return key.action == GLFW_RELEASE ? turn_of_release(key) : turn_of_press(key);
    }

  private:
    Turn turn_of_release(const InputEvents::Key& key) {
        // Not Ctrl before panels saw the key that it was held for, either.
        if (clicked_ || other_key_) return Turn::not_yet;
        if (contains(pressed_, key.key))
            return makes_letters(key) || is_shift(key.key) ? Turn::later : Turn::not_yet;
        released_.push_back(key.key);
        return Turn::now;
    }
    Turn turn_of_press(const InputEvents::Key& key) {
        const bool text = makes_letters(key) || is_shift(key.key);
        if (after_click_ || clicked_ || other_key_ || (letters_ && !text) || contains(released_, key.key))
            return Turn::not_yet;
        pressed_.push_back(key.key);
        other_key_ = !text && !is_modifier(key.key);
        return Turn::now;
    }

    bool after_click_;
    bool letters_ = false;
    bool clicked_ = false;
    bool other_key_ = false;  // was pressed: one that makes no letters and is no modifier
    std::vector<int> pressed_;
    std::vector<int> released_;
    std::vector<int> released_buttons_;
};

}  // namespace

void InputEvents::hear(const Key& key, bool typing, const To& to) {
    const bool presses = key.action != GLFW_RELEASE;
    const bool waits = typing || clicked_ || std::any_of(heard_.begin(), heard_.end(), [](const Heard& one) {
                           const auto* button = std::get_if<Button>(&one.event);
                           return one.shortcut_waits || (button && button->down);
                       });
    if (presses && !waits) to.shortcut(key);
    heard_.push_back({key, presses && waits});
}

bool InputEvents::pass(const To& to) {
    InputFrame frame(clicked_);
    std::vector<Heard> waiting;
    auto next = heard_.begin();
    for (; next != heard_.end(); ++next) {
        const InputFrame::Turn turn =
            std::visit([&](const auto& event) { return frame.turn_of(event); }, next->event);
        if (turn == InputFrame::Turn::not_yet) break;
        if (turn == InputFrame::Turn::later) {
            waiting.push_back(*next);
        } else if (const auto* key = std::get_if<Key>(&next->event)) {
            if (next->shortcut_waits) to.shortcut(*key);
            to.key(*key);
        } else if (const auto* button = std::get_if<Button>(&next->event)) {
            to.button(*button);
        } else {
            to.letter(std::get<unsigned>(next->event));
        }
    }
    clicked_ = frame.clicked();
    waiting.insert(waiting.end(), next, heard_.end());
    heard_ = std::move(waiting);
    return !heard_.empty();
}

}  // namespace talus::app
