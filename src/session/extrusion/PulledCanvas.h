#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace velum::session {

/// The squares of voxels that were put down, the nearest of each pixel, and the picture that they make: lit from the
/// eye, as the surface that lies under the squares, not square by square.
class PulledCanvas {
 public:
  explicit PulledCanvas(glm::ivec2 size);

  /// A square, both corners included. @param distance  from the eye, above 0; @param color  without light
  void put(glm::ivec2 low, glm::ivec2 high, float distance, glm::vec3 color);
  /// What has gone back lies behind all that is there, and is dimmed.
  void putGone(glm::ivec2 low, glm::ivec2 high);
  /// How large what is put down is: over some voxels the squares are evened out. The largest counts.
  /// @param voxel  its edge, length
  void setScale(double voxel, double pixelsPerLength);

  /// 0xAARRGGBB, premultiplied, shape [height][width]; 0 where nobody has put anything. Costs go with the pixels, some
  /// nanoseconds each, and with the voxels that are seen.
  std::vector<std::uint32_t> pixels() const;
  glm::ivec2 size() const { return mSize; }

  /// What a pixel shows: its distance, and the colour in bytes.
  using Seen = glm::vec4;
  struct Lines;

 private:
  Lines thinned(int step) const;
  std::size_t indexOf(glm::ivec2 at) const { return std::size_t(at.y) * std::size_t(mSize.x) + std::size_t(at.x); }
  void putWord(glm::ivec2 low, glm::ivec2 high, float distance, std::uint32_t color);

  glm::ivec2 mSize;
  glm::ivec2 mLow, mEnd{0};           ///< the box of what was put down
  std::vector<std::uint64_t> mCells;  ///< the distance's bits, which ascend with it, over the colour
  double mVoxel = 0.0, mPixelsPerLength = 0.0;
};

}  // namespace velum::session
