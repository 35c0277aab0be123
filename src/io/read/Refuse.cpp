#include "Refuse.h"

#include <fmt/format.h>

#include "velum/core/Error.h"

namespace velum::io {

void refuse(const Path& path, std::string_view reason) {
  throw InputError(fmt::format("{}: {}", path.string(), reason));
}

std::string inQuotes(std::string_view text) {
  std::string result(text.substr(0, 60));
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
  return "'" + result + (text.size() > 60 ? "...'" : "'");
}

}  // namespace velum::io
