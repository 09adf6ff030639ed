// What is read back is what was written, also where the device works behind our back.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <numeric>

#include "sim/gpu/context.h"
#include "sim/gpu/readback.h"
#include "tests/scenes/wait_until.h"

namespace talus::gpu {
namespace {

constexpr int side = 128;

// Of 200 buffers that textures are packed into, how many are read as something else: read(buffer) gives the
// words.
template <typename Read>
int wrong_readings(Read&& read) {
    Texture texture("packed", Format::rgba32f, side, side);
    std::vector<float> texels(static_cast<std::size_t>(side) * side * 4);
    int wrong = 0;
    for (int round = 0; round < 200; ++round) {
        std::iota(texels.begin(), texels.end(), static_cast<float>(round));
        texture.write(texture.whole(), std::as_bytes(std::span(texels)));
        const Buffer buffer("packed into", texels.size() * sizeof(float));
        texture.copy_to(buffer, 0, texture.whole());
        wrong += read(buffer) != texels ? 1 : 0;
    }
    return wrong;
}

// The minimal case of Mesa 22.3's zink on lavapipe: a buffer that textures were packed into was read before
// the packing was done, in 1 of 60 to 2 of 3 readings.
TEST(Readback, ABufferIsReadAfterTexturesWerePackedIntoIt) {
    const Context context;
    EXPECT_EQ(wrong_readings([](const Buffer& buffer) { return buffer.read_all<float>(); }), 0);
}

// The same where it is copied on the device: what was there before was copied, in 1 of 30 to 2 of 3 copies,
// once the packing was handed to the device and not done yet. Undo lost a stroke by it.
TEST(Readback, ABufferIsCopiedAfterTexturesWerePackedIntoIt) {
    const Context context;
    const auto read_copy = [](const Buffer& buffer) {
        glFlush();
        Buffer copy("copy", buffer.bytes());
        copy.copy_from(buffer);
        return copy.read_all<float>();
    };
    EXPECT_EQ(wrong_readings(read_copy), 0);
}

TEST(Readback, ComesByPollingWithoutWaiting) {
    const Context context;
    Texture texture("read", Format::rgba32f, side, side);
    std::vector<float> texels(static_cast<std::size_t>(side) * side * 4);
    Readback readback;
    for (int round = 0; round < 50; ++round) {
        std::iota(texels.begin(), texels.end(), static_cast<float>(round));
        texture.write(texture.whole(), std::as_bytes(std::span(texels)));
        readback.start(texture, texture.whole());
        EXPECT_TRUE(readback.pending());
        std::optional<std::vector<float>> words;
        ASSERT_TRUE(wait_until([&] { return (words = readback.poll()).has_value(); }));
        EXPECT_FALSE(readback.pending());
        EXPECT_EQ(*words, texels);
    }
}

}  // namespace
}  // namespace talus::gpu
