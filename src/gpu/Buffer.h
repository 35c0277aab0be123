#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "gpu/Handle.h"

namespace velum::gpu {

void deleteBuffer(unsigned id);

/// A buffer of bytes on the GPU. GL thread.
class Buffer : public Handle<deleteBuffer> {
 public:
  Buffer() = default;
  /// @param data  nullptr leaves the bytes unset
  /// @throw NoMemory when the driver has no memory for the buffer; for one of less than 1 MiB throwIfExhausted() says
  /// so later
  Buffer(std::string_view label, std::size_t bytes, const void* data = nullptr);
  template <class T>
  Buffer(std::string_view label, std::span<const T> values) : Buffer(label, values.size_bytes(), values.data()) {}

  /// A buffer that the processor reads in place, through mapped(): once a Fence says that the GPU's copy into the
  /// buffer is done.
  static Buffer makeReadable(std::string_view label, std::size_t bytes);

  std::size_t bytes() const { return mBytes; }
  void write(std::size_t offset, std::size_t bytes, const void* data);
  /// Waits for the GPU.
  void read(std::size_t offset, std::size_t bytes, void* data) const;
  /// The address at which the processor reads the bytes, valid as long as the buffer lives; nullptr unless it was made
  /// by makeReadable().
  const std::byte* mapped() const { return mMapped; }
  /// Copies the whole buffer into another one that is at least as large, on the GPU. @param offset  where the copy
  /// begins in the target, bytes
  void copyTo(Buffer& target, std::size_t offset) const { copyTo(target, offset, 0, mBytes); }
  /// Copies a part of the buffer. @param from  where the part begins in this buffer, bytes
  void copyTo(Buffer& target, std::size_t offset, std::size_t from, std::size_t bytes) const;
  void clear();
  /// Sets every 32-bit word of the buffer.
  void fill(std::uint32_t word);
  void bindStorage(unsigned binding) const;
  void bindUniform(unsigned binding) const;

 private:
  std::size_t mBytes = 0;
  const std::byte* mMapped = nullptr;
};

/// A uniform block with the layout of a struct from shaders/shared. Always written as a whole, before it is bound; read
/// by every stage. Takes memory from the first time on.
template <class T>
class UniformBuffer {
 public:
  static_assert(sizeof(T) % 16 == 0, "std140 blocks are whole vec4s");
  /// @param label  a literal
  explicit UniformBuffer(std::string_view label) : mLabel(label) {}
  void set(const T& value) {
    if (!mBuffer) mBuffer = Buffer(mLabel, sizeof(T));
    mBuffer.write(0, sizeof(T), &value);
  }
  void bind(unsigned binding) const { mBuffer.bindUniform(binding); }

 private:
  std::string_view mLabel;
  Buffer mBuffer;
};

}  // namespace velum::gpu
