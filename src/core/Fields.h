#pragma once
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include "core/Assert.h"

namespace velum {

/// The allowed interval of a number, both ends included.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

/// `FieldInfo::unit` of lengths: they are in the unit of their scene.
inline constexpr std::string_view kLength = "length";

/// What one saved field means. Every saved struct lists its fields once, in
/// `static void fields(auto& object, auto& visit)`, and calls `visit(name, member, FieldInfo)`; JSON, the schema,
/// `--set path=value`, the change log and the table of fields in the documents are made from that list.
struct FieldInfo {
  std::string_view unit = "";
  Range range = {};
  std::string_view doc = "";
  bool leftOutByDefault = false;  ///< A value like that of a new object is not written.
  bool nullIsEndless = false;     ///< The number may be infinite; JSON has no such number, so null is written for it.
  std::size_t most = 70'000;  ///< Most items of a list; more than we ever write. Keeps hostile files small in memory.
  bool isDirection = false;   ///< Of a vector its direction counts: on the way to another one it turns.
};
/// Of a field that is a direction.
constexpr FieldInfo directionInfo(std::string_view doc, bool leftOutByDefault = false) {
  return {"", {}, doc, leftOutByDefault, false, 70'000, true};
}

/// A value of any field, as JSON text. In files it stands as itself and not as a text.
struct AnyValue {
  std::string json = "null";
  bool operator==(const AnyValue&) const = default;
};

/// Names of an enumeration's values, in order. Specialise `kNames` as a constexpr array of string_view.
template <class E>
struct EnumNames;

/// The name of an enumeration's value, as in files and on the command line.
template <class E>
constexpr std::string_view enumName(E value) {
  VELUM_ASSERT(static_cast<std::size_t>(value) < std::size(EnumNames<E>::kNames), "every value has a name");
  return EnumNames<E>::kNames[static_cast<std::size_t>(value)];
}

/// The value that has this name; nothing when no value has it.
/// @param isSame  compares two names: to the letter unless told otherwise
template <class E, class Same = std::equal_to<std::string_view>>
constexpr std::optional<E> enumValue(std::string_view name, Same isSame = {}) {
  for (std::size_t i = 0; i < std::size(EnumNames<E>::kNames); ++i)
    if (isSame(name, EnumNames<E>::kNames[i])) return static_cast<E>(i);
  return std::nullopt;
}

}  // namespace velum
