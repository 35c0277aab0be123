#include "gui/service/NewestJob.h"

#include <utility>

namespace velum::gui {

NewestJob::NewestJob(int patienceMs, QObject* parent) : QObject(parent) {
  mPatience.setSingleShot(true);
  mPatience.setInterval(patienceMs);
  connect(&mPatience, &QTimer::timeout, this, &NewestJob::start);
}

NewestJob::~NewestJob() = default;

void NewestJob::want(Prepare prepare, Done done) {
  stop();
  mWish = std::make_unique<Wish>(Wish{std::move(prepare), std::move(done)});
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
  connect(mJob.get(), &Job::finished, this, [this, done = std::move(wish->done)](bool isDone, const QString&) {
    mJob.release()->deleteLater();
    bool isWanted = std::exchange(mIsWanted, false);
    if (isDone && isWanted) done();
    if (mWish && !mPatience.isActive()) start();
  });
  mJob->start();
}

}  // namespace velum::gui
