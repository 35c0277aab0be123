#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/Text.h"
#include "scene/json/FieldTypes.h"

/// Converts structs with fields() to JSON and back. To be included only by the few files that do so, as the JSON
/// library's header is large.
namespace velum::scene::detail {

using Json = nlohmann::ordered_json;

Json write(const auto& value);

template <Fielded T>
Json writeStruct(const T& value) {
  static const T fresh{};
  std::vector<const void*> members;  // of a new object, in their order
  auto note = [&](std::string_view, const auto& member, const FieldInfo&) { members.push_back(&member); };
  T::fields(fresh, note);
  Json out = Json::object();
  std::size_t place = 0;
  auto visit = [&](std::string_view name, const auto& member, const FieldInfo& info) {
    const auto& unchanged = *static_cast<decltype(&member)>(members[place++]);
    if (info.leftOutByDefault && member == unchanged) return;
    out[std::string(name)] = write(member);
  };
  T::fields(value, visit);
  return out;
}

/// The shortest decimal that reads back as the same float, rather than its long double form.
inline Json writeNumber(float value) { return Json(numberIn(fmt::format("{}", value)).value()); }
/// Infinity becomes null.
inline Json writeNumber(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json writeNumber(Number auto value) { return Json(value); }

Json write(const auto& value) {
  using T = std::remove_cvref_t<decltype(value)>;
  if constexpr (Enumeration<T>) {
    return Json(std::string(enumName(value)));
  } else if constexpr (GlmVector<T>) {
    Json out = Json::array();
    for (int i = 0; i < GlmTraits<T>::kSize; ++i) out.push_back(writeNumber(value[i]));
    return out;
  } else if constexpr (List<T>) {
    Json out = Json::array();
    for (const auto& item : value) out.push_back(write(item));
    return out;
  } else if constexpr (Maybe<T>) {
    return value ? write(*value) : Json(nullptr);
  } else if constexpr (Anything<T>) {
    return Json::parse(value.json, nullptr, false);
  } else if constexpr (Fielded<T>) {
    return writeStruct(value);
  } else if constexpr (Number<T>) {
    return writeNumber(value);
  } else {
    return Json(value);
  }
}

/// @throw InputError
[[noreturn]] void fail(const std::string& path, const std::string& what);
/// Warns of JSON members that are no field of the struct: of each by name, with the field that was most likely meant.
void warnOfUnknown(const Json& json, const std::string& path, const std::vector<std::string>& names);

inline constexpr double kFarthestPlace = 1e15;  ///< In any unit of length; and the longest vector that is a direction.
inline constexpr double kLargestValue = 1e300;  ///< Of data: what is made of it stays a number.

/// The range of a field that states none: numbers so large only come of damage, and nothing can be drawn with them.
template <class T>
Range rangeOf(const FieldInfo& info) {
  if (!std::isinf(info.range.min) || !std::isinf(info.range.max)) return info.range;
  double most = info.unit == kLength || GlmVector<T> ? kFarthestPlace : kLargestValue;
  return {-most, most};
}

void read(auto& target, const Json& json, const std::string& path, const FieldInfo& info);

/// @param range  rangeOf() the field
template <Number T>
void readNumber(T& target, const Json& json, const std::string& path, const FieldInfo& info, const Range& range) {
  if constexpr (std::is_floating_point_v<T>) {
    if (info.nullIsEndless && json.is_null()) return void(target = std::numeric_limits<T>::infinity());
  }
  if (!json.is_number()) fail(path, "expected a number");
  double value = json.get<double>();
  if (!std::isfinite(value)) fail(path, "the number is not finite");
  if (value < range.min || value > range.max)
    fail(path, fmt::format("{:.6g} is outside {:.6g} .. {:.6g}{}{}", value, range.min, range.max,
                           info.unit.empty() ? "" : " ", info.unit));
  if constexpr (std::is_integral_v<T>) {
    if (value != std::floor(value) || std::abs(value) > 2147483647.0)
      fail(path, fmt::format("{} is not a whole number", value));
  }
  target = T(value);
}

template <Fielded T>
void readStruct(T& target, const Json& json, const std::string& path) {
  if (!json.is_object()) fail(path.empty() ? "top" : path, "expected an object");
  std::size_t known = 0;
  std::vector<std::string> names;
  auto visit = [&](std::string_view name, auto& member, const FieldInfo& info) {
    names.emplace_back(name);
    auto it = json.find(std::string(name));
    if (it == json.end()) return;
    ++known;
    read(member, *it, path.empty() ? std::string(name) : fmt::format("{}.{}", path, name), info);
  };
  T::fields(target, visit);
  if (known < json.size()) warnOfUnknown(json, path, names);
}

void read(auto& target, const Json& json, const std::string& path, const FieldInfo& info) {
  using T = std::remove_cvref_t<decltype(target)>;
  if constexpr (std::is_same_v<T, bool>) {
    if (!json.is_boolean()) fail(path, "expected true or false");
    target = json.get<bool>();
  } else if constexpr (Number<T>) {
    readNumber(target, json, path, info, rangeOf<T>(info));
  } else if constexpr (std::is_same_v<T, std::string>) {
    if (!json.is_string()) fail(path, "expected a text");
    target = json.get<std::string>();
  } else if constexpr (Enumeration<T>) {
    if (!json.is_string()) fail(path, "expected a word");
    auto value = enumValue<T>(json.get<std::string>());
    if (!value)
      fail(path, fmt::format("'{}' is not one of {}", json.get<std::string>(), fmt::join(EnumNames<T>::kNames, ", ")));
    target = *value;
  } else if constexpr (GlmVector<T>) {
    constexpr int kSize = GlmTraits<T>::kSize;
    if (!json.is_array() || json.size() != kSize) fail(path, fmt::format("expected {} numbers", kSize));
    for (int i = 0; i < kSize; ++i)
      readNumber(target[i], json[std::size_t(i)], fmt::format("{}.{}", path, i), info, rangeOf<T>(info));
  } else if constexpr (List<T>) {
    if (!json.is_array()) fail(path, "expected a list");
    if (json.size() > info.most)
      fail(path, fmt::format("the list has {} items; {} is the most", json.size(), info.most));
    T items;
    for (std::size_t i = 0; i < json.size(); ++i) {
      items.emplace_back();
      read(items.back(), json[i], fmt::format("{}.{}", path, i), info);
    }
    target = std::move(items);
  } else if constexpr (Anything<T>) {
    target.json = json.dump();
  } else if constexpr (Maybe<T>) {
    if (json.is_null()) return target.reset();
    read(target.emplace(), json, path, info);
  } else {
    readStruct(target, json, path);
  }
}

}  // namespace velum::scene::detail
