#pragma once
#include <QMenu>
#include <QObject>

#include "gui/service/JobRunner.h"
#include "session/document/Document.h"

namespace velum::gui {

/// What can be done to a mark, from the list and the views alike. Each is one undo step with a name.
class MarkMenu : public QObject {
  Q_OBJECT
 public:
  MarkMenu(session::Document& document, JobRunner& jobs, QObject* parent)
      : QObject(parent), mDocument(document), mJobs(jobs) {}

  void fill(QMenu& menu, int mark);
  void remove(int mark);
  void duplicate(int mark);
  void setVisible(int mark, bool visible);
  /// @param words  of a label; of others what stands for the name, or before the value; empty: nothing of its own
  void setWords(int mark, const QString& words);
  /// Puts the crosshair to the mark's first point.
  void goTo(int mark);
  /// Lets the mark's points follow what is there, as a job, or lets them go.
  void setFollowing(int mark, bool follows);
  /// Puts the mark's name and value on the clipboard.
  void copy(int mark);

 signals:
  /// The words of a mark are to be typed.
  void renameAsked(int mark);

 private:
  session::Document& mDocument;
  JobRunner& mJobs;
};

}  // namespace velum::gui
