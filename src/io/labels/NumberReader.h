#pragma once
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "core/Volume.h"
#include "io/labels/LabelBricks.h"
#include "io/labels/LabelGuess.h"

namespace velum::io {

/// Samples are ids of ours as they are.
inline bool hasNarrowIds(const Volume& head) {
  return sampleSize(head.type) <= 2 && head.scale == 1.0 && head.offset == 0.0;
}

/// Numbers out of samples.
struct NumberReader {
  const Volume& head;
  const LabelBrickOptions& how;

  [[noreturn]] void refuseValue(double value) const {
    refuse(how.path, fmt::format("is no label volume: it has the value {}; ids are whole numbers from 0 on", value));
  }
  std::uint64_t numberOf(std::uint64_t bits) const {  // of ids that are carried
    if (how.areIdsSigned && bits > std::uint64_t(std::numeric_limits<std::int64_t>::max()))
      refuseValue(double(std::int64_t(bits)));
    return bits;
  }
  template <class Sample>
  std::uint64_t numberOf(Sample sample) const {
    if constexpr (std::is_integral_v<Sample>)
      if (head.scale == 1.0 && head.offset == 0.0 && sample >= 0) return std::uint64_t(sample);
    double value = double(sample) * head.scale + head.offset, whole = std::round(value);
    if (!(std::abs(value - whole) < kWhole) || !(whole >= 0) || !(whole < 0x1p63)) refuseValue(value);
    return std::uint64_t(whole);
  }
  /// Calls body(number, count) for runs of samples that are alike.
  template <class Body>
  void forRuns(const Bytes& samples, std::size_t count, const Body& body) const {
    auto walk = [&](const auto* values) {
      for (std::size_t i = 0; i < count;) {
        std::size_t end = i + 1;
        while (end < count && values[end] == values[i]) ++end;
        body(numberOf(values[i]), end - i);
        i = end;
      }
    };
    if (how.carriesIds) return walk(reinterpret_cast<const std::uint64_t*>(samples.data()));
    Volume typed;
    typed.type = head.type;
    visitSamples(typed, [&](const auto* null) { walk(reinterpret_cast<decltype(null)>(samples.data())); });
  }
};

}  // namespace velum::io
