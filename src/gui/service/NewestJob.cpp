#include "gui/service/NewestJob.h"

#include <utility>

namespace velum::gui {

NewestJob::NewestJob(int patienceMs, QObject* parent) : QObject(parent) {
  mPatience.setSingleShot(true);
  mPatience.setInterval(patienceMs);
  connect(&mPatience, &QTimer::timeout, this, &NewestJob::start);
}

NewestJob::~NewestJob() = default;

void NewestJob::want(Prepare prepare, Done done, Failed failed) {
  stop();
  mWish = std::make_unique<Wish>(Wish{std::move(prepare), std::move(done), std::move(failed)});
  mPatience.start();
}

void NewestJob::stop() {
  mPatience.stop();
  mWish.reset();
  mIsWanted = false;
  if (mJob) mJob->cancel();
}

void NewestJob::start() {
  // Until the one that was cancelled is over.
  if (mJob || !mWish) return;
  std::unique_ptr<Wish> wish = std::move(mWish);
  mJob = std::make_unique<Job>(wish->prepare(), nullptr);
  mIsWanted = true;
  auto end = [this, done = std::move(wish->done), failed = std::move(wish->failed)](bool isDone, const QString& why) {
    mJob.release()->deleteLater();
    bool isWanted = std::exchange(mIsWanted, false);
    if (isDone && isWanted) done();
    if (!isDone && isWanted && failed && !why.isEmpty()) failed(why);
    if (mWish && !mPatience.isActive()) start();
  };
  connect(mJob.get(), &Job::finished, this, end);
  mJob->start();
}

}  // namespace velum::gui
