#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sim/gpu/buffer.h"
#include "sim/gpu/handle.h"
#include "sim/gpu/program_interface.h"
#include "sim/gpu/texture.h"

namespace talus::gpu {

void delete_program(unsigned name);

/// What a draw does with the depth of its target: 1 at the near plane, 0 at infinity.
enum class Depth {
    none,     ///< neither looks at it nor changes it
    nearest,  ///< the nearest wins; triangles that wind clockwise in the picture are not drawn
    behind,   ///< draws at depth 0, only where no triangle was drawn
    reset,    ///< draws everywhere, and its depth takes the place of what was there
};

/// A linked program of GLSL files below shaders/. `#include "maths/patch.glsl"` is resolved below shaders/,
/// each file at most once. Throws talus::Error that names file and line when a shader does not compile.
///
///     Program thermal("sim/thermal.comp");
///     thermal.set("cell_m", glm::vec2(30, 30));
///     thermal.dispatch(8, 8);
class Program {
  public:
    Program() = default;
    /// One path ending in .comp, or two ending in .vert and .frag. `defines` are lines such as "NAME 1".
    explicit Program(std::vector<std::string> paths, std::vector<std::string> defines = {});
    explicit Program(const char* path) : Program(std::vector<std::string>{path}) {}

    /// Uniforms keep their values across a rebuild. A name that the shader optimised away is ignored.
    void set(std::string_view name, float value);
    void set(std::string_view name, int value);
    void set(std::string_view name, unsigned value);
    void set(std::string_view name, glm::vec2 value);
    void set(std::string_view name, glm::vec3 value);
    void set(std::string_view name, glm::vec4 value);
    void set(std::string_view name, glm::ivec2 value);

    /// Binds an object for the next run, by the name that the shader gives it; of a buffer, the name of its
    /// block. A name that the shader does not use is ignored. Between a program's binds and its run no other
    /// program may bind. A run throws talus::Error where something that the shader uses was not bound for it.
    void bind_image(std::string_view name, const Texture& texture);
    void bind_sampled(std::string_view name, const Texture& texture);
    void bind_storage(std::string_view block, const Buffer& buffer);
    /// The same of a uniform block, whose numbers C++ declares by the lines that the shader does
    /// (sim/gpu/uniform_block.h). Throws talus::Error where the buffer has not the block's size.
    void bind_uniforms(std::string_view block, const Buffer& buffer);

    /// Runs compute groups. What they store is there for who uses it after a gpu::barrier() that names the
    /// use.
    void dispatch(int groups_x, int groups_y = 1, int groups_z = 1);
    /// The same with the three group counts read on the device from the buffer at the offset (bytes).
    void dispatch_indirect(const Buffer& arguments, std::size_t offset = 0);
    /// Draws one triangle that covers the viewport.
    void draw_fullscreen(Depth depth = Depth::none);
    /// Draws triangles, as many and as often as the four words at the offset (bytes) say: vertices,
    /// instances, first vertex, base instance.
    void draw_indirect(const Buffer& arguments, std::size_t offset, Depth depth);
    /// The same as points, as large as the vertex shader says: squares without the diagonal of two triangles,
    /// along which software shades twice.
    void draw_points_indirect(const Buffer& arguments, std::size_t offset, Depth depth);
    /// Triangles with 32-bit indices and five words: indices, instances, first index, base vertex, base
    /// instance.
    void draw_indexed_indirect(const Buffer& indices, const Buffer& arguments, std::size_t offset,
                               Depth depth);

  private:
    struct Value {
        int kind = 0;
        std::array<float, 4> real{};
        std::array<int, 2> whole{};
    };

    void build();
    void follow_files();
    Place* place(Use use, std::string_view name);
    void use();
    void upload(std::string_view name, const Value& value);
    void remember(std::string_view name, const Value& value);

    std::uint64_t number_ = 0;  // of this program alone
    std::vector<std::string> paths_;
    std::vector<std::string> defines_;
    Handle<delete_program> handle_;
    unsigned generation_ = 0;
    std::map<std::string, int, std::less<>> locations_;
    std::map<std::string, Value, std::less<>> values_;
    std::vector<Place> places_;
    std::set<std::string, std::less<>> given_;  // names that were ever bound
};

}  // namespace talus::gpu
