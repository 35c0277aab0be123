#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "velum/gpu/Handle.h"

namespace velum::gpu {

void deleteBuffer(unsigned id);

/// Bytes on the GPU. GL thread.
class Buffer : public Handle<deleteBuffer> {
 public:
  Buffer() = default;
  /// @param data  nullptr leaves the bytes unset
  Buffer(std::string_view label, std::size_t bytes, const void* data = nullptr);
  template <class T>
  Buffer(std::string_view label, std::span<const T> values) : Buffer(label, values.size_bytes(), values.data()) {}

  std::size_t bytes() const { return mBytes; }
  void write(std::size_t offset, std::size_t bytes, const void* data);
  /// Waits for the GPU.
  void read(std::size_t offset, std::size_t bytes, void* data) const;
  /// All of it into a larger buffer, on the GPU. @param offset  bytes from that one's beginning
  void copyTo(Buffer& target, std::size_t offset) const;
  void clear();
  void bindStorage(unsigned binding) const;
  void bindUniform(unsigned binding) const;

 private:
  std::size_t mBytes = 0;
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
