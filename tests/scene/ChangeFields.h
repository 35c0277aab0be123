#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <glm/glm.hpp>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "core/Fields.h"
#include "scene/Scene.h"

/// Walks over the fields of any saved struct, so that a field that is added tomorrow is tested tomorrow.
namespace velum::scene {

struct NoVisitor {
  void operator()(auto&&...) const {}
};
template <class T>
concept HasFields = requires(T& t, NoVisitor& v) {
  T::fields(t, v);
};
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsGlm : std::false_type {};
template <int N, class T, glm::qualifier Q>
struct IsGlm<glm::vec<N, T, Q>> : std::true_type {};

template <class T>
struct IsMaybe : std::false_type {};
template <class T>
struct IsMaybe<std::optional<T>> : std::true_type {};

inline double otherNumber(double value, const Range& range) {
  double next = value * 1.25 + 0.125;
  if (std::isfinite(next) && next >= range.min && next <= range.max) return next;
  return 0.63 * std::max(range.min, -1e3) + 0.37 * std::min(range.max, 1e3);
}

/// Gives every field of a value another value that its range allows.
void changeEveryField(auto& value, const FieldInfo& info = {}) {
  using T = std::remove_cvref_t<decltype(value)>;
  if constexpr (std::is_same_v<T, bool>) {
    value = !value;
  } else if constexpr (std::is_enum_v<T>) {
    value = T((static_cast<int>(value) + 1) % static_cast<int>(std::size(EnumNames<T>::kNames)));
  } else if constexpr (std::is_integral_v<T>) {
    value = T(double(value) + 1 <= info.range.max ? value + 1 : value - 1);
  } else if constexpr (std::is_floating_point_v<T>) {
    value = T(otherNumber(double(value), info.range));
  } else if constexpr (std::is_same_v<T, AnyValue>) {
    value.json = value.json == "1.5" ? "[1,\"two\"]" : "1.5";
  } else if constexpr (std::is_same_v<T, std::string>) {
    value += "n\xc3\xa4me \"quoted\" \\ \n\t/";
  } else if constexpr (IsGlm<T>::value) {
    for (int i = 0; i < T::length(); ++i) {
      changeEveryField(value[i], info);
      if (std::is_floating_point_v<typename T::value_type> && value[i] * (1.0 + 0.01 * i) <= info.range.max)
        value[i] = typename T::value_type(value[i] * (1.0 + 0.01 * i));
    }
  } else if constexpr (IsVector<T>::value) {
    value.resize(2);
    for (auto& item : value) changeEveryField(item, info);
    changeEveryField(value[1], info);
  } else if constexpr (IsMaybe<T>::value) {
    changeEveryField(value.emplace(), info);
  } else {
    auto visit = [](std::string_view, auto& member, const FieldInfo& memberInfo) {
      changeEveryField(member, memberInfo);
    };
    T::fields(value, visit);
  }
}

/// Gives the n-th field that is no struct another value; lists keep their length, and of lists of structs the fields of
/// each item count.
/// @param n        counts down as the fields are walked over
/// @param changed  becomes the path of the field; stays as it is when there are not so many
template <class T>
void changeNthField(T& value, int& n, const std::string& path, std::string& changed, const FieldInfo& info = {}) {
  auto below = [&](std::string_view name) { return path.empty() ? std::string(name) : path + "." + std::string(name); };
  if constexpr (HasFields<T>) {
    auto visit = [&](std::string_view name, auto& member, const FieldInfo& memberInfo) {
      changeNthField(member, n, below(name), changed, memberInfo);
    };
    T::fields(value, visit);
    return;
  } else if constexpr (IsMaybe<T>::value) {
    if (value) changeNthField(*value, n, path, changed, info);
    return;
  } else if constexpr (IsVector<T>::value) {
    if constexpr (HasFields<typename T::value_type>) {
      for (std::size_t i = 0; i < value.size(); ++i) changeNthField(value[i], n, below(std::to_string(i)), changed);
      return;
    }
  }
  if constexpr (!HasFields<T>)
    if (n-- == 0) {
      changeEveryField(value, info);
      changed = path;
    }
}

/// A scene in which every field has another value than in a new one.
inline Scene changedScene() {
  Scene scene;
  changeEveryField(scene);
  scene.cuts[0].shape = CutShape::Membrane;  // the only one that has one
  scene.cuts[1].membrane.reset();
  return scene;
}

/// Paths of all fields that are no structs, list items as "N".
template <class T>
void collectLeaves(const T& value, const std::string& path, std::set<std::string>& leaves) {
  if constexpr (HasFields<T>) {
    auto visit = [&](std::string_view name, const auto& member, const FieldInfo&) {
      collectLeaves(member, path.empty() ? std::string(name) : path + "." + std::string(name), leaves);
    };
    T::fields(value, visit);
  } else if constexpr (IsMaybe<T>::value) {
    collectLeaves(typename T::value_type{}, path, leaves);
  } else {
    leaves.insert(path);
    if constexpr (IsVector<T>::value) {
      if constexpr (HasFields<typename T::value_type>) collectLeaves(typename T::value_type{}, path + ".N", leaves);
    }
  }
}

}  // namespace velum::scene
