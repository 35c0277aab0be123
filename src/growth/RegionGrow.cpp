#include "growth/RegionGrow.h"

#include <algorithm>

#include "core/Error.h"
#include "growth/Admission.h"
#include "growth/TileGrid.h"

namespace velum::growth {

namespace {

constexpr int kBrick = LabelVolume::kBrickSize;

bool holdsLabel(const LabelVolume::Brick& brick, int id) {
  return std::any_of(brick.begin(), brick.end(), [&](std::uint16_t is) { return is == id; });
}

/// Calls body(y, z) for the rows of a brick, once for all bricks along a row.
template <class Body>
void forRows(glm::ivec3 dims, int by, int bz, const Body& body) {
  for (int z = bz * kBrick; z < std::min((bz + 1) * kBrick, dims.z); ++z)
    for (int y = by * kBrick; y < std::min((by + 1) * kBrick, dims.y); ++y) body(y, z);
}

/// Bits beside those that are set, in their own row.
void offerAlong(RowTile& tile, int row, std::vector<Word>& beside) {
  const Word* region = tile.region(row);
  std::size_t words = beside.size();
  for (std::size_t w = 0; w < words; ++w) {
    beside[w] = region[w] << 1 | region[w] >> 1;
    if (w > 0) beside[w] |= region[w - 1] >> (kWordBits - 1);
    if (w + 1 < words) beside[w] |= region[w + 1] << (kWordBits - 1);
  }
  if (tile.offer(row, beside.data())) tile.enqueue(row);
}

}  // namespace

struct RegionGrow::State {
  Admission admission;
  TileGrid tiles;
  int structure;
  std::size_t fromSeeds = 0;
  std::vector<glm::ivec3> loose;  ///< seeds that could not join

  void takeLabels();
  void offerAround(int y, int z);
  bool isAsLabelled(int by, int bz) const;
  void lookAnew(int by, int bz);
  bool isIn(glm::ivec3 voxel) const;
  void dropLoose();
};

constexpr glm::ivec3 kBeside[] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};

bool RegionGrow::State::isIn(glm::ivec3 voxel) const {
  if (!isInside(admission.grid(), voxel)) return false;
  const RowTile* tile = tiles.find(voxel.y, voxel.z);
  return tile && bitAt(tile->region(tile->rowAt(voxel.y, voxel.z)), voxel.x);
}

/// What waits beside a seed that is not in the region, and beside nothing that is, waits no longer.
void RegionGrow::State::dropLoose() {
  for (glm::ivec3 seed : loose)
    for (glm::ivec3 step : kBeside) {
      glm::ivec3 voxel = seed + step;
      bool touches = std::any_of(std::begin(kBeside), std::end(kBeside), [&](glm::ivec3 s) { return isIn(voxel + s); });
      if (touches || !isInside(admission.grid(), voxel)) continue;
      RowTile& tile = tiles.make(voxel.y, voxel.z);
      clearBit(tile.front(tile.rowAt(voxel.y, voxel.z)), voxel.x);
    }
  loose.clear();
}

/// Calls body(y, z, bits) for each row in which a structure has voxels.
template <class Body>
void forRowsOf(const LabelVolume& labels, int structure, const Body& body) {
  glm::ivec3 grid = labels.brickGrid();
  std::vector<Word> bits(static_cast<std::size_t>(wordsOf(labels.dims().x)));
  for (int bz = 0; bz < grid.z; ++bz)
    for (int by = 0; by < grid.y; ++by) {
      bool isThere = false;
      for (int bx = 0; bx < grid.x; ++bx) isThere = isThere || holdsLabel(labels.brick({bx, by, bz}), structure);
      if (!isThere) continue;
      forRows(labels.dims(), by, bz, [&](int y, int z) {
        labelBits(labels, y, z, std::uint16_t(structure), bits.data());
        if (std::any_of(bits.begin(), bits.end(), [](Word w) { return w != 0; })) body(y, z, bits);
      });
    }
}

/// Takes over what the structure has, and raises the front around it.
void RegionGrow::State::takeLabels() {
  std::vector<glm::ivec2> rows;
  forRowsOf(*admission.labels(), structure, [&](int y, int z, const std::vector<Word>& bits) {
    RowTile& tile = tiles.make(y, z);
    std::copy(bits.begin(), bits.end(), tile.region(tile.rowAt(y, z)));
    rows.push_back({y, z});
  });
  for (glm::ivec2 row : rows) offerAround(row.x, row.y);
}

