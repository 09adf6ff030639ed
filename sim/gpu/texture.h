#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/gpu/buffer.h"
#include "sim/gpu/handle.h"
#include "sim/gpu/region.h"

namespace talus::gpu {

void delete_texture(unsigned name);
void delete_framebuffer(unsigned name);

/// srgb8: three channels of a picture for screens and one unused; shaders read them linear.
enum class Format { r32f, rg32f, rgba8, srgb8, rgba32f, depth32f };
/// What a texture shows beyond its edge: the edge, or itself again.
enum class Wrap { edge, repeat };
enum class SmallerLevels { made, written };
enum class Access { read, write, read_write };

/// Texels along a side that every device has on which Talus starts (docs/devices.md).
constexpr int widest_texture = 16384;

/// Bytes of one texel.
std::size_t texel_bytes(Format format);

/// A two-dimensional image on the device, with mip levels where asked for; texels beyond the edge read the
/// edge's.
class Texture {
  public:
    Texture() = default;
    Texture(const std::string& label, Format format, int width, int height, int levels = 1);

    int width() const { return width_; }
    int height() const { return height_; }
    int levels() const { return levels_; }
    Format format() const { return format_; }
    unsigned name() const { return handle_; }
    Region whole() const { return {0, 0, width_, height_}; }

    /// Sets every texel of every level: all components to the value.
    void fill(float value);
    /// Rows of tightly packed texels, row 0 first.
    void write(const Region& region, std::span<const std::byte> texels, int level = 0);
    /// Waits for the device. Not for use within a frame (law 7).
    void read(const Region& region, std::span<std::byte> texels, int level = 0) const;
    /// Device to device, without waiting: the region's texels to and from a buffer at an offset in bytes.
    void copy_to(const Buffer& buffer, std::size_t offset, const Region& region) const;
    void copy_from(const Buffer& buffer, std::size_t offset, const Region& region);
    /// Device to device: the same region of a texture of the same format.
    void copy_from(const Texture& other, const Region& region);

    template <typename T>
    std::vector<T> read_all(int level = 0) const {
        const int w = std::max(1, width_ >> level);
        const int h = std::max(1, height_ >> level);
        std::vector<T> texels(static_cast<std::size_t>(w) * h);
        read({0, 0, w, h}, std::as_writable_bytes(std::span(texels)), level);
        return texels;
    }

    /// Reads smooth between texels and levels from then on. Smaller levels are made from the first one, or
    /// written by the caller.
    void filter(Wrap wrap, SmallerLevels smaller = SmallerLevels::made);
    /// Where a program finds it; Program::bind_image() and the like know the unit.
    void bind_sampled(unsigned unit) const;
    void bind_image(unsigned unit, Access access) const;

  private:
    Handle<delete_texture> handle_;
    Format format_ = Format::r32f;
    int width_ = 0;
    int height_ = 0;
    int levels_ = 0;
};

/// Whether filtered textures are read finer across than along where a pixel is drawn out on the surface.
bool filters_along();

/// Textures of one size to draw into, in the order of the fragment shader's outputs; with a depth32f texture,
/// draws of triangles keep the nearest.
class Framebuffer {
  public:
    Framebuffer() = default;
    Framebuffer(const std::string& label, std::span<const Texture* const> colours,
                const Texture* depth = nullptr);

    /// Sets all of a colour texture, and the depth to the farthest.
    void clear(int colour, const std::array<float, 4>& value) const;
    void clear_depth() const;

    /// Makes it the target of the next draws, with the viewport on the region given.
    void bind(const Region& viewport) const;
    /// The same, and no pixel beside `clip` is drawn, until the next bind().
    void bind(const Region& viewport, const Region& clip) const;
    /// Copies the source region onto the window's target region, scaling smoothly where sizes differ.
    void blit_to_window(const Region& source, const Region& target) const;

  private:
    Handle<delete_framebuffer> handle_;
    std::vector<unsigned> targets_;  // names of its colours
};

}  // namespace talus::gpu
