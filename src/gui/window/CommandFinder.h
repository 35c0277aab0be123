#pragma once
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>

#include "kit/ActionTable.h"

namespace velum::gui {

/// Finds any command by a few letters of its name, and does it: type, arrows, Enter.
class CommandFinder : public QDialog {
  Q_OBJECT
 public:
  CommandFinder(const ActionTable& actions, QWidget* parent);

  /// How well letters fit a name: all of them must come in order; beginnings of words and runs count more. 0: not at
  /// all.
  static int score(const QString& letters, const QString& name);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fill(const QString& letters);
  void doChosen();

  const ActionTable& mActions;
  QLineEdit* mLetters;
  QListWidget* mList;
};

}  // namespace velum::gui
