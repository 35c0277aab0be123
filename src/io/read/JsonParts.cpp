#include "io/read/JsonParts.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/Text.h"

namespace velum::io {

Json parseJson(const std::string& text, const Path& path) try {
  return Json::parse(text);
} catch (const Json::parse_error& error) {
  refuse(path, fmt::format("is no sound JSON: at byte {} of {}", error.byte, text.size()));
} catch (const Json::exception&) {
  refuse(path, "is no sound JSON: it holds a number that is too large");
}

const Json& memberOf(const Json& object, std::string_view name) {
  static const Json kNull;
  if (!object.is_object()) return kNull;
  auto at = object.find(std::string(name));
  return at == object.end() ? kNull : *at;
}

std::string wordOf(const Json& value) { return value.is_string() ? value.get<std::string>() : std::string(); }

bool isTrue(const Json& value) { return value.is_boolean() && value.get<bool>(); }

double numberOf(const Json& value, const Path& path, std::string_view what) {
  double number = NAN;
  if (value.is_number()) number = value.get<double>();
  if (value.is_string()) number = numberIn(trimmed(value.get<std::string>())).value_or(NAN);
  if (!(std::abs(number) < 1e9))
    refuse(path, fmt::format("{} has something for a number that is none, or is too large", what));
  return number;
}

std::vector<double> numbersOf(const Json& value, const Path& path, std::string_view what) {
  if (!value.is_array()) refuse(path, fmt::format("{} is no list of numbers", what));
  std::vector<double> numbers;
  for (const Json& item : value) numbers.push_back(numberOf(item, path, what));
  return numbers;
}

glm::dvec3 vectorOf(const Json& value, const Path& path, std::string_view what) {
  if (!value.is_array() || value.size() != 3) refuse(path, fmt::format("{} is no place of three numbers", what));
  return {numberOf(value[0], path, what), numberOf(value[1], path, what), numberOf(value[2], path, what)};
}

std::vector<glm::vec3> pointsOf(const Json& value, const Path& path, std::string_view what) {
  std::vector<glm::vec3> points;
  if (value.is_array() && !value.empty() && value[0].is_array()) {
    for (const Json& item : value) points.emplace_back(vectorOf(item, path, what));
    return points;
  }
  std::vector<double> flat = numbersOf(value, path, what);
  if (flat.size() % 3 != 0) refuse(path, fmt::format("{} has {} numbers, not three a place", what, flat.size()));
  for (std::size_t i = 0; i < flat.size(); i += 3) points.emplace_back(flat[i], flat[i + 1], flat[i + 2]);
  return points;
}

}  // namespace velum::io
