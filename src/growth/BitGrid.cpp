#include "growth/BitGrid.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <map>
#include <utility>

#include "core/Parallel.h"

namespace velum::growth {

namespace {

void orInto(Word* row, const Word* more, int words) {
  for (int w = 0; w < words; ++w) row[w] |= more[w];
}

/// Each bit becomes a run, from `low` to `high` beside it. @param spare  a row
void spreadRow(const Word* from, int low, int high, Word* to, Word* spare, const BitGrid& grid) {
  // Up and down by turns from what of the run is nearest: what is shifted out of the row is lost.
  int start = std::clamp(0, low, high), width = grid.dims().x;
  auto spread = [&](int count, int direction) {
    for (int done = 0, more; done < count; done += more) {
      more = std::min(done + 1, count - done);
      shiftRow(to, grid.words(), direction * more, spare, grid.words(), width);
      orInto(to, spare, grid.words());
    }
  };
  shiftRow(from, grid.words(), start, to, grid.words(), width);
  spread(high - start, 1);
  spread(start - low, -1);
}

}  // namespace

void BitGrid::invert() {
  for (Word& bits : mBits) bits = ~bits;
  Word last = spanBits(mWords - 1, 0, mDims.x);
  for (std::size_t w = std::size_t(mWords - 1); w < mBits.size(); w += std::size_t(mWords)) mBits[w] &= last;
}

void shiftRow(const Word* from, int fromWords, int by, Word* to, int toWords, int toWidth) {
  // Word w takes bits of two words, `whole` and one below.
  int whole = by >= 0 ? by / kWordBits : -((-by + kWordBits - 1) / kWordBits), bits = by - whole * kWordBits;
  auto word = [&](int w) { return w >= 0 && w < fromWords ? from[w] : Word(0); };
  for (int w = 0; w < toWords; ++w) {
    to[w] = word(w - whole) << bits;
    if (bits > 0) to[w] |= word(w - whole - 1) >> (kWordBits - bits);
  }
  to[toWords - 1] &= spanBits(toWords - 1, 0, toWidth);
}

std::vector<BallRow> ballRows(const glm::dmat3& worldFromVoxel, double radius) {
  // What lies at the radius, but for rounding, is in.
  double within = radius * radius * (1.0 + 1e-9);
  glm::dmat3 voxelFromWorld = glm::inverse(worldFromVoxel);
  glm::ivec3 reach;
  for (int axis = 0; axis < 3; ++axis) reach[axis] = int(radius * glm::length(glm::row(voxelFromWorld, axis)) + 1e-6);
  std::vector<BallRow> rows;
  for (int z = -reach.z; z <= reach.z; ++z)
    for (int y = -reach.y; y <= reach.y; ++y) {
      BallRow row{y, z, 1, 0};
      for (int x = -reach.x; x <= reach.x; ++x) {
        glm::dvec3 step = worldFromVoxel * glm::dvec3(x, y, z);
        if (glm::dot(step, step) > within) continue;
        if (row.low > row.high) row.low = x;
        row.high = x;
      }
      if (row.low <= row.high) rows.push_back(row);
    }
  return rows;
}

BitGrid dilated(const BitGrid& grid, const std::vector<BallRow>& ball) {
  std::map<std::pair<int, int>, std::vector<glm::ivec2>> byRun;
  for (const BallRow& row : ball) byRun[{row.low, row.high}].push_back({row.y, row.z});
  BitGrid out(grid.dims()), spread(grid.dims());
  for (const auto& [run, offsets] : byRun) {
    parallelFor(0, grid.dims().z, [&, run = run](int z) {
      std::vector<Word> spare(static_cast<std::size_t>(grid.words()));
      for (int y = 0; y < grid.dims().y; ++y)
        spreadRow(grid.row(y, z), run.first, run.second, spread.row(y, z), spare.data(), grid);
    });
    parallelFor(0, grid.dims().z, [&, &offsets = offsets](int z) {
      for (int y = 0; y < grid.dims().y; ++y)
        for (glm::ivec2 by : offsets)
          if (spread.holdsRow(y - by.x, z - by.y)) orInto(out.row(y, z), spread.row(y - by.x, z - by.y), grid.words());
    });
  }
  return out;
}

namespace {

/// Rows that have something new, each once, until none has.
class Flood {
 public:
  explicit Flood(const BitGrid& open)
      : mOpen(open), mReached(open.dims()), mIsQueued(std::size_t(open.dims().y) * std::size_t(open.dims().z)) {}

  BitGrid fromBorder() {
    glm::ivec3 dims = mOpen.dims();
    std::vector<Word> ends(static_cast<std::size_t>(mOpen.words())), all(ends.size(), ~Word(0));
    setBit(ends.data(), 0);
    setBit(ends.data(), dims.x - 1);
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        offer(y, z, y == 0 || z == 0 || y + 1 == dims.y || z + 1 == dims.z ? all.data() : ends.data());
    for (std::size_t head = 0; head < mQueue.size(); ++head) visit(mQueue[head]);
    return std::move(mReached);
  }

 private:
  void offer(int y, int z, const Word* from) {
    if (!mOpen.holdsRow(y, z)) return;
    const Word* open = mOpen.row(y, z);
    Word *reached = mReached.row(y, z), any = 0;
    for (int w = 0; w < mOpen.words(); ++w) {
      Word added = from[w] & open[w] & ~reached[w];
      reached[w] |= added;
      any |= added;
    }
    auto&& isQueued = mIsQueued[std::size_t(z) * std::size_t(mOpen.dims().y) + std::size_t(y)];
    if (any == 0 || isQueued) return;
    isQueued = true;
    mQueue.push_back({y, z});
  }

  void visit(glm::ivec2 place) {
    auto [y, z] = std::pair(place.x, place.y);
    mIsQueued[std::size_t(z) * std::size_t(mOpen.dims().y) + std::size_t(y)] = false;
    const Word* open = mOpen.row(y, z);
    Word *reached = mReached.row(y, z), carry = 0, above = 0;
    for (int w = 0; w < mOpen.words(); ++w) reached[w] = fillUp(open[w], reached[w], carry);
    for (int w = mOpen.words(); w-- > 0;) {
      reached[w] = fillDown(open[w], reached[w] | (above & open[w]));
      above = reached[w] << (kWordBits - 1);
    }
    offer(y - 1, z, reached);
    offer(y + 1, z, reached);
    offer(y, z - 1, reached);
    offer(y, z + 1, reached);
  }

  const BitGrid& mOpen;
  BitGrid mReached;
  std::vector<glm::ivec2> mQueue;
  std::vector<bool> mIsQueued;
};

}  // namespace

BitGrid joinedToBorder(const BitGrid& open) { return Flood(open).fromBorder(); }

}  // namespace velum::growth
