#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <type_traits>
#include <vector>

#include "core/Fields.h"

/// What a field can be: a leaf (bool, number, string, enumeration, vector of numbers), a list, or a struct with
/// fields(). Code that treats fields by their types uses these concepts.
namespace velum::scene::detail {

template <class T>
concept Enumeration = std::is_enum_v<T>;
template <class T>
concept Number = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
template <class T>
struct GlmTraits : std::false_type {};
template <int N, class T, glm::qualifier Q>
struct GlmTraits<glm::vec<N, T, Q>> : std::true_type {
  static constexpr int kSize = N;
  using Value = T;
};
template <class T>
concept GlmVector = GlmTraits<T>::value;
template <class T>
struct ListTraits : std::false_type {};
template <class T>
struct ListTraits<std::vector<T>> : std::true_type {
  using Item = T;
};
template <class T>
concept List = ListTraits<T>::value;
template <class T>
struct MaybeTraits : std::false_type {
  using Value = T;
};
template <class T>
struct MaybeTraits<std::optional<T>> : std::true_type {
  using Value = T;
};
template <class T>
concept Maybe = MaybeTraits<T>::value;
template <class T>
concept Anything = std::is_same_v<T, AnyValue>;
struct AnyVisitor {
  void operator()(auto&&...) const {}
};
template <class T>
concept Fielded = requires(T& t, AnyVisitor& v) {
  T::fields(t, v);
};

}  // namespace velum::scene::detail
