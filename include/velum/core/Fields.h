#pragma once
#include <limits>
#include <string_view>

namespace velum {

/// The allowed interval of a number, both ends included.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

/// What one saved field means. Every saved struct lists its fields once, in
/// `static void fields(auto& object, auto& visit)`, and calls `visit(name, member, FieldInfo)`; JSON, the schema,
/// `--set path=value` and the property panel are made from that list.
struct FieldInfo {
  std::string_view unit = "";
  Range range = {};
  std::string_view doc = "";
  bool leftOutByDefault = false;  ///< A value like that of a new object is not written.
};

/// Names of an enumeration's values, in order. Specialise `kNames` as a constexpr array of string_view.
template <class E>
struct EnumNames;

/// The name of an enumeration's value, as in files and on the command line.
template <class E>
constexpr std::string_view enumName(E value) {
  return EnumNames<E>::kNames[static_cast<int>(value)];
}

}  // namespace velum
