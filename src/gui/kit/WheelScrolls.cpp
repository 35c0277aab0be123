#include "WheelScrolls.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QSlider>
#include <QTabBar>

namespace velum::gui {

namespace {

bool isChangedByWheel(const QWidget* widget) {
  return qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QSlider*>(widget) ||
         qobject_cast<const QComboBox*>(widget) || qobject_cast<const QTabBar*>(widget);
}

}  // namespace

WheelScrolls::WheelScrolls(QWidget& window) : QObject(&window) { qApp->installEventFilter(this); }

bool WheelScrolls::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish) return false;
  auto* widget = qobject_cast<QWidget*>(watched);
  if (!widget || !isChangedByWheel(widget)) return false;
  if (event->type() == QEvent::Polish) {
    if (widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
    return false;
  }
  if (widget->hasFocus()) return false;
  event->ignore();  // for what it stands in
  return true;
}

}  // namespace velum::gui
