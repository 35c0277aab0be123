#include "gpu/Allocation.h"

#include <fmt/format.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "gpu/Gl.h"
#include "gpu/GpuError.h"

namespace velum::gpu {

namespace {

constexpr const char* kWhatToDo =
    "close other programs that draw, make the picture smaller, or lower VELUM_GPU_MEMORY_MB";

thread_local AllocationFault* tFault = nullptr;
thread_local bool tOwesRefusal = false;  ///< One that is said as drivers do.
std::atomic<AllocationFault*> gFault{nullptr};
std::mutex gFaultMutex;

std::string sizeText(const Allocation& what) {
  std::string bytes = what.bytes >> 20   ? fmt::format("{} MiB", what.bytes >> 20)
                      : what.bytes >> 10 ? fmt::format("{} KiB", what.bytes >> 10)
                                         : fmt::format("{} bytes", what.bytes);
  if (what.texels == glm::ivec3(0)) return bytes;
  return fmt::format("{} x {} x {}, {}", what.texels.x, what.texels.y, what.texels.z, bytes);
}

/// VELUM_FAIL_ALLOCATION: 7, the seventh of the program; 7+, that and all after it; >7, all of more than 7 MiB.
std::unique_ptr<AllocationFault> faultOf(const char* text) {
  using Which = AllocationFault::Which;
  if (!text) return nullptr;
  bool isLarger = *text == '>';
  char* end = nullptr;
  auto number = std::size_t(std::strtoull(text + (isLarger ? 1 : 0), &end, 10));
  Which which = isLarger ? Which::Larger : *end == '+' ? Which::NthOn : Which::Nth;
  return std::make_unique<AllocationFault>(which, isLarger ? number << 20 : number, AllocationFault::Threads::All);
}

AllocationFault::Refusal refusalOf(const Allocation& what) {
  using Refusal = AllocationFault::Refusal;
  static const std::unique_ptr<AllocationFault> ofProgram = faultOf(std::getenv("VELUM_FAIL_ALLOCATION"));
  if (tFault)
    if (Refusal refusal = tFault->refusal(what); refusal != Refusal::None) return refusal;
  if (!gFault.load(std::memory_order_relaxed)) return Refusal::None;
  std::lock_guard lock(gFaultMutex);
  AllocationFault* fault = gFault.load();
  return fault ? fault->refusal(what) : Refusal::None;
}

/// @return true when one of them was for want of memory
bool takeErrors() {
  bool isExhausted = std::exchange(tOwesRefusal, false);
  // A lost context may say so without end.
  for (GLenum error = gl().GetError(); error != GL_NO_ERROR && error != GL_CONTEXT_LOST; error = gl().GetError())
    isExhausted = isExhausted || error == GL_OUT_OF_MEMORY;
  return isExhausted;
}

}  // namespace

void allocate(const Allocation& what, Answer answer, const std::function<void()>& request) {
  std::optional<MayRefuse> mayRefuse;
  if (answer == Answer::AtOnce) {
    throwIfExhausted();
    mayRefuse.emplace();
  }
  AllocationFault::Refusal refusal = refusalOf(what);
  bool isLate = refusal == AllocationFault::Refusal::AsDriversDo && answer == Answer::Later;
  if (isLate) tOwesRefusal = true;
  bool refused = refusal != AllocationFault::Refusal::None && !isLate;
  if (!refused) request();
  if (!refused && answer == Answer::AtOnce) refused = gl().GetError() != GL_NO_ERROR;
  if (refused)
    throw NoMemory(fmt::format("the driver has no memory for {} ({}): {}", what.label, sizeText(what), kWhatToDo));
}

void throwIfExhausted() {
  if (takeErrors()) throw NoMemory(fmt::format("the driver has run out of memory: {}", kWhatToDo));
}

void forgetExhaustion() { takeErrors(); }

AllocationFault::AllocationFault(Which which, std::size_t n, Threads threads)
    : mWhich(which), mN(n), mThreads(threads) {
  if (threads == Threads::This)
    tFault = this;
  else
    gFault = this;
}

AllocationFault::~AllocationFault() {
  std::lock_guard lock(gFaultMutex);
  if (mThreads == Threads::This)
    tFault = nullptr;
  else
    gFault = nullptr;
}

AllocationFault::Refusal AllocationFault::refusal(const Allocation& what) {
  mAsked.emplace_back(what.label);
  bool isNth = mWhich == Which::Nth || mWhich == Which::NthLate;
  bool isRefused = isNth                     ? mAsked.size() == mN
                   : mWhich == Which::NthOn  ? mAsked.size() >= mN
                   : mWhich == Which::Larger ? what.bytes > mN
                                             : false;
  if (!isRefused) return Refusal::None;
  mFailed.emplace_back(what.label);
  return mWhich == Which::NthLate ? Refusal::AsDriversDo : Refusal::Now;
}

std::vector<std::string> AllocationFault::asked() const {
  std::lock_guard lock(gFaultMutex);
  return mAsked;
}

std::vector<std::string> AllocationFault::failed() const {
  std::lock_guard lock(gFaultMutex);
  return mFailed;
}

}  // namespace velum::gpu
