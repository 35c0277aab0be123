#pragma once
#include <fmt/format.h>

#include <string>

namespace velum {

/// A sentence about one thing or several: sayCount(n, "1 image was left out", "{} images were left out"). Both are
/// whole sentences, as other languages inflect other words. @param count  the first place of both  @param more  the
/// others
template <class Count, class... More>
std::string sayCount(const Count& count, fmt::format_string<const Count&, const More&...> one,
                     fmt::format_string<const Count&, const More&...> several, const More&... more) {
  return fmt::format(count == Count(1) ? one : several, count, more...);
}

}  // namespace velum