void RegionGrow::State::offerAround(int y, int z) {
  RowTile& tile = *tiles.find(y, z);
  int row = tile.rowAt(y, z);
  std::vector<Word> beside(static_cast<std::size_t>(wordsOf(tiles.dims().x)));
  offerAlong(tile, row, beside);
  tiles.offerAround(y, z, tile.region(row));
}

/// True when the region has in these bricks what the structure has in the labels.
bool RegionGrow::State::isAsLabelled(int by, int bz) const {
  bool isSame = true;
  std::vector<Word> bits(static_cast<std::size_t>(wordsOf(tiles.dims().x)));
  forRows(tiles.dims(), by, bz, [&](int y, int z) {
    labelBits(*admission.labels(), y, z, std::uint16_t(structure), bits.data());
    const RowTile* tile = tiles.find(y, z);
    const Word* region = tile ? tile->region(tile->rowAt(y, z)) : nullptr;
    for (std::size_t w = 0; w < bits.size(); ++w) isSame = isSame && bits[w] == (region ? region[w] : 0);
  });
  return isSame;
}

/// Voxels have got or lost an owner: which may join, and what touches the region, is found again.
void RegionGrow::State::lookAnew(int by, int bz) {
  forRows(tiles.dims(), by, bz, [&](int y, int z) {
    if (RowTile* tile = tiles.find(y, z)) tile->forget(tile->rowAt(y, z));
  });
  int low = by * kBrick - 1, high = (by + 1) * kBrick;
  for (int z = std::max(bz * kBrick - 1, 0); z <= std::min((bz + 1) * kBrick, tiles.dims().z - 1); ++z)
    for (int y = std::max(low, 0); y <= std::min(high, tiles.dims().y - 1); ++y)
      if (tiles.find(y, z)) offerAround(y, z);
}

RegionGrow::RegionGrow(Shared<Volume> volume, const Shared<LabelVolume>& labels, int structure, GrowRule rule) {
  checkRule(rule, *volume);
  glm::ivec3 dims = FinestVoxels(*volume).grid().dims;
  if (dims != labels->dims()) throw ArgumentError("the labels to grow in are not on the grid of the volume");
  mState.reset(new State{Admission(std::move(volume), labels, std::move(rule)), TileGrid(dims), structure, 0, {}});
  if (structure == 0) return;
  mState->takeLabels();
  mCount = countIn(GrowDomain());
}

RegionGrow::~RegionGrow() = default;
RegionGrow::RegionGrow(RegionGrow&&) noexcept = default;
RegionGrow& RegionGrow::operator=(RegionGrow&&) noexcept = default;

void RegionGrow::addSeed(glm::ivec3 voxel) {
  if (!isInside(mState->admission.grid(), voxel)) return;
  RowTile& tile = mState->tiles.make(voxel.y, voxel.z);
  int row = tile.rowAt(voxel.y, voxel.z);
  if (!bitAt(tile.region(row), voxel.x)) {
    if (tile.open(row, voxel.x / kWordBits, mState->admission) >> (voxel.x % kWordBits) & 1) {
      tile.join(row, voxel.x);
      ++mCount, ++mState->fromSeeds;
    } else {
      mState->loose.push_back(voxel);
    }
  }
  // Its neighbours are tried whether it joined or not.
  std::vector<Word> seed(static_cast<std::size_t>(wordsOf(mState->tiles.dims().x)));
  setBit(seed.data(), voxel.x);
  mState->tiles.offerAround(voxel.y, voxel.z, seed.data());
  std::fill(seed.begin(), seed.end(), Word(0));
  if (voxel.x > 0) setBit(seed.data(), voxel.x - 1);
  if (voxel.x + 1 < mState->tiles.dims().x) setBit(seed.data(), voxel.x + 1);
  if (tile.offer(row, seed.data())) tile.enqueue(row);
}

void RegionGrow::addSeeds(const LabelVolume& labels, int structure) {
  forRowsOf(labels, structure, [&](int y, int z, const std::vector<Word>& bits) {
    RowTile& tile = mState->tiles.make(y, z);
    int row = tile.rowAt(y, z);
    std::size_t joined = 0;
    for (int w = 0; w < int(bits.size()); ++w) {
      Word left = bits[std::size_t(w)] & ~tile.region(row)[w];
      if (left != 0) left &= tile.open(row, w, mState->admission);
      for (; left != 0; left &= left - 1, ++joined) tile.join(row, w * kWordBits + std::countr_zero(left));
    }
    if (joined == 0) return;
    mCount += joined, mState->fromSeeds += joined;
    mState->offerAround(y, z);
  });
}

