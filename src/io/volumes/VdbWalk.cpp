#include "io/volumes/VdbWalk.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <set>
#include <string_view>
#include <vector>

namespace velum::io {

namespace {

constexpr std::uint32_t kZip = 1, kActiveMask = 2, kBlosc = 4;
/// From this version on the compression stands with each grid, and nodes may leave out what is inactive.
constexpr std::uint32_t kNodeMasks = 222;
/// Voxels along a side of the nodes below the root; and how far off these may lie: OpenVDB adds up corners in 32 bits.
constexpr std::int32_t kLargestNode = 4096, kFarthest = 1 << 29;
constexpr std::uint32_t kOldest = 220, kNewest = 224;
/// Names, types, and what else is text for people; longer ones are damage.
constexpr std::uint32_t kLongestText = 1 << 20;

/// Takes values off a file from front to back.
class Bytes {
 public:
  explicit Bytes(const FileBytes& file) : mFile(file), mWindow(1 << 18) {}

  std::uint64_t at() const { return mAt; }
  std::uint64_t left() const { return mFile.size() - mAt; }
  [[noreturn]] void refuseDamage(std::string_view what) const {
    refuse(mFile.path(), fmt::format("is damaged: {} (before byte {} of {})", what, mAt, mFile.size()));
  }

  void skip(std::uint64_t count) {
    if (count > left()) refuseDamage("it ends before its grid does");
    mAt += count;
  }
  /// The next bytes, which stay; good until the next call. At most a window of them.
  std::span<const std::byte> peek(std::size_t count) {
    if (count > left()) refuseDamage("it ends before its grid does");
    if (mAt < mStart || mAt + count > mEnd) {
      mStart = mAt;
      mEnd = mAt + mFile.readSome(mAt, mWindow);
      if (mAt + count > mEnd) refuseDamage("it has become shorter");
    }
    return std::span(mWindow).subspan(std::size_t(mAt - mStart), count);
  }
  template <class T>
  T take() {
    T value;
    std::memcpy(&value, peek(sizeof(T)).data(), sizeof(T));
    mAt += sizeof(T);
    return value;
  }
  std::string takeBytes(std::uint32_t count) {
    if (count > kLongestText) refuseDamage(fmt::format("a text of {} bytes is too long", count));
    std::string text(std::min<std::size_t>(count, std::size_t(left())), '\0');
    for (std::size_t done = 0; done < text.size();) {
      std::size_t now = std::min(text.size() - done, mWindow.size());
      std::memcpy(text.data() + done, peek(now).data(), now);
      mAt += now, done += now;
    }
    if (text.size() < count) refuseDamage("it ends within a text");
    return text;
  }
  std::string takeText() { return takeBytes(take<std::uint32_t>()); }

 private:
  const FileBytes& mFile;
  std::vector<std::byte> mWindow;
  std::uint64_t mAt = 0, mStart = 0, mEnd = 0;
};

/// One bit a place of a node.
template <std::size_t Log2>
struct Mask {
  std::array<std::uint64_t, (std::size_t(1) << (3 * Log2)) / 64> words;

  explicit Mask(Bytes& in) {
    std::memcpy(words.data(), in.peek(sizeof words).data(), sizeof words);
    in.skip(sizeof words);
  }
  std::size_t count() const {
    std::size_t on = 0;
    for (std::uint64_t word : words) on += std::size_t(std::popcount(word));
    return on;
  }
};

/// A tree of numbers with nodes of 32, 16 and 8 voxels a side: first all masks, then the values of all leaves.
class TreeWalk {
 public:
  TreeWalk(Bytes& in, const VdbGrid& grid)
      : mIn(in), mGrid(grid), mValue(grid.isDouble ? sizeof(double) : sizeof(float)) {}

  void walk() {
    if (mIn.take<std::int32_t>() != 1) mIn.refuseDamage("its tree has more than one buffer");
    mIn.skip(mValue);
    auto tiles = mIn.take<std::uint32_t>(), children = mIn.take<std::uint32_t>();
    for (std::uint32_t i = 0; i < tiles; ++i) {
      takeOrigin();
      mIn.skip(mValue);
      if (mIn.take<std::uint8_t>() > 1) mIn.refuseDamage("a tile is neither active nor inactive");
    }
    for (std::uint32_t i = 0; i < children; ++i) {
      takeOrigin();
      walkNode<5>();
    }
    for (std::uint64_t i = 0; i < mLeaves; ++i) walkLeafValues();
  }

