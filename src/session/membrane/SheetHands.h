#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "membrane/sheet/SheetIndex.h"
#include "scene/Cut.h"
#include "scene/Project.h"
#include "scene/SectionPlane.h"
#include "scene/Units.h"
#include "session/ViewSpace.h"

namespace velum::session {

/// What hands put on a membrane: pins that hold it, kernels that push or pull it ([IMC] 3.3). Places are of the world,
///.

/// Strength of a kernel that is put in by a drag, as of scene::UserKernel; a pulling one has its negative.
inline constexpr double kKernelStrength = 500.0;

enum class HandKind {
  None,
  Pin,
  Kernel,  ///< by its middle
  Rim      ///< sets a kernel's radius
};
/// Which pin or kernel of a membrane, and by what it is held.
struct Hand {
  HandKind kind = HandKind::None;
  int index = -1;
  bool operator==(const Hand&) const = default;
};
/// The membrane has it.
bool holds(const scene::Membrane& membrane, Hand hand);

/// A point of a sheet: where it is, and which part of the sheet that is (see scene::Pin).
struct SheetPoint {
  glm::dvec3 place{0.0};
  glm::dvec2 sheet{0.5};
};
/// The first point of a membrane's sheet on a ray; nothing when it passes beside the plane.
std::optional<SheetPoint> sheetOnRay(const scene::Cut& cut, const membrane::SheetIndex& sheet,
                                     const scene::PictureRay& ray);
/// The point of the sheet's curve on a section that is nearest to a pixel. @param reach  pixels
std::optional<SheetPoint> sheetOnSection(const scene::Cut& cut, const membrane::SheetIndex& sheet,
                                         const scene::SectionPlane& plane, glm::dvec2 pixel, double reach);

/// The point of the sheet under a pixel of a view, whichever that is.
std::optional<SheetPoint> sheetAt(const scene::Cut& cut, const membrane::SheetIndex& sheet, const ViewSpace& view,
                                  glm::dvec2 pixel, double reach);

/// The shape of a sheet of which only the index is there.
scene::SheetShape shapeOf(const membrane::SheetIndex& sheet);

/// The point of the rest plane under a place, along its normal: a pin of the command line. Nothing beyond the rest
/// plane.
std::optional<scene::Pin> pinOver(const scene::Cut& cut, glm::dvec3 place);

Hand addPin(scene::Membrane& membrane, const SheetPoint& point);
Hand addKernel(scene::Membrane& membrane, glm::dvec3 centre, double radius, double strength);
/// Nothing when the membrane does not have it.
void removeHand(scene::Membrane& membrane, Hand hand);
/// Makes what repels attract, and the other way round.
void turnKernel(scene::Membrane& membrane, Hand hand);

/// How far a pin is from the rest plane, along its normal; 0 when the membrane does not have it.
double pinHeight(const scene::Cut& cut, Hand hand);
void setPinHeight(scene::Cut& cut, Hand hand, double mm);

/// Radius of a kernel that is put in by a click: a twelfth of the rest plane's mean edge.
double defaultRadius(const scene::Cut& cut);

/// What lies under a pixel: pins first, then middles, then rims. @param reach  how far beside it, pixels
Hand handAt(const scene::Membrane& membrane, const scene::Camera& camera, glm::dvec2 size, glm::dvec2 pixel,
            double reach);
Hand handAt(const scene::Membrane& membrane, const scene::SectionPlane& plane, glm::dvec2 pixel, double reach);
Hand handAt(const scene::Membrane& membrane, const ViewSpace& view, glm::dvec2 pixel, double reach);

/// The membrane after a drag, from how it was when the drag began: going back gives the membrane that was. In a picture
/// things move in the plane that faces the eye; a rim follows the pointer.
/// @param along  moves along this direction only, unit
scene::Membrane dragHand(const scene::Membrane& start, Hand hand, const scene::Camera& camera, glm::dvec2 size,
                         glm::dvec2 from, glm::dvec2 to, std::optional<glm::dvec3> along = {});
/// On a section they move in it, and a rim is that of the kernel's circle there.
scene::Membrane dragHand(const scene::Membrane& start, Hand hand, const scene::SectionPlane& plane, glm::dvec2 from,
                         glm::dvec2 to);
/// @param along  of a picture; on a section things move in its plane in any case
scene::Membrane dragHand(const scene::Membrane& start, Hand hand, const ViewSpace& view, glm::dvec2 from, glm::dvec2 to,
                         std::optional<glm::dvec3> along = {});

/// A kernel whose ball a drag has drawn: its middle where the drag began, its rim where it is.
double radiusOfDrag(const scene::SectionPlane& plane, glm::dvec2 from, glm::dvec2 to);
double radiusOfDrag(const scene::Camera& camera, glm::dvec2 size, glm::dvec3 centre, glm::dvec2 to);
double radiusOfDrag(const ViewSpace& view, glm::dvec3 centre, glm::dvec2 from, glm::dvec2 to);

/// The circle in which a section cuts a kernel's ball; nothing when it misses it.
std::optional<ViewCircle> circleOnSection(const scene::SectionPlane& plane, const scene::UserKernel& kernel);
/// How visible a place is on a section: 1 on it, 0 a dozen pixels' length off it.
double nearnessToSection(const scene::SectionPlane& plane, glm::dvec3 place);
/// Three rings about a kernel's middle, across the axes of a plane.
std::vector<std::vector<glm::dvec3>> kernelRings(const scene::UserKernel& kernel, const glm::dmat3& axes);

/// Why the sheet does not pass through a pin: it lies beside the frame, or farther from the rest plane than half of the
/// reach; empty where it does.
std::string whyNotHeld(const scene::LengthFormat& lengths, const scene::Cut& cut, Hand hand);
/// For people: how far it is from the rest plane, "+3.2 mm", or a radius, "r 12.0 mm". UTF-8.
std::string handText(const scene::LengthFormat& lengths, const scene::Cut& cut, Hand hand);
/// The name of the undo step: "Move pin", "Move kernel", "Resize kernel".
const char* handLabel(Hand hand);

}  // namespace velum::session
