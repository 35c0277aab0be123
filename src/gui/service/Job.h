#pragma once
#include <QObject>
#include <QString>
#include <memory>

#include "session/Job.h"

namespace velum::gui {

/// A session::Job that tells by signals, in this object's thread. Deleting the object cancels work that is under way,
/// and no signal comes any more. In a slot of finished() use deleteLater() to delete it.
class Job : public QObject {
  Q_OBJECT
 public:
  using Work = session::Job::Work;
  Job(Work work, QObject* parent, session::Urgency urgency = session::Urgency::Background);
  ~Job() override;

  void start();
  void cancel();

 signals:
  void progressed(double fraction, const QString& what);
  /// @param error  one line for the user; empty when the work is done or was cancelled
  void finished(bool done, const QString& error);

 private:
  Work mWork;
  session::Urgency mUrgency;
  std::unique_ptr<session::Job> mJob;
};

/// Passes on at most thirty reports a second, so that a fast reader does not flood the event queue.
Progress::Listener throttled(std::function<void(double fraction, const QString& what)> listener);

}  // namespace velum::gui
