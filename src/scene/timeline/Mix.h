#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <type_traits>
#include <vector>

#include "scene/Camera.h"
#include "scene/Sections.h"
#include "scene/json/FieldTypes.h"
#include "scene/json/PathKey.h"

/// Values of any kind of field on the way from a key to the next one: one more visitor of the fields() lists.
namespace velum::scene::detail {

/// Where between two keys: `t` is eased already. Smooth paths look at the keys on both sides, too.
struct Moment {
  double t = 0.0;                                ///< 0: at the key before, 1: at the key after; below 1
  bool isSmooth = false;                         ///< cubic through the keys on both sides, where there are such
  double before = 0.0, span = 1.0, after = 0.0;  ///< seconds between these keys; before, after: 0 where there is none
};

/// The values of the four keys about a moment; `before` and `after` are null where there are none.
template <class T>
struct Four {
  const T *before = nullptr, *from = nullptr, *to = nullptr, *after = nullptr;
};

/// A number between keys: linear; smooth: a cubic whose slopes at the keys are the weighted harmonic means of those on
/// both sides (Fritsch and Butland 1984), 0 at the first and the last key and where the numbers turn back, so that it
/// never leaves the interval of its two keys. Endless numbers hold. @param before, after  nullptr: no key there
double mixNumber(const double* before, double from, double to, const double* after, const Moment& moment);
template <class T>
double mixNumber(const Four<T>& four, const Moment& moment) {
  double before = four.before ? double(*four.before) : 0.0, after = four.after ? double(*four.after) : 0.0;
  return mixNumber(four.before ? &before : nullptr, double(*four.from), double(*four.to), four.after ? &after : nullptr,
                   moment);
}

/// A direction between keys: it turns on the shortest way; its length goes along.
glm::dvec3 mixDirection(const Four<glm::dvec3>& four, const Moment& moment);
/// A camera between keys: turned by quaternions on the shortest way about its target, with the distance and height
/// mixed by their logarithms.
Camera mixCamera(const Four<Camera>& four, const Moment& moment);
/// The frame of a section between keys, turned by quaternions on the shortest way.
void mixFrame(glm::dvec3& normal, glm::dvec3& up, const Four<Section>& four, const Moment& moment);

template <class T>
void mixInto(T& out, const Four<T>& four, const Moment& moment, const FieldInfo& info);

/// The same member of four structs. @param place  of the member in the list of fields
template <class Member>
Four<Member> memberOf(const Four<std::vector<const void*>>& members, std::size_t place) {
  auto at = [&](const std::vector<const void*>* list) {
    return list ? static_cast<const Member*>((*list)[place]) : nullptr;
  };
  return {at(members.before), at(members.from), at(members.to), at(members.after)};
}

template <Fielded T>
std::vector<const void*> membersOf(const T* value) {
  std::vector<const void*> members;
  auto note = [&](std::string_view, const auto& member, const FieldInfo&) { members.push_back(&member); };
  if (value) T::fields(*value, note);
  return members;
}

template <Fielded T>
void mixStruct(T& out, const Four<T>& four, const Moment& moment) {
  std::array<std::vector<const void*>, 4> lists{membersOf(four.before), membersOf(four.from), membersOf(four.to),
                                                membersOf(four.after)};
  Four<std::vector<const void*>> members{four.before ? &lists[0] : nullptr, &lists[1], &lists[2],
                                         four.after ? &lists[3] : nullptr};
  std::size_t place = 0;
  auto visit = [&](std::string_view, auto& member, const FieldInfo& info) {
    using Member = std::remove_cvref_t<decltype(member)>;
    mixInto(member, memberOf<Member>(members, place++), moment, info);
  };
  T::fields(out, visit);
}

/// Points of a curve: their first field is the place on it.
template <class Item>
concept CurvePoint = requires(Item& point) {
  { point.value } -> std::same_as<double&>;
};

/// A point of a piecewise linear curve, as it goes on beyond its ends. @param curve  ascending, not empty
template <CurvePoint Item>
Item pointAt(const std::vector<Item>& curve, double value) {
  auto above = std::find_if(curve.begin(), curve.end(), [&](const Item& point) { return point.value >= value; });
  Item out = above == curve.end() ? curve.back() : *above;
  if (above != curve.begin() && above != curve.end()) {
    const Item& below = *(above - 1);
    double width = above->value - below.value;
    mixInto(out, Four<Item>{nullptr, &below, &*above, nullptr}, Moment{width > 0 ? (value - below.value) / width : 1.0},
            {});
  }
  out.value = value;
  return out;
}

/// Two curves of different numbers of points: the curve between them has the points of both.
template <CurvePoint Item>
void mixCurves(std::vector<Item>& out, const std::vector<Item>& from, const std::vector<Item>& to,
               const Moment& moment) {
  std::vector<double> values;
  for (const auto* curve : {&from, &to})
    for (const Item& point : *curve) values.push_back(point.value);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  out.clear();
  for (double value : values) {
    Item a = pointAt(from, value), b = pointAt(to, value);
    mixInto(out.emplace_back(a), Four<Item>{nullptr, &a, &b, nullptr}, moment, {});
  }
}

/// True where the items of two lists are the same things: as many, and of the same ids or keys.
template <class Item>
bool areSame(const std::vector<Item>& a, const std::vector<Item>& b) {
  auto isSame = [](const Item& one, const Item& other) {
    NamedItem x = namedItem(one), y = namedItem(other);
    return x.id >= 0 ? x.id == y.id : !Keyed<Item> || x.name == y.name;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), isSame);
}

