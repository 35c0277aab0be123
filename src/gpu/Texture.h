#pragma once
#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <string_view>

#include "gpu/Buffer.h"
#include "gpu/Handle.h"

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
  Rg32ui,
  Rgba32ui,
  Depth32f
};
enum class Filter { Nearest, Linear };
enum class Access { Read, Write, ReadWrite };
/// What a shader gets as one component of a texel: one of the texel's own components, or a constant.
enum class Component { Red, Green, Blue, Alpha, Zero, One };

/// Bytes of one texel as uploaded and read back.
std::size_t texelBytes(Format format);

/// True for formats whose texels are integers and reach shaders as integers.
bool isInteger(Format format);

void deleteTexture(unsigned id);

/// How many levels it takes to halve a size down to one texel.
int levelCountOf(glm::ivec3 size);

/// A 2D (depth 1) or 3D texture, clamped to its edge, with one level or several: each level is half as long along each
/// axis as the one before, rounded down, and at least one texel. GL thread.
class Texture : public Handle<deleteTexture> {
 public:
  Texture() = default;
  /// @param levels  with more than one, Linear also interpolates between levels and Nearest takes the nearest level
  /// @throw NoMemory when the driver has no memory for the texture
  static Texture make2d(std::string_view label, Format format, glm::ivec2 size, Filter filter = Filter::Nearest,
                        int levels = 1);
  /// A texture that shows the values of a buffer, for texelFetch from a samplerBuffer. Must not be used after the
  /// buffer is gone.
  static Texture makeOfBuffer(std::string_view label, Format format, const Buffer& buffer);
  static Texture make3d(std::string_view label, Format format, glm::ivec3 size, Filter filter = Filter::Linear,
                        int levels = 1);

  glm::ivec3 size() const { return mSize; }
  /// Size of a level, texels.
  glm::ivec3 size(int level) const;
  int levelCount() const { return mLevels; }
  Format format() const { return mFormat; }
  /// Writes a box of texels, given tightly packed, x fastest.
  void write(glm::ivec3 origin, glm::ivec3 size, const void* texels, int level = 0);
  /// Reads a whole level, tightly packed. Waits for the GPU.
  void read(void* texels, std::size_t bytes, int level = 0) const;
  /// Reads one box of a level, tightly packed. Waits for the GPU.
  void read(glm::ivec3 origin, glm::ivec3 size, void* texels, std::size_t bytes, int level = 0) const;
  /// Copies one box of a level to the beginning of a buffer, tightly packed, on the GPU.
  void copyTo(Buffer& target, glm::ivec3 origin, glm::ivec3 size, int level = 0) const;
  /// Copies a box of the first level from the same place of another texture of that format and size, on the GPU.
  void copyFrom(const Texture& other, glm::ivec3 origin, glm::ivec3 size);
  /// Sets the first level to zero.
  void clear();
  /// Fills each level after the first with means of the level before it. Not for integer formats.
  void generateLevels();
  void bindSampler(unsigned unit) const;
  /// Chooses what shaders that sample the texture get, from now on, as r, g, b and a of a texel.
  void setComponents(const std::array<Component, 4>& components);
  /// Binds one level for imageLoad and imageStore.
  void bindImage(unsigned unit, Access access, int level = 0) const;

 private:
  Texture(unsigned id, Format format, glm::ivec3 size, bool is3d, int levels = 1)
      : Handle(id), mFormat(format), mSize(size), mIs3d(is3d), mLevels(levels) {}
  Texture alone(glm::ivec3 origin, glm::ivec3 size, int level) const;
  Format mFormat = Format::R8;
  glm::ivec3 mSize{0};
  bool mIs3d = false;
  int mLevels = 1;
};

}  // namespace velum::gpu
