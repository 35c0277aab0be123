#include "growth/TileGrid.h"

#include <algorithm>

#include "core/Parallel.h"

namespace velum::growth {

namespace {

constexpr int kEdge = RowTile::kEdge;

}  // namespace

TileGrid::TileGrid(glm::ivec3 dims)
    : mDims(dims),
      mAlongY((dims.y + kEdge - 1) / kEdge),
      mTiles(std::size_t(mAlongY) * std::size_t((dims.z + kEdge - 1) / kEdge)) {}

RowTile& TileGrid::make(int y, int z) {
  auto& tile = mTiles[indexOf(y, z)];
  if (!tile) tile = std::make_unique<RowTile>(glm::ivec2(y, z) / kEdge * kEdge, mDims);
  return *tile;
}

void TileGrid::offer(int y, int z, const Word* row) {
  if (y < 0 || z < 0 || y >= mDims.y || z >= mDims.z) return;
  RowTile& tile = make(y, z);
  if (int other = tile.rowAt(y, z); tile.offer(other, row)) tile.enqueue(other);
}

void TileGrid::offerAround(int y, int z, const Word* row) {
  offer(y - 1, z, row);
  offer(y + 1, z, row);
  offer(y, z - 1, row);
  offer(y, z + 1, row);
}

/// Hands on what has grown at the tiles' edges: on one core, for rows of two tiles would be written to by both.
void TileGrid::exchange(const std::vector<RowTile*>& tiles, std::vector<RowTile*>& next) {
  next.clear();
  auto give = [&](const RowTile& from, int y, int z, const Word* row) {
    if (y < 0 || z < 0 || y >= mDims.y || z >= mDims.z) return;
    RowTile& tile = make(y, z);
    if (&tile == &from) return;
    int other = tile.rowAt(y, z);
    if (!tile.offer(other, row)) return;
    if (tile.isIdle()) next.push_back(&tile);
    tile.enqueue(other);
  };
  for (RowTile* tile : tiles) {
    for (int row : tile->border()) {
      glm::ivec2 place = tile->placeOf(row);
      const Word* bits = tile->region(row);
      give(*tile, place.x - 1, place.y, bits);
      give(*tile, place.x + 1, place.y, bits);
      give(*tile, place.x, place.y - 1, bits);
      give(*tile, place.x, place.y + 1, bits);
    }
    tile->clearBorder();
  }
}

std::size_t TileGrid::settle(const Admission& admission, const GrowDomain& domain, Progress& progress) {
  std::vector<RowTile*> active, next;
  std::size_t added = 0;
  for (const auto& tile : mTiles)
    if (tile && tile->wake(domain)) active.push_back(tile.get());
  while (!active.empty()) {
    auto settleOne = [&](std::size_t i) { active[i]->settle(admission, domain, progress); };
    if (active.size() == 1)
      settleOne(0);
    else
      parallelFor(std::size_t(0), active.size(), settleOne);
    for (RowTile* tile : active) added += tile->takeAdded();
    exchange(active, next);
    if (progress.isCancelled()) break;
    std::swap(active, next);
  }
  if (progress.isCancelled())
    for (const auto& tile : mTiles)
      if (tile) tile->rest();
  return added;
}

}  // namespace velum::growth
