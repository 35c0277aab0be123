#include "scene/json/FieldPaths.h"

#include <algorithm>

#include "core/NearestName.h"
#include "core/Text.h"

namespace velum::scene::detail {

Json parseValue(std::string_view text) {
  Json value = Json::parse(text, nullptr, false);
  if (!value.is_discarded()) return value;
  if (text.find(',') != std::string_view::npos) {
    value = Json::parse(fmt::format("[{}]", text), nullptr, false);
    if (!value.is_discarded()) return value;
    std::string lists(text);
    for (std::size_t at = 0; (at = lists.find(';', at)) != std::string::npos; at += 3) lists.replace(at, 1, "],[");
    value = Json::parse(fmt::format("[[{}]]", lists), nullptr, false);
    if (!value.is_discarded()) return value;
  }
  return Json(std::string(text));
}

PathPart takePart(std::string_view path) {
  std::string_view head = path.substr(0, path.find_first_of(".["));
  std::string_view tail = path.substr(head.size());
  if (tail.starts_with('.')) tail.remove_prefix(1);
  return {head, tail};
}

void failNoField(std::string_view name, const std::string& path, const std::vector<std::string>& known) {
  throw ArgumentError(fmt::format("no field '{}' in {}{}; there are {}", name, path.empty() ? "a scene" : path,
                                  meantText(name, known), fmt::join(known, ", ")));
}

void failWhereFull(const std::string& path, std::size_t index, std::size_t most) {
  if (index >= most) throw ArgumentError(fmt::format("{} has {} items, and more it cannot have", path, most));
}

namespace {

/// A whole number without the ".0" of JSON's text.
std::string numberText(const Json& number) {
  std::string text = number.dump();
  return text.ends_with(".0") ? text.substr(0, text.size() - 2) : text;
}

}  // namespace

std::string valueText(const Json& value) {
  if (value.is_number()) return numberText(value);
  auto isNumber = [](const Json& item) { return item.is_number(); };
  if (value.is_array() && value.size() > 1 && std::all_of(value.begin(), value.end(), isNumber)) {
    std::string text;
    for (const Json& item : value) text += (text.empty() ? "" : ",") + numberText(item);
    return text;
  }
  if (value.is_string()) {
    const auto& word = value.get_ref<const std::string&>();
    bool isOneLine = word.find_first_of("\n\r") == std::string::npos && trimmed(word) == word;
    if (!word.empty() && isOneLine && parseValue(word) == value) return word;
  }
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace velum::scene::detail
