#pragma once
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>

#include "gui/window/Findable.h"

namespace velum::gui {

/// Finds what the window can do by a few letters of its name, and does it: type, arrows, Enter. A number behind the
/// name goes into the field of that name.
class CommandFinder : public QDialog {
  Q_OBJECT
 public:
  /// @param runLine  does a command that was typed as in a script, with its arguments; none are offered without it
  CommandFinder(std::vector<Findable> all, QWidget* parent, std::function<void(const QString&)> runLine = {});

  /// How well letters fit a name: all of them must come in order; beginnings of words and runs count more. 0: not at
  /// all.
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
