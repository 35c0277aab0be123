#pragma once
#include <optional>
#include <vector>

#include "session/lettering/PlaceNames.h"

namespace velum::session {

/// Names that look for places, and where they stood in the frame before (null: nowhere).
struct WaitingNames {
  std::vector<NameToPlace> names;
  std::vector<const NamePlace*> before;
};

/// Where names would stand left and right of the subject: the low corners of their blocks; none for those for which
/// there is no room. Leaders of one column do not cross; those of both only where names keep their side from the frame
/// before and something else is in their way, too.
/// @param room  what is taken includes all that names must avoid
std::vector<std::optional<glm::dvec2>> columnPlaces(const WaitingNames& waiting, const NameRoom& room);

}  // namespace velum::session
