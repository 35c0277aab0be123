#include "growth/SolidPart.h"

#include <algorithm>
#include <array>
#include <vector>

#include "growth/RowBits.h"

namespace velum::growth {

namespace {

/// Layers that are kept of each stage: those that the next one looks at are not farther apart.
constexpr int kKept = 8;
/// Rows around those that are asked for that are looked at.
constexpr int kAround = 2;

/// The stages of eroding a region, row by row as they are asked for. Bits outside of what is known, of the volume and
/// behind a row's end are 1.
class Erosion {
 public:
  /// @param low, high  least and largest y of the rows that are asked for
  Erosion(const RegionGrow& region, glm::ivec3 dims, const GrowDomain& known, int low, int high)
      : mRegion(region),
        mDims(dims),
        mKnown(known),
        mWords(std::size_t(wordsOf(dims.x))),
        mLow(std::max(low - kAround, 0)),
        mRows(std::size_t(std::min(high + kAround + 1, dims.y) - mLow)),
        mOutside(mWords, ~Word(0)) {}

  /// What is left of a row, not of the region where it is unknown. @param bits  [word], all written
  void rest(int y, int z, Word* bits) {
    std::fill_n(bits, mWords, ~Word(0));
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy) keepBesides(erodedByFaces(y + dy, z + dz), bits);
  }

 private:
  /// Rows of a layer, one after the other.
  struct Layer {
    int z = -1;
    std::vector<Word> bits;
    std::vector<char> known;  ///< [y - mLow]
  };
  using Stage = std::array<Layer, kKept>;

  /// A row of a stage, and whether it has been made already.
  Word* place(Stage& stage, int y, int z, bool& isMade) const {
    Layer& layer = stage[std::size_t(z % kKept)];
    if (layer.z != z) {
      layer.z = z;
      layer.bits.resize(mWords * mRows);
      layer.known.assign(mRows, 0);
    }
    auto row = std::size_t(y - mLow);
    isMade = layer.known[row] != 0;
    layer.known[row] = 1;
    return layer.bits.data() + mWords * row;
  }

  bool isOutside(int y, int z) const { return y < 0 || z < 0 || y >= mDims.y || z >= mDims.z; }

  /// Bits that stay, whatever is beside them.
  Word unknown(std::size_t w, RowSpan span) const { return ~spanBits(int(w), span.first, span.end); }

  /// The region, with all that is unknown.
  const Word* region(int y, int z) {
    if (isOutside(y, z)) return mOutside.data();
    bool isMade;
    Word* bits = place(mWhole, y, z, isMade);
    if (isMade) return bits;
    mRegion.read(y, z, bits);
    RowSpan span = mKnown.rowSpan(y, z, mDims.x);
    for (std::size_t w = 0; w < mWords; ++w) bits[w] |= unknown(w, span);
    return bits;
  }

  const Word* erodedByFaces(int y, int z) {
    if (isOutside(y, z)) return mOutside.data();
    bool isMade;
    Word* bits = place(mFaces, y, z, isMade);
    if (isMade) return bits;
    std::fill_n(bits, mWords, ~Word(0));
    keepBesides(region(y, z), bits);
    for (const Word* beside : {region(y - 1, z), region(y + 1, z), region(y, z - 1), region(y, z + 1)})
      for (std::size_t w = 0; w < mWords; ++w) bits[w] &= beside[w];
    RowSpan span = mKnown.rowSpan(y, z, mDims.x);
    for (std::size_t w = 0; w < mWords; ++w) bits[w] |= unknown(w, span);
    return bits;
  }

  /// Of bits those that a row has itself and to either side.
  void keepBesides(const Word* row, Word* bits) const {
    for (std::size_t w = 0; w < mWords; ++w) {
      Word below = w > 0 ? row[w - 1] >> (kWordBits - 1) : 1;
      Word above = w + 1 < mWords ? row[w + 1] << (kWordBits - 1) : Word(1) << (kWordBits - 1);
      bits[w] &= row[w] & (row[w] << 1 | below) & (row[w] >> 1 | above);
    }
  }

  const RegionGrow& mRegion;
  glm::ivec3 mDims;
  const GrowDomain& mKnown;
  std::size_t mWords;
  int mLow;           ///< y of the first row of a layer
  std::size_t mRows;  ///< of a layer
  std::vector<Word> mOutside;
  Stage mWhole, mFaces;
};

}  // namespace

std::size_t countSolid(const RegionGrow& region, glm::ivec3 dims, const GrowDomain& known, const GrowDomain& slab) {
  std::vector<glm::ivec2> rows = region.rowsIn(slab);
  if (rows.empty()) return 0;
  auto [low, high] = std::minmax_element(rows.begin(), rows.end(), [](auto a, auto b) { return a.x < b.x; });
  Erosion erosion(region, dims, known, low->x, high->x);
  std::vector<Word> rest(static_cast<std::size_t>(wordsOf(dims.x))), row(rest.size());
  std::size_t count = 0;
  for (glm::ivec2 place : rows) {
    region.read(place.x, place.y, row.data());
    erosion.rest(place.x, place.y, rest.data());
    RowSpan span = slab.rowSpan(place.x, place.y, dims.x);
    for (int w = span.first / kWordBits; w * kWordBits < span.end; ++w)
      count += std::size_t(countBits(row[std::size_t(w)] & rest[std::size_t(w)] & spanBits(w, span.first, span.end)));
  }
  return count;
}

}  // namespace velum::growth
