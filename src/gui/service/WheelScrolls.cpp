#include "gui/service/WheelScrolls.h"

#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QSlider>
#include <QTabBar>
#include <QWheelEvent>

namespace velum::gui {

namespace {

bool isChangedByWheel(const QWidget* widget) {
  return qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QSlider*>(widget) ||
         qobject_cast<const QComboBox*>(widget) || qobject_cast<const QTabBar*>(widget);
}

/// Hands the wheel to the page that the widget stands in, if that page scrolls.
void giveToPage(QWidget& widget, QWheelEvent& event) {
  QWidget* at = widget.parentWidget();
  while (at && !qobject_cast<QAbstractScrollArea*>(at)) at = at->parentWidget();
  if (!at) return event.ignore();
  QWidget* page = static_cast<QAbstractScrollArea*>(at)->viewport();
  QPointF place = page->mapFromGlobal(event.globalPosition());
  QWheelEvent there(place, event.globalPosition(), event.pixelDelta(), event.angleDelta(), event.buttons(),
                    event.modifiers(), event.phase(), event.inverted());
  QApplication::sendEvent(page, &there);
  event.accept();
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
  giveToPage(*widget, static_cast<QWheelEvent&>(*event));
  return true;
}

}  // namespace velum::gui
