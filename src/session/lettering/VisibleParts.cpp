#include "session/lettering/VisibleParts.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "core/Error.h"

namespace velum::session {

namespace {

constexpr int kToSide = 3, kToCorner = 4;  // [BORGEFORS]: ways between pixels, thirds of a pixel
constexpr double kWellInside = 0.75, kStillInside = 0.5, kStillLarge = 0.5;  // of the deepest, of the largest

void checkMap(const KeyMap& map) {
  if (map.step < 1 || map.size.x < 0 || map.size.y < 0 ||
      map.keys.size() != std::size_t(map.size.x) * std::size_t(map.size.y))
    throw ArgumentError(
        fmt::format("a map of {} keys is not {} x {}, or has no step", map.keys.size(), map.size.x, map.size.y));
}

/// Pixels of one key that are joined, over sides or corners.
struct Piece {
  std::int32_t key = -1;
  std::uint64_t pixels = 0;
  glm::dvec2 sum{0};
  int deepest = 0;
};

/// The pixels of a map: how far it is to another key, or out of the picture, and to which piece they belong. They lie
/// in a frame of one pixel that has no key, so that each has all its neighbours.
class MapPixels {
 public:
  explicit MapPixels(const KeyMap& map)
      : mSize(map.size),
        mRow(map.size.x + 2),
        mKeys(std::size_t(mRow) * std::size_t(map.size.y + 2), kNoKey),
        mDepths(mKeys.size()),
        mPieces(mKeys.size(), -1) {
    for (int y = 0; y < mSize.y; ++y)
      std::copy_n(map.keys.begin() + std::ptrdiff_t(y) * mSize.x, mSize.x, mKeys.begin() + indexOf(0, y));
    sweepDown();
    sweepUp();
    gather();
  }
  const std::vector<Piece>& pieces() const { return mGathered; }
  /// Below 0: none.
  int pieceAt(int x, int y) const { return mPieces[std::size_t(indexOf(x, y))]; }
  int depthAt(int x, int y) const { return mDepths[std::size_t(indexOf(x, y))]; }

 private:
  static constexpr std::int32_t kNoKey = -1;

  std::ptrdiff_t indexOf(int x, int y) const { return std::ptrdiff_t(y + 1) * mRow + x + 1; }

  int rootOf(int piece) {
    while (mParents[std::size_t(piece)] != piece)
      piece = mParents[std::size_t(piece)] = mParents[std::size_t(mParents[std::size_t(piece)])];
    return piece;
  }

  /// The piece of a pixel that is in one piece, or none (-1), and beside another.
  int joined(int piece, int other) {
    if (piece == other || other < 0) return piece;
    int there = rootOf(other);
    if (piece < 0) return there;
    int here = rootOf(piece);
    mParents[std::size_t(std::max(here, there))] = std::min(here, there);
    return std::min(here, there);
  }

  /// From the top: ways to the edge over what is above and to the left, and pieces.
  void sweepDown() {
    for (int y = 0; y < mSize.y; ++y) {
      std::ptrdiff_t first = indexOf(0, y);
      for (std::ptrdiff_t i = first; i < first + mSize.x; ++i) {
        std::int32_t key = mKeys[std::size_t(i)];
        if (key < 0) continue;
        int depth = std::numeric_limits<int>::max(), piece = -1;
        auto look = [&](std::ptrdiff_t j, int way, bool doesJoin) {
          bool isSame = mKeys[std::size_t(j)] == key;
          depth = std::min(depth, isSame ? mDepths[std::size_t(j)] + way : way);
          if (isSame && doesJoin) piece = joined(piece, mPieces[std::size_t(j)]);
          return isSame;
        };
        // What is above has joined the pixels beside it.
        bool isBelowItsOwn = look(i - mRow, kToSide, true);
        look(i - 1, kToSide, true);
        look(i - mRow - 1, kToCorner, !isBelowItsOwn);
        look(i - mRow + 1, kToCorner, !isBelowItsOwn);
        if (piece < 0) {
          piece = int(mParents.size());
          mParents.push_back(piece);
        }
        mDepths[std::size_t(i)] = depth;
        mPieces[std::size_t(i)] = piece;
      }
    }
  }

  void sweepUp() {
    for (int y = mSize.y - 1; y >= 0; --y) {
      std::ptrdiff_t first = indexOf(0, y);
      for (std::ptrdiff_t i = first + mSize.x; i-- > first;) {
        std::int32_t key = mKeys[std::size_t(i)];
        if (key < 0) continue;
        auto wayOver = [&](std::ptrdiff_t j, int way) {
          return mKeys[std::size_t(j)] == key ? mDepths[std::size_t(j)] + way : way;
        };
        int way = std::min(std::min(wayOver(i + 1, kToSide), wayOver(i + mRow, kToSide)),
                           std::min(wayOver(i + mRow + 1, kToCorner), wayOver(i + mRow - 1, kToCorner)));
        mDepths[std::size_t(i)] = std::min(mDepths[std::size_t(i)], way);
      }
    }
  }

