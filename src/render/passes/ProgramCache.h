#pragma once
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <list>
#include <utility>

#include "gpu/Program.h"

namespace velum::render {

/// The programs of a pass by the variant they are compiled for; only those asked for most recently are kept. With
/// software drivers a program takes ten megabytes and more, and there are hundreds of variants: a long session would
/// otherwise gather all that it ever used.
template <class Variant>
class ProgramCache {
 public:
  static constexpr std::size_t kMost = 16;

  bool contains(const Variant& variant) const {
    return std::any_of(mKept.begin(), mKept.end(), [&](const auto& kept) { return kept.first == variant; });
  }
  /// @param make  compiles the program when it is not kept
  /// @return the program; it lives at least until the next call
  template <class Make>
  const gpu::Program& find(const Variant& variant, const Make& make) {
    auto found = mKept.begin();
    while (found != mKept.end() && found->first != variant) ++found;
    if (found != mKept.end()) {
      mKept.splice(mKept.begin(), mKept, found);
    } else {
      mKept.emplace_front(variant, make());
      if (mKept.size() > kMost) mKept.pop_back();
    }
    return mKept.front().second;
  }

 private:
  std::list<std::pair<Variant, gpu::Program>> mKept;  ///< The one asked for last comes first.
};

}  // namespace velum::render
