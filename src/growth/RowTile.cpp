#include "growth/RowTile.h"

#include <algorithm>
#include <utility>

namespace velum::growth {

namespace {

/// Rows are visited in so many before somebody is asked whether to go on.
constexpr std::size_t kVisitsUncancelled = 64;

}  // namespace

RowTile::RowTile(glm::ivec3 first, glm::ivec3 dims, int width)
    : mFirst(first),
      mCount(glm::min(glm::ivec2(kEdge), glm::ivec2(dims.y - first.y, dims.z - first.z))),
      mWidth(std::min(width, dims.x - first.x)),
      mWords(wordsOf(mWidth)),
      mHasBefore(first.x > 0),
      mHasBehind(first.x + mWidth < dims.x),
      mBits(std::size_t(kEdge * mCount.y * 3) * std::size_t(mWords)),
      mFlags(std::size_t(kEdge * mCount.y)),
      mNew(static_cast<std::size_t>(mWords)) {}

RowSpan RowTile::spanOf(int row, const GrowDomain& domain) const {
  glm::ivec2 place = placeOf(row);
  RowSpan span = domain.rowSpan(place.x, place.y, mFirst.x + mWidth);
  span = {std::max(span.first - mFirst.x, 0), span.end - mFirst.x};
  return span.isEmpty() ? RowSpan{} : span;
}

/// Makes a word of a row known, and with it, where that costs nothing but time, the row.
void RowTile::know(int row, int word, const Admission& admission) {
  if (is(row, kIsKnown)) return;
  glm::ivec2 place = placeOf(row);
  if (!admission.isPiecewise()) {
    admission.open(place.x, place.y, {firstWord(), firstWord() + mWords}, words(row, kOpen));
    mark(row, kIsKnown);
    return;
  }
  if (mKnown.empty()) mKnown.resize(mFlags.size() * std::size_t(wordsOf(mWords)));
  if (bitAt(known(row), word)) return;
  int inVolume = firstWord() + word;
  admission.open(place.x, place.y, {inVolume, inVolume + 1}, words(row, kOpen) + word);
  setBit(known(row), word);
}

bool RowTile::offer(int row, const Word* neighbour, int firstWord, int endWord) {
  const Word *open = words(row, kOpen), *region = words(row, kRegion);
  Word* front = words(row, kFront);
  Word any = 0, unknown = is(row, kIsKnown) ? 0 : ~Word(0);
  auto take = [&](int w, Word may) {
    Word offered = neighbour[w] & ~region[w] & may;
    front[w] |= offered;
    any |= offered;
  };
  if (const Word* known = this->known(row))
    for (int w = firstWord; w < endWord; ++w) take(w, bitAt(known, w) ? open[w] : ~Word(0));
  else
    for (int w = firstWord; w < endWord; ++w) take(w, open[w] | unknown);
  return any != 0;
}

/// True where a voxel may still join as far as that is known.
bool RowTile::mayJoin(int row, int x) {
  if (bitAt(region(row), x)) return false;
  if (is(row, kIsKnown)) return bitAt(words(row, kOpen), x);
  const Word* known = this->known(row);
  return !known || !bitAt(known, x / kWordBits) || bitAt(words(row, kOpen), x);
}

bool RowTile::offer(int row, int x) {
  if (!mayJoin(row, x)) return false;
  setBit(front(row), x);
  return true;
}

void RowTile::join(int row, int x) {
  setBit(region(row), x);
  clearBit(front(row), x);
  noteGrown(row);
}

void RowTile::noteGrown(int row) {
  if (is(row, kHasChanged)) return;
  mark(row, kHasChanged);
  mChanged.push_back(std::uint16_t(row));
}

void RowTile::enqueue(int row) {
  if (is(row, kIsQueued)) return;
  mark(row, kIsQueued);
  mQueue.push_back(std::uint16_t(row));
}

void RowTile::wait(int row) {
  if (is(row, kIsWaiting)) return;
  mark(row, kIsWaiting);
  mWaiting.push_back(std::uint16_t(row));
}

bool RowTile::wake(const GrowDomain& domain) {
  if (mWaiting.empty() || !domain.mayMeet(mFirst, end() - 1)) return !mQueue.empty();
  for (int row : mWaiting) {
    unmark(row, kIsWaiting);
    enqueue(row);
  }
  mWaiting.clear();
  return true;
}

void RowTile::rest() {
  for (int row : mQueue) {
    unmark(row, kIsQueued);
    wait(row);
  }
  mQueue.clear();
}

void RowTile::clearBorder() {
  for (int row : mBorder) unmark(row, kIsOnBorder);
  mBorder.clear();
}

std::vector<std::uint16_t> RowTile::takeChanged() {
  for (int row : mChanged) unmark(row, kHasChanged);
  return std::exchange(mChanged, {});
}

void RowTile::forget(int row) {
  unmark(row, kIsKnown);
  if (Word* known = this->known(row)) {
    std::fill_n(known, wordsOf(mWords), Word(0));
    std::fill_n(words(row, kOpen), mWords, Word(0));
  }
  std::fill_n(words(row, kFront), mWords, Word(0));
}

void RowTile::settle(const Admission& admission, const GrowDomain& domain, const Progress& progress) {
  for (std::size_t head = 0; head < mQueue.size();) {
    // Where bricks are read a visit may take long.
    if ((admission.isPiecewise() || head % kVisitsUncancelled == 0) && progress.isCancelled()) {
      mQueue.erase(mQueue.begin(), mQueue.begin() + std::ptrdiff_t(head));
      return;
    }
    visit(mQueue[head++], admission, domain);
  }
  mQueue.clear();
}

/// False where nothing joins. What joins is in mNew, in the words of the span. Words that are not known have no voxel
/// that is open: they become known where the front is, and where a run goes on into them.
bool RowTile::fill(int row, RowSpan span, const Admission& admission) {
  const Word* open = words(row, kOpen);
  Word *region = words(row, kRegion), *front = words(row, kFront), *added = mNew.data();
  int from = span.first / kWordBits, end = wordsOf(span.end);
  if (!admission.isPiecewise()) know(row, from, admission);
  bool asks = !is(row, kIsKnown);
  Word any = 0, carry = 0;
  for (int w = from; w < end; ++w) {
    Word inside = spanBits(w, span.first, span.end);
    if (asks && ((front[w] & inside) != 0 || carry != 0)) know(row, w, admission);
    Word may = open[w] & ~region[w] & inside, seeds = front[w] & may;
    front[w] &= ~inside;
    any |= seeds;
    added[w] = fillUp(may, seeds, carry);
  }
  if (any == 0) return false;
  Word above = 0;
  for (int w = end; w-- > from;) {
    if (asks && above != 0) know(row, w, admission);
    Word may = open[w] & ~region[w] & spanBits(w, span.first, span.end);
    Word filled = fillDown(may, added[w] | (above & may));
    added[w] = filled;
    above = filled << (kWordBits - 1);
    region[w] |= filled;
    mAdded += std::size_t(countBits(filled));
  }
  // What goes on behind the ends of the domain waits there.
  auto leave = [&](int inside, int x) {
    if (x >= 0 && x < mWidth && bitAt(added, inside)) offer(row, x);
  };
  leave(span.first, span.first - 1);
  leave(span.end - 1, span.end);
  return true;
}

void RowTile::handOn(int row, int firstWord, int endWord) {
  int y = row % kEdge, z = row / kEdge;
  auto give = [&](int other) {
    if (offer(other, mNew.data(), firstWord, endWord)) enqueue(other);
  };
  if (y > 0) give(row - 1);
  if (y + 1 < mCount.x) give(row + 1);
  if (z > 0) give(row - kEdge);
  if (z + 1 < mCount.y) give(row + kEdge);
  bool isAtEdge = y == 0 || z == 0 || y + 1 == mCount.x || z + 1 == mCount.y;
  isAtEdge = isAtEdge || (mHasBefore && bitAt(region(row), 0)) || (mHasBehind && bitAt(region(row), mWidth - 1));
  if (isAtEdge && !is(row, kIsOnBorder)) {
    mark(row, kIsOnBorder);
    mBorder.push_back(std::uint16_t(row));
  }
}

void RowTile::visit(int row, const Admission& admission, const GrowDomain& domain) {
  ++mVisits;
  unmark(row, kIsQueued);
  RowSpan span = spanOf(row, domain);
  Word* front = words(row, kFront);
  int from = span.first / kWordBits, end = wordsOf(span.end);
  Word inside = 0, all = 0;
  for (int w = from; w < end; ++w) inside |= front[w] & spanBits(w, span.first, span.end);
  bool hasGrown = false;
  if (inside != 0) hasGrown = fill(row, span, admission);
  for (int w = 0; w < mWords; ++w) all |= front[w];
  if (all != 0) wait(row);
  if (!hasGrown) return;
  noteGrown(row);
  handOn(row, from, end);
}

}  // namespace velum::growth
