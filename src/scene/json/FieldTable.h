#pragma once
#include <string>
#include <vector>

#include "scene/json/FieldJson.h"
#include "scene/json/Schema.h"

/// Structs with fields() as rows of a table, for people.
namespace velum::scene::detail {

template <class T>
std::string typeName() {
  if constexpr (std::is_same_v<T, bool>)
    return "true or false";
  else if constexpr (std::is_integral_v<T>)
    return "whole number";
  else if constexpr (Number<T>)
    return "number";
  else if constexpr (std::is_same_v<T, std::string>)
    return "text";
  else if constexpr (Anything<T>)
    return "any value";
  else if constexpr (GlmVector<T>)
    return fmt::format("{} numbers", GlmTraits<T>::kSize);
  else if constexpr (List<T>)
    return fmt::format("list of {}", typeName<typename ListTraits<T>::Item>());
  else if constexpr (Enumeration<T>) {
    std::string names;
    for (auto name : EnumNames<T>::kNames) names += fmt::format("{}`{}`", names.empty() ? "" : ", ", name);
    return names;
  } else
    return "object";
}

inline std::string rangeText(const Range& range) {
  if (std::isinf(range.min) && std::isinf(range.max)) return "";
  return fmt::format("{} .. {}", range.min, range.max);
}

template <Fielded T>
void addRows(const T& defaults, const std::string& path, std::vector<FieldRow>& rows) {
  auto visit = [&](std::string_view name, const auto& member, const FieldInfo& info) {
    using M = typename MaybeTraits<std::remove_cvref_t<decltype(member)>>::Value;
    std::string here = path.empty() ? std::string(name) : fmt::format("{}.{}", path, name);
    if constexpr (Maybe<std::remove_cvref_t<decltype(member)>> && Fielded<M>) {
      addRows(M{}, here, rows);
    } else if constexpr (Fielded<M>) {
      addRows(member, here, rows);
    } else {
      std::string range = List<M> ? fmt::format("at most {}", info.most) : rangeText(info.range);
      rows.push_back(
          {here, typeName<M>(), std::string(info.unit), std::move(range), std::string(info.doc), write(member).dump()});
      if constexpr (List<M>) {
        if constexpr (Fielded<typename ListTraits<M>::Item>) addRows(typename ListTraits<M>::Item{}, here + ".N", rows);
      }
    }
  };
  T::fields(defaults, visit);
}

}  // namespace velum::scene::detail
