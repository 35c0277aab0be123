#pragma once
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTimer>
#include <QWidget>

#include "gui/service/JobRunner.h"

namespace velum::gui {

/// What has been done to what is open, as the lines of a script that does it again; and a line to type another.
class CommandsWindow : public QWidget {
  Q_OBJECT
 public:
  CommandsWindow(session::Session& session, JobRunner& jobs, QWidget* parent);

  /// The document has changed. Its lines are told when nothing has changed for a moment.
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
