#pragma once
#include <optional>
#include <vector>

#include "app/Common.h"
#include "session/model/CountFiles.h"

namespace velum::app {

/// The number of each kind in kCountKinds, and the total.
Json countJson(const Counts& counts);

/// Prints one line for each row with the number of each kind and the total; the column of names is as wide as the
/// longest name. @param pixels  how many the picture has; with it a last column tells which percentage of the picture
/// shows the row
void printCounts(const std::vector<session::CountRow>& rows, std::optional<double> pixels = std::nullopt);

}  // namespace velum::app
