#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/Levels.h"

namespace velum::model {

/// The picture of what balls cover, seen from one side without perspective: a bit a pixel.
class Silhouette {
 public:
  /// @param side  unit direction from which one looks @param around  balls that the picture must have room for @param
  /// pixel edge of a pixel, angstrom
  Silhouette(glm::vec3 side, std::span<const Ball> around, float pixel);
  /// The same picture with nothing in it.
  Silhouette blank() const;
  void add(std::span<const Ball> balls);

  /// How far apart the outlines of two silhouettes on the same pixels are, angstrom, half a pixel at least: the larger
  /// of the two distances by which one must grow to hold the other (the Hausdorff distance, along octagons).
  friend float distanceBetween(const Silhouette& a, const Silhouette& b);

 private:
  bool holds(const Silhouette& other) const;
  void grow(bool diagonally);
  void addRun(int y, int from, int to);
  bool covers(glm::ivec2 low, glm::ivec2 high) const;

  glm::vec3 mRight{0.0f}, mUp{0.0f};
  glm::vec2 mLow{0.0f};
  float mPixel = 1.0f;
  glm::ivec2 mSize{0};
  int mWords = 0;  ///< of a row
  std::vector<std::uint64_t> mBits;
};

float distanceBetween(const Silhouette& a, const Silhouette& b);

}  // namespace velum::model
