// OpenGL values: errors are exceptions, shaders reload while running.
#include <gtest/gtest.h>

#include <unistd.h>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <tuple>

#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/gpu/embedded_text.h"
#include "sim/gpu/program.h"
#include "sim/gpu/shader_text.h"
#include "sim/gpu/texture.h"
#include "sim/passes/dab_numbers.h"
#include "sim/passes/sediment_step.h"
#include "sim/passes/thermal_step.h"
#include "sim/passes/water_numbers.h"

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

// Shaders of a folder are for one test.
struct BuiltInAfterwards {
    ~BuiltInAfterwards() { use_built_in_shaders(); }
};

TEST(Debug, ErrorsAreExceptions) {
    const Context context;
    EXPECT_THROW(Texture("impossible", Format::r32f, -5, 4), Error);
    EXPECT_NO_THROW(Texture("possible", Format::r32f, 5, 4));
}

TEST(Context, RefusesADeviceThatIsNotThere) {
    EXPECT_THROW(Context(ContextChoice{99, false}), Error);
}

// A line of a block: its type and name, and where C++ has it, bytes.
struct Number {
    std::string type;
    std::string name;
    std::size_t offset;
};

std::vector<Number> dab_lines() {
    std::vector<Number> lines;
#define NUMBER(type, name) lines.push_back({#type, #name, offsetof(DabNumbers, name)});
#include "maths/dab_numbers.glsl"
#undef NUMBER
    return lines;
}
std::vector<Number> thermal_lines() {
    std::vector<Number> lines;
#define NUMBER(type, name) lines.push_back({#type, #name, offsetof(ThermalNumbers, name)});
#include "maths/thermal_numbers.glsl"
#undef NUMBER
    return lines;
}
std::vector<Number> sediment_lines() {
    std::vector<Number> lines;
#define NUMBER(type, name) lines.push_back({#type, #name, offsetof(SedimentNumbers, name)});
#include "maths/sediment_numbers.glsl"
#undef NUMBER
    return lines;
}
std::vector<Number> water_lines() {
    std::vector<Number> lines;
#define NUMBER(type, name) lines.push_back({#type, #name, offsetof(WaterNumbers, name)});
#include "maths/water_numbers.glsl"
#undef NUMBER
    return lines;
}

// A shader that writes the words of all numbers, in their order.
std::string copying_shader(const std::string& file, const std::vector<Number>& lines) {
    std::string body;
    int words = 0;
    for (const Number& line : lines) {
        const bool pair = line.type.ends_with("2");
        for (const char* part : {".x", ".y"}) {
            if (!pair && part[1] == 'y') continue;
            const std::string value = line.name + (pair ? part : "");
            const bool whole = line.type.find("int") != std::string::npos;
            body += "    words[" + std::to_string(words++) + "] = " + (whole ? "uint(" : "floatBitsToUint(") +
                    value + ");\n";
        }
    }
    return "layout(local_size_x = 1) in;\n#include \"maths/glsl_types.glsl\"\n"
           "layout(std140) uniform Numbers {\n#include \"maths/" +
           file +
           "\"\n};\n"
           "layout(std430) buffer Words { uint words[64]; };\nvoid main() {\n" +
           body + "}\n";
}

// Every number of every block lies where C++ has it (std140).
TEST(Program, ReadsUniformBlocksWhereTheStructsHaveThem) {
    const Context context;
    const fs::path folder = fs::temp_directory_path() / ("talus_blocks_" + std::to_string(::getpid()));
    const auto copy = [&](const std::string& name) { write(folder / name, embedded_shaders().at(name)); };
    copy("maths/glsl_types.glsl");
    const std::tuple<std::string, std::vector<Number>, std::size_t> blocks[] = {
        {"dab_numbers.glsl", dab_lines(), sizeof(DabNumbers)},
        {"thermal_numbers.glsl", thermal_lines(), sizeof(ThermalNumbers)},
        {"sediment_numbers.glsl", sediment_lines(), sizeof(SedimentNumbers)},
        {"water_numbers.glsl", water_lines(), sizeof(WaterNumbers)}};
    for (const auto& [file, lines, bytes] : blocks) {
        copy("maths/" + file);
        write(folder / ("copy_" + file + ".comp"), copying_shader(file, lines));
    }
    use_shader_folder(folder);
    const BuiltInAfterwards afterwards;
    for (const auto& [file, lines, bytes] : blocks) {
        // Every word is another one, and a float that no device flushes to 0.
        std::vector<std::uint32_t> memory((bytes + 15) / 16 * 4);
        for (std::size_t i = 0; i < memory.size(); ++i)
            memory[i] = 0x3f800000U + static_cast<std::uint32_t>(i);
        Buffer numbers("numbers", memory.size() * sizeof(std::uint32_t));
        numbers.write_all(memory);
        Buffer words("words", 64 * sizeof(std::uint32_t));
        words.fill(0);
        Program program(("copy_" + file + ".comp").c_str());
        program.bind_uniforms("Numbers", numbers);
        program.bind_storage("Words", words);
        program.dispatch(1);
        barrier({Use::storage, Use::buffer_transfer});
        const auto read = words.read_all<std::uint32_t>();
        std::size_t at = 0;
        for (const Number& line : lines)
            for (std::size_t part = 0; part < (line.type.ends_with("2") ? 2U : 1U); ++part)
                EXPECT_EQ(read[at++], 0x3f800000U + line.offset / 4 + part) << line.name;
        EXPECT_THROW(program.bind_uniforms("Numbers", Buffer("too small", numbers.bytes() - 16)), Error);
        program.bind_storage("Words", words);
        EXPECT_THROW(program.dispatch(1), Error) << "without its numbers";
    }
    fs::remove_all(folder);
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
    const BuiltInAfterwards afterwards;
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
    const BuiltInAfterwards afterwards;
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
