#pragma once
#include <QObject>
#include <functional>

#include "gui/kit/Messages.h"
#include "session/Session.h"
#include "session/command/Command.h"

namespace velum::gui {

/// The job on whose end the user waits: one at a time, shown in the progress strip; what goes wrong is said in the
/// message bar.
class JobRunner : public QObject {
  Q_OBJECT
 public:
  JobRunner(session::Session& session, ProgressStrip& strip, MessageBar& messages, QObject* parent);

  /// Says so, and does nothing else, while another one runs. @param whenDone  in the window's thread
  void start(const QString& what, session::Job::Work work, std::function<void()> whenDone);
  /// The same for work that is mostly over at once: then nothing is seen of it, and it is done when this returns.
  void startShort(const QString& what, session::Job::Work work, std::function<void()> whenDone);
  /// Does a command: at once, or, where it is long, as startShort() does work; what was done meanwhile is not lost.
  /// What there is to tell, and what goes wrong, is said in the message bar.
  void run(const session::Call& call, bool merge = false);
  /// An edit that is worked out beside the document.
  struct Beside {
    /// What it stands on: of the scene, what is open; or the cuts and the model. Where that is another meanwhile the
    /// edit is not made. Of the scene: where all else has changed it is worked out again, so that nothing is lost.
    enum class Ground { Scene, Cuts };
    Ground ground = Ground::Scene;
    std::function<session::Edit(const scene::Scene&, Progress&)> make;  ///< in another thread
    std::function<void(const session::Edit&)> commit;
    bool isShort = false;  ///< as of startShort()
  };
  void edit(const QString& what, const Beside& beside);
  void cancel();
  bool isBusy() const { return mSession.isBusy(); }
  /// What went wrong last; empty when nothing did.
  QString lastError() const { return mLastError; }
  /// Of something that was done at once: kept, and said where there is an error.
  void setError(const QString& error);

 signals:
  void busyChanged(bool busy);
  /// It is done, was cancelled or has failed.
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
