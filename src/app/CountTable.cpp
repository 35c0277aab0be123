#include "app/CountTable.h"

#include <fmt/format.h>

#include <algorithm>

namespace velum::app {

Json countJson(const Counts& counts) {
  Json json;
  for (std::size_t i = 0; i < kCountKinds.size(); ++i) json[std::string(kCountKinds[i].name)] = counts.parts[i];
  json["total"] = counts.total();
  return json;
}

void printCounts(const std::vector<session::CountRow>& rows, std::optional<double> pixels) {
  auto nameOf = [](const session::CountRow& row) { return std::string(std::size_t(2 * row.depth), ' ') + row.name; };
  std::size_t width = 4;
  for (const auto& row : rows) width = std::max(width, nameOf(row).size());
  std::string head;
  for (const CountKind& kind : kCountKinds) head += fmt::format(" {:>10}", kind.name);
  fmt::print("{:<{}}{} {:>10}{}\n", "", width, head, "total", pixels ? fmt::format(" {:>10}", "%") : "");
  for (const auto& row : rows) {
    std::string numbers;
    for (std::uint64_t part : row.count.parts) numbers += fmt::format(" {:>10}", part);
    std::string share = pixels ? fmt::format(" {:>10.2f}", 100.0 * double(row.count.visible()) / *pixels) : "";
    fmt::print("{:<{}}{} {:>10}{}\n", nameOf(row), width, numbers, row.count.total(), share);
  }
}

}  // namespace velum::app
