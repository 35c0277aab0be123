#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/Fields.h"

/// Facts about single fields of a scene, by their paths, taken from the fields() lists; forms are made from them.
namespace velum::scene {

/// The kinds of fields, as people see them.
enum class FieldKind { Truth, Whole, Number, Text, Choice, Color, Other };

/// What is known of a field without a scene.
struct FieldFacts {
  FieldKind kind = FieldKind::Other;
  int count = 1;  ///< For Whole and Number: the number of components of a vector, else 1.
  std::string unit;
  Range range;
  std::string meaning;             ///< FieldInfo::doc
  std::vector<std::string> names;  ///< For a choice: names of its values, in order.
};

/// @param path  "finish.contours"; of items of lists "cuts.N.faceOpacity", with whatever stands there for N
/// @throw ArgumentError naming the part of the path that no scene has
FieldFacts fieldFacts(std::string_view path);

}  // namespace velum::scene
