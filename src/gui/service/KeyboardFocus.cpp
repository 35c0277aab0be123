#include "gui/service/KeyboardFocus.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollArea>
#include <QTabBar>

namespace velum::gui {

namespace {

constexpr int kReach = 3;  // pixels of the ring beyond its widget
constexpr double kWidth = 2.0, kRound = 6.0;

class Ring : public QWidget {
 public:
  explicit Ring(QWidget* parent) : QWidget(parent) {
    setObjectName("focusRing");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Link), kWidth));
    double inset = 0.5 * kWidth;
    painter.drawRoundedRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset), kRound, kRound);
  }
};

/// The widget that the ring is a child of: the one that scrolls with the marked widget, or else its window.
QWidget* hostOf(QWidget* widget) {
  for (QWidget* p = widget->parentWidget(); p; p = p->parentWidget()) {
    auto* area = p->parentWidget() ? qobject_cast<QScrollArea*>(p->parentWidget()->parentWidget()) : nullptr;
    if (p->isWindow() || (area && area->widget() == p)) return p;
  }
  return nullptr;
}

/// Keys that a control answers to, and that commands of the window have, too.
bool wants(const QWidget* control, const QKeyEvent& event) {
  if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return false;
  bool isList = qobject_cast<const QAbstractItemView*>(control) || qobject_cast<const QComboBox*>(control);
  bool isNumber = qobject_cast<const QAbstractSlider*>(control) || qobject_cast<const QAbstractSpinBox*>(control);
  switch (event.key()) {
    case Qt::Key_Space:
      return isList || qobject_cast<const QAbstractButton*>(control);
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      return isList || isNumber;
    default:
      return false;
  }
}

}  // namespace

KeyboardFocus::KeyboardFocus(QWidget& window, std::function<QWidget*()> home)
    : QObject(&window), mWindow(window), mHome(std::move(home)) {
  qApp->installEventFilter(this);
}

/// True for widgets of the window or of a dialog over it; popups have a mark of their own.
bool KeyboardFocus::isOurs(const QWidget* widget) const {
  for (const QWidget* p = widget; p; p = p->parentWidget()) {
    if (p == &mWindow) return true;
    if (p->windowType() == Qt::Popup) return false;
  }
  return false;
}

bool KeyboardFocus::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      mLastWasKey = false;
      break;
    case QEvent::KeyPress:
      mLastWasKey = true;
      if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) return goHome(watched);
      break;
    case QEvent::ShortcutOverride:
      if (auto* widget = qobject_cast<QWidget*>(watched); widget && wants(widget, *static_cast<QKeyEvent*>(event)))
        event->accept();
      break;
    case QEvent::FocusIn:
      if (auto* widget = qobject_cast<QWidget*>(watched)) focusCame(widget, static_cast<QFocusEvent*>(event)->reason());
      break;
    case QEvent::FocusOut:
      if (watched == mTarget) focusWent(mTarget, static_cast<QFocusEvent*>(event)->reason());
      break;
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
      if (auto* widget = qobject_cast<QWidget*>(watched);
          widget && mTarget && (widget == mTarget || widget->isAncestorOf(mTarget)))
        placeRing();
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

void KeyboardFocus::focusCame(QWidget* widget, Qt::FocusReason reason) {
  if (!isOurs(widget)) return;
  switch (reason) {
    case Qt::TabFocusReason:
    case Qt::BacktabFocusReason:
    case Qt::ShortcutFocusReason:
      return mark(widget);
    case Qt::ActiveWindowFocusReason:
      return mark(mLastWasKey ? widget : nullptr);
    case Qt::PopupFocusReason:
    case Qt::MenuBarFocusReason:
      return;
    default:
      return mark(nullptr);
  }
}

void KeyboardFocus::focusWent(QWidget*, Qt::FocusReason reason) {
  if (reason != Qt::PopupFocusReason && reason != Qt::MenuBarFocusReason && reason != Qt::ActiveWindowFocusReason)
    mark(nullptr);
}

/// Esc that no widget in the window has used: the keyboard goes to the home view.
bool KeyboardFocus::goHome(QObject* watched) {
  if (watched != &mWindow) return false;
  QWidget *home = mHome(), *now = mWindow.focusWidget();
  if (!home || !now || now == home || now->parentWidget() == home->parentWidget()) return false;
  home->setFocus(Qt::ShortcutFocusReason);
  return true;
}

void KeyboardFocus::mark(QWidget* target) {
  mTarget = target;
  placeRing();
}

void KeyboardFocus::placeRing() {
  QWidget* host = mTarget && mTarget->isVisible() ? hostOf(mTarget) : nullptr;
  if (!host) {
    if (mRing) mRing->hide();
    return;
  }
  if (!mRing || mRing->parentWidget() != host) {
    delete mRing;
    mRing = new Ring(host);
  }
  const auto* tabs = qobject_cast<QTabBar*>(mTarget.data());
  QRect rect = tabs ? tabs->tabRect(tabs->currentIndex()) : mTarget->rect();
  rect.moveTopLeft(mTarget->mapTo(host, rect.topLeft()));
  mRing->setGeometry(rect.adjusted(-kReach, -kReach, kReach, kReach) & host->rect());
  mRing->raise();
  mRing->show();
}

}  // namespace velum::gui
