#pragma once
#include <QObject>
#include <QWidget>

namespace velum::gui {

/// Undo and redo in a field take back what is typed there, and nothing else: of a field in which nothing has been typed
/// since it was entered they are the window's. Fields keep the keys for themselves otherwise, to no effect.
class FieldUndo : public QObject {
  Q_OBJECT
 public:
  explicit FieldUndo(QWidget& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace velum::gui
