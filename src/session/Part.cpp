#include "session/Part.h"

#include <fmt/format.h>

#include <optional>

#include "core/Error.h"
#include "core/Text.h"

namespace velum::session {

Part parsePart(std::string_view text) {
  std::size_t bar = text.find('/');
  auto number = numberIn(text.substr(0, bar));
  auto parts = bar == text.npos ? std::nullopt : numberIn(text.substr(bar + 1));
  auto isCount = [](auto value) { return value && *value >= 1.0 && *value <= 1e6 && *value == double(int(*value)); };
  if (!isCount(number) || !isCount(parts) || *number > *parts)
    throw ArgumentError(fmt::format("part {}: expected K/N, as 3/16, with K from 1 to N", text));
  return {int(*number), int(*parts)};
}

}  // namespace velum::session
