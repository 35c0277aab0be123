#pragma once
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "growth/RowTile.h"

namespace velum::growth {

/// The tiles of a volume, made when the region first comes into them, and the growing of all tiles side by side.
class TileGrid {
 public:
  /// @param width  of the tiles' rows, a multiple of kWordBits; 0: as long as the volume is wide
  TileGrid(glm::ivec3 dims, int width);

  RowTile* find(glm::ivec3 voxel) const;
  RowTile& make(glm::ivec3 voxel);
  glm::ivec3 dims() const { return mDims; }
  /// How long the rows of tiles are.
  int width() const { return mWidth; }

  /// Offers the voxels of a row to the four rows beside it, within its tile and in other tiles.
  /// @param x  first voxel of a tile @param row  the words of that tile
  void offerAround(glm::ivec3 first, const Word* row);
  /// Offers to a row's neighbours along x, in the tiles before and behind, where the row's first or last voxel is set.
  void offerBeside(const RowTile& tile, int row);
  /// Grows all tiles, on all cores, until nothing is left to try. @return how many voxels joined @throw Cancelled; then
  /// all queued rows wait for the next domain
  std::size_t settle(const Admission& admission, const GrowDomain& domain, Progress& progress);

  /// Calls body(tile) for each tile that was made.
  template <class Body>
  void forEach(const Body& body) const {
    for (const auto& tile : mTiles) body(*tile);
  }
  /// Calls body(tile, row, span) for the parts of rows of these tiles that lie in a domain.
  template <class Body>
  void forSpans(const GrowDomain& domain, const Body& body) const {
    for (const auto& tile : mTiles) {
      if (!domain.mayMeet(tile->first(), tile->end() - 1)) continue;
      for (int row = 0; row < tile->count().y * RowTile::kEdge; ++row)
        if (row % RowTile::kEdge < tile->count().x) body(std::as_const(*tile), row, tile->spanOf(row, domain));
    }
  }
  /// Calls body(tile) for each tile that was made and has part of a row, along x.
  template <class Body>
  void forRow(int y, int z, const Body& body) const {
    for (int x = 0; x < mDims.x; x += mWidth)
      if (RowTile* tile = find({x, y, z})) body(*tile);
  }

 private:
  std::size_t indexOf(glm::ivec3 voxel) const {
    constexpr int kEdge = RowTile::kEdge;
    return (std::size_t(voxel.z / kEdge) * std::size_t(mAlongY) + std::size_t(voxel.y / kEdge)) * std::size_t(mAlongX) +
           std::size_t(mAlongX == 1 ? 0 : voxel.x / mWidth);
  }
  void offer(glm::ivec3 first, const Word* row);
  void exchange(const std::vector<RowTile*>& tiles, std::vector<RowTile*>& next);

  glm::ivec3 mDims;
  int mWidth, mAlongX, mAlongY;
  std::vector<std::unique_ptr<RowTile>> mTiles;       ///< in the order in which they were made
  std::vector<RowTile*> mTable;                       ///< by index, where rows have one tile each
  std::unordered_map<std::size_t, RowTile*> mSparse;  ///< by index, where they have several: few of many are made
};

}  // namespace velum::growth
