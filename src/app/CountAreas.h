#pragma once
#include <string>
#include <vector>

#include "app/Common.h"
#include "app/Inputs.h"
#include "session/model/PictureCounter.h"

namespace velum::app {

/// Which areas of structures are wanted, and where the counts are written.
struct AreaOptions {
  std::vector<std::string> areas;  ///< STRUCTURE=PIXELS or STRUCTURE=PERCENT%
  std::string csv, svg, output;    ///< files; empty: none
  bool json = false;
};

/// Sets the areas that are wanted, and reports in pixels how much of each of the scene's structures the picture shows,
/// how much is hidden in it and how much cuts have removed. Areas that cannot be met are said on stderr. @return exit
/// code
int countAreas(session::Session& session, const AreaOptions& options, session::PictureCounter& counter);

}  // namespace velum::app
