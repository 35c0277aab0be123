#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/Assert.h"

namespace velum {

namespace detail {

/// A loop body without its type, so that sharing it out to threads is compiled in a single .cpp, which alone includes
/// the thread library.
struct RangeWork {
  const void* body;
  void (*call)(const void* body, std::size_t first, std::size_t end);
};

/// Calls the work for pieces of 0..count of about `grain` indices or more.
void forRanges(std::size_t count, std::size_t grain, const RangeWork& work);

struct Work {
  const void* body;
  void (*call)(const void* body);
};
void isolated(const Work& work);

}  // namespace detail

/// Divides [first, end) into pieces and calls body(first, end) for each of them, on all cores, in no order; the calling
/// thread helps. For bodies that keep something from one index to the next. An exception that a body throws is thrown
/// on to the caller; pieces that had not begun by then are left out.
/// @param grain  pieces have at least half as many indices as this
template <class Index, class Body>
void parallelForRanges(Index first, Index end, Index grain, const Body& body) {
  if (!(first < end)) return;
  struct Loop {
    Index first;
    const Body& body;
  } loop{first, body};
  auto call = [](const void* of, std::size_t a, std::size_t b) {
    const auto& l = *static_cast<const Loop*>(of);
    l.body(Index(l.first + Index(a)), Index(l.first + Index(b)));
  };
  detail::forRanges(std::size_t(end - first), std::size_t(grain), {&loop, call});
}

/// Calls body(i) for each i from first to before end, as parallelForRanges() does.
template <class Index, class Body>
void parallelFor(Index first, Index end, const Body& body) {
  parallelForRanges(first, end, Index(1), [&body](Index from, Index to) {
    for (Index i = from; i < to; ++i) body(i);
  });
}

/// Joins the values that body(first, end) returns for pieces of `grain` indices. The pieces and the order in which
/// their values are joined are the same on every machine, and so is the result, even of floats.
/// @param identity  join(identity, x) is x
template <class Index, class Value, class Body, class Join>
Value parallelReduce(Index first, Index end, Index grain, const Value& identity, const Body& body, const Join& join) {
  VELUM_ASSERT(grain > Index(0), "pieces hold something");
  if (!(first < end)) return identity;
  auto size = std::size_t(grain), count = std::size_t(end - first);
  struct Part {  // not a bare value: neighbouring bools would share a byte
    Value value;
  };
  std::vector<Part> parts((count + size - 1) / size, Part{identity});
  parallelFor(std::size_t(0), parts.size(), [&](std::size_t i) {
    std::size_t from = i * size, to = std::min(from + size, count);
    parts[i].value = body(Index(first + Index(from)), Index(first + Index(to)));
  });
  Value result = identity;
  for (const Part& part : parts) result = join(result, part.value);
  return result;
}

/// Calls body() on this thread. While the thread waits for parallel loops that body() has started, it works only on
/// pieces of these loops, never of other ones: for callers that hold a lock which the pieces of other loops might want,
/// too.
template <class Body>
void isolated(const Body& body) {
  detail::isolated({&body, [](const void* of) { (*static_cast<const Body*>(of))(); }});
}

/// From now on `entered` is called in each thread that comes to help with loops: at least once a thread, before its
/// first piece. To be called once in a program. @param entered  does not throw
void onHelpers(void (*entered)());

}  // namespace velum
