#include "session/lettering/VisibleParts.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "core/Error.h"

namespace velum::session {

namespace {

constexpr int kBeside = 3, kDiagonal = 4;  // [BORGEFORS]: ways between pixels, thirds of a pixel
constexpr double kWellInside = 0.75, kStillInside = 0.5, kStillLarge = 0.5;  // of the deepest, of the largest

void check(const KeyMap& map) {
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

/// The pixels of a map: how far it is to another key, or out of the picture, and to which piece they belong.
class Pixels {
 public:
  explicit Pixels(const KeyMap& map) : mMap(map), mDepths(map.keys.size()), mPieces(map.keys.size()) {
    sweepDown();
    sweepUp();
    gather();
  }
  const std::vector<Piece>& pieces() const { return mGathered; }
  int pieceAt(std::size_t i) const { return mPieces[i]; }
  int depthAt(std::size_t i) const { return mDepths[i]; }

 private:
  bool isIn(int x, int y) const { return x >= 0 && y >= 0 && x < mMap.size.x && y < mMap.size.y; }
  std::size_t indexOf(int x, int y) const { return std::size_t(y) * std::size_t(mMap.size.x) + std::size_t(x); }

  /// How far a pixel is from the edge by way of a neighbour.
  int wayOver(std::size_t i, int x, int y, int way) const {
    if (!isIn(x, y)) return way;
    std::size_t j = indexOf(x, y);
    return mMap.keys[j] == mMap.keys[i] ? mDepths[j] + way : way;
  }

  int rootOf(int piece) {
    while (mParents[std::size_t(piece)] != piece)
      piece = mParents[std::size_t(piece)] = mParents[std::size_t(mParents[std::size_t(piece)])];
    return piece;
  }

  void join(std::size_t i, int x, int y) {
    if (!isIn(x, y) || mMap.keys[indexOf(x, y)] != mMap.keys[i]) return;
    int there = rootOf(mPieces[indexOf(x, y)]);
    if (mPieces[i] < 0) {
      mPieces[i] = there;
      return;
    }
    int here = rootOf(mPieces[i]);
    mParents[std::size_t(std::max(here, there))] = std::min(here, there);
  }

  void sweepDown() {
    std::size_t i = 0;
    for (int y = 0; y < mMap.size.y; ++y)
      for (int x = 0; x < mMap.size.x; ++x, ++i) {
        mPieces[i] = -1;
        if (mMap.keys[i] < 0) continue;
        mDepths[i] = std::min(std::min(wayOver(i, x - 1, y, kBeside), wayOver(i, x, y - 1, kBeside)),
                              std::min(wayOver(i, x - 1, y - 1, kDiagonal), wayOver(i, x + 1, y - 1, kDiagonal)));
        join(i, x - 1, y);
        // What is above joins its own neighbours, so that only a gap there needs more.
        if (!isIn(x, y - 1) || mMap.keys[indexOf(x, y - 1)] != mMap.keys[i]) {
          join(i, x - 1, y - 1);
          join(i, x + 1, y - 1);
        } else {
          join(i, x, y - 1);
        }
        if (mPieces[i] >= 0) continue;
        mPieces[i] = int(mParents.size());
        mParents.push_back(mPieces[i]);
      }
  }

  void sweepUp() {
    std::size_t i = mMap.keys.size();
    for (int y = mMap.size.y - 1; y >= 0; --y)
      for (int x = mMap.size.x - 1; x >= 0; --x) {
        if (mMap.keys[--i] < 0) continue;
        int way = std::min(std::min(wayOver(i, x + 1, y, kBeside), wayOver(i, x, y + 1, kBeside)),
                           std::min(wayOver(i, x + 1, y + 1, kDiagonal), wayOver(i, x - 1, y + 1, kDiagonal)));
        mDepths[i] = std::min(mDepths[i], way);
      }
  }

  void gather() {
    std::vector<int> numbers(mParents.size(), -1);
    std::size_t i = 0;
    for (int y = 0; y < mMap.size.y; ++y)
      for (int x = 0; x < mMap.size.x; ++x, ++i) {
        if (mPieces[i] < 0) continue;
        int& number = numbers[std::size_t(rootOf(mPieces[i]))];
        if (number < 0) {
          number = int(mGathered.size());
          mGathered.push_back({mMap.keys[i]});
        }
        mPieces[i] = number;
        Piece& piece = mGathered[std::size_t(number)];
        ++piece.pixels;
        piece.sum += glm::dvec2(x, y);
        piece.deepest = std::max(piece.deepest, mDepths[i]);
      }
  }

  const KeyMap& mMap;
  std::vector<int> mDepths, mPieces, mParents;
  std::vector<Piece> mGathered;
};

/// In which piece a key gets its anchor, how deep in it, and near which pixel.
struct Search {
  std::uint64_t pixels = 0;  ///< of all pieces
  int piece = -1;
  double deepEnough = 0.0;
  glm::dvec2 goal{0};
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t at = 0;
};

/// What to look for, of each key.
std::map<std::int32_t, Search> searchesIn(const KeyMap& map, const Pixels& pixels,
                                          std::span<const VisiblePart> before) {
  std::map<std::int32_t, Search> searches;
  const std::vector<Piece>& pieces = pixels.pieces();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Search& search = searches[pieces[i].key];
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
    Search& search = found->second;
    search.goal = part.anchor / double(map.step) - 0.5;
    glm::ivec2 pixel(glm::floor(part.anchor / double(map.step)));
    if (glm::all(glm::greaterThanEqual(pixel, glm::ivec2(0))) && glm::all(glm::lessThan(pixel, map.size))) {
      std::size_t i = std::size_t(pixel.y) * std::size_t(map.size.x) + std::size_t(pixel.x);
      double large = kStillLarge * double(pieces[std::size_t(search.piece)].pixels);
      int there = map.keys[i] == part.key ? pixels.pieceAt(i) : search.piece;
      if (double(pieces[std::size_t(there)].pixels) >= large) search.piece = there;
    }
    search.deepEnough = kStillInside * pieces[std::size_t(search.piece)].deepest;
  }
  return searches;
}

}  // namespace

std::vector<VisiblePart> computeVisibleParts(const KeyMap& map, std::span<const VisiblePart> before) {
  check(map);
  Pixels pixels(map);
  auto searches = searchesIn(map, pixels, before);
  std::vector<Search*> byPiece(pixels.pieces().size(), nullptr);
  for (auto& [key, search] : searches) byPiece[std::size_t(search.piece)] = &search;
  // The pixel that is deep enough and nearest to where it is wanted.
  std::size_t i = 0;
  for (int y = 0; y < map.size.y; ++y)
    for (int x = 0; x < map.size.x; ++x, ++i) {
      Search* search = map.keys[i] < 0 ? nullptr : byPiece[std::size_t(pixels.pieceAt(i))];
      if (!search || pixels.depthAt(i) < search->deepEnough) continue;
      glm::dvec2 away = glm::dvec2(x, y) - search->goal;
      if (glm::dot(away, away) >= search->nearest) continue;
      search->nearest = glm::dot(away, away);
      search->at = i;
    }
  std::vector<VisiblePart> parts;
  std::uint64_t each = std::uint64_t(map.step) * std::uint64_t(map.step);
  for (const auto& [key, search] : searches) {
    glm::dvec2 pixel(search.at % std::size_t(map.size.x), search.at / std::size_t(map.size.x));
    parts.push_back({key, search.pixels * each, (pixel + 0.5) * double(map.step),
                     pixels.depthAt(search.at) * double(map.step) / kBeside});
  }
  return parts;
}

Silhouette silhouetteOf(const KeyMap& map) {
  check(map);
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
