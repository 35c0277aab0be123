#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/Levels.h"

namespace velum::model {

/// What balls cover, seen from one side without perspective: a bit a pixel.
class Silhouette {
 public:
  /// @param side  unit, from where  @param around  what the picture has to hold  @param pixel  its edge, angstrom
  Silhouette(glm::vec3 side, std::span<const Ball> around, float pixel);
  /// The same picture with nothing in it.
  Silhouette blank() const;
  void add(std::span<const Ball> balls);

  /// How far the outlines of two of the same picture are apart to either side, angstrom, half a pixel at least:
  /// the larger of the distances that one must grow by to hold the other (the Hausdorff distance, along octagons).
  friend float distanceBetween(const Silhouette& a, const Silhouette& b);

 private:
  bool holds(const Silhouette& other) const;
  void grow(bool diagonally);
  void addRun(int y, int from, int to);

  glm::vec3 mRight{0.0f}, mUp{0.0f};
  glm::vec2 mLow{0.0f};
  float mPixel = 1.0f;
  glm::ivec2 mSize{0};
  int mWords = 0;  ///< of a row
  std::vector<std::uint64_t> mBits;
};

float distanceBetween(const Silhouette& a, const Silhouette& b);

}  // namespace velum::model
