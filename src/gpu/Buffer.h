#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "gpu/Handle.h"

namespace velum::gpu {

void deleteBuffer(unsigned id);

/// Bytes on the GPU. GL thread.
class Buffer : public Handle<deleteBuffer> {
 public:
  Buffer() = default;
  /// @param data  nullptr leaves the bytes unset
  /// @throw GpuError when the driver has no memory for it
  Buffer(std::string_view label, std::size_t bytes, const void* data = nullptr);
  template <class T>
  Buffer(std::string_view label, std::span<const T> values) : Buffer(label, values.size_bytes(), values.data()) {}

  /// Bytes that the processor reads in place, through mapped(), what the GPU has copied there and a Fence says is done.
  static Buffer makeReadable(std::string_view label, std::size_t bytes);

  std::size_t bytes() const { return mBytes; }
  void write(std::size_t offset, std::size_t bytes, const void* data);
  /// Waits for the GPU.
  void read(std::size_t offset, std::size_t bytes, void* data) const;
  /// Where the bytes lie for the processor, as long as the buffer lives; nullptr unless it is readable.
  const std::byte* mapped() const { return mMapped; }
  /// All of it into a larger buffer, on the GPU. @param offset  bytes from that one's beginning
  void copyTo(Buffer& target, std::size_t offset) const { copyTo(target, offset, 0, mBytes); }
  /// Part of it. @param from  bytes from the beginning of this one
  void copyTo(Buffer& target, std::size_t offset, std::size_t from, std::size_t bytes) const;
  void clear();
  /// All words of it.
  void fill(std::uint32_t word);
  void bindStorage(unsigned binding) const;
  void bindUniform(unsigned binding) const;

 private:
  std::size_t mBytes = 0;
  const std::byte* mMapped = nullptr;
};

/// A uniform block with the layout of a struct from shaders/shared. Written at once, read by every stage.
template <class T>
class UniformBuffer {
 public:
  static_assert(sizeof(T) % 16 == 0, "std140 blocks are whole vec4s");
  explicit UniformBuffer(std::string_view label) : mBuffer(label, sizeof(T)) {}
  void set(const T& value) { mBuffer.write(0, sizeof(T), &value); }
  void bind(unsigned binding) const { mBuffer.bindUniform(binding); }

 private:
  Buffer mBuffer;
};

}  // namespace velum::gpu
