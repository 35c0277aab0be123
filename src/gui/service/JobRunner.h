#pragma once
#include <QObject>
#include <functional>

#include "gui/kit/Messages.h"
#include "session/Session.h"
#include "session/command/Command.h"

namespace velum::gui {

/// Runs the jobs for whose end the user waits: one at a time, shown in the progress strip; errors are shown in the
/// message bar.
class JobRunner : public QObject {
  Q_OBJECT
 public:
  JobRunner(session::Session& session, ProgressStrip& strip, MessageBar& messages, QObject* parent);

  /// Starts a job. While another job runs it only tells the user so. @param work  called in another thread
  /// @param whenDone  called in the window's thread when the work is done
  void start(const QString& what, session::Job::Work work, std::function<void()> whenDone);
  /// The same for work that is mostly over at once: if it is, no progress is shown, and the work is done when this
  /// function returns.
  void startShort(const QString& what, session::Job::Work work, std::function<void()> whenDone);
  /// Runs a command: at once, or, if the command is long, as startShort() does; edits that are made meanwhile are not
  /// lost. Notes and errors of the command are shown in the message bar.
  void run(const session::Call& call, bool merge = false);
  /// An edit that is worked out in another thread, on a copy of the scene.
  struct Beside {
    /// What must be unchanged when the edit is ready; otherwise the edit is dropped. Scene: the volume; if anything
    /// else in the scene has changed, the edit is worked out again, so that nothing is lost. Cuts: the cuts and the
    /// model.
    enum class Ground { Scene, Cuts };
    Ground ground = Ground::Scene;
    std::function<session::Edit(const scene::Scene&, Progress&)> make;  ///< called in another thread
    std::function<void(const session::Edit&)> commit;
    bool isShort = false;  ///< run as by startShort()
  };
  void edit(const QString& what, const Beside& beside);
  void cancel();
  bool isBusy() const { return mSession.isBusy(); }
  /// What went wrong last; empty when nothing did.
  QString lastError() const { return mLastError; }
  /// Keeps the error of something that was done at once, and shows it; empty: there was no error.
  void setError(const QString& error);

 signals:
  void busyChanged(bool busy);
  /// The user has asked for the job to be stopped; it ends soon.
  void cancelled();
  /// The job is done, was cancelled or has failed.
  void ended();

 private:
  void runLong(const session::Call& call, bool merge);
  void begin(const QString& what, session::Job::Work work, std::function<void()> whenDone);

  session::Session& mSession;
  ProgressStrip& mStrip;
  MessageBar& mMessages;
  QString mLastError;
};

}  // namespace velum::gui
