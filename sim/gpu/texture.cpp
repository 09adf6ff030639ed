#include "sim/gpu/texture.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sim/error.h"
#include "sim/gpu/debug.h"
#include "sim/gpu/hazards.h"

namespace talus::gpu {
namespace {

struct Layout {
    GLenum internal;
    GLenum format;
    GLenum type;
    std::size_t bytes;
};

Layout layout_of(Format format) {
    switch (format) {
        case Format::r32f:
            return {GL_R32F, GL_RED, GL_FLOAT, 4};
        case Format::rg32f:
            return {GL_RG32F, GL_RG, GL_FLOAT, 8};
        case Format::rgba8:
            return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4};
        case Format::srgb8:
            return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, 4};
        case Format::rgba32f:
            return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16};
        case Format::depth32f:
            return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4};
    }
    throw Error("a texture has no such format");
}

constexpr float anisotropy = 8;

}  // namespace

void delete_texture(unsigned name) {
    glDeleteTextures(1, &name);
}
void delete_framebuffer(unsigned name) {
    glDeleteFramebuffers(1, &name);
}
std::size_t texel_bytes(Format format) {
    return layout_of(format).bytes;
}

Texture::Texture(const std::string& label, Format format, int width, int height, int levels)
    : format_(format), width_(width), height_(height), levels_(levels) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    handle_ = Handle<delete_texture>(name);
    glObjectLabel(GL_TEXTURE, name, static_cast<GLsizei>(label.size()), label.data());
    glTextureStorage2D(name, levels, layout_of(format).internal, width, height);
    hazards::made(hazards::Kind::texture, name, label);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    raise_errors();
}

