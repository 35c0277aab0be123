#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/Mark.h"
#include "scene/SceneFwd.h"
#include "session/ViewSpace.h"

namespace velum::session {

/// Where the marks of a scene are in a view: in the 3D picture, or in a section. Pixels from the top left corner.
class MarkView {
 public:
  /// @param scene  outlives this object  @param space  what the pixels of the picture mean
  MarkView(const scene::Scene& scene, const ViewSpace& space);

  const scene::Scene& scene() const { return mScene; }
  const ViewSpace& space() const { return mSpace; }
  bool isSection() const { return mSpace.section() != nullptr; }
  /// The pixels of several places; none where one of them lies behind the eye.
  std::optional<std::vector<glm::dvec2>> pixels(const std::vector<glm::dvec3>& places) const;
  /// How far a place lies before a section, towards the viewer; 0 in the 3D picture. Scene units.
  double height(glm::dvec3 world) const;
  /// How much of a mark is seen here, 0..1, see markShare(); nothing at other time steps than its own.
  double opacityOf(const scene::Mark& mark) const;
  /// See goesThrough() and markLines().
  bool goesThrough(const scene::Mark& mark) const;
  std::vector<std::vector<glm::dvec2>> lines(const scene::Mark& mark) const;

 private:
  const scene::Scene& mScene;
  ViewSpace mSpace;
  double mStep = 1.0;  ///< of the section, scene units
};

/// The eight corners of a box mark, in the order of binary digits of their axes: first x, then y, then z along the
/// volume's axes, in the world. @param mark  of the kind Box
std::vector<glm::dvec3> boxCorners(const scene::Scene& scene, const scene::Mark& mark);

}  // namespace velum::session
