#pragma once
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>

#include "gui/window/Findable.h"

namespace velum::gui {

/// Finds what the window can do by a few letters of its name, and does it: type, arrows, Enter. A number that is typed
/// behind the name of a number field goes into that field.
class CommandFinder : public QDialog {
  Q_OBJECT
 public:
  /// @param runLine  runs a command that was typed with its arguments as in a script; empty: such commands are not
  /// offered
  CommandFinder(std::vector<Findable> all, QWidget* parent, std::function<void(const QString&)> runLine = {});

  /// How well letters fit a name: all of them must come in order; letters at beginnings of words and letters in a row
  /// count more. 0: the letters do not fit.
  static int score(const QString& letters, const QString& name);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fill();
  void doChosen();
  void sayNothingFound();

  bool addTyped();

  const std::vector<Findable> mAll;
  std::function<void(const QString&)> mRunLine;
  QLineEdit* mLetters;
  QListWidget* mList;
};

}  // namespace velum::gui
