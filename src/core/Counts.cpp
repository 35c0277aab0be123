#include "core/Counts.h"

#include <algorithm>
#include <cmath>

#include "core/Text.h"

namespace velum {

Counts expectedCounts(const Counts& before, std::uint64_t left, std::uint64_t total) {
  double seen = before.left() > 0 ? double(before.visible()) / double(before.left()) : 1.0;
  Counts now;
  now[CountOf::Visible] = std::min(left, std::uint64_t(std::llround(double(left) * seen)));
  now[CountOf::Hidden] = left - now.visible();
  now[CountOf::Clipped] = total - std::min(total, left);
  return now;
}

std::string countColumns() {
  std::string text;
  for (const CountKind& kind : kCountKinds) text += std::string(kind.name) + ",";
  return text + "total";
}

std::string countFields(const Counts& counts) {
  std::string text;
  for (std::uint64_t part : counts.parts) text += std::to_string(part) + ",";
  return text + std::to_string(counts.total());
}

std::string countText(std::uint64_t count) { return grouped(count, ","); }

}  // namespace velum
