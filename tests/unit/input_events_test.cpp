// Keys, letters and buttons between the window that hears them and the panels that look at them once a frame.
#include "app/window/input_events.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <string>

namespace talus::input_events_test {
namespace {

// What arrived, in its order: + a press, - a release, ! a shortcut, ( and ) the left button, letters as they
// are.
struct Heard {
    std::string text;
    app::InputEvents::To to{
        [this](const app::InputEvents::Key& key) { text += std::string("!") + static_cast<char>(key.key); },
        [this](const app::InputEvents::Key& key) {
            text += std::string(key.action == GLFW_RELEASE ? "-" : "+") + static_cast<char>(key.key);
        },
        [this](unsigned letter) { text += static_cast<char>(letter); },
        [this](const app::InputEvents::Button& button) { text += button.down ? '(' : ')'; }};
};

app::InputEvents::Key press(char key) {
    return {key, 0, GLFW_PRESS, 0};
}
app::InputEvents::Key release(char key) {
    return {key, 0, GLFW_RELEASE, 0};
}

TEST(InputEvents, AShortcutActsAtOnce) {
    Heard heard;
    app::InputEvents events;
    events.hear(press('A'), false, heard.to);
    EXPECT_EQ(heard.text, "!A");
    EXPECT_FALSE(events.pass(heard.to));
    EXPECT_EQ(heard.text, "!A+A");
}

TEST(InputEvents, WhereSomebodyTypesItComesBehindWhatWasTypedBefore) {
    Heard heard;
    app::InputEvents events;
    events.hear(press('X'), true, heard.to);
    events.hear_letter('x');
    // Typing has begun, whatever the panels say by now.
    events.hear(press('E'), false, heard.to);
    EXPECT_EQ(heard.text, "");
    events.pass(heard.to);
    EXPECT_EQ(heard.text, "!X+Xx!E+E");
}

TEST(InputEvents, AKeyThatIsPressedAndLetGoInOneFrameIsLetGoInTheNext) {
    Heard heard;
    app::InputEvents events;
    events.hear(press('S'), false, heard.to);
    events.hear_letter('s');
    events.hear(release('S'), false, heard.to);
    heard.text.clear();
    EXPECT_TRUE(events.pass(heard.to)) << "something waits";
    EXPECT_EQ(heard.text, "+Ss");
    EXPECT_FALSE(events.pass(heard.to));
    EXPECT_EQ(heard.text, "+Ss-S");
}

// A frame of a busy scene lasts long: a name of forty letters must not take forty of them.
TEST(InputEvents, AllTextOfAFramePassesInIt) {
    Heard heard;
    app::InputEvents events;
    for (const char letter : std::string("WALL")) {
        events.hear(press(letter), true, heard.to);
        events.hear_letter(static_cast<unsigned>(letter - 'A' + 'a'));
        events.hear(release(letter), true, heard.to);
    }
    events.pass(heard.to);
    EXPECT_EQ(heard.text, "!W+Ww!A+Aa!L+Ll!L+Ll");
    EXPECT_FALSE(events.pass(heard.to));
    EXPECT_EQ(heard.text, "!W+Ww!A+Aa!L+Ll!L+Ll-W-A-L-L");
}

// Panels that get Backspace and letters in one frame cannot know which came first.
TEST(InputEvents, OtherKeysThanThoseOfLettersHaveTheirOwnFrames) {
    Heard heard;
    app::InputEvents events;
    const auto other = [](int action) { return app::InputEvents::Key{GLFW_KEY_BACKSPACE, 0, action, 0}; };
    const std::string key(1, static_cast<char>(GLFW_KEY_BACKSPACE));
    events.hear(press('A'), true, heard.to);
    events.hear_letter('a');
    events.hear(other(GLFW_PRESS), true, heard.to);
    events.hear(other(GLFW_RELEASE), true, heard.to);
    events.hear_letter('b');
    std::string expected = "!A+Aa";
    events.pass(heard.to);
    EXPECT_EQ(heard.text, expected);
    expected += "!" + key + "+" + key;
    events.pass(heard.to);
    EXPECT_EQ(heard.text, expected);
    expected += "-" + key + "b";
    EXPECT_FALSE(events.pass(heard.to));
    EXPECT_EQ(heard.text, expected);
}

// Ctrl+A by a quick hand: select everything, and not the letter alone.
TEST(InputEvents, AModifierIsHeldUntilItsKeyWasSeen) {
    Heard heard;
    app::InputEvents events;
    const std::string ctrl(1, static_cast<char>(GLFW_KEY_LEFT_CONTROL));
    events.hear({GLFW_KEY_LEFT_CONTROL, 0, GLFW_PRESS, 0}, false, heard.to);
    heard.text.clear();
    events.pass(heard.to);
    events.hear({'A', 0, GLFW_PRESS, GLFW_MOD_CONTROL}, true, heard.to);
    events.hear({GLFW_KEY_LEFT_CONTROL, 0, GLFW_RELEASE, GLFW_MOD_CONTROL}, true, heard.to);
    events.pass(heard.to);
    EXPECT_EQ(heard.text, "+" + ctrl + "!A+A");
    events.pass(heard.to);
    EXPECT_EQ(heard.text, "+" + ctrl + "!A+A-" + ctrl);
}

// Twice Backspace within a long frame takes two letters away.
TEST(InputEvents, WhatIsPressedTwiceIsSeenTwice) {
    Heard heard;
    app::InputEvents events;
    const auto backspace = [](int action) { return app::InputEvents::Key{GLFW_KEY_BACKSPACE, 0, action, 0}; };
    for (int i = 0; i < 2; ++i) {
        events.hear(backspace(GLFW_PRESS), false, heard.to);
        events.hear(backspace(GLFW_RELEASE), false, heard.to);
    }
    for (int i = 0; i < 2; ++i) {
        events.hear_button({GLFW_MOUSE_BUTTON_LEFT, true, {}});
        events.hear_button({GLFW_MOUSE_BUTTON_LEFT, false, {}});
    }
    heard.text.clear();
    std::vector<std::string> frames;
    for (bool waits = true; waits;) {
        heard.text.clear();
        waits = events.pass(heard.to);
        frames.push_back(heard.text);
    }
    const std::string key(1, static_cast<char>(GLFW_KEY_BACKSPACE));
    EXPECT_EQ(frames,
              (std::vector<std::string>{"+" + key, "-" + key, "+" + key, "-" + key + "(", ")", "(", ")"}));
}

// The digits beside the arrows are text like any other.
TEST(InputEvents, DigitsOfTheKeypadPassAsText) {
    Heard heard;
    app::InputEvents events;
    for (const int digit : {1, 2, 3}) {
        events.hear({GLFW_KEY_KP_0 + digit, 0, GLFW_PRESS, 0}, false, heard.to);
        events.hear_letter(static_cast<unsigned>('0' + digit));
        events.hear({GLFW_KEY_KP_0 + digit, 0, GLFW_RELEASE, 0}, false, heard.to);
    }
    int letters = 0;
    heard.to.letter = [&](unsigned) { ++letters; };
    events.pass(heard.to);
    EXPECT_EQ(letters, 3);
}

// Left and then Shift for a capital: not Shift+Left, which would select.
TEST(InputEvents, AModifierBelongsToTheKeyBehindIt) {
    Heard heard;
    app::InputEvents events;
    const std::string left(1, static_cast<char>(GLFW_KEY_LEFT));
    const std::string shift(1, static_cast<char>(GLFW_KEY_LEFT_SHIFT));
    events.hear({GLFW_KEY_LEFT, 0, GLFW_PRESS, 0}, false, heard.to);
    events.hear({GLFW_KEY_LEFT_SHIFT, 0, GLFW_PRESS, GLFW_MOD_SHIFT}, false, heard.to);
    events.hear({'A', 0, GLFW_PRESS, GLFW_MOD_SHIFT}, false, heard.to);
    events.hear_letter('A');
    heard.text.clear();
    events.pass(heard.to);
    EXPECT_EQ(heard.text, "+" + left);
    events.pass(heard.to);
    EXPECT_EQ(heard.text, "+" + left + "+" + shift + "+AA");
}

// Ctrl+C and V before C is up: panels do one of two in a frame.
TEST(InputEvents, TwoOtherKeysTakeTwoFrames) {
    Heard heard;
    app::InputEvents events;
    events.hear({'C', 0, GLFW_PRESS, GLFW_MOD_CONTROL}, false, heard.to);
    events.hear({'V', 0, GLFW_PRESS, GLFW_MOD_CONTROL}, false, heard.to);
    heard.text.clear();
    EXPECT_TRUE(events.pass(heard.to));
    EXPECT_EQ(heard.text, "+C");
    EXPECT_FALSE(events.pass(heard.to));
    EXPECT_EQ(heard.text, "+C+V");
}

// Who clicks into a field and types at once does not press shortcuts: whether it was a field is known a frame
// later.
TEST(InputEvents, AShortcutWaitsUntilItIsKnownWhatWasClicked) {
    Heard heard;
    app::InputEvents events;
    events.hear_button({GLFW_MOUSE_BUTTON_LEFT, true, {}});
    events.hear(press('P'), false, heard.to);
    EXPECT_EQ(heard.text, "");
    events.pass(heard.to);
    events.hear(release('P'), false, heard.to);
    events.hear(press('Q'), false, heard.to);
    EXPECT_EQ(heard.text, "(");
    events.pass(heard.to);
    EXPECT_EQ(heard.text, "(") << "panels have not yet drawn the field";
    events.pass(heard.to);
    EXPECT_EQ(heard.text, "(!P+P!Q+Q");
}

// Who types a name and clicks on Write gets the whole name.
TEST(InputEvents, AClickComesBehindWhatWasTypedBefore) {
    Heard heard;
    app::InputEvents events;
    events.hear_letter('a');
    events.hear({GLFW_KEY_ENTER, 0, GLFW_PRESS, 0}, false, heard.to);
    events.hear_button({GLFW_MOUSE_BUTTON_LEFT, true, {}});
    events.hear_button({GLFW_MOUSE_BUTTON_LEFT, false, {}});
    events.hear_letter('b');
    heard.text.clear();
    const std::string enter(1, static_cast<char>(GLFW_KEY_ENTER));
    for (const std::string& expected :
         {std::string("a"), "a+" + enter, "a+" + enter + "(", "a+" + enter + "()", "a+" + enter + "()b"}) {
        events.pass(heard.to);
        EXPECT_EQ(heard.text, expected);
    }
    EXPECT_FALSE(events.pass(heard.to));
}

}  // namespace
}  // namespace talus::input_events_test
