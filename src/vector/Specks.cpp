#include "vector/Specks.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "vector/PixelBorders.h"

namespace velum::vector {

namespace {

/// Pieces of pixels that hang together.
class Pieces {
 public:
  Pieces(glm::ivec2 size, const std::vector<int>& ids) : mSize(size), mParents(ids.size()), mAreas(ids.size(), 1) {
    std::iota(mParents.begin(), mParents.end(), 0);
    IdGrid grid{size, ids};
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        int own = indexAt(x, y), id = ids[std::size_t(own)];
        if (x > 0 && ids[std::size_t(own - 1)] == id) join(own - 1, own);
        if (y > 0 && ids[std::size_t(own - size.x)] == id) join(own - size.x, own);
        if (x > 0 && y > 0 && isCrosswise(grid, {x, y})) {
          if (joinsDown(grid, {x, y}))
            join(own - size.x - 1, own);
          else
            join(own - size.x, own - 1);
        }
      }
  }

  int rootOf(int i) {
    while (mParents[std::size_t(i)] != i) {
      int& parent = mParents[std::size_t(i)];
      parent = mParents[std::size_t(parent)];
      i = parent;
    }
    return i;
  }
  int areaOf(int root) const { return mAreas[std::size_t(root)]; }
  int indexAt(int x, int y) const { return y * mSize.x + x; }
  /// What was of `from` is of the root of `into`, whose id it takes. @param from  a root
  void give(int from, int into) {
    into = rootOf(into);
    if (from == into) return;
    mParents[std::size_t(from)] = into;
    mAreas[std::size_t(into)] += mAreas[std::size_t(from)];
  }

 private:
  void join(int a, int b) {
    a = rootOf(a);
    b = rootOf(b);
    // The smaller index stays, so that roots do not depend on the order.
    if (a != b) give(std::max(a, b), std::min(a, b));
  }

  glm::ivec2 mSize;
  std::vector<std::int32_t> mParents, mAreas;
};

/// A pixel's edge between a speck and a neighbour, by their roots.
struct Contact {
  std::int32_t speck, other;
  auto operator<=>(const Contact&) const = default;
};

std::vector<Contact> contactsOf(glm::ivec2 size, Pieces& pieces, double least) {
  std::vector<Contact> contacts;
  auto touch = [&](int a, int b) {
    int rootA = pieces.rootOf(a), rootB = pieces.rootOf(b);
    if (rootA == rootB) return;
    if (pieces.areaOf(rootA) < least) contacts.push_back({rootA, rootB});
    if (pieces.areaOf(rootB) < least) contacts.push_back({rootB, rootA});
  };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      if (x > 0) touch(pieces.indexAt(x - 1, y), pieces.indexAt(x, y));
      if (y > 0) touch(pieces.indexAt(x, y - 1), pieces.indexAt(x, y));
    }
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

/// Of the contacts of a speck the neighbour that has the most; -1: none.
int closestOf(std::vector<Contact>::const_iterator first, std::vector<Contact>::const_iterator end, Pieces& pieces) {
  std::vector<int> roots;
  int own = first == end ? -1 : pieces.rootOf(first->speck);
  for (; first != end; ++first)
    if (int root = pieces.rootOf(first->other); root != own) roots.push_back(root);
  std::sort(roots.begin(), roots.end());
  int best = -1;
  std::ptrdiff_t most = 0;
  for (auto at = roots.begin(); at != roots.end();) {
    auto next = std::upper_bound(at, roots.end(), *at);
    if (next - at > most) {
      most = next - at;
      best = *at;
    }
    at = next;
  }
  return best;
}

}  // namespace

void absorbSpecks(glm::ivec2 size, std::vector<int>& ids, double least) {
  if (least <= 1.0) return;
  Pieces pieces(size, ids);
  std::vector<Contact> contacts = contactsOf(size, pieces, least);
  struct Speck {
    int area, root;
    std::vector<Contact>::const_iterator first, end;
  };
  std::vector<Speck> specks;
  for (auto at = contacts.cbegin(); at != contacts.cend();) {
    auto next = std::find_if(at, contacts.cend(), [&](const Contact& contact) { return contact.speck != at->speck; });
    specks.push_back({pieces.areaOf(at->speck), at->speck, at, next});
    at = next;
  }
  std::stable_sort(specks.begin(), specks.end(), [](const Speck& a, const Speck& b) { return a.area < b.area; });
  for (const Speck& speck : specks) {
    if (pieces.rootOf(speck.root) != speck.root || pieces.areaOf(speck.root) >= least) continue;
    if (int into = closestOf(speck.first, speck.end, pieces); into >= 0) pieces.give(speck.root, into);
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    int root = pieces.rootOf(int(i));
    ids[i] = ids[std::size_t(root)];
  }
}

}  // namespace velum::vector
