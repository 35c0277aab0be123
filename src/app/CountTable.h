#pragma once
#include <optional>
#include <vector>

#include "app/Common.h"
#include "session/model/CountFiles.h"

namespace velum::app {

/// The numbers of kCountKinds, and their total.
Json countJson(const Counts& counts);

/// A line a row, with those numbers; columns are as wide as what they hold.
/// @param pixels  of the picture: there is a last column, how much of it shows the row
void printCounts(const std::vector<session::CountRow>& rows, std::optional<double> pixels = std::nullopt);

}  // namespace velum::app