template <class Item>
void mixList(std::vector<Item>& out, const Four<std::vector<Item>>& four, const Moment& moment, const FieldInfo& info) {
  const auto &from = *four.from, &to = *four.to;
  out = from;
  if (areSame(from, to)) {
    auto likeFrom = [&](const std::vector<Item>* list) { return list && areSame(*list, from) ? list : nullptr; };
    const auto *before = likeFrom(four.before), *after = likeFrom(four.after);
    for (std::size_t i = 0; i < from.size(); ++i)
      mixInto(out[i], Four<Item>{before ? &(*before)[i] : nullptr, &from[i], &to[i], after ? &(*after)[i] : nullptr},
              moment, info);
    return;
  }
  if constexpr (CurvePoint<Item>)
    if (!from.empty() && !to.empty()) mixCurves(out, from, to, moment);
}

template <GlmVector T>
void mixVector(T& out, const Four<T>& four, const Moment& moment, const FieldInfo& info) {
  if constexpr (std::is_same_v<T, glm::dvec3>)
    if (info.isDirection) return void(out = mixDirection(four, moment));
  for (int i = 0; i < GlmTraits<T>::kSize; ++i) {
    using Value = typename GlmTraits<T>::Value;
    auto at = [&](const T* value) { return value ? &(*value)[i] : nullptr; };
    mixInto(out[i], Four<Value>{at(four.before), at(four.from), at(four.to), at(four.after)}, moment, info);
  }
}

template <class T>
void mixInto(T& out, const Four<T>& four, const Moment& moment, const FieldInfo& info) {
  if constexpr (std::is_same_v<T, Camera>) {
    out = mixCamera(four, moment);
  } else if constexpr (std::is_same_v<T, Section>) {
    mixStruct(out, four, moment);
    mixFrame(out.normal, out.up, four, moment);
  } else if constexpr (Number<T>) {
    double value = mixNumber(four, moment);
    if constexpr (std::is_integral_v<T>)
      out = T(std::lround(value));
    else
      out = T(value);
  } else if constexpr (GlmVector<T>) {
    mixVector(out, four, moment, info);
  } else if constexpr (List<T>) {
    mixList(out, four, moment, info);
  } else if constexpr (Maybe<T>) {
    using Value = typename MaybeTraits<T>::Value;
    out = *four.from;
    auto at = [](const T* value) { return value && *value ? &**value : nullptr; };
    if (*four.from && *four.to)
      mixInto(*out, Four<Value>{at(four.before), at(four.from), at(four.to), at(four.after)}, moment, info);
  } else if constexpr (Fielded<T>) {
    out = *four.from;
    mixStruct(out, four, moment);
  } else {
    out = *four.from;  // there is nothing between two words
  }
}

}  // namespace velum::scene::detail
