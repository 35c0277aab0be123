#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/Fields.h"
#include "scene/SheetShape.h"

namespace velum::scene {

/// How a kernel's push is directed. Paper: away from the kernel's centre ([IMC] eq. 3). Sided: along the rest plane's
/// normal, to the side on which the least cut leaves the kernel's structure.
enum class KernelRule { Sided, Paper };
/// On which side of the sheet a structure comes to lie that the rest plane would cut and the sheet can pass by: the
/// side that stays, the side that is removed, or the side on which more of the structure lies.
enum class MembraneSide { Keep, Remove, Nearest };
/// What the sheet does when its rest plane moves ([IMC] 3.3): start anew from the flat sheet, or be dragged along.
enum class Repositioning { Passive, Active };
/// What the sheet does to the picture ([IMC] 3.4): removes what is in front of it; or keeps what lies between the sheet
/// and the rest plane, which is drawn as an image.
enum class MembraneUse { Clip, Inlay };
/// How the sheet itself is shown.
enum class SheetLook { Hidden, Grid, Surface };

/// A point of a piecewise linear curve from an attribute of the data to a force.
struct StrengthPoint {
  double value = 0.0;     ///< the volume's unit; for a gradient: that unit per unit of length of the scene
  double strength = 0.0;  ///< > 0 repels the sheet, < 0 attracts it
  bool operator==(const StrengthPoint&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("value", o.value, FieldInfo{"", {}, "Value of the data, or gradient magnitude per unit of length."});
    visit("strength", o.strength, FieldInfo{"", {-1000, 1000}, "Above 0 the sheet is repelled, below attracted."});
  }
};

/// The force of a whole structure.
struct LabelStrength {
  int id = 0;
  double strength = 0.0;
  bool operator==(const LabelStrength&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("id", o.id, FieldInfo{"", {0, 65535}, "Label id of the structure."});
    visit("strength", o.strength, FieldInfo{"", {-1000, 1000}, "Above 0 the sheet is repelled, below attracted."});
  }
};

/// The force of the instances of a molecular type, or of all types of a compartment.
struct TypeStrength {
  std::string path;
  double strength = 0.0;
  bool operator==(const TypeStrength&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("path", o.path, FieldInfo{"", {}, "Path of a type or compartment of the model, with dots."});
    visit("strength", o.strength, FieldInfo{"", {-1000, 1000}, "Above 0 the sheet is repelled, below attracted."});
  }
};

/// A kernel that the user has put somewhere ([IMC] 3.3): a ball that pushes away from its centre or pulls to it.
struct UserKernel {
  glm::dvec3 centre{0.0};
  double radius = 10.0;
  double strength = 500.0;
  bool operator==(const UserKernel&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("centre", o.centre, FieldInfo{kLength, {}, "Middle."});
    visit("radius", o.radius, FieldInfo{kLength, {0, 1e9}, "How far it reaches."});
    visit("strength", o.strength, FieldInfo{"", {-1000, 1000}, "Above 0 the sheet is repelled, below attracted."});
  }
};

/// A particle of the sheet that is held in a place ([IMC] 3.3).
struct Pin {
  glm::dvec2 sheet{0.5};  ///< which particle: share of the rest plane's width and height, 0..1
  glm::dvec3 place{0.0};  ///< where it is held, world
  bool operator==(const Pin&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("sheet", o.sheet, FieldInfo{"", {0, 1}, "Which particle: share of the rest plane's width and height."});
    visit("place", o.place, FieldInfo{kLength, {}, "Where it is held."});
  }
};

/// A stroke on a section that says what the sheet is to spare, or to follow ([IMC] 3.3).
struct Stroke {
  std::vector<glm::dvec3> path;
  double radius = 3.0;
  bool avoid = false;  ///< false: keep what is under it whole; true: let the sheet through
  bool operator==(const Stroke&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("path", o.path, FieldInfo{kLength, {}, "Points along the stroke."});
    visit("radius", o.radius, FieldInfo{kLength, {0, 1e9}, "Half its width."});
    visit("avoid", o.avoid, FieldInfo{"", {}, "Lets the sheet through what is under it, rather than keep that whole."});
  }
};

/// From data to forces: the potential field transfer function and the kernels made by it ([IMC] 3, 3.2).
struct ForceField {
  std::vector<StrengthPoint> byValue;     ///< ascending; 0 before the first and after the last; the parts add up
  std::vector<StrengthPoint> byGradient;  ///< as byValue, but over the gradient's magnitude
  std::vector<LabelStrength> byLabel;     ///< of structures, where there are labels
  std::vector<TypeStrength> byType;       ///< of a model's types; of two that lead to a type the longer path counts
  bool denoise = false;                   ///< the curves are over the data with its noise taken out
  int leastPiece = -1;                    ///< pieces of fewer voxels protected by value do not count; -1: as noise says
  int level = 1;                          ///< super-voxels of 2^level voxels per axis
  double threshold = 0.5;                 ///< super-voxels weaker than this have no kernel
  double areaOfEffect = 2.0;              ///< half-width of a kernel in super-voxels
  KernelRule rule = KernelRule::Sided;
  MembraneSide side = MembraneSide::Keep;  ///< side of structures that need not be cut; by the sided rule only
  std::vector<UserKernel> kernels;
  std::vector<Stroke> strokes;
  std::vector<StrengthPoint> byValueBefore;  ///< where there are strokes: byValue as it was before the first
  bool operator==(const ForceField&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("byValue", o.byValue, FieldInfo{"", {}, "Strength by value of the data: points of a curve."});
    visit("byGradient", o.byGradient, FieldInfo{"", {}, "Strength by gradient magnitude."});
    visit("byLabel", o.byLabel, FieldInfo{"", {}, "Strength of structures."});
    visit("byType", o.byType, FieldInfo{"", {}, "Strength of molecular types, where their instances are dense."});
    visit("denoise", o.denoise, FieldInfo{"", {}, "The curves are over the data with its noise taken out."});
    visit("leastPiece", o.leastPiece,
          FieldInfo{"",
                    {-1, 1e9},
                    "What byValue protects counts in pieces of so many voxels or more, joined by faces; 0, 1: in all; "
                    "-1: as many as noise does not explain."});
    visit("level", o.level, FieldInfo{"", {0, 6}, "A kernel for every 2^level voxels along each axis."});
    visit("threshold", o.threshold, FieldInfo{"", {0, 1000}, "Weaker kernels are left out."});
    visit("areaOfEffect", o.areaOfEffect, FieldInfo{"", {1, 4}, "Half-width of a kernel in super-voxels."});
    visit("rule", o.rule, FieldInfo{"", {}, "Sided: along the normal, by the least cut; paper: away from the centre."});
    visit("side", o.side,
          FieldInfo{
              "", {}, "Of what can be passed by: keep it, remove it, or leave it on the nearest side (sided rule)."});
    visit("kernels", o.kernels, FieldInfo{"", {}, "Kernels put in by hand."});
    visit("strokes", o.strokes, FieldInfo{"", {}, "Strokes from which the curve was fitted."});
    visit("byValueBefore", o.byValueBefore, FieldInfo{"", {}, "The curve before the first stroke."});
  }
};

/// The strength that byType has for a type of the model; 0 where nothing in the list leads to it. @param path  the
/// type's
double strengthOf(const ForceField& field, std::string_view path);

/// The elastic sheet ([IMC] 3.1). Forces and stiffness are in units of the rest plane, so that a sheet behaves alike at
/// every size and resolution: strength 1 is an acceleration of 1/128 of the rest plane's mean edge per s^2.
struct Cloth {
  glm::ivec2 particles{50, 50};  ///< along the rest plane's width and height
  int finest = 1024;             ///< the sheet is refined at rest up to so many along an edge, where the data is finer
  double stretch = 0.3;          ///< stiffness 0..1 of the mesh edges
  double bend = 0.1;             ///< stiffness 0..1 against folding
  double restoring = 400.0;      ///< pull back to the rest plane, 1/s^2
  double damping = 12.0;         ///< 1/s
  double timeStepS = 0.02;
  int iterations = 8;  ///< of the constraints in a step
  bool operator==(const Cloth&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("particles", o.particles, FieldInfo{"", {3, 260}, "Particles along the rest plane's width and height."});
    visit("finest", o.finest, FieldInfo{"", {3, 1024}, "At rest the sheet is refined up to so many along an edge."});
    visit("stretch", o.stretch, FieldInfo{"", {0, 1}, "Stiffness against stretching."});
    visit("bend", o.bend, FieldInfo{"", {0, 1}, "Stiffness against bending."});
    visit("restoring", o.restoring, FieldInfo{"1/s^2", {0, 2000}, "Pull back to the rest plane."});
    visit("damping", o.damping, FieldInfo{"1/s", {0.1, 100}, "How fast motion dies away."});
    visit("timeStepS", o.timeStepS, FieldInfo{"s", {0.001, 0.05}, "Time of one step."});
    visit("iterations", o.iterations, FieldInfo{"", {1, 64}, "Passes over the constraints in a step."});
  }
};

/// What makes a cut a membrane: a sheet that hangs in the cut's frame. The cut's `size` are the rest plane's width and
/// height and the whole reach along its axis: the sheet stays within half of it on either side of the rest plane.
struct Membrane {
  ForceField field;
  Cloth cloth;
  Repositioning repositioning = Repositioning::Passive;
  std::vector<Pin> pins;
  MembraneUse use = MembraneUse::Clip;
  SheetLook look = SheetLook::Hidden;
  double inlayOpacity = 0.9;  ///< of an inlay's image, 0..1
  double emphasis = 0.0;      ///< -1 only what is behind the rest plane, 1 only what is in front, 0 both alike
  double falloff = 0.0;       ///< distance from the rest plane at which structures have faded; 0: the reach
  SheetShape shape;           ///< where an active sheet has come to rest; empty: it hangs flat at first
  bool operator==(const Membrane&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("field", o.field, FieldInfo{"", {}, "Forces: the potential field transfer function and its kernels."});
    visit("cloth", o.cloth, FieldInfo{"", {}, "The elastic sheet."});
    visit("repositioning", o.repositioning,
          FieldInfo{"", {}, "Passive: anew from the flat sheet; active: dragged along with the frame."});
    visit("pins", o.pins, FieldInfo{"", {}, "Particles held in place."});
    visit("use", o.use, FieldInfo{"", {}, "Clip: removes what is in front; inlay: an image and what is next to it."});
    visit("look", o.look, FieldInfo{"", {}, "How the sheet itself is shown: hidden, grid, surface."});
    visit("inlayOpacity", o.inlayOpacity, FieldInfo{"", {0, 1}, "Opacity of an inlay's image."});
    visit("emphasis", o.emphasis, FieldInfo{"", {-1, 1}, "-1: only behind the rest plane; 1: only in front; 0: both."});
    visit("falloff", o.falloff, FieldInfo{kLength, {0, 1e9}, "Distance at which structures have faded; 0: the reach."});
    visit("shape", o.shape, FieldInfo{"", {}, "Where an active sheet rests.", true});
  }
};

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::KernelRule> {
  static constexpr std::string_view kNames[] = {"sided", "paper"};
};
template <>
struct velum::EnumNames<velum::scene::MembraneSide> {
  static constexpr std::string_view kNames[] = {"keep", "remove", "nearest"};
};
template <>
struct velum::EnumNames<velum::scene::Repositioning> {
  static constexpr std::string_view kNames[] = {"passive", "active"};
};
template <>
struct velum::EnumNames<velum::scene::MembraneUse> {
  static constexpr std::string_view kNames[] = {"clip", "inlay"};
};
template <>
struct velum::EnumNames<velum::scene::SheetLook> {
  static constexpr std::string_view kNames[] = {"hidden", "grid", "surface"};
};
