#pragma once
#include <array>
#include <cstdint>
#include <deque>

namespace velum::render {

/// How many groups of each list of draws a software driver is handed at a time: as many as take about as long as is
/// wanted.
class DrawPace {
 public:
  /// Forgets what is with the driver, not how fast it was.
  void restart() { mHandedOver.clear(); }
  std::uint32_t groupsOf(int list) const { return mLists[std::size_t(list)].next; }
  /// Each step in its order. @param groups  0: it counts for nothing
  void handOver(int list, std::uint32_t groups) { mHandedOver.push_back({list, groups}); }
  /// How long the first of what is with the driver took.
  void took(double ms);

 private:
  struct List {
    std::uint32_t next = 128;
    bool isKnown = false;
  };
  struct Piece {
    int list;
    std::uint32_t groups;
  };
  std::array<List, 4> mLists;
  std::deque<Piece> mHandedOver;
};

}  // namespace velum::render
