#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/Assert.h"

namespace velum {

namespace detail {

/// A piece of work without its type: whoever shares it out is one .cpp, which alone knows the threads.
struct RangeWork {
  const void* body;
  void (*call)(const void* body, std::size_t first, std::size_t end);
};

/// Pieces of about `grain` or more.
void forRanges(std::size_t count, std::size_t grain, const RangeWork& work);

struct Work {
  const void* body;
  void (*call)(const void* body);
};
void isolated(const Work& work);

}  // namespace detail

/// Calls body(first, end) for pieces of [first, end) that make it up, on all cores, in no order; the calling thread
/// helps. For bodies that keep something from index to index. What a body throws is thrown here; pieces that had not
/// begun by then are left out.
/// @param grain  pieces are at least half as large
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

/// Calls body(i) for each i from first to before end, as above.
template <class Index, class Body>
void parallelFor(Index first, Index end, const Body& body) {
  parallelForRanges(first, end, Index(1), [&body](Index from, Index to) {
    for (Index i = from; i < to; ++i) body(i);
  });
}

/// Joins what body(first, end) returns for pieces of `grain` indices. Pieces and the order in which they are
/// joined are the same whatever the machine: so is the result, even of floats.
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

/// Calls body() here. While it waits for loops of its own, this thread takes up pieces of these only, none of other
/// loops: for who holds a lock that those might want, too.
template <class Body>
void isolated(const Body& body) {
  detail::isolated({&body, [](const void* of) { (*static_cast<const Body*>(of))(); }});
}

/// Calls `entered` in each thread that helps with loops, from now on, when it comes to help: at least once a thread,
/// before its first piece. Once in a program. @param entered  does not throw
void onHelpers(void (*entered)());

}  // namespace velum
