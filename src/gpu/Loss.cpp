#include "gpu/Loss.h"

#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "core/Log.h"
#include "gpu/Context.h"
#include "gpu/Gl.h"

namespace velum::gpu {

namespace {

/// The losses that tests ask for.
struct PlannedLosses {
  std::mutex mutex;
  int questions = 0, times = 0;
  PlannedLosses() {
    const char* text = std::getenv("VELUM_LOSE_CONTEXT");
    if (text && std::sscanf(text, "%d,%d", &questions, &times) == 1) times = 1;
  }
  /// A question is asked. @return true where the answer is to be that the context is lost
  bool isDue() {
    std::lock_guard guard(mutex);
    if (times == 0 || (questions > 0 && --questions > 0)) return false;
    --times;
    return true;
  }
};

PlannedLosses& planned() {
  static PlannedLosses instance;
  return instance;
}

}  // namespace

unsigned contextNumber() { return hasGl() ? gl().number : 0; }

bool isContextLost() {
  if (!hasGl()) return false;
  const GlTable& table = gl();
  // A driver may say so only once.
  if (!table.isLost) table.isLost = table.GetGraphicsResetStatus() != GL_NO_ERROR || planned().isDue();
  return table.isLost;
}

void throwIfLost() {
  if (isContextLost()) throw ContextLost("the graphics driver was reset while it drew: draw again");
}

void renewContext() {
  gl().owner->renew();
  log::warning("the graphics driver was reset; what it was drawing is drawn once more");
}

void giveUpAfterLosses() {
  throw ContextLost(
      "the graphics driver is reset whenever it draws this: update it, or have Mesa's software driver draw, which is "
      "slower (LIBGL_ALWAYS_SOFTWARE=1)");
}

void simulateLoss(int question, int times) {
  PlannedLosses& losses = planned();
  std::lock_guard guard(losses.mutex);
  losses.questions = question;
  losses.times = question > 0 ? times : 0;
}

}  // namespace velum::gpu
