#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/SceneFwd.h"

/// Sets and gets single fields of a scene, by their paths, as text.
namespace velum::scene {

/// Changes one field by its path: "rayCast.stepVoxels", "cuts.0.centre", "cuts.+" appends a cut, "cuts.*.enabled" sets
/// the field of each cut.
/// @param value  JSON, or a bare word or comma list: 0.5, true, mip, 1,2,3, "[{...}]"
/// @throw ArgumentError naming the part of the path, or the value, that does not fit
void setField(Scene& scene, std::string_view path, std::string_view value);

/// A text as a value that setField() takes for this text, whatever it holds.
std::string valueOfText(const std::string& text);

/// The value of a field, or of a part with all of its fields, as text that setField() takes. "cuts.*.enabled" gives a
/// list.
/// @param path  empty: the whole scene @throw ArgumentError naming the part of the path that does not fit
std::string getField(const Scene& scene, std::string_view path);

/// A field and its value, as text that setField() takes.
struct FieldValue {
  std::string path, value;
  bool operator==(const FieldValue&) const = default;
};
/// The fields to set, in this order, to turn one scene into another. A list that grew or shrank is set as a whole. The
/// shapes in which sheets came to rest are left out.
std::vector<FieldValue> fieldChanges(const Scene& before, const Scene& after);

}  // namespace velum::scene
