#pragma once
#include "app/Common.h"
#include "session/structure/StructureValues.h"

namespace velum::app {

/// Prints the report of `info` as text for people on stdout: what the input is, then a line for each fact about the
/// input, with units and sensible digits. Programs read the JSON.
void printForPeople(const Json& report);

/// The first elements of a vector.
Json listOf(const auto& vector, int count) {
  Json list = Json::array();
  for (int i = 0; i < count; ++i) list.push_back(vector[i]);
  return list;
}

/// The values that a scan measured in a structure, as reports have them.
Json valuesJson(const session::StructureValues& values);

}  // namespace velum::app
