#pragma once
#include "app/Common.h"
#include "session/structure/StructureValues.h"

namespace velum::app {

/// What `info` reports, as text for people on stdout: what it is, then a line for each thing that one wants to know of
/// it, with units and sensible digits. Programs read the JSON.
void printForPeople(const Json& report);

/// What a scan measured in a structure, as reports have it.
Json valuesJson(const session::StructureValues& values);

}  // namespace velum::app
