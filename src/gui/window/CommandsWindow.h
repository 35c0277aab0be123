#pragma once
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTimer>
#include <QWidget>

#include "gui/service/JobRunner.h"

namespace velum::gui {

/// Shows the edits of the open scene as lines of a script that makes these edits again, and has a field in which
/// another command is typed.
class CommandsWindow : public QWidget {
  Q_OBJECT
 public:
  CommandsWindow(session::Session& session, JobRunner& jobs, QWidget* parent);

  /// To be called when the document has changed. The lines are shown when nothing has changed for a moment.
  void refresh();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QString lines() const;
  void fill();
  void runTyped();
  void save();

  session::Session& mSession;
  JobRunner& mJobs;
  QPlainTextEdit* mLines;
  QLineEdit* mTyped;
  QLabel* mSaid;
  QTimer mPatience;
};

}  // namespace velum::gui
