#include "session/cut/ShapeTraits.h"

#include <iterator>

#include "scene/Scene.h"
#include "session/cut/CutEdit.h"
#include "session/cut/NewCut.h"

namespace velum::session {

namespace {

using scene::Cut, scene::CutShape;

void makePlane(Cut& cut, const NewCut& at) { cut.axis = nearestAxis(at.toEye); }

void makeBox(Cut& cut, const NewCut& at) {
  cut.axis = {0, 0, 1};
  cut.size = at.data.edges / 3.0;
  cut.centre = at.atSide;
}

void makeSphere(Cut& cut, const NewCut& at) {
  cut.axis = {0, 0, 1};
  cut.size = glm::dvec3(at.third);
  cut.centre = at.atSide;
}

void makeCylinder(Cut& cut, const NewCut& at) {
  cut.axis = at.toEye;
  cut.size = {at.third, at.third, at.through};
}

void makeCone(Cut& cut, const NewCut& at) {
  cut.axis = at.toEye;
  cut.size = {2.0 * at.third, 2.0 * at.third, at.through * 0.5};
}

/// A cut that is everywhere leaves all instances until it is told otherwise: it is there to hold a focus, or shares of
/// types.
void makeEverywhere(Cut& cut, const NewCut& at) {
  const auto& model = at.scene.model.data;
  if (!model || model->compartments.empty()) return;
  cut.model.spares.push_back({});
  cut.model.spares.back().type = model->compartments.front().name;
}

/// In the order of CutShape, in which menus have them.
constexpr ShapeTraits kShapes[] = {
    {.shape = CutShape::Plane,
     .title = "Plane",
     .menuText = nullptr,
     .icon = "M -6 -1 L 2 -5.5 L 6 1 L -2 5.5 Z",
     .sizes = {},
     .girth = Girth::None,
     .faces = 0,
     .low = 0.0,
     .high = 0.0,
     .isWire = false,
     .make = makePlane},
    {.shape = CutShape::Box,
     .title = "Box",
     .menuText = "Add &box",
     .icon = "M -6 -2.5 L 2.5 -2.5 L 2.5 6 L -6 6 Z M -6 -2.5 L -2.5 -6 L 6 -6 L 6 2.5 L 2.5 6 M 2.5 -2.5 L 6 -6",
     .sizes = {{{"x ", "Edge along the box's x"},
                {"y ", "Edge along the box's y"},
                {"z ", "Edge along the box's axis"}}},
     .girth = Girth::None,
     .faces = kFacesX | kFacesY | kFacesZ,
     .low = -0.5,
     .high = 0.5,
     .isWire = true,
     .make = makeBox},
    {.shape = CutShape::Sphere,
     .title = "Sphere",
     .menuText = "Add sp&here",
     .icon = "O 0 0 6 6 U 0 0 6 2.2",
     .sizes = {{{"\u2300 ", "Diameter"}, {}, {}}},
     .girth = Girth::Ball,
     .faces = 0,
     .low = -0.5,
     .high = 0.5,
     .isWire = false,
     .make = makeSphere},
    {.shape = CutShape::Cylinder,
     .title = "Cylinder",
     .menuText = "Add c&ylinder",
     .icon = "O 0 -4 4.5 2 M -4.5 -4 L -4.5 4 M 4.5 -4 L 4.5 4 U 0 4 4.5 2",
     .sizes = {{{"\u2300 ", "Diameter"}, {}, {"long ", "Length along the axis"}}},
     .girth = Girth::Barrel,
     .faces = kFacesZ,
     .low = -0.5,
     .high = 0.5,
     .isWire = true,
     .make = makeCylinder},
    {.shape = CutShape::Cone,
     .title = "Cone",
     .menuText = "Add co&ne",
     .icon = "O 0 -4 5 2 M -5 -4 L 0 6 L 5 -4",
     .sizes = {{{"\u2300 ", "Diameter of the base"}, {}, {"high ", "Height from apex to base"}}},
     .girth = Girth::Taper,
     .faces = kFacesZ,
     .low = 0.0,
     .high = 1.0,
     .isWire = true,
     .make = makeCone},
    {.shape = CutShape::Membrane,
     .title = "Membrane",
     .menuText = nullptr,
     .icon = "M -6.5 2.5 C -2.5 2.5 -3.5 -5 0 -5 C 3.5 -5 2.5 2.5 6.5 2.5 O 0 0.5 2 2",
     .sizes = {{{"x ", "Width of the rest plane"},
                {"y ", "Height of the rest plane"},
                {"reach ",
                 "How far the sheet may go, both sides together: half of it to either side of the rest plane"}}},
     .girth = Girth::None,
     .faces = kFacesX | kFacesY | kFacesZ,
     .low = -0.5,
     .high = 0.5,
     .isWire = false,
     .make = hangMembrane},
    {.shape = CutShape::Everywhere,
     .title = "Everywhere",
     .menuText = "Add a cut &everywhere",
     .icon = "M -6 -3 L -6 -6 L -3 -6 M 3 -6 L 6 -6 L 6 -3 M 6 3 L 6 6 L 3 6 M -3 6 L -6 6 L -6 3 O 0 0 2 2",
     .sizes = {},
     .girth = Girth::None,
     .faces = 0,
     .low = 0.0,
     .high = 0.0,
     .isWire = false,
     .make = makeEverywhere},
};
static_assert(std::size(kShapes) == std::size(EnumNames<CutShape>::kNames), "each shape has its row");

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < std::size(kShapes); ++i)
    if (static_cast<std::size_t>(kShapes[i].shape) != i) return false;
  return true;
}
static_assert(isInOrder(), "rows are found by their shape");

}  // namespace

std::span<const ShapeTraits> allShapes() { return kShapes; }

const ShapeTraits& traitsOf(scene::CutShape shape) { return kShapes[static_cast<int>(shape)]; }

}  // namespace velum::session
