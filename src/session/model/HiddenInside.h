#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/Counts.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// The compartments of which a picture shows next to nothing, although no cut takes anything of them away: what is
/// around them hides them, as a membrane hides what it holds. Of those in one another the outermost; ascending. None
/// where the picture shows nothing of the model. @param counts  of compartments, of a complete picture
std::vector<std::uint32_t> hiddenInside(const scene::Scene& scene, const std::vector<Counts>& counts);

/// "Next to nothing is seen of capsid and interior: what is around them hides them"; empty where there are none.
std::string hiddenWords(const scene::Scene& scene, const std::vector<std::uint32_t>& compartments);

}  // namespace velum::session
