#include "session/Rest.h"

#include <exception>

#include "core/Error.h"
#include "gpu/Loss.h"

namespace velum::session {

namespace {

constexpr double kMoveMs = 50.0;  ///< Between two looks at whether all is to be cancelled.

/// @return false when there was nothing to do
bool workOnce(Worker& worker, Progress& progress) {
  Worker::Work work = worker.nextWork();
  if (!work) return false;
  try {
    worker.endWork(work(progress), {});
  } catch (const Cancelled&) {
    worker.endWork({}, {});
    throw;
  } catch (const std::exception& error) {
    worker.endWork({}, error.what());
    throw;
  }
  return true;
}

}  // namespace

void bringToRest(Worker& worker, const std::function<void()>& complete, Progress& progress) {
  for (bool goesOn = true; goesOn;) {
    progress.throwIfCancelled();
    goesOn = workOnce(worker, progress);
    if (!worker.hasRests()) continue;
    complete();
    goesOn = true;
  }
}

void bringToRest(Mover& mover, const std::function<void()>& complete, Progress& progress) {
  auto asWorker = [&] { bringToRest(static_cast<Worker&>(mover), complete, progress); };
  gpu::despiteLoss([&] {
    for (asWorker(); mover.isMoving(); asWorker()) {
      progress.report(0.5, "membrane");
      mover.advance(kMoveMs);
    }
  });
}

}  // namespace velum::session
