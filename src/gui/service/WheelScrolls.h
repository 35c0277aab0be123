#pragma once
#include <QObject>
#include <QWidget>

namespace velum::gui {

/// Makes the wheel over panels and dialogs scroll them: the wheel changes a number, a slider, a list that drops down or
/// a row of tabs only while this control has the keyboard, and does not give it the keyboard. Otherwise a control that
/// comes under the pointer while a panel scrolls would change unnoticed.
class WheelScrolls : public QObject {
  Q_OBJECT
 public:
  explicit WheelScrolls(QWidget& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace velum::gui
