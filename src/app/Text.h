#pragma once
#include "Common.h"

namespace velum::app {

/// What `info` reports, as text for people on stdout: what it is, then a line for each thing that one wants to know of
/// it, with units and sensible digits. Programs read the JSON.
void printForPeople(const Json& report);

}  // namespace velum::app
