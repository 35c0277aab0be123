// The knobs of a ModelList's bars, under the pointer and by keys.
#include <algorithm>
#include <cmath>

#include "gui/model/ModelList.h"

namespace velum::gui {

/// The handle nearest to the pointer; of two handles at one place, the one on whose side of it the pointer is.
Equalizer::Handle ModelList::handleAt(const QModelIndex& index, double x) const {
  CountBar bar = mDelegate->barOf(rowOf(index), visualRect(index.siblingAtColumn(ModelTree::Bar)));
  double at = x - bar.box.left(), toSeen = std::abs(at - bar.seen), toLeft = std::abs(at - bar.left);
  if (toSeen == toLeft) return at < bar.seen ? Equalizer::Handle::Seen : Equalizer::Handle::Left;
  return toSeen < toLeft ? Equalizer::Handle::Seen : Equalizer::Handle::Left;
}

bool ModelList::takeHandle(const QModelIndex& index, double x) {
  const TypeTree::Row& row = rowOf(index);
  if (mTree->countOf(row).total() == 0) return false;
  selectRowOf(index, ModelTree::Name);
  mHeldBar = index;
  Equalizer::Handle handle = handleAt(index, x);
  CountBar bar = mDelegate->barOf(row, visualRect(index));
  mEqualizer.take(row.path, handle);
  holdKnob(x, bar.box.left() + (handle == Equalizer::Handle::Seen ? bar.seen : bar.left));
  return true;
}

void ModelList::dragKnob(double x) {
  if (!mHeldBar.isValid()) return;
  const TypeTree::Row& row = rowOf(mHeldBar);
  CountBar bar = mDelegate->barOf(row, visualRect(QModelIndex(mHeldBar).siblingAtColumn(ModelTree::Bar)));
  if (bar.box.isEmpty()) return;
  double total = double(mTree->countOf(row).total());
  mEqualizer.moveTo(std::round(bar.countAt(x, mTree->scale(), total)));
}

void ModelList::letKnobGo() {
  mEqualizer.letGo();
  mHeldBar = QModelIndex();
}

void ModelList::giveKnobUp() {
  mHeldBar = QModelIndex();
  mEqualizer.giveUp();
}

void ModelList::stepKnob(int steps, bool isSeen) {
  if (!currentIndex().isValid()) return;
  Equalizer::Handle handle = isSeen ? Equalizer::Handle::Seen : Equalizer::Handle::Left;
  const TypeTree::Row& row = rowOf(currentIndex());
  Counts count = mTree->countOf(row);
  if (count.total() == 0) return;
  double by = std::max(1.0, std::round(kStep * double(count.total()))) * steps;
  auto now = double(handle == Equalizer::Handle::Left ? count.left() : count.visible());
  mEqualizer.set(row.path, handle, std::clamp(now + by, 0.0, double(count.total())));
}

}  // namespace velum::gui
