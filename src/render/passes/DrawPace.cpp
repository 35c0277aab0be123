#include "render/passes/DrawPace.h"

#include <algorithm>
#include <utility>

namespace velum::render {

namespace {

constexpr double kPieceMs = 16.0, kMostGroups = 32768.0;  // of a piece

}  // namespace

/// The next piece of a list takes about as long as is wanted, and at most twice as many groups as the last.
void DrawPace::took(double ms) {
  if (mHandedOver.empty()) return;
  Piece piece = mHandedOver.front();
  mHandedOver.pop_front();
  if (piece.groups == 0) return;
  List& list = mLists[std::size_t(piece.list)];
  // The first piece has the driver compile.
  if (!std::exchange(list.isKnown, true)) return;
  double wanted = kPieceMs / std::max(ms, 0.01) * piece.groups;
  list.next = std::uint32_t(std::clamp(wanted, 1.0, std::min(2.0 * piece.groups, kMostGroups)));
}

}  // namespace velum::render
