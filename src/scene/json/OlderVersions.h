#pragma once
#include <nlohmann/json_fwd.hpp>

namespace velum::scene::detail {

/// Brings the JSON of a scene in an older version of the format to the present version, by a table of renames and
/// conversions. Values that do not fit stay as they are, for the reader to refuse.
/// @param version  version of the format that the scene was written in
void bringUpToDate(nlohmann::ordered_json& scene, int version);

}  // namespace velum::scene::detail
