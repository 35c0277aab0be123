// The tracks of a film without a mouse.
#include "gui/timeline/TrackCanvas.h"

#include <QKeyEvent>
#include <algorithm>

#include "session/command/FilmCommands.h"

namespace velum::gui {

namespace {
constexpr int kWideStep = 10;  ///< frames
}

/// Before commands of the window that have the same keys.
bool TrackCanvas::isOwnKey(const QKeyEvent& event) const {
  if (event.modifiers() == Qt::ControlModifier)
    return event.key() == Qt::Key_C || event.key() == Qt::Key_V || event.key() == Qt::Key_A;
  if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return false;
  switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_K:
    case Qt::Key_Comma:
    case Qt::Key_Period:
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
    case Qt::Key_Plus:
    case Qt::Key_Minus:
      return true;
    case Qt::Key_Escape:
      return !mSelected.empty();
    default:
      return false;
  }
}

bool TrackCanvas::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && isOwnKey(static_cast<QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
  return QAbstractScrollArea::event(event);
}

void TrackCanvas::keyPressEvent(QKeyEvent* event) {
  if (!isOwnKey(*event)) return QAbstractScrollArea::keyPressEvent(event);
  int frames = event->modifiers() & Qt::ShiftModifier ? kWideStep : 1;
  switch (event->key()) {
    case Qt::Key_Left:
      return moveSelected(-frames / timeline().framesPerSecond);
    case Qt::Key_Right:
      return moveSelected(frames / timeline().framesPerSecond);
    case Qt::Key_Up:
    case Qt::Key_Down: {
      auto row = std::ranges::find(tracks(), mRow, &scene::Track::path) - tracks().begin();
      row = std::clamp<std::ptrdiff_t>(row + (event->key() == Qt::Key_Up ? -1 : 1), 0, std::ssize(tracks()) - 1);
      return selectRow(std::size_t(std::max<std::ptrdiff_t>(row, 0)));
    }
    case Qt::Key_K:
      return keyRow();
    case Qt::Key_Comma:
      return goToKey(-1);
    case Qt::Key_Period:
      return goToKey(1);
    case Qt::Key_Plus:
      return zoom(1.25);
    case Qt::Key_Minus:
      return zoom(0.8);
    case Qt::Key_C:
      mClips = clipsOf(tracks(), mSelected);
      return;
    case Qt::Key_V:
      return paste();
    case Qt::Key_A:
      return select(allKeys());
    case Qt::Key_Escape:
      return select({});
    default:
      return removeSelected();
  }
}

void TrackCanvas::keyReleaseEvent(QKeyEvent* event) {
  bool isArrow = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
  if (isArrow && !event->isAutoRepeat()) mDocument.endMerge();
  QAbstractScrollArea::keyReleaseEvent(event);
}

/// Where no key is selected the playhead moves.
void TrackCanvas::moveSelected(double seconds) {
  if (mSelected.empty()) return mDocument.setPlayhead(std::clamp(playhead() + seconds, 0.0, timeline().duration));
  seconds = movable(mSelected, seconds, timeline().duration);
  KeyNames moved = mSelected;
  for (KeyName& key : moved) key.time += seconds;
  change(moved.size() == 1 ? tr("Move key") : tr("Move keys"), withMoved(tracks(), mSelected, seconds, false), true);
  select(std::move(moved));
}

void TrackCanvas::keyRow() {
  if (!mRow.empty()) session::editKey(mDocument, session::SetFilmKey{mRow, -1.0, {}});
}

void TrackCanvas::removeSelected() {
  if (mSelected.empty()) return;
  change(mSelected.size() == 1 ? tr("Remove key") : tr("Remove keys"), withoutKeys(tracks(), mSelected));
}

/// Tab goes from key to key, and on to what comes next in the window.
bool TrackCanvas::focusNextPrevChild(bool next) {
  KeyNames all = allKeys();
  auto now = mSelected.empty() ? all.end() : std::ranges::find(all, mSelected.back());
  auto place = now - all.begin();
  auto to = mSelected.empty() ? (next ? 0 : -1) : place + (next ? 1 : -1);
  if (to < 0 || to >= std::ssize(all)) {
    select({});
    return QAbstractScrollArea::focusNextPrevChild(next);
  }
  mRow = all[std::size_t(to)].path;
  showTime(all[std::size_t(to)].time);
  select({all[std::size_t(to)]});
  return true;
}

void TrackCanvas::focusInEvent(QFocusEvent* event) {
  viewport()->update();
  QAbstractScrollArea::focusInEvent(event);
}

void TrackCanvas::focusOutEvent(QFocusEvent* event) {
  viewport()->update();
  QAbstractScrollArea::focusOutEvent(event);
}

}  // namespace velum::gui
