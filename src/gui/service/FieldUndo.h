#pragma once
#include <QObject>
#include <QWidget>

namespace velum::gui {

/// Gives the keys of undo and redo to the window while the field with the keyboard has no typed text to undo or redo.
/// In a field with typed text the keys act on this text, and on nothing else. Without this class a field would take the
/// keys even when they have no effect there.
class FieldUndo : public QObject {
  Q_OBJECT
 public:
  explicit FieldUndo(QWidget& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace velum::gui
