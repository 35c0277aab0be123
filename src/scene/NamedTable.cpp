#include "scene/NamedTable.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/Error.h"
#include "core/NearestName.h"

namespace velum::scene {

void failNoName(std::string_view what, std::string_view name, const std::vector<std::string>& known) {
  throw ArgumentError(
      fmt::format("no {} '{}'{}; there are {}", what, name, meantText(name, known), fmt::join(known, ", ")));
}

}  // namespace velum::scene
