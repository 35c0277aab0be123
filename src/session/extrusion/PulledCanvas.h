#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace velum::session {

/// Collects the squares with which voxels are drawn, the nearest square at each pixel, and makes a picture of them: lit
/// from the eye, as the surface that lies under the squares, not square by square.
class PulledCanvas {
 public:
  explicit PulledCanvas(glm::ivec2 size);

  /// Puts down a square, both corners included. @param low, high  pixels  @param distance  from the eye, above 0
  /// @param color  without light
  void put(glm::ivec2 low, glm::ivec2 high, float distance, glm::vec3 color);
  /// Puts down a square of what has gone back: it lies behind all other squares, and is dimmed.
  void putGone(glm::ivec2 low, glm::ivec2 high);
  /// Says how large the voxels are: over some voxels the squares are evened out. Of several calls the largest counts.
  /// @param voxel  edge of a voxel, length
  void setScale(double voxel, double pixelsPerLength);

  /// 0xAARRGGBB, premultiplied, shape [height][width]; 0 where no square was put down. Costs go with the pixels, some
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
  glm::ivec2 mLow, mEnd{0};           ///< the box around all squares
  std::vector<std::uint64_t> mCells;  ///< for each pixel the bits of the distance, which ascend with the distance, over
                                      ///< the colour
  double mVoxel = 0.0, mPixelsPerLength = 0.0;
};

}  // namespace velum::session
