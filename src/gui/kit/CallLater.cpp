#include "CallLater.h"

// The thread sanitizer knows nothing of Qt's queue, which is not built with it: this file, which is built without it,
// tells that who is called comes after who asked for it.
#if defined(VELUM_TSAN)
#include <sanitizer/tsan_interface.h>
#endif

namespace velum::gui {

namespace {

void release([[maybe_unused]] void* place) {
#if defined(VELUM_TSAN)
  __tsan_release(place);
#endif
}

void acquire([[maybe_unused]] void* place) {
#if defined(VELUM_TSAN)
  __tsan_acquire(place);
#endif
}

/// What stands in the queue.
class Posted {
 public:
  explicit Posted(const detail::LaterCall& call) : mCall(call) { release(mCall.body); }
  /// Into the queue: what Qt has allocated for it must be told, too.
  Posted(Posted&& other) noexcept : mCall(other.mCall) {
    other.mCall.body = nullptr;
    release(mCall.body);
  }
  Posted(const Posted&) = delete;
  Posted& operator=(const Posted&) = delete;
  ~Posted() {
    if (!mCall.body) return;
    acquire(mCall.body);
    mCall.drop(mCall.body);
  }
  void operator()() const {
    acquire(mCall.body);
    mCall.run(mCall.body);
  }

 private:
  detail::LaterCall mCall;
};

}  // namespace

void detail::callLater(QObject* owner, const LaterCall& call) {
  QMetaObject::invokeMethod(owner, Posted(call), Qt::QueuedConnection);
}

}  // namespace velum::gui
