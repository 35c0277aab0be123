#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace velum::shared {
struct InstanceView;
}

namespace velum::model {

/// From the first copy to another one, in the frame of a view. @param copy  its number in the grid of all copies
glm::vec3 copyShift(const shared::InstanceView& view, std::uint32_t copy);

/// Blocks of copies that the window of a view may hold.
struct BlocksInView {
  std::vector<std::uint32_t> blocks;  ///< their numbers in the grid of blocks, the nearest first
  std::uint64_t looks = 0;            ///< how many blocks, and blocks of blocks, were looked at for that
};
/// Copies nest: blocks of kBlockEdge along each axis, blocks of blocks, and so on, each of which is left out as a whole
/// where it lies beside the window. O(blocks in view).
BlocksInView blocksInView(const shared::InstanceView& view);

/// The copies in the window that are so near that an error shows, a length, the nearest first: by more than the view's
/// detail. What is far is left out block by block. @param most  so many at most
std::vector<std::uint32_t> nearCopies(const shared::InstanceView& view, float error, std::size_t most);

}  // namespace velum::model
