#pragma once
#include <array>
#include <cstdint>
#include <deque>

namespace velum::render {

/// Chooses how many groups of each list of draws a software driver gets at a time: as many as take about the wanted
/// time.
class DrawPace {
 public:
  /// Forgets the pieces that are with the driver, but not how fast the driver was.
  void restart() { mHandedOver.clear(); }
  std::uint32_t groupsOf(int list) const { return mLists[std::size_t(list)].next; }
  /// To be called for each step, in the order of the steps. @param groups  0: the time of the step is not used
  void handOver(int list, std::uint32_t groups) { mHandedOver.push_back({list, groups}); }
  /// Tells how long the first of the pieces that are with the driver took.
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
