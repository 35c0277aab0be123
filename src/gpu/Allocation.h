#pragma once
#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace velum::gpu {

/// Memory that the driver is asked for.
struct Allocation {
  std::string_view label;  ///< What it is for, in words for people.
  std::size_t bytes = 0;
  glm::ivec3 texels{0};  ///< Of a texture; 0: a buffer.
};

/// When the driver's answer is asked for.
enum class Answer {
  AtOnce,  ///< Waits for a driver that has a thread of its own.
  Later    ///< Whoever calls throwIfExhausted() next hears of it. For what is small and made with every picture.
};

/// Asks the driver for memory: all memory on the GPU, of textures and buffers, is asked for through here. GL thread.
/// @param request  the call of OpenGL
/// @throw NoMemory when the driver has none, or an AllocationFault says so
void allocate(const Allocation& what, Answer answer, const std::function<void()>& request);

/// @throw NoMemory when the driver has run out of memory since it was asked last, as for a small buffer. Waits for a
/// driver that has a thread of its own. GL thread.
void throwIfExhausted();

/// What has found no memory until now is nobody's: for whoever begins something. GL thread.
void forgetExhaustion();

/// While an object of this class lives, allocations fail as they do where the card's memory is full: for tests. The
/// variable VELUM_FAIL_ALLOCATION does the same to a whole program.
class AllocationFault {
 public:
  enum class Which {
    None,     ///< None fails; they are counted.
    Nth,      ///< The n-th from now on fails, counted from 1.
    NthLate,  ///< The same, heard of as from drivers: where the answer is due later, from whoever asks for it next.
    NthOn,    ///< The n-th and all after it fail.
    Larger,   ///< All of more than n bytes fail.
  };
  enum class Threads { This, All };

  explicit AllocationFault(Which which = Which::None, std::size_t n = 0, Threads threads = Threads::This);
  ~AllocationFault();
  AllocationFault(const AllocationFault&) = delete;
  AllocationFault& operator=(const AllocationFault&) = delete;

  /// The labels of all that was asked for, in the order in which it was.
  std::vector<std::string> asked() const;
  /// The labels of what has failed.
  std::vector<std::string> failed() const;

  enum class Refusal { None, Now, AsDriversDo };
  /// Called by allocate(). @return whether this one fails, and when that is said
  Refusal refusal(const Allocation& what);

 private:
  Which mWhich;
  std::size_t mN;
  Threads mThreads;
  std::vector<std::string> mAsked, mFailed;
};

}  // namespace velum::gpu
