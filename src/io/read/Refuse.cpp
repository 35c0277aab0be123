#include "io/read/Refuse.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "core/Text.h"

namespace velum::io {

void refuse(const Path& path, std::string_view reason) {
  throw InputError(fmt::format("{}: {}", path.string(), reason));
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t kMost = 60;
  return "'" + printable(text.substr(0, kMost)) + (text.size() > kMost ? "...'" : "'");
}

}  // namespace velum::io
