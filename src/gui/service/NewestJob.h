#pragma once
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>

#include "gui/service/Job.h"

namespace velum::gui {

/// Background work that is wanted anew whenever something changes: of several requests only the last one is done, when
/// there has been no further request for a while and the work before is over. The caller never waits.
class NewestJob : public QObject {
  Q_OBJECT
 public:
  /// Makes the work from the state of things at the moment when the work begins.
  using Prepare = std::function<Job::Work()>;
  using Done = std::function<void()>;
  using Failed = std::function<void(const QString& why)>;

  /// @param patienceMs  how long there must be no further request, so that no work begins while the user still drags
  NewestJob(int patienceMs, QObject* parent);
  ~NewestJob() override;

  /// Asks for work, and gives up all work that was asked for before. @param prepare  called in this object's thread;
  /// the work that it returns runs in a thread of its own  @param done  called afterwards in this object's thread,
  /// unless other work has been asked for or the work has failed  @param failed  called instead where it has
  void want(Prepare prepare, Done done, Failed failed = {});
  /// Gives up all work that was asked for.
  void stop();
  /// Work has been asked for and is not done yet.
  bool isBusy() const { return mWish != nullptr || mIsWanted; }

 private:
  struct Wish {
    Prepare prepare;
    Done done;
    Failed failed;
  };
  void start();

  QTimer mPatience;
  std::unique_ptr<Wish> mWish;  ///< the request that has not begun
  std::unique_ptr<Job> mJob;    ///< the work that runs, perhaps for a request that was given up
  bool mIsWanted = false;       ///< mJob's result is still wanted
};

}  // namespace velum::gui
