#pragma once
#include <string>
#include <vector>

#include "app/Common.h"
#include "app/Inputs.h"
#include "session/model/PictureCounter.h"

namespace velum::app {

/// What is counted of structures, and where it goes.
struct AreaOptions {
  std::vector<std::string> areas;  ///< STRUCTURE=PIXELS or STRUCTURE=PERCENT%
  std::string csv, svg, output;    ///< files; empty: none
  bool json = false;
};

/// Sets the areas that are wanted, and says what of a scene's structures its picture shows, hides and has lost to cuts,
/// in pixels. What is not met is said on stderr.
int countAreas(session::Session& session, const AreaOptions& options, session::PictureCounter& counter);

}  // namespace velum::app
