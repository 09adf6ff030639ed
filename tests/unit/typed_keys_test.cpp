// Keys between the window that hears them and the panels that look at them once a frame.
#include "app/window/typed_keys.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <string>

namespace talus::typed_keys_test {
namespace {

// What arrived, in its order: + a press, - a release, ! a shortcut, letters as they are.
struct Heard {
    std::string text;
    app::TypedKeys::To to{
        [this](const app::TypedKeys::Key& key) { text += std::string("!") + static_cast<char>(key.key); },
        [this](const app::TypedKeys::Key& key) {
            text += std::string(key.action == GLFW_RELEASE ? "-" : "+") + static_cast<char>(key.key);
        },
        [this](unsigned letter) { text += static_cast<char>(letter); }};
};

app::TypedKeys::Key press(char key) {
    return {key, 0, GLFW_PRESS, 0};
}
app::TypedKeys::Key release(char key) {
    return {key, 0, GLFW_RELEASE, 0};
}

TEST(TypedKeys, AShortcutActsAtOnce) {
    Heard heard;
    app::TypedKeys keys;
    keys.hear(press('A'), false, heard.to);
    EXPECT_EQ(heard.text, "!A");
    EXPECT_FALSE(keys.pass(heard.to));
    EXPECT_EQ(heard.text, "!A+A");
}

TEST(TypedKeys, WhereSomebodyTypesItComesBehindWhatWasTypedBefore) {
    Heard heard;
    app::TypedKeys keys;
    keys.hear(press('X'), true, heard.to);
    keys.hear_letter('x');
    // Typing has begun, whatever the panels say by now.
    keys.hear(press('E'), false, heard.to);
    EXPECT_EQ(heard.text, "");
    keys.pass(heard.to);
    EXPECT_EQ(heard.text, "!X+Xx!E+E");
}

TEST(TypedKeys, AKeyThatIsPressedAndLetGoInOneFrameIsLetGoInTheNext) {
    Heard heard;
    app::TypedKeys keys;
    keys.hear(press('S'), false, heard.to);
    keys.hear(release('S'), false, heard.to);
    keys.hear_letter('s');
    heard.text.clear();
    EXPECT_TRUE(keys.pass(heard.to)) << "something waits";
    EXPECT_EQ(heard.text, "+S");
    EXPECT_FALSE(keys.pass(heard.to));
    EXPECT_EQ(heard.text, "+S-Ss");
}

}  // namespace
}  // namespace talus::typed_keys_test
