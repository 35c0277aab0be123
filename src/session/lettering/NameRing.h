#pragma once
#include "session/lettering/NameColumns.h"

namespace velum::session {

/// Where names would stand around the subject, as columnPlaces() says it: blocks touch a line around it (an ellipse, or
/// one nearer to a box) from outside, in the order of their anchors, as near to these and their directions as others
/// let them ([ILLUSTRATIONS]).
std::vector<std::optional<glm::dvec2>> ringPlaces(const WaitingNames& waiting, const NameRoom& room);

}  // namespace velum::session
