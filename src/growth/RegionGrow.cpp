#include "growth/RegionGrow.h"

#include <algorithm>

#include "core/Error.h"
#include "growth/Admission.h"
#include "growth/LabelRows.h"
#include "growth/TileGrid.h"

namespace velum::growth {

namespace {

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
  void offerAround(RowTile& tile, int row);
  bool read(int y, int z, Word* bits) const;
  bool isAsLabelled(int by, int bz) const;
  void lookAnew(int by, int bz);
  bool isIn(glm::ivec3 voxel) const;
  void dropLoose();
  /// Calls body(tile, words) for the tiles in which some bits of a row lie.
  template <class Body>
  void forParts(int y, int z, const std::vector<Word>& bits, const Body& body) {
    for (int x = 0; x < tiles.dims().x; x += tiles.width()) {
      auto first = bits.begin() + x / kWordBits;
      auto end = bits.begin() + wordsOf(std::min(x + tiles.width(), tiles.dims().x));
      if (std::any_of(first, end, [](Word w) { return w != 0; })) body(tiles.make({x, y, z}), &*first);
    }
  }
};

namespace {

constexpr glm::ivec3 kBeside[] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
/// How long the rows of tiles are where bricks are read: a front fills few of them.
constexpr int kStreamedWidth = 2 * kWordBits;

}  // namespace

bool RegionGrow::State::isIn(glm::ivec3 voxel) const {
  if (!isInside(admission.grid(), voxel)) return false;
  const RowTile* tile = tiles.find(voxel);
  return tile && bitAt(tile->region(tile->rowAt(voxel.y, voxel.z)), voxel.x - tile->first().x);
}

/// What waits beside a seed that is not in the region, and beside nothing that is, waits no longer.
void RegionGrow::State::dropLoose() {
  for (glm::ivec3 seed : loose)
    for (glm::ivec3 step : kBeside) {
      glm::ivec3 voxel = seed + step;
      bool touches = std::any_of(std::begin(kBeside), std::end(kBeside), [&](glm::ivec3 s) { return isIn(voxel + s); });
      if (touches || !isInside(admission.grid(), voxel)) continue;
      RowTile& tile = tiles.make(voxel);
      clearBit(tile.front(tile.rowAt(voxel.y, voxel.z)), voxel.x - tile.first().x);
    }
  loose.clear();
}

/// Takes over what the structure has, and raises the front around it.
void RegionGrow::State::takeLabels() {
  std::vector<std::pair<RowTile*, int>> rows;
  forRowsOf(*admission.labels(), structure, [&](int y, int z, const std::vector<Word>& bits) {
    forParts(y, z, bits, [&](RowTile& tile, const Word* words) {
      int row = tile.rowAt(y, z);
      std::copy_n(words, tile.wordCount(), tile.region(row));
      rows.push_back({&tile, row});
    });
  });
  for (auto [tile, row] : rows) offerAround(*tile, row);
}

void RegionGrow::State::offerAround(RowTile& tile, int row) {
  std::vector<Word> beside(static_cast<std::size_t>(tile.wordCount()));
  offerAlong(tile, row, beside);
  glm::ivec2 place = tile.placeOf(row);
  tiles.offerAround({tile.first().x, place}, tile.region(row));
  tiles.offerBeside(tile, row);
}

bool RegionGrow::State::read(int y, int z, Word* bits) const {
  std::fill_n(bits, wordsOf(tiles.dims().x), Word(0));
  if (const RowTile* tile = tiles.find({0, y, z}); tiles.width() == tiles.dims().x) {
    if (tile) std::copy_n(tile->region(tile->rowAt(y, z)), tile->wordCount(), bits);
    return tile != nullptr;
  }
  bool isThere = false;
  tiles.forRow(y, z, [&](const RowTile& tile) {
    isThere = true;
    std::copy_n(tile.region(tile.rowAt(y, z)), tile.wordCount(), bits + tile.firstWord());
  });
  return isThere;
}

/// True when the region has in these bricks what the structure has in the labels.
bool RegionGrow::State::isAsLabelled(int by, int bz) const {
  bool isSame = true;
  std::vector<Word> bits(static_cast<std::size_t>(wordsOf(tiles.dims().x))), region(bits.size());
  forBrickRows(tiles.dims(), by, bz, [&](int y, int z) {
    labelBits(*admission.labels(), y, z, std::uint16_t(structure), bits.data());
    read(y, z, region.data());
    isSame = isSame && bits == region;
  });
  return isSame;
}

/// Voxels have got or lost an owner: which may join, and what touches the region, is found again.
void RegionGrow::State::lookAnew(int by, int bz) {
  forBrickRows(tiles.dims(), by, bz,
               [&](int y, int z) { tiles.forRow(y, z, [&](RowTile& tile) { tile.forget(tile.rowAt(y, z)); }); });
  int low = by * kLabelBrick - 1, high = (by + 1) * kLabelBrick;
  for (int z = std::max(bz * kLabelBrick - 1, 0); z <= std::min((bz + 1) * kLabelBrick, tiles.dims().z - 1); ++z)
    for (int y = std::max(low, 0); y <= std::min(high, tiles.dims().y - 1); ++y)
      tiles.forRow(y, z, [&](RowTile& tile) { offerAround(tile, tile.rowAt(y, z)); });
}

RegionGrow::RegionGrow(Shared<Volume> volume, const Shared<LabelVolume>& labels, int structure, GrowRule rule) {
  checkRule(rule, *volume);
  FinestVoxels voxels(*volume);
  glm::ivec3 dims = voxels.grid().dims;
  if (dims != labels->dims()) throw ArgumentError("the labels to grow in are not on the grid of the volume");
  mState.reset(new State{Admission(std::move(volume), labels, std::move(rule)),
                         TileGrid(dims, voxels.isStreamed() ? kStreamedWidth : 0),
                         structure,
                         0,
                         {}});
  if (structure == 0) return;
  mState->takeLabels();
  mCount = countIn(GrowDomain());
}

RegionGrow::~RegionGrow() = default;
RegionGrow::RegionGrow(RegionGrow&&) noexcept = default;
RegionGrow& RegionGrow::operator=(RegionGrow&&) noexcept = default;

void RegionGrow::addSeed(glm::ivec3 voxel) {
  const Volume& grid = mState->admission.grid();
  if (!isInside(grid, voxel)) return;
  RowTile& tile = mState->tiles.make(voxel);
  int row = tile.rowAt(voxel.y, voxel.z), x = voxel.x - tile.first().x;
  if (!bitAt(tile.region(row), x)) {
    if (tile.open(row, x / kWordBits, mState->admission) >> (x % kWordBits) & 1) {
      tile.join(row, x);
      ++mCount, ++mState->fromSeeds;
    } else {
      mState->loose.push_back(voxel);
    }
  }
  // Its neighbours are tried whether it joined or not.
  for (glm::ivec3 step : kBeside) {
    glm::ivec3 beside = voxel + step;
    if (!isInside(grid, beside)) continue;
    RowTile& to = mState->tiles.make(beside);
    int other = to.rowAt(beside.y, beside.z);
    if (to.offer(other, beside.x - to.first().x)) to.enqueue(other);
  }
}

void RegionGrow::addSeeds(const LabelVolume& labels, int structure) {
  forRowsOf(labels, structure, [&](int y, int z, const std::vector<Word>& bits) {
    mState->forParts(y, z, bits, [&](RowTile& tile, const Word* words) {
      int row = tile.rowAt(y, z);
      std::size_t joined = 0;
      for (int w = 0; w < tile.wordCount(); ++w) {
        Word left = words[w] & ~tile.region(row)[w];
        if (left != 0) left &= tile.open(row, w, mState->admission);
        for (; left != 0; left &= left - 1, ++joined) tile.join(row, w * kWordBits + std::countr_zero(left));
      }
      if (joined == 0) return;
      mCount += joined, mState->fromSeeds += joined;
      mState->offerAround(tile, row);
    });
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
    box.first = glm::min(box.first, tile.first());
    box.end = glm::max(box.end, tile.end());
  });
  return box;
}

bool RegionGrow::has(glm::ivec3 voxel) const { return mState->isIn(voxel); }

std::uint64_t RegionGrow::word(int y, int z, int w) const {
  const RowTile* tile = mState->tiles.find({w * kWordBits, y, z});
  return tile ? tile->region(tile->rowAt(y, z))[w - tile->firstWord()] : 0;
}

bool RegionGrow::read(int y, int z, std::uint64_t* bits) const { return mState->read(y, z, bits); }

std::size_t RegionGrow::countIn(const GrowDomain& domain) const {
  std::size_t count = 0;
  mState->tiles.forSpans(domain, [&](const RowTile& tile, int row, RowSpan span) {
    const Word* bits = tile.region(row);
    for (int w = span.first / kWordBits; w * kWordBits < span.end; ++w)
      count += std::size_t(countBits(bits[w] & spanBits(w, span.first, span.end)));
  });
  return count;
}

std::vector<glm::ivec2> RegionGrow::rowsIn(const GrowDomain& domain) const {
  std::vector<glm::ivec2> rows;
  mState->tiles.forSpans(domain, [&](const RowTile& tile, int row, RowSpan span) {
    Word any = 0;
    for (int w = span.first / kWordBits; w * kWordBits < span.end; ++w)
      any |= tile.region(row)[w] & spanBits(w, span.first, span.end);
    if (any != 0) rows.push_back(tile.placeOf(row));
  });
  std::sort(rows.begin(), rows.end(), [](auto a, auto b) { return std::pair(a.y, a.x) < std::pair(b.y, b.x); });
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

RegionGrow::Changed RegionGrow::takeChanged() {
  Changed changed;
  glm::ivec3 low(mState->tiles.dims()), high(0);
  mState->tiles.forEach([&](RowTile& tile) {
    for (int row : tile.takeChanged()) {
      glm::ivec2 place = tile.placeOf(row);
      const Word* bits = tile.region(row);
      int first = 0, last = tile.wordCount() - 1;
      while (bits[first] == 0) ++first;
      while (bits[last] == 0) --last;
      low = glm::min(low, glm::ivec3((tile.firstWord() + first) * kWordBits, place));
      high = glm::max(high, glm::ivec3(std::min((tile.firstWord() + last + 1) * kWordBits, tile.end().x), place + 1));
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
