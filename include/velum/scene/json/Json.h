#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "velum/scene/Scene.h"

namespace velum::scene {

constexpr int kSceneVersion = 2;

/// The scene as JSON text (version, then every field of every saved struct). The same scene gives the same bytes.
std::string toJson(const Scene& scene);

/// The counterpart of toJson. Fields that are missing keep their defaults; fields that are unknown are left alone with
/// a warning. Payloads (`data`) are empty.
/// @throw InputError for text that is no scene, is from a newer version, or has a value of the wrong kind or out of
/// range
Scene fromJson(std::string_view text);

constexpr int kTransferVersion = 1;

/// A transfer function alone as JSON text, by the same field list: {"velumTransfer": 1, "colors": ...}.
std::string transferToJson(const TransferFunction& transfer);

/// The counterpart. @throw InputError for text that is no transfer function of ours, is from a newer version, or has a
/// value of the wrong kind or out of range
TransferFunction transferFromJson(std::string_view text);

/// Changes one field by its path: "rayCast.stepVoxels", "cuts.0.centre", "cuts.+" appends one, "cuts.*.enabled" is of
/// each.
/// @param value  JSON, or a bare word or comma list: 0.5, true, mip, 1,2,3, "[{...}]"
/// @throw ArgumentError naming the part of the path, or the value, that does not fit
void setField(Scene& scene, std::string_view path, std::string_view value);

/// The counterpart: a field, or a part with all of its fields, as setField() takes it. "cuts.*.enabled" gives a list.
/// @param path  empty: the whole scene  @throw ArgumentError naming the part of the path that does not fit
std::string getField(const Scene& scene, std::string_view path);

/// A field and its value, as text that setField() takes.
struct FieldValue {
  std::string path, value;
  bool operator==(const FieldValue&) const = default;
};
/// What to set, in this order, so that one scene becomes another; a list that grew or shrank is set whole. Not among
/// them: where sheets came to rest.
std::vector<FieldValue> fieldChanges(const Scene& before, const Scene& after);

/// One row a field, for the documentation: path, type, unit, range, meaning, default.
struct FieldRow {
  std::string path, type, unit, range, doc, defaultValue;
};
std::vector<FieldRow> fieldTable();

/// The JSON schema of scene files, made from the same field lists.
std::string jsonSchema();

}  // namespace velum::scene
