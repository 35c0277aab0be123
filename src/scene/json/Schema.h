#pragma once
#include <string>
#include <vector>

/// Lists the fields of a scene, for people and for other programs.
namespace velum::scene {

/// A row for each field, for the documentation: path, type, unit, range, meaning, default.
struct FieldRow {
  std::string path, type, unit, range, doc, defaultValue;
};
std::vector<FieldRow> fieldTable();

/// The JSON schema of scene files, made from the same field lists.
std::string jsonSchema();

}  // namespace velum::scene
