#pragma once
#include <utility>
#include <vector>

#include "core/Task.h"
#include "growth/Admission.h"
#include "growth/GrowDomain.h"
#include "growth/RowBits.h"

namespace velum::growth {

/// A square of rows of voxels, as wide as the volume: what one thread grows by itself. Three bits a voxel:
/// *open*, may join (made when a row is first met), *region*, has joined, and *front*, touches what has joined and has
/// not been tried, or lay outside the domain when it was. A row with bits in its front is queued, or waits for another
/// domain.
class RowTile {
 public:
  static constexpr int kEdge = 16;  ///< rows along y and z. Of 8, 16 and 32 the fastest, see docs/PERFORMANCE.md

  /// @param first  y and z of its first row  @param dims  of the volume
  RowTile(glm::ivec2 first, glm::ivec3 dims);

  glm::ivec2 first() const { return mFirst; }
  glm::ivec2 count() const { return mCount; }
  /// A row's place here. Rows are told by it.
  int rowAt(int y, int z) const { return (z - mFirst.y) * kEdge + (y - mFirst.x); }
  glm::ivec2 placeOf(int row) const { return mFirst + glm::ivec2(row % kEdge, row / kEdge); }
  const Word* region(int row) const { return words(row, kRegion); }
  Word* region(int row) { return words(row, kRegion); }
  Word* front(int row) { return words(row, kFront); }
  const Word* open(int row, const Admission& admission);

  /// A neighbour of all that another row has: what of it is not here yet goes into the front. True when a row that
  /// waits for nothing yet has something to try now.
  bool offer(int row, const Word* neighbour) { return offer(row, neighbour, 0, mWords); }
  /// A voxel joins, wherever it lies.
  void join(int row, int x);
  /// A row with bits in its front is to be tried.
  void enqueue(int row);
  /// Rows whose front waits outside an earlier domain are tried again. False when none can lie in this one.
  bool wake(const GrowDomain& domain);
  bool isIdle() const { return mQueue.empty(); }
  /// Queued rows wait for the next domain: growing was cancelled.
  void rest();
  /// Grows until nothing here is left to try. What touches other tiles is in border() after.
  void settle(const Admission& admission, const GrowDomain& domain, const Progress& progress);

  /// Rows at the tile's edge that have grown since clearBorder().
  const std::vector<std::uint16_t>& border() const { return mBorder; }
  void clearBorder();
  /// All rows that have grown since takeChanged().
  std::vector<std::uint16_t> takeChanged();
  /// Voxels that joined since it was last asked.
  std::size_t takeAdded() { return std::exchange(mAdded, 0); }
  std::size_t visits() const { return mVisits; }

  /// A row is looked at anew: what may join has changed.
  void forget(int row);
  std::size_t bytes() const { return mBits.size() * sizeof(Word) + mFlags.size(); }

 private:
  bool offer(int row, const Word* neighbour, int firstWord, int endWord);
  enum Kind { kOpen, kRegion, kFront };
  enum Flag : std::uint8_t { kIsKnown = 1, kIsQueued = 2, kIsWaiting = 4, kIsOnBorder = 8, kHasChanged = 16 };
  const Word* words(int row, Kind kind) const { return &mBits[std::size_t(row * 3 + kind) * std::size_t(mWords)]; }
  Word* words(int row, Kind kind) { return &mBits[std::size_t(row * 3 + kind) * std::size_t(mWords)]; }
  void visit(int row, const Admission& admission, const GrowDomain& domain);
  bool fill(int row, RowSpan span);
  void handOn(int row, int firstWord, int endWord);
  void wait(int row);
  void noteGrown(int row);
  bool is(int row, Flag flag) const { return mFlags[std::size_t(row)] & flag; }
  void mark(int row, Flag flag) { mFlags[std::size_t(row)] |= flag; }
  void unmark(int row, Flag flag) { mFlags[std::size_t(row)] &= std::uint8_t(~flag); }

  glm::ivec2 mFirst, mCount;
  int mWidth, mWords;
  std::vector<Word> mBits;  ///< [row][open, region, front][word]
  std::vector<std::uint8_t> mFlags;
  std::vector<std::uint16_t> mQueue, mWaiting, mBorder, mChanged;
  std::vector<Word> mNew;  ///< of the row that is visited
  std::size_t mAdded = 0, mVisits = 0;
};

}  // namespace velum::growth
