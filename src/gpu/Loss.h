#pragma once
#include "gpu/GpuError.h"

/// What becomes of a context that the driver loses (GL_KHR_robustness): after a reset of the card, of its driver or of
/// the machine's graphics as a whole. What is on the GPU is made from what the processor has, so that nothing is lost
/// with it: work that waits for its result is done again in a new context, and whoever keeps objects from one piece of
/// work to the next looks whether the context is still the one in which they were made. GL thread.
namespace velum::gpu {

/// The number of the context that is current in this thread: another one for each context that there has been, also
/// where one was made anew. 0: there is none.
unsigned contextNumber();
/// Whether the driver has lost the current context. Asks the driver, which costs little: once for each piece of work.
bool isContextLost();
/// @throw ContextLost when the driver has lost the current context
void throwIfLost();
/// Makes the current context anew, with another number. @throw ContextLost where it is the window's who made it;
/// GpuError where the driver makes none any more
void renewContext();

/// Most losses that a piece of work bears.
constexpr int kMostLosses = 3;
/// Says that it is no use to try again. @throw ContextLost
[[noreturn]] void giveUpAfterLosses();

/// Does a piece of work, and does it again in a new context where the context was lost meanwhile, as long as there is
/// hope. The work asks throwIfLost() itself before it takes a result for good.
/// @throw ContextLost as renewContext(), and after too many losses; what the work throws
template <class Work>
auto despiteLoss(Work work) {
  for (int losses = 0;; ++losses) {
    try {
      return work();
    } catch (const GpuError&) {
      if (!isContextLost()) throw;
      if (losses == kMostLosses) giveUpAfterLosses();
      renewContext();
    }
  }
}

/// For tests: the context is lost when isContextLost() is asked for the `question`-th time from now, in any thread, and
/// again at each question after that until it has been lost so many times. 0: no more. VELUM_LOSE_CONTEXT=QUESTION or
/// QUESTION,TIMES does the same from the start of a program.
void simulateLoss(int question, int times = 1);

}  // namespace velum::gpu
