#pragma once
#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/Error.h"
#include "core/Parallel.h"
#include "membrane/forces/LeastCut.h"

namespace velum::membrane {

/// Most units between two nodes: halves of 127 pairs where all pairs are equally strong; else as much as flows have
/// room for.
constexpr int kMostHalves = 255, kMostUnits = 3276;
/// Most units between two nodes in a column, where there is more room.
constexpr int kMostUp = 65535;

inline std::size_t columnOf(glm::ivec3 dims, glm::ivec3 node) {
  return std::size_t(node.y) * std::size_t(dims.x) + std::size_t(node.x);
}

inline bool isWithin(glm::ivec3 dims, glm::ivec3 node) {
  return unsigned(node.x) < unsigned(dims.x) && unsigned(node.y) < unsigned(dims.y) &&
         unsigned(node.z) < unsigned(dims.z);
}

/// Which nodes of a lattice hold something: a bit each, counted by words.
class NodeBits {
 public:
  explicit NodeBits(glm::ivec3 dims)
      : mDims(dims),
        mWords(std::size_t(dims.z + 63) / 64),
        mBits(std::size_t(dims.x) * std::size_t(dims.y) * mWords, 0) {}

  /// Any thread, also at the same time.
  void set(glm::ivec3 node) {
    std::atomic_ref<std::uint64_t> word(mBits[wordOf(node)]);
    std::uint64_t bit = std::uint64_t(1) << (node.z & 63);
    if ((word.load(std::memory_order_relaxed) & bit) == 0) word.fetch_or(bit, std::memory_order_relaxed);
  }

  /// Numbers the nodes that are set, column by column, upwards, and fills CutLattice::first and CutLattice::layer.
  void number(CutLattice& lattice) {
    std::size_t columns = mBits.size() / mWords;
    std::uint32_t count = 0;
    mBefore.resize(mBits.size());
    lattice.first.resize(columns + 1);
    for (std::size_t word = 0; word < mBits.size(); ++word) {
      if (word % mWords == 0) lattice.first[word / mWords] = count;
      mBefore[word] = count;
      count += std::uint32_t(std::popcount(mBits[word]));
    }
    lattice.first[columns] = count;
    lattice.layer.resize(count);
    parallelFor(std::size_t(0), columns, [&](std::size_t column) {
      std::uint16_t* layer = lattice.layer.data() + lattice.first[column];
      for (std::size_t word = 0; word < mWords; ++word)
        for (std::uint64_t rest = mBits[column * mWords + word]; rest; rest &= rest - 1)
          *layer++ = std::uint16_t(word * 64 + std::size_t(std::countr_zero(rest)));
    });
  }
  std::uint32_t at(glm::ivec3 node) const {
    std::size_t word = wordOf(node);
    std::uint64_t lower = (std::uint64_t(1) << (node.z & 63)) - 1;
    return mBefore[word] + std::uint32_t(std::popcount(mBits[word] & lower));
  }

 private:
  std::size_t wordOf(glm::ivec3 node) const { return columnOf(mDims, node) * mWords + std::size_t(node.z) / 64; }
  glm::ivec3 mDims;
  std::size_t mWords;
  std::vector<std::uint64_t> mBits;
  std::vector<std::uint32_t> mBefore;  ///< by word: how many nodes are in the words before it
};

/// makeLattice() for callers with many pairs to hand out.
/// @param unit  see CutLattice::unit
/// @param pairs  called twice with add(lower node, axis, pairs in units), which any threads may call at the same time
template <class Pairs>
CutLattice buildLattice(glm::ivec3 dims, double restLayer, int unit, const Pairs& pairs) {
  if (glm::any(glm::lessThan(dims, glm::ivec3(1)))) throw ArgumentError("a lattice needs one node along each axis");
  if (dims.z > std::numeric_limits<std::uint16_t>::max())
    throw ArgumentError("a lattice of " + std::to_string(dims.z) + " layers is too high");
  CutLattice lattice;
  lattice.dims = dims;
  lattice.restLayer = restLayer;
  lattice.unit = unit;
  NodeBits bits(dims);
  auto upper = [](glm::ivec3 node, int axis) { return ++node[axis], node; };
  auto holds = [&](glm::ivec3 node, int axis) { return isWithin(dims, node) && node[axis] + 1 < dims[axis]; };
  pairs([&](glm::ivec3 node, int axis, int units) {
    if (units <= 0 || !holds(node, axis)) return;
    bits.set(node);
    bits.set(upper(node, axis));
  });
  bits.number(lattice);
  for (auto& p : lattice.pairs) p.assign(lattice.layer.size(), 0);
  pairs([&](glm::ivec3 node, int axis, int units) {
    if (units <= 0 || !holds(node, axis)) return;
    int most = unit == CutLattice::kHalves ? kMostHalves : axis == 2 ? kMostUp : kMostUnits;
    std::atomic_ref<std::uint16_t> sum(lattice.pairs[axis][bits.at(node)]);
    std::uint16_t now = sum.load(std::memory_order_relaxed);
    while (
        !sum.compare_exchange_weak(now, std::uint16_t(std::min(int(now) + units, most)), std::memory_order_relaxed)) {
    }
  });
  return lattice;
}

}  // namespace velum::membrane
