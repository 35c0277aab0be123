#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace velum::vector {

/// Pixels that hang together, one after the other.
struct PixelChain {
  std::vector<glm::ivec2> pixels;  ///< neighbours, by edge or corner
  bool isClosed = false;           ///< the last is a neighbour of the first
};

/// Which pixels are part of something, with a border of one pixel that are not.
class Mask {
 public:
  explicit Mask(glm::ivec2 size) : mSize(size), mSet(std::size_t(size.x + 2) * std::size_t(size.y + 2)) {}
  glm::ivec2 size() const { return mSize; }
  bool at(glm::ivec2 p) const { return mSet[indexOf(p)] != 0; }
  void set(glm::ivec2 p, bool isSet) { mSet[indexOf(p)] = isSet ? 1 : 0; }
  /// The eight around a pixel as bits: right, below right, below ... round to above right.
  unsigned around(glm::ivec2 p) const;

 private:
  std::size_t indexOf(glm::ivec2 p) const {
    return std::size_t(p.y + 1) * std::size_t(mSize.x + 2) + std::size_t(p.x + 1);
  }
  glm::ivec2 mSize;
  std::vector<std::uint8_t> mSet;
};

/// Makes bands a pixel thin, in their middles, and takes them as lines: of those that meet the two that go on
/// straightest are one. Ends that stick out of a line by less than a spur are noise of the band's edge and left out.
/// @param mask  is thin after it  @param spur  pixels
std::vector<PixelChain> thinLines(Mask& mask, int spur);

}  // namespace velum::vector
