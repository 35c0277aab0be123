#pragma once
#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "core/Assert.h"

namespace velum {

/// A value for each brick of a grid, in blocks of 4^3 that copies share, and that share one where all are alike: a copy
/// costs a pointer a block, and a grid that was never written to hardly more. Reading: any thread; the values of one
/// table are put in by one thread at a time.
template <class T>
class BrickTable {
 public:
  BrickTable() = default;
  /// @param grid  bricks along x, y, z
  BrickTable(glm::ivec3 grid, const T& all) : mGrid(grid), mBlockGrid((grid + kEdge - 1) / kEdge) {
    Block block;
    block.fill(all);
    mBlocks.assign(std::size_t(mBlockGrid.x) * std::size_t(mBlockGrid.y) * std::size_t(mBlockGrid.z),
                   std::make_shared<const Block>(std::move(block)));
  }

  glm::ivec3 grid() const { return mGrid; }
  const T& operator[](glm::ivec3 at) const { return (*mBlocks[blockOf(at)])[placeOf(at)]; }
  /// Cost: copies a block.
  void put(glm::ivec3 at, T value) {
    auto& slot = mBlocks[blockOf(at)];
    auto block = std::make_shared<Block>(*slot);
    (*block)[placeOf(at)] = std::move(value);
    slot = std::move(block);
  }

 private:
  static constexpr int kEdge = 4;
  using Block = std::array<T, std::size_t(kEdge) * kEdge * kEdge>;

  std::size_t blockOf(glm::ivec3 at) const {
    VELUM_ASSERT(glm::all(glm::lessThan(glm::uvec3(at), glm::uvec3(mGrid))), "the brick lies in the grid");
    glm::ivec3 block = at / kEdge;
    return (std::size_t(block.z) * std::size_t(mBlockGrid.y) + std::size_t(block.y)) * std::size_t(mBlockGrid.x) +
           std::size_t(block.x);
  }
  static std::size_t placeOf(glm::ivec3 at) {
    glm::ivec3 in = at % kEdge;
    return (std::size_t(in.z) * kEdge + std::size_t(in.y)) * kEdge + std::size_t(in.x);
  }

  glm::ivec3 mGrid{0}, mBlockGrid{0};
  std::vector<std::shared_ptr<const Block>> mBlocks;
};

}  // namespace velum
