#include "session/Bar.h"

#include <algorithm>
#include <cmath>

namespace velum::session {

void Bar::take(Hold hold) {
  mNow = hold.start;
  Wish wish{hold.label, {}, 0};
  mHeld = std::make_unique<Held>(Held{std::move(hold), mDocument.shown(), std::move(wish), false});
}

std::string Bar::moveTo(double count) {
  if (!mHeld) return {};
  const Hold& hold = mHeld->hold;
  double left = count;
  if (hold.handle == Handle::Seen) {
    // As many more are left as of those that were left are seen.
    double seen = double(hold.start.visible()), before = double(hold.start.left());
    left = seen > 0.0 ? count * before / seen : before + count;
  }
  Solved solved = hold.solve(left);
  mHeld->isMoved = true;
  mHeld->wish.seen = std::uint64_t(std::llround(std::max(0.0, count)));
  mHeld->wish.cuts = solved.cuts;
  mNow = expectedCounts(hold.start, solved.reached, hold.total);
  put(hold.label, solved.scene);
  return solved.words;
}

std::optional<Bar::Wish> Bar::letGo() {
  if (!mHeld) return std::nullopt;
  std::unique_ptr<Held> held = std::move(mHeld);
  if (held->isMoved && held->hold.handle == Handle::Seen) return std::move(held->wish);
  mDocument.endMerge();
  return std::nullopt;
}

void Bar::giveUp() {
  if (!mHeld) return;
  std::unique_ptr<Held> held = std::move(mHeld);
  if (held->isMoved) put(held->hold.label, held->before);
  mDocument.endMerge();
}

void Bar::put(const std::string& label, const scene::Scene& from) {
  mDocument.edit(
      label,
      [&](scene::Scene& scene) {
        scene.cuts = from.cuts;
        scene.model.types = from.model.types;
        scene.model.targets = from.model.targets;
      },
      true);
}

}  // namespace velum::session
