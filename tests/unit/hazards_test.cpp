// The book of sim/gpu finds the barrier that is missing between what a shader stored and how it is used next.
#include "sim/gpu/hazards.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "sim/error.h"
#include "sim/gpu/context.h"
#include "sim/gpu/program.h"
#include "sim/gpu/readback.h"
#include "sim/gpu/shader_text.h"
#include "sim/gpu/texture.h"
#include "sim/terrain/generate.h"
#include "sim/terrain/terrain.h"

namespace talus::gpu {
namespace {

namespace fs = std::filesystem;

// A context that keeps the book, and three shaders: one stores into an image and into two buffers, the others
// use them.
class Hazards : public ::testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(folder_ / "maths");
        const auto write = [&](const char* name, const char* text) { std::ofstream(folder_ / name) << text; };
        write("store.comp",
              "layout(local_size_x = 1) in;\n"
              "layout(r32f) uniform writeonly image2D stored;\n"
              "layout(std430) writeonly buffer Words { uint words[]; };\n"
              "void main() { imageStore(stored, ivec2(0), vec4(7.0)); words[0] = 1u; words[1] = 1u; words[2] "
              "= 1u; }\n");
        write("by_image.comp",
              "layout(local_size_x = 1) in;\n"
              "layout(r32f) uniform readonly image2D stored;\n"
              "layout(std430) writeonly buffer Sum { float sum[]; };\n"
              "void main() { sum[0] = imageLoad(stored, ivec2(0)).x; }\n");
        write("by_sampler.comp",
              "layout(local_size_x = 1) in;\n"
              "uniform sampler2D stored;\n"
              "layout(std430) writeonly buffer Sum { float sum[]; };\n"
              "void main() { sum[0] = texelFetch(stored, ivec2(0), 0).x; }\n");
        write("by_buffer.comp",
              "layout(local_size_x = 1) in;\n"
              "layout(std430) readonly buffer Words { uint words[]; };\n"
              "layout(std430) writeonly buffer Sum { float sum[]; };\n"
              "void main() { sum[0] = float(words[0]); }\n");
        hazards::keep(true);
        context_.emplace();
        use_shader_folder(folder_);
        image = Texture("a stored image", Format::r32f, 4, 4);
        words = Buffer("stored words", 12);
        sum = Buffer("sum", 16);
    }
    void TearDown() override {
        use_built_in_shaders();
        hazards::keep(false);
        fs::remove_all(folder_);
    }

    // A program with all that it may need bound.
    Program program(const char* path) {
        Program made(path);
        made.bind_image("stored", image);
        made.bind_sampled("stored", image);
        made.bind_storage("Words", words);
        made.bind_storage("Sum", sum);
        return made;
    }
    void store() { program("store.comp").dispatch(1); }
    // Throws without a barrier for one of these uses, and says who stored what; goes through with it.
    template <typename Act>
    void expect_needed(Use use, const char* object, Act&& act) {
        store();
        // Every other use is in order.
        for (unsigned other = 0; other < use_count; ++other)
            if (static_cast<Use>(other) != use) barrier({static_cast<Use>(other)});
        try {
            act();
            ADD_FAILURE() << "use " << static_cast<unsigned>(use) << " of " << object << " went through";
        } catch (const Error& error) {
            const std::string said = error.what();
            EXPECT_NE(said.find(object), std::string::npos) << said;
            EXPECT_NE(said.find("store.comp"), std::string::npos) << said;
        }
        barrier({use});
        EXPECT_NO_THROW(act());
        barrier({Use::image, Use::sampler, Use::storage, Use::indirect, Use::texture_transfer,
                 Use::buffer_transfer, Use::pixel_buffer, Use::framebuffer, Use::elements});
    }

  private:
    std::optional<Context> context_;  // first: it outlives what is made in it

  protected:
    Texture image;
    Buffer words;
    Buffer sum;

  private:
    fs::path folder_ = fs::temp_directory_path() / ("talus_hazards_" + std::to_string(::getpid()));
};

TEST_F(Hazards, ImageToImage) {
    expect_needed(Use::image, "a stored image", [&] { program("by_image.comp").dispatch(1); });
}

TEST_F(Hazards, ImageToSampler) {
    expect_needed(Use::sampler, "a stored image", [&] { program("by_sampler.comp").dispatch(1); });
}

TEST_F(Hazards, BufferToBuffer) {
    expect_needed(Use::storage, "stored words", [&] { program("by_buffer.comp").dispatch(1); });
}

TEST_F(Hazards, BufferToIndirect) {
    expect_needed(Use::indirect, "stored words",
                  [&] { program("by_sampler.comp").dispatch_indirect(words); });
}

TEST_F(Hazards, WriteToReadBack) {
    expect_needed(Use::texture_transfer, "a stored image", [&] { image.read_all<float>(); });
    expect_needed(Use::buffer_transfer, "stored words", [&] { words.read_all<std::uint32_t>(); });
    expect_needed(Use::texture_transfer, "a stored image", [&] { Readback().start(image, {0, 0, 1, 1}); });
}

TEST_F(Hazards, ADrawIntoWhatWasStored) {
    const std::array<const Texture*, 1> colour = {&image};
    const Framebuffer target("target", colour);
    expect_needed(Use::framebuffer, "a stored image", [&] { target.clear(0, {1, 1, 1, 1}); });
}

// What Talus does itself is in order: the book of a terrain that is made, changed and read.
TEST_F(Hazards, ATerrainIsInOrder) {
    use_built_in_shaders();
    const Grid grid{70, 70, 10, 10};
    Terrain terrain(bedrock_terrain(grid, generate_heights(grid, {"hills", 1, 100})));
    EXPECT_NO_THROW(terrain.refresh({0, 0, 70, 70}));
    EXPECT_NO_THROW(terrain.read());
}

}  // namespace
}  // namespace talus::gpu
