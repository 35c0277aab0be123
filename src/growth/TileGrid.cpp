#include "growth/TileGrid.h"

#include <algorithm>

#include "core/Parallel.h"

namespace velum::growth {

namespace {

constexpr int kEdge = RowTile::kEdge;

}  // namespace

TileGrid::TileGrid(glm::ivec3 dims, int width)
    : mDims(dims),
      mWidth(width > 0 ? std::min(width, dims.x) : dims.x),
      mAlongX((dims.x + mWidth - 1) / mWidth),
      mAlongY((dims.y + kEdge - 1) / kEdge) {
  if (mAlongX == 1) mTable.resize(std::size_t(mAlongY) * std::size_t((dims.z + kEdge - 1) / kEdge));
}

RowTile* TileGrid::find(glm::ivec3 voxel) const {
  std::size_t index = indexOf(voxel);
  if (mAlongX == 1) return mTable[index];
  auto found = mSparse.find(index);
  return found == mSparse.end() ? nullptr : found->second;
}

RowTile& TileGrid::make(glm::ivec3 voxel) {
  std::size_t index = indexOf(voxel);
  RowTile*& tile = mAlongX == 1 ? mTable[index] : mSparse[index];
  if (tile) return *tile;
  glm::ivec3 size(mWidth, kEdge, kEdge);
  mTiles.push_back(std::make_unique<RowTile>(voxel / size * size, mDims, mWidth));
  tile = mTiles.back().get();
  return *tile;
}

void TileGrid::offer(glm::ivec3 first, const Word* row) {
  if (first.y < 0 || first.z < 0 || first.y >= mDims.y || first.z >= mDims.z) return;
  RowTile& tile = make(first);
  if (int other = tile.rowAt(first.y, first.z); tile.offer(other, row)) tile.enqueue(other);
}

void TileGrid::offerAround(glm::ivec3 first, const Word* row) {
  offer(first - glm::ivec3(0, 1, 0), row);
  offer(first + glm::ivec3(0, 1, 0), row);
  offer(first - glm::ivec3(0, 0, 1), row);
  offer(first + glm::ivec3(0, 0, 1), row);
}

void TileGrid::offerBeside(const RowTile& tile, int row) {
  glm::ivec2 place = tile.placeOf(row);
  auto give = [&](int x) {
    RowTile& to = make({x, place.x, place.y});
    int other = to.rowAt(place.x, place.y);
    if (to.offer(other, x - to.first().x)) to.enqueue(other);
  };
  if (tile.first().x > 0 && bitAt(tile.region(row), 0)) give(tile.first().x - 1);
  if (tile.end().x < mDims.x && bitAt(tile.region(row), tile.width() - 1)) give(tile.end().x);
}

/// Hands on what has grown at the tiles' edges: on one core, for rows of two tiles would be written to by both.
void TileGrid::exchange(const std::vector<RowTile*>& tiles, std::vector<RowTile*>& next) {
  next.clear();
  auto take = [&](RowTile& tile, int row, bool isOffered) {
    if (!isOffered) return;
    if (tile.isIdle()) next.push_back(&tile);
    tile.enqueue(row);
  };
  auto give = [&](const RowTile& from, int y, int z, const Word* row) {
    if (y < 0 || z < 0 || y >= mDims.y || z >= mDims.z) return;
    if (y >= from.first().y && z >= from.first().z && y < from.end().y && z < from.end().z) return;
    RowTile& tile = make({from.first().x, y, z});
    int other = tile.rowAt(y, z);
    take(tile, other, tile.offer(other, row));
  };
  auto giveAlong = [&](glm::ivec3 voxel) {
    RowTile& tile = make(voxel);
    int other = tile.rowAt(voxel.y, voxel.z);
    take(tile, other, tile.offer(other, voxel.x - tile.first().x));
  };
  for (RowTile* tile : tiles) {
    for (int row : tile->border()) {
      glm::ivec2 place = tile->placeOf(row);
      const Word* bits = tile->region(row);
      give(*tile, place.x - 1, place.y, bits);
      give(*tile, place.x + 1, place.y, bits);
      give(*tile, place.x, place.y - 1, bits);
      give(*tile, place.x, place.y + 1, bits);
      if (tile->first().x > 0 && bitAt(bits, 0)) giveAlong({tile->first().x - 1, place});
      if (tile->end().x < mDims.x && bitAt(bits, tile->width() - 1)) giveAlong({tile->end().x, place});
    }
    tile->clearBorder();
  }
}

std::size_t TileGrid::settle(const Admission& admission, const GrowDomain& domain, Progress& progress) {
  std::vector<RowTile*> active, next;
  std::size_t added = 0;
  for (const auto& tile : mTiles)
    if (tile->wake(domain)) active.push_back(tile.get());
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
    for (const auto& tile : mTiles) tile->rest();
  return added;
}

}  // namespace velum::growth
