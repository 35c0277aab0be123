#include "gui/rows/FieldKey.h"

#include <QCheckBox>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QPainter>
#include <algorithm>
#include <memory>
#include <utility>

#include "gui/kit/Widgets.h"
#include "scene/timeline/Tracks.h"
#include "session/command/FilmCommands.h"

namespace velum::gui {

namespace {

/// Pixels between a mark and the end of the control over which it stands; and what the arrow of a choice takes there.
constexpr int kOverMargin = 4, kArrowRoom = 20;

/// Whether a film has keys of a field, and one at the playhead.
struct KeyState {
  std::string path;  ///< of the track
  bool hasTrack = false, isHere = false;
};

/// Nothing for a field that a film cannot change. A field may be a part of what has a track as a whole.
std::optional<KeyState> keyState(const session::Document& document, const std::string& path) {
  const scene::Timeline& film = document.scene().timeline;
  auto of = path.empty() ? std::nullopt : scene::trackPathOf(document.scene(), path);
  if (!of) return std::nullopt;
  const scene::Track* track = scene::findTrack(film, *of);
  for (const scene::Track& whole : film.tracks)
    if (!track && of->starts_with(whole.path + ".")) track = &whole;
  if (!track) return KeyState{*of};
  return KeyState{track->path, true, scene::keyAt(*track, document.playhead().value_or(0.0)).has_value()};
}

void toggleKey(session::Document& document, const KeyState& state) {
  state.isHere ? session::editKey(document, session::RemoveFilmKey{state.path, -1.0})
               : session::editKey(document, session::SetFilmKey{state.path, -1.0, {}});
}

}  // namespace

void addKeyEntry(QMenu& menu, session::Document& document, const std::string& path, const QString& what) {
  auto state = keyState(document, path);
  if (!state) return;
  QString set = what.isEmpty() ? FieldKey::tr("Key this") : FieldKey::tr("Key %1").arg(what);
  QString remove = what.isEmpty() ? FieldKey::tr("Remove key") : FieldKey::tr("Remove key of %1").arg(what);
  QAction* entry =
      menu.addAction(state->isHere ? remove : set, &menu, [&document, state = *state] { toggleKey(document, state); });
  entry->setToolTip(FieldKey::tr("What it is at the playhead of the film"));
}

FieldKey::FieldKey(session::Document& document, const QString& title, std::function<std::string()> path,
                   QWidget* parent)
    : QAbstractButton(parent), mDocument(document), mPath(std::move(path)) {
  setObjectName("fieldKey");
  setAccessibleName(tr("Key of %1").arg(title));
  setFocusPolicy(Qt::TabFocus);
  setFixedSize(sizeHint());
  connect(this, &QAbstractButton::clicked, this, [this] {
    if (auto state = keyState(mDocument, mPath())) toggleKey(mDocument, *state);
  });
  hide();
}

void FieldKey::watch(QWidget* control) {
  control->installEventFilter(this);
  for (auto* inner : control->findChildren<QWidget*>()) inner->installEventFilter(this);
}

void FieldKey::standOver(QWidget* control) {
  setParent(control);
  mOver = control;
  place();
}

/// Behind the words of a tick box, in front of the arrow of a choice.
void FieldKey::place() {
  int end = mOver->width() - kOverMargin;
  if (qobject_cast<QCheckBox*>(mOver))
    end = std::min(mOver->width(), mOver->sizeHint().width() + width() + kOverMargin);
  if (qobject_cast<QComboBox*>(mOver)) end -= kArrowRoom;
  move(end - width(), (mOver->height() - height()) / 2);
}

void FieldKey::refresh(bool isShown) {
  bool hasFilm = isShown && !mDocument.scene().timeline.tracks.empty();
  auto state = hasFilm ? keyState(mDocument, mPath()) : std::nullopt;
  setVisible(state && state->hasTrack);
  mIsHere = state && state->isHere;
  if (!state) return;
  setToolTip(mIsHere ? tr("A film changes it; its key at the playhead: click to remove it")
                     : tr("A film changes it; click for a key at the playhead"));
  update();
}

bool FieldKey::eventFilter(QObject* watched, QEvent* event) {
  if (watched == mOver && event->type() == QEvent::Resize) place();
  if (event->type() != QEvent::ContextMenu || !keyState(mDocument, mPath()))
    return QAbstractButton::eventFilter(watched, event);
  auto* control = qobject_cast<QWidget*>(watched);
  if (!control || !control->isEnabled()) return false;
  showMenu(*control, static_cast<QContextMenuEvent*>(event)->globalPos());
  return true;
}

/// Behind what the control's own menu has.
void FieldKey::showMenu(QWidget& control, QPoint globalPlace) {
  auto* text = qobject_cast<QLineEdit*>(&control);
  if (!text) text = control.findChild<QLineEdit*>();
  std::unique_ptr<QMenu> menu(text ? text->createStandardContextMenu() : new QMenu(&control));
  if (text) menu->addSeparator();
  addKeyEntry(*menu, mDocument, mPath());
  menu->exec(globalPlace);
}

void FieldKey::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(5.5, 0.5 * height());
  double r = underMouse() ? 5.2 : 4.4;
  auto* onColor = qobject_cast<ColorButton*>(mOver);
  QColor accent = onColor ? onColor->ink() : palette().color(QPalette::Link);
  painter.setPen(QPen(accent, 1.3));
  painter.setBrush(mIsHere ? QBrush(accent) : QBrush(Qt::NoBrush));
  painter.drawPolygon(QPolygonF{{0, -r}, {r, 0}, {0, r}, {-r, 0}});
}

}  // namespace velum::gui
