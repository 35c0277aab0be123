#pragma once
#include <utility>
#include <vector>

#include "core/Task.h"
#include "growth/Admission.h"
#include "growth/GrowDomain.h"
#include "growth/RowBits.h"

namespace velum::growth {

/// A square (in y and z) of rows of voxels, as long as the volume is wide, or a part of that: the part of a region that
/// one thread grows by itself. All places along x are counted from the tile's first voxel. Each voxel has three bits:
/// *open*, it may join (made when a row is first met, or, where that may have to be read, when the front comes to its
/// word); *region*, it has joined; and *front*, it touches the region but has not been tried, or lay outside the domain
/// when it was. A row with bits in its front is queued, or waits for another domain.
class RowTile {
 public:
  static constexpr int kEdge = 16;  ///< rows along y and z. Of 8, 16 and 32 the fastest, see docs/PERFORMANCE.md

  /// @param first  the tile's first voxel, along x the first of a word @param dims  of the volume @param width  voxels
  /// of its rows, where the volume has so many
  RowTile(glm::ivec3 first, glm::ivec3 dims, int width);

  glm::ivec3 first() const { return mFirst; }
  /// One past the last voxel.
  glm::ivec3 end() const { return mFirst + glm::ivec3(mWidth, mCount); }
  glm::ivec2 count() const { return mCount; }
  int width() const { return mWidth; }
  int wordCount() const { return mWords; }
  /// Its first word in the rows of the volume.
  int firstWord() const { return mFirst.x / kWordBits; }
  /// Number of a row within the tile; all functions below name rows by this number.
  int rowAt(int y, int z) const { return (z - mFirst.z) * kEdge + (y - mFirst.y); }
  glm::ivec2 placeOf(int row) const { return {mFirst.y + row % kEdge, mFirst.z + row / kEdge}; }
  /// The part of a row that lies in a domain.
  RowSpan spanOf(int row, const GrowDomain& domain) const;
  const Word* region(int row) const { return words(row, kRegion); }
  Word* region(int row) { return words(row, kRegion); }
  Word* front(int row) { return words(row, kFront); }
  Word open(int row, int word, const Admission& admission) {
    know(row, word, admission);
    return words(row, kOpen)[word];
  }

  /// Tells a row which voxels a neighbouring row has: those that have not joined here and may still join go into the
  /// row's front. True when there are any, so that the row is to be queued.
  bool offer(int row, const Word* neighbour) { return offer(row, neighbour, 0, mWords); }
  /// The same for a single voxel beside one that a neighbour has.
  bool offer(int row, int x);
  /// Makes a voxel part of the region, wherever it lies.
  void join(int row, int x);
  /// Queues a row with bits in its front, to be tried.
  void enqueue(int row);
  /// Queues the rows whose front waited outside an earlier domain. False when none of them can lie in this domain.
  bool wake(const GrowDomain& domain);
  bool isIdle() const { return mQueue.empty(); }
  /// Makes the queued rows wait for the next domain, after growing was cancelled.
  void rest();
  /// Grows until nothing in this tile is left to try. Rows that touch other tiles are in border() afterwards.
  void settle(const Admission& admission, const GrowDomain& domain, const Progress& progress);

  /// Rows at the tile's edge that have grown since clearBorder().
  const std::vector<std::uint16_t>& border() const { return mBorder; }
  void clearBorder();
  /// All rows that have grown since takeChanged().
  std::vector<std::uint16_t> takeChanged();
  /// How many voxels joined since the last call.
  std::size_t takeAdded() { return std::exchange(mAdded, 0); }
  std::size_t visits() const { return mVisits; }

  /// Forgets which voxels of a row may join, as that has changed: the row is looked at anew.
  void forget(int row);
  std::size_t bytes() const { return (mBits.size() + mKnown.size()) * sizeof(Word) + mFlags.size(); }

 private:
  bool offer(int row, const Word* neighbour, int firstWord, int endWord);
  bool mayJoin(int row, int x);
  enum Kind { kOpen, kRegion, kFront };
  enum Flag : std::uint8_t { kIsKnown = 1, kIsQueued = 2, kIsWaiting = 4, kIsOnBorder = 8, kHasChanged = 16 };
  const Word* words(int row, Kind kind) const { return &mBits[std::size_t(row * 3 + kind) * std::size_t(mWords)]; }
  Word* words(int row, Kind kind) { return &mBits[std::size_t(row * 3 + kind) * std::size_t(mWords)]; }
  void visit(int row, const Admission& admission, const GrowDomain& domain);
  bool fill(int row, RowSpan span, const Admission& admission);
  void know(int row, int word, const Admission& admission);
  /// Which words of a row are known, as bits; null where none is.
  Word* known(int row) { return mKnown.empty() ? nullptr : &mKnown[std::size_t(row * wordsOf(mWords))]; }
  void handOn(int row, int firstWord, int endWord);
  void wait(int row);
  void noteGrown(int row);
  bool is(int row, Flag flag) const { return mFlags[std::size_t(row)] & flag; }
  void mark(int row, Flag flag) { mFlags[std::size_t(row)] |= flag; }
  void unmark(int row, Flag flag) { mFlags[std::size_t(row)] &= std::uint8_t(~flag); }

  glm::ivec3 mFirst;
  glm::ivec2 mCount;
  int mWidth, mWords;
  bool mHasBefore, mHasBehind;  ///< the volume goes on along x
  std::vector<Word> mBits;      ///< [row][open, region, front][word]
  std::vector<Word> mKnown;     ///< [row][word]: see known(); empty where rows become known as a whole
  std::vector<std::uint8_t> mFlags;
  std::vector<std::uint16_t> mQueue, mWaiting, mBorder, mChanged;
  std::vector<Word> mNew;  ///< new voxels of the row that is visited
  std::size_t mAdded = 0, mVisits = 0;
};

}  // namespace velum::growth
