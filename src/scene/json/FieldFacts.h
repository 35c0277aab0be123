#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/Fields.h"

/// What fields() says of single fields of a scene, by their paths: forms are made from that.
namespace velum::scene {

/// What a field can be, as people meet it.
enum class FieldKind { Truth, Whole, Number, Text, Choice, Color, Other };

/// What is known of a field without a scene.
struct FieldFacts {
  FieldKind kind = FieldKind::Other;
  int count = 1;  ///< Of whole numbers and numbers: of a vector, its components.
  std::string unit;
  Range range;
  std::string meaning;             ///< FieldInfo::doc
  std::vector<std::string> names;  ///< Of a choice: its values, in order.
};

/// @param path  "finish.contours"; of items of lists "cuts.N.faceOpacity", with whatever stands there for N
/// @throw ArgumentError naming the part of the path that no scene has
FieldFacts fieldFacts(std::string_view path);

}  // namespace velum::scene