void RegionGrow::forgetSeeds() { mState->dropLoose(); }

std::size_t RegionGrow::grow(const GrowDomain& domain, Progress& progress) {
  std::size_t added = mState->tiles.settle(mState->admission, domain, progress);
  mCount += added;
  progress.throwIfCancelled();
  return added + std::exchange(mState->fromSeeds, 0);
}

VoxelBox RegionGrow::reach() const {
  VoxelBox box{mState->tiles.dims(), glm::ivec3(0)};
  mState->tiles.forEach([&](const RowTile& tile) {
    box.first = glm::min(box.first, glm::ivec3(0, tile.first()));
    box.end = glm::max(box.end, glm::ivec3(mState->tiles.dims().x, tile.first() + tile.count()));
  });
  return box;
}

bool RegionGrow::has(glm::ivec3 voxel) const { return mState->isIn(voxel); }

const std::uint64_t* RegionGrow::row(int y, int z) const {
  const RowTile* tile = std::as_const(mState->tiles).find(y, z);
  return tile ? tile->region(tile->rowAt(y, z)) : nullptr;
}

std::size_t RegionGrow::countIn(const GrowDomain& domain) const {
  std::size_t count = 0;
  int width = mState->tiles.dims().x;
  mState->tiles.forEach([&](const RowTile& tile) {
    if (!domain.mayMeet({0, tile.first()}, {width - 1, tile.first() + tile.count() - 1})) return;
    for (int row = 0; row < tile.count().y * RowTile::kEdge; ++row) {
      if (row % RowTile::kEdge >= tile.count().x) continue;
      glm::ivec2 place = tile.placeOf(row);
      RowSpan span = domain.rowSpan(place.x, place.y, width);
      const Word* bits = tile.region(row);
      for (int w = span.first / kWordBits; w * kWordBits < span.end; ++w)
        count += std::size_t(countBits(bits[w] & spanBits(w, span.first, span.end)));
    }
  });
  return count;
}

RegionGrow::Changed RegionGrow::takeChanged() {
  Changed changed;
  int words = wordsOf(mState->tiles.dims().x);
  glm::ivec3 low(mState->tiles.dims()), high(0);
  mState->tiles.forEach([&](RowTile& tile) {
    for (int row : tile.takeChanged()) {
      glm::ivec2 place = tile.placeOf(row);
      const Word* bits = tile.region(row);
      int first = 0, last = words - 1;
      while (bits[first] == 0) ++first;
      while (bits[last] == 0) --last;
      low = glm::min(low, glm::ivec3(first * kWordBits, place));
      high = glm::max(high, glm::ivec3(std::min((last + 1) * kWordBits, mState->tiles.dims().x), place + 1));
      changed.rows.push_back(place);
    }
  });
  if (!changed.rows.empty()) changed.box = {low, high};
  return changed;
}

bool RegionGrow::follow(const Shared<LabelVolume>& labels) {
  Shared<LabelVolume> before = mState->admission.labels();
  if (before == labels) return true;
  if (before->dims() != labels->dims()) return false;
  mState->admission.setLabels(labels);
  glm::ivec3 grid = labels->brickGrid();
  for (int bz = 0; bz < grid.z; ++bz)
    for (int by = 0; by < grid.y; ++by) {
      bool differs = false;
      for (int bx = 0; bx < grid.x; ++bx)
        differs = differs || before->brickId({bx, by, bz}) != labels->brickId({bx, by, bz});
      if (!differs) continue;
      if (!mState->isAsLabelled(by, bz)) return false;
      mState->lookAnew(by, bz);
    }
  return true;
}

void RegionGrow::adopt(const Shared<LabelVolume>& labels) { mState->admission.setLabels(labels); }

const GrowRule& RegionGrow::rule() const { return mState->admission.rule(); }

std::size_t RegionGrow::bytes() const {
  std::size_t bytes = 0;
  mState->tiles.forEach([&](const RowTile& tile) { bytes += tile.bytes(); });
  return bytes;
}

std::size_t RegionGrow::visits() const {
  std::size_t visits = 0;
  mState->tiles.forEach([&](const RowTile& tile) { visits += tile.visits(); });
  return visits;
}

}  // namespace velum::growth
