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

/// What hands put on a membrane: pins that hold its sheet, kernels that push or pull it ([IMC] 3.3). Places and
/// directions are in the world, lengths in scene units, pixels are those of a view.

/// Strength of a kernel that a drag puts in, as of scene::UserKernel; a kernel that pulls has the negative of it.
inline constexpr double kKernelStrength = 500.0;

enum class HandKind {
  None,
  Pin,
  Kernel,  ///< a kernel, held by its middle
  Rim      ///< the rim of a kernel: sets its radius
};
/// A pin or kernel of a membrane, and by which part it is held.
struct Hand {
  HandKind kind = HandKind::None;
  int index = -1;
  bool operator==(const Hand&) const = default;
};
/// True when the membrane has this pin or kernel.
bool holds(const scene::Membrane& membrane, Hand hand);

/// A point of a sheet: its place in the world, and which part of the sheet is there (see scene::Pin).
struct SheetPoint {
  glm::dvec3 place{0.0};
  glm::dvec2 sheet{0.5};
};
/// The first point of a membrane's sheet on a ray; nothing when the ray passes beside the sheet.
std::optional<SheetPoint> sheetOnRay(const scene::Cut& cut, const membrane::SheetIndex& sheet,
                                     const scene::PictureRay& ray);
/// The point of the sheet's curve on a section that is nearest to a pixel. @param reach  pixels
std::optional<SheetPoint> sheetOnSection(const scene::Cut& cut, const membrane::SheetIndex& sheet,
                                         const scene::SectionPlane& plane, glm::dvec2 pixel, double reach);

/// The point of the sheet under a pixel of a view, be it the 3D picture or a section.
std::optional<SheetPoint> sheetAt(const scene::Cut& cut, const membrane::SheetIndex& sheet, const ViewSpace& view,
                                  glm::dvec2 pixel, double reach);

/// The shape of a sheet, made from its index where nothing else of the sheet is at hand.
scene::SheetShape shapeOf(const membrane::SheetIndex& sheet);

/// A pin at a place, which holds the point of the rest plane that lies under the place along the plane's normal: a pin
/// of the command line. Nothing where the place lies beside the rest plane.
std::optional<scene::Pin> pinOver(const scene::Cut& cut, glm::dvec3 place);

Hand addPin(scene::Membrane& membrane, const SheetPoint& point);
Hand addKernel(scene::Membrane& membrane, glm::dvec3 centre, double radius, double strength);
/// Removes a pin or kernel; does nothing when the membrane does not have it.
void removeHand(scene::Membrane& membrane, Hand hand);
/// Makes a kernel that repels attract, and the other way round.
void turnKernel(scene::Membrane& membrane, Hand hand);

/// How far a pin is from the rest plane, along the plane's normal; 0 when the membrane does not have the pin.
double pinHeight(const scene::Cut& cut, Hand hand);
void setPinHeight(scene::Cut& cut, Hand hand, double length);

/// Radius of a kernel that a click puts in: a twelfth of the rest plane's mean edge.
double defaultRadius(const scene::Cut& cut);

/// The pin or kernel under a pixel: pins first, then the middles of kernels, then their rims. @param reach  how far
/// beside the pixel may be, pixels
Hand handAt(const scene::Membrane& membrane, const scene::Camera& camera, glm::dvec2 size, glm::dvec2 pixel,
            double reach);
Hand handAt(const scene::Membrane& membrane, const scene::SectionPlane& plane, glm::dvec2 pixel, double reach);
Hand handAt(const scene::Membrane& membrane, const ViewSpace& view, glm::dvec2 pixel, double reach);

/// The membrane after a drag, made from the membrane as it was when the drag began: going back gives the membrane that
/// was. In a 3D picture pins and kernels move in the plane through them that faces the eye; a rim follows the pointer.
/// @param along  moves along this direction only, unit
scene::Membrane dragHand(const scene::Membrane& start, Hand hand, const scene::Camera& camera, glm::dvec2 size,
                         glm::dvec2 from, glm::dvec2 to, std::optional<glm::dvec3> along = {});
/// On a section pins and kernels move in the section's plane; a rim is that of the circle in which the section cuts the
/// kernel.
scene::Membrane dragHand(const scene::Membrane& start, Hand hand, const scene::SectionPlane& plane, glm::dvec2 from,
                         glm::dvec2 to);
/// @param along  for the 3D picture; on a section pins and kernels move in its plane in any case
scene::Membrane dragHand(const scene::Membrane& start, Hand hand, const ViewSpace& view, glm::dvec2 from, glm::dvec2 to,
                         std::optional<glm::dvec3> along = {});

/// Radius of a kernel whose ball a drag has drawn: its middle is where the drag began, its rim where the pointer is.
double radiusOfDrag(const scene::SectionPlane& plane, glm::dvec2 from, glm::dvec2 to);
double radiusOfDrag(const scene::Camera& camera, glm::dvec2 size, glm::dvec3 centre, glm::dvec2 to);
double radiusOfDrag(const ViewSpace& view, glm::dvec3 centre, glm::dvec2 from, glm::dvec2 to);

/// The circle in which a section cuts a kernel's ball; nothing when the section misses the ball.
std::optional<ViewCircle> circleOnSection(const scene::SectionPlane& plane, const scene::UserKernel& kernel);
/// How visible a place is on a section: 1 on the section's plane, 0 when it is the length of a dozen pixels off the
/// plane.
double nearnessToSection(const scene::SectionPlane& plane, glm::dvec3 place);
/// Three rings about a kernel's middle with the kernel's radius, each across one of three axes. World.
std::vector<std::vector<glm::dvec3>> kernelRings(const scene::UserKernel& kernel, const glm::dmat3& axes);

/// Why the sheet does not pass through a pin: the pin lies beside the frame, or farther from the rest plane than half
/// of the reach. Empty where the sheet passes through it.
std::string whyNotHeld(const scene::LengthFormat& lengths, const scene::Cut& cut, Hand hand);
/// For people: how far a pin or a kernel's middle is from the rest plane, "+3.2 mm", or a kernel's radius, "r 12.0 mm".
/// UTF-8.
std::string handText(const scene::LengthFormat& lengths, const scene::Cut& cut, Hand hand);
/// The name of the undo step: "Move pin", "Move force", "Resize force".
const char* handLabel(Hand hand);

}  // namespace velum::session
