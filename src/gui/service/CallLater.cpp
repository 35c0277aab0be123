#include "gui/service/CallLater.h"

#include <memory>

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
  /// What was called goes here and now: Qt may let go of this object in the thread that asked for the call.
  void operator()() {
    acquire(mCall.body);
    std::unique_ptr<void, void (*)(void*)> body(std::exchange(mCall.body, nullptr), mCall.drop);
    mCall.run(body.get());
  }

 private:
  detail::LaterCall mCall;
};

}  // namespace

void detail::callLater(QObject* owner, const LaterCall& call) {
  QMetaObject::invokeMethod(owner, Posted(call), Qt::QueuedConnection);
}

}  // namespace velum::gui
