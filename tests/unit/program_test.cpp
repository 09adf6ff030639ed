// OpenGL values: errors are exceptions, shaders reload while running.
#include <gtest/gtest.h>

#include <unistd.h>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "sim/gpu/context.h"
#include "sim/gpu/embedded_text.h"
#include "sim/gpu/error.h"
#include "sim/gpu/program.h"
#include "sim/gpu/texture.h"

namespace talus::gpu {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, std::string_view text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

// File times may be coarse: each change gets a later one.
void touch_later(const fs::path& path) {
    static int steps = 0;
    fs::last_write_time(path, fs::file_time_type::clock::now() + std::chrono::seconds(++steps));
}

TEST(Debug, ErrorsAreExceptions) {
    const Context context;
    EXPECT_THROW(Texture("impossible", Format::r32f, -5, 4), Error);
    EXPECT_NO_THROW(Texture("possible", Format::r32f, 5, 4));
}

TEST(Context, RefusesADeviceThatIsNotThere) {
    EXPECT_THROW(Context(ContextChoice{99, false}), Error);
}

TEST(Program, FollowsItsFolderAndKeepsTheOldOneWhenTheNewDoesNotCompile) {
    const Context context;
    const fs::path folder = fs::temp_directory_path() / ("talus_shaders_" + std::to_string(::getpid()));
    write(folder / "maths/value.glsl", "float value() { return 1.0; }\n");
    const char* body =
        "layout(local_size_x = 1) in;\n#include \"maths/value.glsl\"\nlayout(binding = 0, r32f) uniform "
        "writeonly image2D target;\n"
        "void main() { imageStore(target, ivec2(0), vec4(value())); }\n";
    write(folder / "sim/store.comp", body);
    use_shader_folder(folder);
    std::string message;
    on_shader_message([&](const std::string& text) { message = text; });
    struct BuiltInAfterwards {
        ~BuiltInAfterwards() { use_built_in_shaders(); }
    } const afterwards;
    const Texture target("target", Format::r32f, 1, 1);
    Program program("sim/store.comp");
    const auto run = [&] {
        target.bind_image(0, Access::write);
        program.dispatch(1);
        barrier({Use::texture_transfer, Use::image});
        return target.read_all<float>()[0];
    };
    EXPECT_EQ(run(), 1.0F);
    write(folder / "maths/value.glsl", "float value() { return 2.0; }\n");
    touch_later(folder / "maths/value.glsl");
    EXPECT_TRUE(poll_shader_folder());
    EXPECT_EQ(run(), 2.0F);
    write(folder / "maths/value.glsl", "float helper() { return 1.0; }\nfloat value() { return broken; }\n");
    touch_later(folder / "maths/value.glsl");
    EXPECT_TRUE(poll_shader_folder());
    EXPECT_EQ(run(), 2.0F) << "the old program goes on";
    EXPECT_NE(message.find("shaders/maths/value.glsl:2"), std::string::npos) << message;
    EXPECT_FALSE(poll_shader_folder());
    write(folder / "maths/value.glsl", "float value() { return 3.0; }\n");
    touch_later(folder / "maths/value.glsl");
    EXPECT_TRUE(poll_shader_folder());
    EXPECT_EQ(run(), 3.0F);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace talus::gpu
