#pragma once
#include <nlohmann/json_fwd.hpp>

namespace velum::scene::detail {

/// Brings the JSON of a scene that an older version of the format wrote to the present one, by a table of renames and
/// conversions. What does not fit stays as it is, for the reader to refuse.
/// @param version  that it was written in
void bringUpToDate(nlohmann::ordered_json& scene, int version);

}  // namespace velum::scene::detail
