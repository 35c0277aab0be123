// What the wheel changes.
#include <QComboBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QWheelEvent>

#include "WindowFixture.h"
#include "gui/kit/NumberField.h"
#include "scene/Scene.h"

namespace velum::gui {
namespace {

class Wheel : public Window {
 protected:
  /// As the system sends it, so that who is meant has first say over who gets the keyboard.
  void turn(QWidget& widget) {
    QPointF place(widget.rect().center());
    QWheelEvent event(place, widget.mapToGlobal(place), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&widget, &event);
  }
  template <class T>
  std::vector<T*> shownControls() {
    std::vector<T*> found;
    for (T* control : child<QWidget>("sidePanel")->template findChildren<T*>())
      if (control->isVisible() && control->isEnabled()) found.push_back(control);
    return found;
  }
};

TEST_F(Wheel, ScrollsPanelsAndChangesOnlyWhatHasTheKeyboard) {
  openPhantom();
  scene::Scene before = scene();
  std::size_t controls = 0;
  auto* tabs = child<QTabWidget>("sideTabs");
  ASSERT_TRUE(tabs);
  for (int page = 0; page < tabs->count(); ++page) {
    if (!tabs->isTabEnabled(page)) continue;
    tabs->setCurrentIndex(page);
    for (auto* number : shownControls<QAbstractSpinBox>()) turn(*number), ++controls;
    for (auto* slider : shownControls<QSlider>()) turn(*slider), ++controls;
    for (auto* box : shownControls<QComboBox>()) turn(*box), ++controls;
    EXPECT_EQ(tabs->currentIndex(), page);
    for (auto* number : shownControls<QAbstractSpinBox>()) EXPECT_NE(number->focusPolicy(), Qt::WheelFocus);
  }
  EXPECT_GT(controls, 5u);
  EXPECT_EQ(scene(), before);
  // A page that is higher than its room moves meanwhile.
  tabs->setCurrentIndex(0);
  auto numbers = shownControls<NumberField>();
  ASSERT_FALSE(numbers.empty());
  auto* area = tabs->currentWidget()->findChild<QScrollArea*>();
  if (!area) area = qobject_cast<QScrollArea*>(tabs->currentWidget());
  ASSERT_TRUE(area);
  ASSERT_GT(area->verticalScrollBar()->maximum(), 0);
  turn(*numbers.front());
  EXPECT_GT(area->verticalScrollBar()->value(), 0);
  // And what has the keyboard is changed.
  numbers.front()->setFocus();
  double value = numbers.front()->value();
  turn(*numbers.front());
  EXPECT_NE(numbers.front()->value(), value);
}

}  // namespace
}  // namespace velum::gui