 private:
  void takeOrigin() {
    auto origin = mIn.take<std::array<std::int32_t, 3>>();
    for (std::int32_t c : origin)
      if (c % kLargestNode != 0 || c < -kFarthest || c > kFarthest) mIn.refuseDamage("a node lies off its lattice");
    if (!mOrigins.insert(origin).second) mIn.refuseDamage("two nodes lie at one place");
  }

  template <std::size_t Log2>
  void walkNode() {
    Mask<Log2> children(mIn), active(mIn);
    for (std::size_t i = 0; i < children.words.size(); ++i)
      if (children.words[i] & active.words[i]) mIn.refuseDamage("a value stands where a node is");
    constexpr std::size_t kPlaces = std::size_t(1) << (3 * Log2);
    bool isOld = mGrid.fileVersion < kNodeMasks;
    walkValues(isOld ? kPlaces - children.count() : kPlaces, active.count(), sizeof(Mask<Log2>));
    for (std::size_t i = children.count(); i > 0; --i) {
      if constexpr (Log2 == 5)
        walkNode<4>();
      else
        mIn.skip(sizeof(Mask<3>)), ++mLeaves;
    }
  }

  void walkLeafValues() {
    Mask<3> active(mIn);
    if (mGrid.fileVersion < kNodeMasks) {
      mIn.skip(3 * sizeof(std::int32_t));
      if (mIn.take<std::int8_t>() > 1) mIn.refuseDamage("a leaf has more than one buffer");
    }
    walkValues(512, active.count(), sizeof active);
  }

  /// The values of a node: all, or the active ones with what is needed to make up the others.
  void walkValues(std::size_t count, std::size_t active, std::size_t maskBytes) {
    constexpr int kAllValues = 6;
    int kind = mGrid.fileVersion < kNodeMasks ? kAllValues : mIn.take<std::int8_t>();
    if (kind < 0 || kind > kAllValues) mIn.refuseDamage(fmt::format("values are packed in an unknown way, {}", kind));
    bool hasOneValue = kind == 2 || kind == 4, hasTwoValues = kind == 5;
    mIn.skip(hasTwoValues ? 2 * mValue : hasOneValue ? mValue : 0);
    if (kind >= 3 && kind <= 5) mIn.skip(maskBytes);
    bool hasActiveOnly = (mGrid.compression & kActiveMask) && kind != kAllValues;
    std::size_t stored = hasActiveOnly ? active : count;
    if (mGrid.isHalf && stored == 0) return;  // then OpenVDB does not even write a size
    walkBlock(stored * (mGrid.isHalf ? 2 : mValue));
  }

  /// @param bytes  that come out
  void walkBlock(std::size_t bytes) {
    if (!(mGrid.compression & (kZip | kBlosc))) return mIn.skip(bytes);
    auto packed = mIn.take<std::int64_t>();
    if (packed <= 0) {
      if (packed != -std::int64_t(bytes)) mIn.refuseDamage(fmt::format("a block of {} bytes has {}", bytes, -packed));
      return mIn.skip(bytes);
    }
    if (std::uint64_t(packed) > mIn.left())
      mIn.refuseDamage(fmt::format("a block of {} bytes is longer than the file", packed));
    if (mGrid.compression & kBlosc) checkBlosc(std::uint64_t(packed), bytes);
    mIn.skip(std::uint64_t(packed));
  }

  /// Blosc is not told how long its block is: it goes by what the block says.
  void checkBlosc(std::uint64_t packed, std::size_t bytes) {
    constexpr std::size_t kHead = 16;
    std::array<std::uint32_t, 4> head{};
    if (packed >= kHead) std::memcpy(head.data(), mIn.peek(kHead).data(), kHead);
    if (head[1] != bytes || head[3] != packed)
      mIn.refuseDamage(fmt::format("a block of {} bytes says that it has {} of {}", packed, head[3], head[1]));
  }

