#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <string_view>

#include "velum/gpu/Buffer.h"
#include "velum/gpu/Handle.h"

namespace velum::gpu {

enum class Format {
  R8,
  Rg8,
  Rgba8,
  R16,
  R16f,
  Rgba16f,
  R32f,
  Rg32f,
  Rgba32f,
  R8ui,
  Rg8ui,
  R16ui,
  R32ui,
  Rgba32ui,
  Depth32f
};
enum class Filter { Nearest, Linear };
enum class Access { Read, Write, ReadWrite };

/// Bytes of one texel as uploaded and read back.
std::size_t texelBytes(Format format);

void deleteTexture(unsigned id);

/// A 2D (depth 1) or 3D texture with one level, clamped to its edge. GL thread.
class Texture : public Handle<deleteTexture> {
 public:
  Texture() = default;
  /// @throw GpuError when the driver has no memory for it
  static Texture make2d(std::string_view label, Format format, glm::ivec2 size, Filter filter = Filter::Nearest);
  /// The values of a buffer, for texelFetch from a samplerBuffer. Lives no longer than the buffer.
  static Texture makeOfBuffer(std::string_view label, Format format, const Buffer& buffer);
  static Texture make3d(std::string_view label, Format format, glm::ivec3 size, Filter filter = Filter::Linear);

  glm::ivec3 size() const { return mSize; }
  Format format() const { return mFormat; }
  /// Tightly packed texels, x fastest.
  void write(glm::ivec3 origin, glm::ivec3 size, const void* texels);
  /// Waits for the GPU. Whole texture, tightly packed.
  void read(void* texels, std::size_t bytes) const;
  /// One box of a texture. Waits for the GPU.
  void read(glm::ivec3 origin, glm::ivec3 size, void* texels, std::size_t bytes) const;
  void clear();
  void bindSampler(unsigned unit) const;
  void bindImage(unsigned unit, Access access) const;

 private:
  Texture(unsigned id, Format format, glm::ivec3 size, bool is3d)
      : Handle(id), mFormat(format), mSize(size), mIs3d(is3d) {}
  Format mFormat = Format::R8;
  glm::ivec3 mSize{0};
  bool mIs3d = false;
};

}  // namespace velum::gpu
