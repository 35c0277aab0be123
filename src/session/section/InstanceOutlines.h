#pragma once
#include <cstdint>
#include <vector>

#include "scene/SectionPlane.h"

namespace velum::session {

/// A circle of a section view: where the plane meets the sphere of an instance.
struct InstanceOutline {
  glm::dvec2 middle{0.0};  ///< pixels of the plane
  double radius = 0.0;     ///< pixels
  std::uint32_t type = 0;  ///< in Model::types
};

struct InstanceOutlines {
  std::vector<InstanceOutline> circles;  ///< in the order of the instances
  std::size_t missing = 0;               ///< number of circles that were left out
};

/// The circles of the instances in a section view whose types are shown. Where there are more than `most`, about the
/// same share of each type is left out. Circles with a radius below a third of a pixel are left out, too, and not
/// counted.
InstanceOutlines outlineInstances(const scene::Scene& scene, const scene::SectionPlane& plane, std::size_t most);

}  // namespace velum::session
