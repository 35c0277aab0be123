#pragma once
#include <memory>
#include <vector>

#include "growth/RowTile.h"

namespace velum::growth {

/// The tiles of a volume, made when the region first comes into them, and the growing of all tiles side by side.
class TileGrid {
 public:
  explicit TileGrid(glm::ivec3 dims);

  RowTile* find(int y, int z) { return mTiles[indexOf(y, z)].get(); }
  const RowTile* find(int y, int z) const { return mTiles[indexOf(y, z)].get(); }
  RowTile& make(int y, int z);
  glm::ivec3 dims() const { return mDims; }

  /// Offers the voxels of a row to the four rows beside it, within its tile and in other tiles.
  void offerAround(int y, int z, const Word* row);
  /// Grows all tiles, on all cores, until nothing is left to try. @return how many voxels joined @throw Cancelled; then
  /// all queued rows wait for the next domain
  std::size_t settle(const Admission& admission, const GrowDomain& domain, Progress& progress);

  /// Calls body(tile) for each tile that was made.
  template <class Body>
  void forEach(const Body& body) const {
    for (const auto& tile : mTiles)
      if (tile) body(*tile);
  }

 private:
  std::size_t indexOf(int y, int z) const {
    return std::size_t(z / RowTile::kEdge) * std::size_t(mAlongY) + std::size_t(y / RowTile::kEdge);
  }
  void offer(int y, int z, const Word* row);
  void exchange(const std::vector<RowTile*>& tiles, std::vector<RowTile*>& next);

  glm::ivec3 mDims;
  int mAlongY;
  std::vector<std::unique_ptr<RowTile>> mTiles;  ///< [tile z][tile y]
};

}  // namespace velum::growth
