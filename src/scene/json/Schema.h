#pragma once
#include <string>
#include <vector>

/// What fields a scene has, for people and for other programs.
namespace velum::scene {

/// One row a field, for the documentation: path, type, unit, range, meaning, default.
struct FieldRow {
  std::string path, type, unit, range, doc, defaultValue;
};
std::vector<FieldRow> fieldTable();

/// The JSON schema of scene files, made from the same field lists.
std::string jsonSchema();

}  // namespace velum::scene
