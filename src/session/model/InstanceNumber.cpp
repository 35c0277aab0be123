#include "session/model/InstanceNumber.h"

#include <fmt/format.h>

#include <cmath>

#include "core/Error.h"
#include "core/Text.h"
#include "scene/Scene.h"
#include "scene/Shown.h"
#include "session/model/TypesAt.h"

namespace velum::session {

std::optional<double> instanceNumber(std::string_view text, double total) {
  auto trim = [&text] {
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  };
  trim();
  bool isShare = text.ends_with('%');
  if (isShare) text.remove_suffix(1), trim();
  std::optional<double> value = numberIn(text);
  if (!value || !std::isfinite(*value) || *value < 0.0 || *value > (isShare ? 100.0 : 1e12)) return std::nullopt;
  if (isShare) return std::round(total * *value / 100.0);
  return *value == std::floor(*value) ? value : std::nullopt;
}

double instanceNumber(const scene::Scene& scene, std::string_view path, std::string_view text) {
  if (!scene.model.data) throw InputError("there is no model: open one first");
  double total = 0.0;
  for (std::uint32_t type : typesAt(*scene.model.data, path).types)
    total += double(scene.model.data->types[type].instanceCount) * double(scene::copyCount(scene.model));
  if (auto number = instanceNumber(text, total)) return *number;
  throw ArgumentError(fmt::format("{}: expected {}", text, kInstanceNumberForm));
}

}  // namespace velum::session
