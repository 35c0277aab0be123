#include "gui/service/FieldUndo.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>

namespace velum::gui {

namespace {

/// Where the text of a control is typed; nothing where none is.
QLineEdit* textOf(QObject* control) {
  if (auto* edit = qobject_cast<QLineEdit*>(control)) return edit;
  if (auto* list = qobject_cast<QComboBox*>(control)) return list->lineEdit();
  if (qobject_cast<QAbstractSpinBox*>(control)) return control->findChild<QLineEdit*>();
  return nullptr;
}

}  // namespace

FieldUndo::FieldUndo(QWidget& window) : QObject(&window) { qApp->installEventFilter(this); }

bool FieldUndo::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  auto& key = static_cast<QKeyEvent&>(*event);
  bool isUndo = key.matches(QKeySequence::Undo), isRedo = key.matches(QKeySequence::Redo);
  if (!isUndo && !isRedo) return false;
  auto isTyped = [&](const auto& text) { return isUndo ? text.isUndoAvailable() : text.isRedoAvailable(); };
  QLineEdit* edit = textOf(watched);
  auto* lines = qobject_cast<QPlainTextEdit*>(watched);
  if ((!edit && !lines) || (edit ? isTyped(*edit) : isTyped(*lines->document()))) return false;
  event->ignore();
  return true;
}

}  // namespace velum::gui
