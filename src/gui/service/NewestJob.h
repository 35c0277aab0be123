#pragma once
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>

#include "gui/service/Job.h"

namespace velum::gui {

/// Background work that is wanted anew whenever something changes: of several wishes the last one is done, when nothing
/// has been wished for a while and the one before is over. Whoever wishes never waits.
class NewestJob : public QObject {
  Q_OBJECT
 public:
  /// Takes what the work needs as it is when the work begins.
  using Prepare = std::function<Job::Work()>;
  using Done = std::function<void()>;

  /// @param patienceMs  a hand that moves on is not answered on its way
  NewestJob(int patienceMs, QObject* parent);
  ~NewestJob() override;

  /// What was wished before is given up. @param prepare  in this object's thread; its work in a thread of its own
  /// @param done  afterwards, in this object's thread, unless something else has been wished or the work has failed
  void want(Prepare prepare, Done done);
  /// Nothing is wished any more.
  void stop();
  /// Something is wished, and is not there yet.
  bool isBusy() const { return mWish != nullptr || mIsWanted; }

 private:
  struct Wish {
    Prepare prepare;
    Done done;
  };
  void start();

  QTimer mPatience;
  std::unique_ptr<Wish> mWish;  ///< not begun
  std::unique_ptr<Job> mJob;    ///< perhaps of something that nobody wants any more
  bool mIsWanted = false;       ///< the job
};

}  // namespace velum::gui
