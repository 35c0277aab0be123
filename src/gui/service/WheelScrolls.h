#pragma once
#include <QObject>
#include <QWidget>

namespace velum::gui {

/// The wheel over panels and dialogs scrolls them: it changes a number, a slider, a list that drops down or a row of
/// tabs only while that has the keyboard, which the wheel does not give it. What is under the pointer as a panel
/// scrolls would change unseen otherwise.
class WheelScrolls : public QObject {
  Q_OBJECT
 public:
  explicit WheelScrolls(QWidget& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace velum::gui