void Texture::filter(Wrap wrap, SmallerLevels smaller) {
    if (smaller == SmallerLevels::made) glGenerateTextureMipmap(handle_);
    const GLint beyond = wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTextureParameteri(handle_, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(handle_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(handle_, GL_TEXTURE_WRAP_S, beyond);
    glTextureParameteri(handle_, GL_TEXTURE_WRAP_T, beyond);
    if (filters_along()) glTextureParameterf(handle_, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
    raise_errors();
}

bool filters_along() {
    // llvmpipe has it, and takes seconds for a picture (docs/benchmarks.md).
    const std::string_view renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") &&
           renderer.find("llvmpipe") == std::string_view::npos;
}

void Texture::fill(float value) {
    hazards::used(hazards::Kind::texture, handle_, Use::texture_transfer, "Texture::fill");
    const std::array<float, 4> texel = {value, value, value, value};
    for (int level = 0; level < levels_; ++level)
        glClearTexImage(handle_, level, layout_of(format_).format, GL_FLOAT, texel.data());
    raise_errors();
}

void Texture::write(const Region& region, std::span<const std::byte> texels, int level) {
    hazards::used(hazards::Kind::texture, handle_, Use::texture_transfer, "Texture::write");
    const Layout layout = layout_of(format_);
    glTextureSubImage2D(handle_, level, region.x, region.y, region.width, region.height, layout.format,
                        layout.type, texels.data());
    raise_errors();
}

void Texture::read(const Region& region, std::span<std::byte> texels, int level) const {
    const Layout layout = layout_of(format_);
    hazards::used(hazards::Kind::texture, handle_, Use::texture_transfer, "Texture::read");
    glGetTextureSubImage(handle_, level, region.x, region.y, 0, region.width, region.height, 1, layout.format,
                         layout.type, static_cast<GLsizei>(texels.size()), texels.data());
    raise_errors();
}

void Texture::copy_to(const Buffer& buffer, std::size_t offset, const Region& region) const {
    const Layout layout = layout_of(format_);
    hazards::used(hazards::Kind::texture, handle_, Use::texture_transfer, "Texture::copy_to");
    hazards::used(hazards::Kind::buffer, buffer.name(), Use::pixel_buffer, "Texture::copy_to");
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer.name());
    glGetTextureSubImage(handle_, 0, region.x, region.y, 0, region.width, region.height, 1, layout.format,
                         layout.type, static_cast<GLsizei>(buffer.bytes() - offset), as_offset(offset));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    raise_errors();
}

void Texture::copy_from(const Buffer& buffer, std::size_t offset, const Region& region) {
    const Layout layout = layout_of(format_);
    hazards::used(hazards::Kind::texture, handle_, Use::texture_transfer, "Texture::copy_from");
    hazards::used(hazards::Kind::buffer, buffer.name(), Use::pixel_buffer, "Texture::copy_from");
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer.name());
    glTextureSubImage2D(handle_, 0, region.x, region.y, region.width, region.height, layout.format,
                        layout.type, as_offset(offset));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    raise_errors();
}

void Texture::copy_from(const Texture& other, const Region& region) {
    hazards::used(hazards::Kind::texture, other.handle_, Use::texture_transfer, "Texture::copy_from");
    hazards::used(hazards::Kind::texture, handle_, Use::texture_transfer, "Texture::copy_from");
    glCopyImageSubData(other.handle_, GL_TEXTURE_2D, 0, region.x, region.y, 0, handle_, GL_TEXTURE_2D, 0,
                       region.x, region.y, 0, region.width, region.height, 1);
    raise_errors();
}

void Texture::bind_sampled(unsigned unit) const {
    glBindTextureUnit(unit, handle_);
}

void Texture::bind_image(unsigned unit, Access access) const {
    const GLenum mode = access == Access::read    ? GL_READ_ONLY
                        : access == Access::write ? GL_WRITE_ONLY
                                                  : GL_READ_WRITE;
    glBindImageTexture(unit, handle_, 0, GL_FALSE, 0, mode, layout_of(format_).internal);
}

Framebuffer::Framebuffer(const std::string& label, std::span<const Texture* const> colours,
                         const Texture* depth) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    handle_ = Handle<delete_framebuffer>(name);
    glObjectLabel(GL_FRAMEBUFFER, name, static_cast<GLsizei>(label.size()), label.data());
    std::vector<GLenum> targets;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        targets.push_back(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + i));
        glNamedFramebufferTexture(name, targets.back(), colours[i]->name(), 0);
    }
    for (const Texture* colour : colours) targets_.push_back(colour->name());
    if (depth) glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth->name(), 0);
    glNamedFramebufferDrawBuffers(name, static_cast<GLsizei>(targets.size()), targets.data());
    glNamedFramebufferReadBuffer(name, GL_COLOR_ATTACHMENT0);
    raise_errors();
    if (glCheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(fmt::format("framebuffer '{}' is not complete on this driver", label));
}

void Framebuffer::clear(int colour, const std::array<float, 4>& value) const {
    hazards::used(hazards::Kind::texture, targets_[static_cast<std::size_t>(colour)], Use::framebuffer,
                  "Framebuffer::clear");
    glClearNamedFramebufferfv(handle_, GL_COLOR, colour, value.data());
    raise_errors();
}

void Framebuffer::clear_depth() const {
    const float farthest = 0;
    glClearNamedFramebufferfv(handle_, GL_DEPTH, 0, &farthest);
    raise_errors();
}

void Framebuffer::bind(const Region& viewport) const {
    hazards::bound_targets(targets_);
    glBindFramebuffer(GL_FRAMEBUFFER, handle_);
    glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
    glDisable(GL_SCISSOR_TEST);
}

void Framebuffer::bind(const Region& viewport, const Region& clip) const {
    bind(viewport);
    glEnable(GL_SCISSOR_TEST);
    glScissor(clip.x, clip.y, clip.width, clip.height);
}

void Framebuffer::blit_to_window(const Region& source, const Region& target) const {
    hazards::used(hazards::Kind::texture, targets_.front(), Use::framebuffer, "Framebuffer::blit_to_window");
    const bool same = source.width == target.width && source.height == target.height;
    glBlitNamedFramebuffer(handle_, 0, source.x, source.y, source.x + source.width, source.y + source.height,
                           target.x, target.y, target.x + target.width, target.y + target.height,
                           GL_COLOR_BUFFER_BIT, same ? GL_NEAREST : GL_LINEAR);
    raise_errors();
}

}  // namespace talus::gpu
