#pragma once
#include <optional>
#include <string_view>

#include "scene/SceneFwd.h"

namespace velum::session {

/// How people write how many instances are meant, for messages.
inline constexpr std::string_view kInstanceNumberForm = "a whole number of instances, or a share such as 20%";

/// The number of instances that a text means: "50", or "20 %" of all that there are. @param total  how many there are
/// @return none where the text is neither a whole number from 0 on nor a share from 0 to 100 %
std::optional<double> instanceNumber(std::string_view text, double total);

/// The same for a type or compartment of a scene's model. @throw ArgumentError where the text is none; InputError as of
/// typesAt()
double instanceNumber(const scene::Scene& scene, std::string_view path, std::string_view text);

}  // namespace velum::session
