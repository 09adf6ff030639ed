// OpenGL values: errors are exceptions, shaders reload while running.
#include <gtest/gtest.h>

#include <unistd.h>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/gpu/embedded_text.h"
#include "sim/gpu/program.h"
#include "sim/gpu/shader_text.h"
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

// What shaders use is bound by name before each run; anything else would be what another program left.
TEST(Program, RefusesToRunWithoutWhatItsShadersUse) {
    const Context context;
    const fs::path folder = fs::temp_directory_path() / ("talus_bound_" + std::to_string(::getpid()));
    write(folder / "maths/value.glsl", "");
    write(folder / "add.comp",
          "layout(local_size_x = 1) in;\nlayout(r32f) uniform readonly image2D from;\n"
          "uniform sampler2D besides;\nlayout(std430) buffer Sum { float sum[]; };\n"
          "void main() { sum[0] += imageLoad(from, ivec2(0)).x + texelFetch(besides, ivec2(0), 0).x; }\n");
    use_shader_folder(folder);
    struct BuiltInAfterwards {
        ~BuiltInAfterwards() { use_built_in_shaders(); }
    } const afterwards;
    Texture two("two", Format::r32f, 1, 1);
    Texture five("five", Format::r32f, 1, 1);
    two.fill(2);
    five.fill(5);
    Buffer sum("sum", sizeof(float));
    sum.fill(0);
    Program first("add.comp");
    Program second("add.comp");
    const auto bind = [&](Program& program, bool image, bool sampler, bool storage) {
        if (image) program.bind_image("from", two);
        if (sampler) program.bind_sampled("besides", five);
        if (storage) program.bind_storage("Sum", sum);
        program.bind_image("nothing of this name", two);
    };
    const auto refusal = [&](Program& program) -> std::string {
        try {
            program.dispatch(1);
            barrier({Use::storage, Use::buffer_transfer});
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    bind(first, false, true, true);
    EXPECT_EQ(refusal(first), "shaders/add.comp is run without its image 'from'");
    bind(first, true, false, true);
    EXPECT_EQ(refusal(first), "");  // the texture is still bound: the run before did not happen
    bind(first, true, false, true);
    EXPECT_EQ(refusal(first), "shaders/add.comp is run without its texture 'besides'");
    bind(second, true, true, false);
    EXPECT_EQ(refusal(second), "shaders/add.comp is run without its buffer 'Sum'");
    // Another program binds in between.
    bind(first, true, true, true);
    bind(second, true, true, true);
    EXPECT_NE(refusal(first), "");
    EXPECT_EQ(refusal(second), "");
    EXPECT_EQ(sum.read_all<float>()[0], 14.0F);
    fs::remove_all(folder);
}

TEST(Program, FollowsItsFolderAndKeepsTheOldOneWhenTheNewDoesNotCompile) {
    const Context context;
    const fs::path folder = fs::temp_directory_path() / ("talus_shaders_" + std::to_string(::getpid()));
    write(folder / "maths/value.glsl", "float value() { return 1.0; }\n");
    const char* body =
        "layout(local_size_x = 1) in;\n#include \"maths/value.glsl\"\nlayout(r32f) uniform "
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
        program.bind_image("target", target);
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
