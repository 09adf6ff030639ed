#include "sim/gpu/buffer.h"

#include <epoxy/gl.h>

#include "sim/gpu/debug.h"
#include "sim/gpu/fence.h"
#include "sim/gpu/hazards.h"

namespace talus::gpu {

void delete_buffer(unsigned name) {
    glDeleteBuffers(1, &name);
}

namespace {

unsigned made(const std::string& label, std::size_t bytes, const std::byte* data, GLbitfield flags) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glObjectLabel(GL_BUFFER, name, static_cast<GLsizei>(label.size()), label.data());
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(bytes), data, flags);
    hazards::made(hazards::Kind::buffer, name, label);
    raise_errors();
    return name;
}

}  // namespace

Buffer::Buffer(const std::string& label, std::size_t bytes)
    : handle_(made(label, bytes, nullptr, GL_DYNAMIC_STORAGE_BIT)), bytes_(bytes) {}

Buffer::Buffer(const std::string& label, std::span<const std::byte> data)
    : handle_(made(label, data.size(), data.data(), 0)), bytes_(data.size()) {}

void Buffer::fill(std::uint32_t word) {
    hazards::used(hazards::Kind::buffer, handle_, Use::buffer_transfer, "Buffer::fill");
    glClearNamedBufferData(handle_, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &word);
    raise_errors();
}

void Buffer::write(std::size_t offset, std::span<const std::byte> data) {
    if (data.empty()) return;
    hazards::used(hazards::Kind::buffer, handle_, Use::buffer_transfer, "Buffer::write");
    // The bytes go by a buffer of their own: NVIDIA's glNamedBufferSubData overtakes dispatches that were
    // asked for before it, whatever barrier stands between (docs/devices.md).
    GLuint staging = 0;
    glCreateBuffers(1, &staging);
    const Handle<delete_buffer> dropped(staging);
    glNamedBufferStorage(staging, static_cast<GLsizeiptr>(data.size()), data.data(), 0);
    glCopyNamedBufferSubData(staging, handle_, 0, static_cast<GLintptr>(offset),
                             static_cast<GLsizeiptr>(data.size()));
    raise_errors();
}

void Buffer::read(std::size_t offset, std::span<std::byte> data) const {
    // OpenGL makes glGetNamedBufferSubData wait for all that was asked before. Mesa 22.3's zink does not wait
    // for glGetTextureSubImage into the buffer: a fence does, most of the time (docs/devices.md).
    Fence::now().wait();
    read_passed(offset, data);
}

void Buffer::read_passed(std::size_t offset, std::span<std::byte> data) const {
    hazards::used(hazards::Kind::buffer, handle_, Use::buffer_transfer, "Buffer::read");
    glGetNamedBufferSubData(handle_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(data.size()),
                            data.data());
    raise_errors();
}

void Buffer::copy_from(const Buffer& other) {
    copy_part(0, other, 0, bytes_);
}

void Buffer::copy_part(std::size_t offset, const Buffer& other, std::size_t other_offset, std::size_t bytes) {
    hazards::used(hazards::Kind::buffer, other.handle_, Use::buffer_transfer, "Buffer::copy_part");
    hazards::used(hazards::Kind::buffer, handle_, Use::buffer_transfer, "Buffer::copy_part");
    glCopyNamedBufferSubData(other.handle_, handle_, static_cast<GLintptr>(other_offset),
                             static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes));
    raise_errors();
}

void Buffer::bind_storage(unsigned index) const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, index, handle_);
}

void Buffer::bind_uniforms(unsigned index) const {
    glBindBufferBase(GL_UNIFORM_BUFFER, index, handle_);
}

}  // namespace talus::gpu
