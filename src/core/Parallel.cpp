#include "core/Parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

// The thread sanitizer knows nothing of oneTBB, which is not built with it: to it, what the calling thread wrote before
// a loop and what its helpers read would be races. So this file, which is built without it, tells where a loop begins
// and ends. Two places a loop: with one, a piece would be after whatever piece ended before, and hide that the two
// race.
#if defined(VELUM_TSAN)
#include <sanitizer/tsan_interface.h>
#endif

namespace velum {

namespace {

#if defined(VELUM_TSAN)
class Order {
 public:
  Order() { __tsan_release(&mBegun); }
  ~Order() { __tsan_acquire(&mEnded); }
  Order(const Order&) = delete;
  Order& operator=(const Order&) = delete;

  class Piece {
   public:
    explicit Piece(Order& order) : mOrder(order) { __tsan_acquire(&order.mBegun); }
    ~Piece() { __tsan_release(&mOrder.mEnded); }
    Piece(const Piece&) = delete;
    Piece& operator=(const Piece&) = delete;

   private:
    Order& mOrder;
  };

 private:
  long mBegun = 0, mEnded = 0;  // what counts is where they are
};
#else
struct Order {
  ~Order() {}  // not trivial, so that nobody warns of a variable that is not used
  struct Piece {
    explicit Piece(Order&) {}
    ~Piece() {}
  };
};
#endif

class Observer : public tbb::task_scheduler_observer {
 public:
  explicit Observer(void (*entered)()) : mEntered(entered) {}
  void on_scheduler_entry(bool isWorker) override {
    if (isWorker) mEntered();
  }

 private:
  void (*mEntered)();
};

}  // namespace

namespace detail {

void forRanges(std::size_t count, std::size_t grain, const RangeWork& work) {
  Order order;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      Order::Piece piece(order);
                      work.call(work.body, range.begin(), range.end());
                    });
}

void isolated(const Work& work) {
  tbb::this_task_arena::isolate([&] { work.call(work.body); });
}

}  // namespace detail

void onHelpers(void (*entered)()) {
  // Never destroyed: helpers outlive what is static, and oneTBB would lose what they refer to. Asked to observe out
  // here, not by its constructor, so that the pointer is read and stays.
  static auto* observer = new Observer(entered);
  observer->observe(true);
}

}  // namespace velum
