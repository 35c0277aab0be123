#include "gpu/Buffer.h"

#include <fmt/format.h>

#include "core/Assert.h"
#include "gpu/Allocation.h"
#include "gpu/Context.h"
#include "gpu/Gl.h"
#include "gpu/GpuError.h"

namespace velum::gpu {

void deleteBuffer(unsigned id) {
  if (hasGl()) gl().DeleteBuffers(1, &id);
}

namespace {
unsigned createBuffer() {
  unsigned id = 0;
  gl().CreateBuffers(1, &id);
  return id;
}

constexpr std::size_t kMostUniformBytes = 16384;  // OpenGL 4.5, table 23.64

/// Smaller ones are made with every picture: a driver with a thread of its own is not waited for each time.
constexpr std::size_t kLargeBytes = std::size_t(1) << 20;
}  // namespace

Buffer::Buffer(std::string_view label, std::size_t bytes, const void* data) : Handle(createBuffer()), mBytes(bytes) {
  allocate({label, bytes}, bytes >= kLargeBytes ? Answer::AtOnce : Answer::Later,
           [&] { gl().NamedBufferStorage(id(), GLsizeiptr(bytes ? bytes : 16), data, GL_DYNAMIC_STORAGE_BIT); });
  gl().ObjectLabel(GL_BUFFER, id(), GLsizei(label.size()), label.data());
}

Buffer Buffer::makeReadable(std::string_view label, std::size_t bytes) {
  constexpr GLbitfield kAccess = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  Buffer buffer;
  static_cast<Handle&>(buffer) = Handle(createBuffer());
  buffer.mBytes = bytes;
  // Mapping waits for the driver, anyhow.
  allocate({label, bytes}, Answer::AtOnce,
           [&] { gl().NamedBufferStorage(buffer.id(), GLsizeiptr(bytes), nullptr, kAccess | GL_CLIENT_STORAGE_BIT); });
  gl().ObjectLabel(GL_BUFFER, buffer.id(), GLsizei(label.size()), label.data());
  MayRefuse mayRefuse;
  buffer.mMapped = static_cast<const std::byte*>(gl().MapNamedBufferRange(buffer.id(), 0, GLsizeiptr(bytes), kAccess));
  if (!buffer.mMapped)
    throw NoMemory(fmt::format("the driver cannot map {} ({} bytes): make the picture smaller", label, bytes));
  return buffer;
}

void Buffer::write(std::size_t offset, std::size_t bytes, const void* data) {
  VELUM_ASSERT(offset + bytes <= mBytes, "what is written lies in the buffer");
  gl().NamedBufferSubData(id(), GLintptr(offset), GLsizeiptr(bytes), data);
}
void Buffer::read(std::size_t offset, std::size_t bytes, void* data) const {
  VELUM_ASSERT(offset + bytes <= mBytes, "what is read lies in the buffer");
  gl().GetNamedBufferSubData(id(), GLintptr(offset), GLsizeiptr(bytes), data);
}
void Buffer::copyTo(Buffer& target, std::size_t offset, std::size_t from, std::size_t bytes) const {
  VELUM_ASSERT(from + bytes <= mBytes && offset + bytes <= target.mBytes, "the copy lies in both buffers");
  gl().CopyNamedBufferSubData(id(), target.id(), GLintptr(from), GLintptr(offset), GLsizeiptr(bytes));
}
void Buffer::clear() { gl().ClearNamedBufferData(id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr); }
void Buffer::fill(std::uint32_t word) {
  gl().ClearNamedBufferData(id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &word);
}
void Buffer::bindStorage(unsigned binding) const {
  // Shaders would see its beginning alone.
  if (mBytes > gl().limits->storageBlock)
    throw GpuError(
        fmt::format("the driver's shaders reach {} MiB of a buffer, and {} MiB are needed: take fewer copies, or a "
                    "smaller picture or volume",
                    gl().limits->storageBlock >> 20, (mBytes + (1 << 20) - 1) >> 20));
  gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, id());
}
void Buffer::bindUniform(unsigned binding) const {
  VELUM_ASSERT(mBytes <= kMostUniformBytes, "a uniform block is as long as every driver takes");
  gl().BindBufferBase(GL_UNIFORM_BUFFER, binding, id());
}

}  // namespace velum::gpu