  void gather() {
    std::vector<int> numbers(mParents.size(), -1);
    for (int y = 0; y < mSize.y; ++y)
      for (int x = 0; x < mSize.x; ++x) {
        std::size_t i = std::size_t(indexOf(x, y));
        if (mPieces[i] < 0) continue;
        int& number = numbers[std::size_t(rootOf(mPieces[i]))];
        if (number < 0) {
          number = int(mGathered.size());
          mGathered.push_back({mKeys[i]});
        }
        mPieces[i] = number;
        Piece& piece = mGathered[std::size_t(number)];
        ++piece.pixels;
        piece.sum += glm::dvec2(x, y);
        piece.deepest = std::max(piece.deepest, mDepths[i]);
      }
  }

  glm::ivec2 mSize;
  std::ptrdiff_t mRow;
  std::vector<std::int32_t> mKeys;
  std::vector<int> mDepths, mPieces, mParents;
  std::vector<Piece> mGathered;
};

/// In which piece a key gets its anchor, how deep in it, and near which pixel.
struct PartSearch {
  std::uint64_t pixels = 0;  ///< of all pieces
  int piece = -1;
  double deepEnough = 0.0;
  glm::dvec2 goal{0};
  double nearest = std::numeric_limits<double>::infinity();
  glm::ivec2 at{0};
};

/// What to look for, of each key.
std::map<std::int32_t, PartSearch> searchesIn(const KeyMap& map, const MapPixels& pixels,
                                              std::span<const VisiblePart> before) {
  std::map<std::int32_t, PartSearch> searches;
  const std::vector<Piece>& pieces = pixels.pieces();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    PartSearch& search = searches[pieces[i].key];
    search.pixels += pieces[i].pixels;
    if (search.piece < 0 || pieces[i].pixels > pieces[std::size_t(search.piece)].pixels) search.piece = int(i);
  }
  for (auto& [key, search] : searches) {
    const Piece& piece = pieces[std::size_t(search.piece)];
    search.goal = piece.sum / double(piece.pixels);
    search.deepEnough = kWellInside * piece.deepest;
  }
  for (const VisiblePart& part : before) {
    auto found = searches.find(part.key);
    if (found == searches.end()) continue;
    PartSearch& search = found->second;
    search.goal = part.anchor / double(map.step) - 0.5;
    glm::ivec2 pixel(glm::floor(part.anchor / double(map.step)));
    if (glm::all(glm::greaterThanEqual(pixel, glm::ivec2(0))) && glm::all(glm::lessThan(pixel, map.size))) {
      int there = pixels.pieceAt(pixel.x, pixel.y);
      double large = kStillLarge * double(pieces[std::size_t(search.piece)].pixels);
      if (there >= 0 && pieces[std::size_t(there)].key == part.key &&
          double(pieces[std::size_t(there)].pixels) >= large)
        search.piece = there;
    }
    search.deepEnough = kStillInside * pieces[std::size_t(search.piece)].deepest;
  }
  return searches;
}

}  // namespace

std::vector<VisiblePart> computeVisibleParts(const KeyMap& map, std::span<const VisiblePart> before) {
  checkMap(map);
  MapPixels pixels(map);
  auto searches = searchesIn(map, pixels, before);
  std::vector<PartSearch*> byPiece(pixels.pieces().size(), nullptr);
  for (auto& [key, search] : searches) byPiece[std::size_t(search.piece)] = &search;
  // The pixel that is deep enough and nearest to where it is wanted.
  for (int y = 0; y < map.size.y; ++y)
    for (int x = 0; x < map.size.x; ++x) {
      int piece = pixels.pieceAt(x, y);
      PartSearch* search = piece < 0 ? nullptr : byPiece[std::size_t(piece)];
      if (!search || pixels.depthAt(x, y) < search->deepEnough) continue;
      glm::dvec2 away = glm::dvec2(x, y) - search->goal;
      if (glm::dot(away, away) >= search->nearest) continue;
      search->nearest = glm::dot(away, away);
      search->at = {x, y};
    }
  std::vector<VisiblePart> parts;
  std::uint64_t each = std::uint64_t(map.step) * std::uint64_t(map.step);
  for (const auto& [key, search] : searches)
    parts.push_back({key, search.pixels * each, (glm::dvec2(search.at) + 0.5) * double(map.step),
                     pixels.depthAt(search.at.x, search.at.y) * double(map.step) / kToSide});
  return parts;
}

Silhouette silhouetteOf(const KeyMap& map) {
  checkMap(map);
  Silhouette out{map.step, {}};
  for (int y = 0; y < map.size.y; ++y) {
    auto row = map.keys.subspan(std::size_t(y) * std::size_t(map.size.x), std::size_t(map.size.x));
    auto isSeen = [](std::int32_t key) { return key >= 0; };
    auto left = std::find_if(row.begin(), row.end(), isSeen) - row.begin();
    auto right = row.rend() - std::find_if(row.rbegin(), row.rend(), isSeen);
    out.rows.push_back(glm::dvec2(left, right) * double(map.step));
  }
  return out;
}

}  // namespace velum::session
