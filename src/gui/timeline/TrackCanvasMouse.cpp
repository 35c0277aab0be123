// The hand on the tracks of a film. What is dragged is worked out from what it was when the drag began.
#include "gui/timeline/TrackCanvas.h"

#include <fmt/format.h>

#include <QMouseEvent>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

#include "gui/timeline/KeyPaint.h"
#include "gui/timeline/TrackCanvasSizes.h"
#include "scene/timeline/Tracks.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"
#include "session/command/FilmCommands.h"

namespace velum::gui {

namespace {
constexpr double kStillHand = 3.0;  ///< pixels: a hand that clicks moves less
}

void TrackCanvas::mousePressEvent(QMouseEvent* event) {
  if (mDrag != Drag::None) return;
  Hit hit = hitAt(event->position());
  mPressed = mLast = event->position();
  mHasMoved = false;
  mStart = tracks();
  mStartSelected = mSelected;
  bool adds = event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier);
  if (event->button() == Qt::MiddleButton) {
    mDrag = Drag::Pan;
    return viewport()->setCursor(Qt::ClosedHandCursor);
  }
  if (event->button() != Qt::LeftButton) return;
  using Part = Hit::Part;
  if (hit.part != Part::Ruler && hit.part != Part::RangeStart && hit.part != Part::RangeEnd) selectRow(hit.row);
  switch (hit.part) {
    case Part::Ruler:
      mDrag = Drag::Playhead;
      return scrubTo(snapped(mScale.timeAt(mPressed.x())));
    case Part::RangeStart:
      mDrag = Drag::RangeStart;
      return;
    case Part::RangeEnd:
      mDrag = Drag::RangeEnd;
      return;
    case Part::Eye:
      return toggle(hit.row);
    case Part::Key:
      return pressKey(hit.key, event->modifiers());
    default:
      mDrag = Drag::Band;
      if (!adds) select({});
      mStartSelected = mSelected;
  }
}

/// A press with Shift or Ctrl takes a key in or out; any other one leaves keys together that are selected together.
void TrackCanvas::pressKey(const KeyName& key, Qt::KeyboardModifiers keys) {
  mGrabbed = key;
  mDrag = Drag::Keys;
  if (keys & (Qt::ShiftModifier | Qt::ControlModifier)) {
    KeyNames next = mSelected;
    if (std::erase(next, key) == 0) next.push_back(key);
    select(std::move(next));
  } else if (!isSelected(key)) {
    select({key});
  }
  mStartSelected = mSelected;
}

void TrackCanvas::mouseMoveEvent(QMouseEvent* event) {
  QPointF place = event->position();
  if (mDrag == Drag::None) {
    Hit hit = hitAt(place);
    auto hover = hit.part == Hit::Part::Key ? std::optional(hit.key) : std::nullopt;
    bool isEnd = hit.part == Hit::Part::RangeStart || hit.part == Hit::Part::RangeEnd;
    viewport()->setCursor(isEnd ? Qt::SizeHorCursor : hover ? Qt::PointingHandCursor : Qt::ArrowCursor);
    if (std::exchange(mHover, hover) != hover) viewport()->update();
    return;
  }
  QPointF off = place - mPressed;
  mHasMoved = mHasMoved || std::hypot(off.x(), off.y()) > kStillHand;
  switch (mDrag) {
    case Drag::Playhead:
      scrubTo(std::min(snapped(mScale.timeAt(place.x())), timeline().duration));
      break;
    case Drag::RangeStart:
    case Drag::RangeEnd:
      if (mHasMoved) dragRange(std::min(snapped(mScale.timeAt(place.x())), timeline().duration));
      break;
    case Drag::Keys:
      if (mHasMoved) dragKeys(place, event->modifiers() & Qt::AltModifier);
      break;
    case Drag::Band:
      if (mHasMoved) dragBand(place, !mStartSelected.empty());
      break;
    case Drag::Pan:
      pan(place.x() - mLast.x());
      break;
    case Drag::None:
      break;
  }
  mLast = place;
}

void TrackCanvas::dragKeys(QPointF place, bool copies) {
  if (mStartSelected.empty()) return;
  double wanted = mGrabbed.time + (place.x() - mPressed.x()) / mScale.pixelsPerSecond;
  double seconds = movable(mStartSelected, snapped(wanted, mSelected) - mGrabbed.time, timeline().duration);
  Tracks next = withMoved(mStart, mStartSelected, seconds, copies);
  change(mStartSelected.size() == 1 ? tr("Move key") : tr("Move keys"), next, true);
  KeyNames moved = mStartSelected;
  for (KeyName& key : moved) key.time += seconds;
  select(std::move(moved));
}

/// The end of the range at the end of the film goes with it.
void TrackCanvas::dragRange(double time) {
  bool isStart = mDrag == Drag::RangeStart;
  double frame = 1.0 / timeline().framesPerSecond;
  if (isStart) time = std::clamp(time, 0.0, std::max(0.0, rangeEnd() - frame));
  if (!isStart) time = std::max(time, timeline().rangeStart + frame);
  if (!isStart && time >= timeline().duration - 1e-9) time = 0.0;
  session::edit(mDocument,
                session::SetField{isStart ? "timeline.rangeStart" : "timeline.rangeEnd", fmt::format("{}", time)}, true,
                tr("Change range of film").toStdString());
}

void TrackCanvas::dragBand(QPointF place, bool adds) {
  mBand = QRectF(mPressed, place).normalized();
  KeyNames inside = adds ? mStartSelected : KeyNames();
  for (const KeyName& key : allKeys())
    if (auto at = placeOf(key); at && mBand.contains(*at) && std::ranges::find(inside, key) == inside.end())
      inside.push_back(key);
  select(std::move(inside));
}

void TrackCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->buttons() != Qt::NoButton || mDrag == Drag::None) return;
  bool isClickOnKey = mDrag == Drag::Keys && !mHasMoved;
  if (isClickOnKey && !(event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier))) select({mGrabbed});
  if (mDrag == Drag::Keys || mDrag == Drag::RangeStart || mDrag == Drag::RangeEnd) mDocument.endMerge();
  mDrag = Drag::None;
  mBand = {};
  viewport()->setCursor(Qt::ArrowCursor);
  refresh();
}

/// On a row a key is made there, of what the film shows there; on a key its menu opens.
void TrackCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  Hit hit = hitAt(event->position());
  if (event->button() != Qt::LeftButton || (hit.part != Hit::Part::Row && hit.part != Hit::Part::Key))
    return mousePressEvent(event);
  if (hit.part == Hit::Part::Key) {
    select({hit.key});
    QMenu menu(this);
    fillKeyMenu(menu);
    menu.exec(event->globalPosition().toPoint());
    return;
  }
  KeyName made{hit.key.path, std::min(snapped(hit.key.time), scene::kLongestFilm)};
  mDocument.setPlayhead(made.time);
  session::editKey(mDocument, session::SetFilmKey{made.path, made.time, {}});
  select({made});
}

void TrackCanvas::wheelEvent(QWheelEvent* event) {
  QPoint turn = event->angleDelta();
  if (event->modifiers() & Qt::ControlModifier) {
    mIsFitted = false;
    mScale = zoomed(mScale, mScale.timeAt(event->position().x()), std::pow(1.2, turn.y() / 120.0));
    viewport()->update();
  } else if (event->modifiers() & (Qt::ShiftModifier | Qt::AltModifier) || std::abs(turn.x()) > std::abs(turn.y())) {
    pan(turn.x() != 0 ? turn.x() : turn.y());
  } else {
    verticalScrollBar()->setValue(verticalScrollBar()->value() - turn.y() / 2);
  }
  event->accept();
}

// Menus.

void TrackCanvas::contextMenuEvent(QContextMenuEvent* event) {
  if (mDrag != Drag::None) return;
  bool isKeyboard = event->reason() == QContextMenuEvent::Keyboard;
  Hit hit = hitAt(event->pos());
  QPoint place = event->globalPos();
  QMenu menu(this);
  menu.setToolTipsVisible(true);
  if (isKeyboard && !mSelected.empty()) {
    if (auto at = placeOf(mSelected.front())) place = viewport()->mapToGlobal(at->toPoint());
    fillKeyMenu(menu);
  } else if (hit.part == Hit::Part::Key) {
    if (!isSelected(hit.key)) select({hit.key});
    mGrabbed = hit.key;
    fillKeyMenu(menu);
  } else if (hit.part == Hit::Part::Row || hit.part == Hit::Part::Title || hit.part == Hit::Part::Eye) {
    selectRow(hit.row);
    fillRowMenu(menu, hit.row);
  }
  if (!menu.isEmpty()) menu.exec(place);
}

void TrackCanvas::fillKeyMenu(QMenu& menu) {
  menu.setToolTipsVisible(true);
  std::optional<scene::Ease> now;
  if (auto clips = clipsOf(tracks(), mSelected); !clips.empty()) now = clips.front().key.ease;
  for (std::size_t i = 0; i < std::size(EnumNames<scene::Ease>::kNames); ++i) {
    auto ease = scene::Ease(i);
    QAction* entry = menu.addAction(easeIcon(ease, palette()), easeName(ease), this,
                                    [this, ease] { change(tr("Ease keys"), withEase(tracks(), mSelected, ease)); });
    entry->setToolTip(easeMeaning(ease));
    if (now == ease) menu.setDefaultAction(entry);
  }
  menu.addSeparator();
  menu.addAction(tr("Copy"), this, [this] { mClips = clipsOf(tracks(), mSelected); });
  menu.addAction(tr("Paste at the playhead"), this, [this] { paste(); })->setEnabled(!mClips.empty());
  menu.addAction(tr("Delete"), this, [this] { removeSelected(); });
  menu.addSeparator();
  menu.addAction(tr("Go there"), this, [this] {
    if (!mSelected.empty()) mDocument.setPlayhead(mSelected.front().time);
  });
}

void TrackCanvas::fillRowMenu(QMenu& menu, std::size_t row) {
  const scene::Track& track = tracks()[row];
  menu.addAction(tr("Key at the playhead"), this, [this] { keyRow(); });
  menu.addAction(tr("Paste at the playhead"), this, [this] { paste(); })->setEnabled(!mClips.empty());
  menu.addSeparator();
  menu.addAction(track.enabled ? tr("Disable") : tr("Enable"), this, [this, row] { toggle(row); });
  menu.addAction(tr("Remove track"), this, [this, path = track.path] {
    Tracks left = tracks();
    std::erase_if(left, [&](const scene::Track& one) { return one.path == path; });
    change(tr("Remove track"), left);
  });
}

void TrackCanvas::toggle(std::size_t row) {
  Tracks next = tracks();
  if (row >= next.size()) return;
  next[row].enabled = !next[row].enabled;
  change(next[row].enabled ? tr("Enable track") : tr("Disable track"), next);
}

void TrackCanvas::paste() {
  if (mClips.empty()) return;
  double first = scene::kLongestFilm;
  for (const KeyClip& clip : mClips) first = std::min(first, clip.key.time);
  KeyNames pasted;
  for (const KeyClip& clip : mClips) pasted.push_back({clip.path, playhead() + clip.key.time - first});
  change(tr("Paste keys"), withPasted(tracks(), mClips, playhead()));
  select(std::move(pasted));
}

}  // namespace velum::gui