  Bytes& mIn;
  const VdbGrid& mGrid;
  std::size_t mValue;  ///< Bytes of a number that is not packed.
  std::uint64_t mLeaves = 0;
  std::set<std::array<std::int32_t, 3>> mOrigins;
};

/// @return the notes that are short; OpenVDB's own table for delayed loading is as long as the tree
std::map<std::string, VdbNote> takeNotes(Bytes& in) {
  std::map<std::string, VdbNote> notes;
  for (auto count = in.take<std::uint32_t>(); count > 0; --count) {
    std::string name = in.takeText();
    VdbNote note{in.takeText(), {}};
    auto size = in.take<std::uint32_t>();
    if (size > kLongestText || note.type == "__delayedload")
      in.skip(size);
    else if (note.bytes = in.takeBytes(size); notes.size() < 1000)
      notes[name] = std::move(note);
  }
  return notes;
}

/// Of OpenVDB's linear maps: so many doubles each.
void walkTransform(Bytes& in) {
  constexpr std::pair<std::string_view, int> kMaps[] = {{"AffineMap", 16},
                                                        {"UnitaryMap", 16},
                                                        {"ScaleMap", 15},
                                                        {"UniformScaleMap", 15},
                                                        {"TranslationMap", 3},
                                                        {"ScaleTranslateMap", 18},
                                                        {"UniformScaleTranslateMap", 18}};
  std::string type = in.takeText();
  auto map = std::find_if(std::begin(kMaps), std::end(kMaps), [&](auto& m) { return m.first == type; });
  if (map == std::end(kMaps))
    in.refuseDamage(fmt::format("its grid's transform {} is not linear, or not known", inQuotes(type)));
  in.skip(std::uint64_t(map->second) * sizeof(double));
}

VdbGrid takeHeader(Bytes& in, const Path& path, bool& hasOffsets) {
  if (in.left() < 16 || in.take<std::uint64_t>() != 0x56444220) refuse(path, "is not an OpenVDB file");
  VdbGrid grid;
  grid.fileVersion = in.take<std::uint32_t>();
  if (grid.fileVersion < kOldest || grid.fileVersion > kNewest)
    refuse(path,
           fmt::format("is an OpenVDB file of version {}; {} to {} are read", grid.fileVersion, kOldest, kNewest));
  grid.libraryMajor = in.take<std::uint32_t>();
  grid.libraryMinor = in.take<std::uint32_t>();
  hasOffsets = in.take<std::uint8_t>() != 0;
  if (grid.fileVersion < kNodeMasks) grid.compression = in.take<std::uint8_t>() ? kZip : 0;
  in.skip(36);  // the file's own id
  takeNotes(in);
  return grid;
}

}  // namespace

VdbGrid walkVdb(const FileBytes& file) {
  Bytes in(file);
  bool hasOffsets = false;
  VdbGrid grid = takeHeader(in, file.path(), hasOffsets);
  std::string others;
  grid.gridsInFile = in.take<std::int32_t>();
  for (int count = grid.gridsInFile; count > 0; --count) {
    in.takeText();  // its name, made unique
    std::string type = in.takeText(), parent = in.takeText();
    in.skip(2 * sizeof(std::int64_t));  // where the grid and its values begin: here, and where the walk leads
    auto end = in.take<std::uint64_t>();
    grid.isHalf = type.ends_with("_HalfFloat");
    grid.isDouble = type.starts_with("Tree_double_5_4_3");
    if ((!grid.isDouble && !type.starts_with("Tree_float_5_4_3")) || !parent.empty()) {
      if (others.size() < 200) others += (others.empty() ? "" : ", ") + type;
      if (!hasOffsets) refuse(file.path(), fmt::format("its first grid is a {}, which is not read", inQuotes(type)));
      if (end < in.at()) in.refuseDamage("a grid ends before it begins");
      in.skip(end - in.at());
      continue;
    }
    if (grid.fileVersion >= kNodeMasks) grid.compression = in.take<std::uint32_t>();
    if (grid.compression > (kZip | kActiveMask | kBlosc))
      in.refuseDamage(fmt::format("a compression {} is not known", grid.compression));
    grid.notes = takeNotes(in);
    grid.transformAt = in.at();
    walkTransform(in);
    TreeWalk(in, grid).walk();
    if (hasOffsets && in.at() != end) in.refuseDamage(fmt::format("its grid ends here and should at byte {}", end));
    return grid;
  }
  refuse(file.path(),
         fmt::format("has no grid of floats or doubles (it has: {})", others.empty() ? "nothing" : inQuotes(others)));
}

}  // namespace velum::io
