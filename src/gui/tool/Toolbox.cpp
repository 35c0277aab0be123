#include "gui/tool/Toolbox.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QWindow>
#include <algorithm>
#include <utility>

#include "gui/tool/HandlePaint.h"
#include "gui/tool/ToolOverlay.h"

namespace velum::gui {

namespace {

/// A pointer's event as handlers get it. @param button  that the event is about; none for a move
PointerEvent pointerEvent(const ViewPoint& at, const QMouseEvent& event) {
  return {at, event.button(), event.modifiers(), event.globalPosition().toPoint()};
}

}  // namespace

Toolbox::Toolbox(const session::Document& document, QWidget& window)
    : QObject(&window), mDocument(document), mWindow(window) {
  qApp->installEventFilter(this);
}

void Toolbox::addView(ToolView& view) { mViews.push_back({&view, new ToolOverlay(*this, view)}); }

void Toolbox::bind(Tool& tool, QAbstractButton& button) {
  button.setCheckable(true);
  connect(&button, &QAbstractButton::clicked, this, [this, &tool, &button](bool on) {
    on ? start(tool) : stop(tool);
    button.setChecked(tool.isActive());
  });
  connect(&tool, &Tool::activeChanged, &button, &QAbstractButton::setChecked);
}

void Toolbox::bind(Tool& tool, QAction& action) {
  action.setCheckable(true);
  connect(&action, &QAction::triggered, this, [this, &tool, &action](bool on) {
    on ? start(tool) : stop(tool);
    action.setChecked(tool.isActive());
  });
  connect(&tool, &Tool::activeChanged, &action, &QAction::setChecked);
}

// Which tool is active.

void Toolbox::start(Tool& tool) {
  if (mActive == &tool) return;
  stop();
  if (!tool.start()) return;
  mActive = &tool;
  tool.mIsActive = true;
  showCursors();
  repaint();
  emit tool.activeChanged(true);
  emit activeChanged(&tool);
}

void Toolbox::stop() {
  if (!mActive) return;
  Tool* was = std::exchange(mActive, nullptr);
  was->mIsActive = false;
  if (mHolder == was) mHolder = nullptr;
  was->stop();
  mKeyPointer.letGo();
  showCursors();
  repaint();
  emit was->activeChanged(false);
  emit activeChanged(nullptr);
}

void Toolbox::stop(const Tool& tool) {
  if (mActive == &tool) stop();
}

void Toolbox::setHandlesShown(bool shown) {
  if (mHandlesShown == shown) return;
  leave();
  mHandlesShown = shown;
  repaint();
  emit handlesShownChanged(shown);
}

void Toolbox::showCursors() {
  for (const Place& place : mViews)
    place.view->widget().setCursor(mActive ? Qt::CrossCursor : place.view->restCursor());
}

// The pointer: one chain for all.

bool Toolbox::hasHandles(const ToolView& view) const {
  return mHandlesShown && view.showsHandles() && !(mActive && mActive->hidesHandles());
}

std::vector<Manipulator*> Toolbox::chainOf(const ToolView& view) const {
  std::vector<Manipulator*> chain;
  if (mActive) chain.push_back(mActive);
  if (hasHandles(view)) chain.insert(chain.end(), mManipulators.begin(), mManipulators.end());
  return chain;
}

bool Toolbox::press(ToolView& view, const QMouseEvent& event) {
  if (mHolder) return true;
  ViewPoint at(view, mDocument.shown(), event.position());
  for (Manipulator* next : chainOf(view)) {
    mHolder = next;  // a tool that ends with the press lets go of it itself
    if (next->press(pointerEvent(at, event))) return true;
    mHolder = nullptr;
  }
  return false;
}

bool Toolbox::drag(ToolView& view, const QMouseEvent& event) {
  if (!mHolder) return false;
  ViewPoint at(view, mDocument.shown(), event.position());
  mHolder->drag(pointerEvent(at, event));
  return true;
}

bool Toolbox::release(ToolView& view, const QMouseEvent& event) {
  if (!mHolder) return false;
  if (event.buttons() != Qt::NoButton) return true;
  ViewPoint at(view, mDocument.shown(), event.position());
  std::exchange(mHolder, nullptr)->release(pointerEvent(at, event));
  return true;
}

bool Toolbox::click(ToolView& view, const QMouseEvent& event) {
  if (!mActive || event.button() != Qt::LeftButton) return false;
  ViewPoint at(view, mDocument.shown(), event.position());
  mActive->click(pointerEvent(at, event));
  return true;
}

bool Toolbox::wheel(ToolView& view, const QWheelEvent& event) {
  QPoint turn = event.angleDelta();  // with Alt, Qt takes it for a sideways one
  double notches = (turn.y() != 0 ? turn.y() : turn.x()) / 120.0;
  ViewPoint at(view, mDocument.shown(), event.position());
  PointerEvent pointer{at, Qt::NoButton, event.modifiers(), event.globalPosition().toPoint()};
  auto chain = chainOf(view);
  return notches != 0.0 &&
         std::any_of(chain.begin(), chain.end(), [&](Manipulator* next) { return next->wheel(pointer, notches); });
}

std::optional<Qt::CursorShape> Toolbox::hover(ToolView& view, QPointF place) {
  if (mHolder) return std::nullopt;
  ViewPoint at(view, mDocument.shown(), place);
  std::optional<Qt::CursorShape> cursor;
  for (Manipulator* next : chainOf(view)) {
    if (!cursor)
      cursor = next->hover(at);
    else
      next->leave();
  }
  if (!cursor && mActive) return Qt::CrossCursor;
  return cursor;
}

void Toolbox::leave() {
  if (mHolder) return;
  if (mActive) mActive->leave();
  for (Manipulator* each : mManipulators) each->leave();
}

void Toolbox::pressAt(ToolView& view, QPointF place) {
  if (mHolder || !mActive) return;
  ViewPoint at(view, mDocument.shown(), place);
  mHolder = mActive;
  if (!mActive->press({at, Qt::LeftButton, Qt::NoModifier, view.widget().mapToGlobal(place).toPoint()}))
    mHolder = nullptr;
}

void Toolbox::dragAt(ToolView& view, QPointF place) {
  ViewPoint at(view, mDocument.shown(), place);
  if (mHolder) mHolder->drag({at, Qt::NoButton, Qt::NoModifier, view.widget().mapToGlobal(place).toPoint()});
}

void Toolbox::releaseAt(ToolView& view, QPointF place, bool isClick) {
  ViewPoint at(view, mDocument.shown(), place);
  PointerEvent event{at, Qt::LeftButton, Qt::NoModifier, view.widget().mapToGlobal(place).toPoint()};
  if (mHolder)
    std::exchange(mHolder, nullptr)->release(event);
  else if (isClick && mActive)
    mActive->click(event);
}

void Toolbox::hoverAt(ToolView& view, QPointF place) {
  ViewPoint at(view, mDocument.shown(), place);
  if (mActive && !mHolder) mActive->hover(at);
}

bool Toolbox::isInTheWay(const ViewPoint& at) const {
  return hasHandles(at.view()) && std::any_of(mManipulators.begin(), mManipulators.end(),
                                              [&](const Manipulator* each) { return each->isInTheWay(at); });
}

// Keys.

bool Toolbox::isOurs(const QObject* watched) const {
  if (const auto* widget = qobject_cast<const QWidget*>(watched)) return widget->window() == &mWindow;
  return watched == mWindow.windowHandle();
}

KeyAnswer Toolbox::answerTo(const KeyStroke& stroke) {
  if (mActive)
    if (KeyAnswer answer = mActive->key(stroke)) return answer;
  if (mActive && stroke.key == Qt::Key_Escape) return [this] { stop(); };
  if (!mHandlesShown) return {};
  for (Manipulator* each : mManipulators)
    if (KeyAnswer answer = each->key(stroke)) return answer;
  return {};
}

ToolView* Toolbox::viewWithKeyboard(const QObject* watched) const {
  for (const Place& place : mViews) {
    const QWidget* widget = &place.view->widget();
    if (widget == mWindow.focusWidget() || widget == watched) return place.view;
  }
  return nullptr;
}

/// Before commands of the window that have the same keys.
bool Toolbox::eventFilter(QObject* watched, QEvent* event) {
  bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (!isKey || !isOurs(watched)) return QObject::eventFilter(watched, event);
  if (QApplication::activeModalWidget() || QApplication::activePopupWidget()) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  const QWidget* focus = mWindow.focusWidget();
  ToolView* view = viewWithKeyboard(watched);
  KeyStroke stroke{key->key(), key->modifiers(), view,
                   qobject_cast<const QLineEdit*>(focus) || qobject_cast<const QAbstractSpinBox*>(focus)};
  KeyAnswer answer = answerTo(stroke);
  if (!answer && mActive && view) answer = mKeyPointer.key(stroke, *view);
  if (!answer) return false;
  event->accept();
  if (event->type() == QEvent::KeyPress) answer();
  return true;
}

// What is shown.

void Toolbox::refresh() {
  for (Manipulator* each : mManipulators) each->refresh();
  if (mActive) mActive->refresh();
}

void Toolbox::repaint() {
  for (const Place& place : mViews) place.overlay->update();
}

void Toolbox::repaint(const ToolView& view) {
  for (const Place& place : mViews)
    if (place.view == &view) place.overlay->update();
}

void Toolbox::paint(ViewPainter& over) const {
  for (auto each = mManipulators.rbegin(); each != mManipulators.rend(); ++each)
    if (hasHandles(over.view) || (*each)->isOfPicture()) (*each)->paint(over);
  if (!mActive) return;
  mActive->paint(over);
  mKeyPointer.paint(over);
  // In one view is enough: the first that is shown.
  auto first =
      std::find_if(mViews.begin(), mViews.end(), [](const Place& place) { return place.view->widget().isVisible(); });
  if (first != mViews.end() && first->view == &over.view) drawHint(over.painter, over.size, mActive->hint());
}

}  // namespace velum::gui
