#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/Fields.h"
#include "scene/Focus.h"
#include "scene/Ids.h"
#include "scene/Membrane.h"
#include "scene/Spare.h"

namespace velum::scene {

enum class CutShape { Plane, Box, Sphere, Cylinder, Cone, Membrane, Everywhere };
enum class CutFace { Shaded, Section };

/// Most cuts in a scene; addCut() and files keep to this limit.
constexpr std::size_t kMostCuts = 1024;

/// What a cut does with the instances of a model ([VE] 3).
struct ModelCut {
  std::vector<TypeSpare> spares;  ///< what the cut leaves of them, by their types; the longest path that fits counts
  bool wholeInstances = false;  ///< an instance is removed when all of its sphere is; else when the sphere's middle is
  double leastMass = 0.0, mostMass = Spare::kEndless;      ///< of an instance, dalton; types outside are not spared
  double leastCopies = 0.0, mostCopies = Spare::kEndless;  ///< instances of a type; types outside are not spared
  std::optional<Focus> focus;  ///< types that the cut keeps in view; none: the cut clears nothing for a view
  bool operator==(const ModelCut&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("spares", o.spares, FieldInfo{"", {}, "What this cut leaves of the instances of a model.", true});
    visit("wholeInstances", o.wholeInstances,
          FieldInfo{"", {}, "Instances are removed when all of their sphere is; else when its middle is.", true});
    visit("leastMass", o.leastMass, FieldInfo{"Da", {0}, "Lighter types are not spared.", true});
    visit("mostMass", o.mostMass,
          FieldInfo{"Da", {0}, "Heavier types are not spared; null: none is too heavy.", true, true});
    visit("leastCopies", o.leastCopies, FieldInfo{"", {0}, "Types of fewer instances are not spared.", true});
    visit("mostCopies", o.mostCopies,
          FieldInfo{"", {0}, "Types of more instances are not spared; null: none has too many.", true, true});
    visit("focus", o.focus, FieldInfo{"", {}, "Types of a model that the cut keeps in view; null: none.", true});
  }
};

/// One thing that removes material. What it removes: a plane, the side that `axis` points to; a closed shape, its
/// inside; a membrane, the side of its sheet that `axis` points to (beyond its rest plane, of the rest plane); with
/// `invert`, the other side; everywhere: the whole domain, for what it spares and what it keeps in view. A position is
/// kept when no enabled cut removes it. World frame (LPS).
struct Cut {
  int id = 0;  ///< number by which the cut is known everywhere: from 1, unique in a scene, see addCut(); 0: none yet
  std::string name;
  CutShape shape = CutShape::Plane;
  bool enabled = true;
  bool invert = false;
  bool joined = false;              ///< removes only what the cut before it in the list removes, too: a wedge
  glm::dvec3 centre{0.0};           ///< a point of the plane; middle of box, sphere, cylinder; apex of the cone
  glm::dvec3 axis{0.0, -1.0, 0.0};  ///< normal of the plane; local z of the others; the cone opens along it; any length
  double spinDeg = 0.0;             ///< turn of a box about its axis
  glm::dvec3 size{100.0};  ///< box: edges along local x, y, z; sphere: diameter x; cylinder, cone: diameter x, length
                           ///< z; membrane: its rest plane's width x, height y, and reach to both sides z
  CutFace face = CutFace::Shaded;    ///< how the cut surface looks
  double faceOpacity = 1.0;          ///< section faces: 0..1
  std::vector<Spare> spares;         ///< what this cut leaves of structures
  ModelCut model;                    ///< what the cut does with the instances of a model
  std::optional<Membrane> membrane;  ///< what a membrane is beside its rest plane; other shapes have none
  // Compiled once, in Cut.cpp: nearly every file copies some.
  Cut();
  Cut(const Cut&);
  Cut(Cut&&) noexcept;
  Cut& operator=(const Cut&);
  Cut& operator=(Cut&&) noexcept;
  ~Cut();
  bool operator==(const Cut&) const;
  static void fields(auto& o, auto& visit) {
    visit("id", o.id,
          FieldInfo{"", {0, kMostId}, "Number by which the cut is known, unique in a scene; 0: a new one."});
    visit("name", o.name, FieldInfo{"", {}, "Name for people."});
    visit("shape", o.shape, FieldInfo{"", {}, "Plane, box, sphere, cylinder, cone, membrane or everywhere."});
    visit("enabled", o.enabled, FieldInfo{"", {}, "Off: the cut removes nothing."});
    visit("invert", o.invert, FieldInfo{"", {}, "Removes the other side."});
    visit("joined", o.joined,
          FieldInfo{"", {}, "Removes only what the cut before it removes, too: two joined planes open a wedge.", true});
    visit("centre", o.centre,
          FieldInfo{kLength, {}, "A point of the plane; middle of box, sphere, cylinder; apex of the cone."});
    visit("axis", o.axis, directionInfo("Normal of the plane (towards what is removed); axis of the others."));
    visit("spinDeg", o.spinDeg, FieldInfo{"deg", {-360, 360}, "Turn of a box about its axis."});
    visit("size", o.size,
          FieldInfo{kLength,
                    {0, 1e9},
                    "Box: edges; sphere: diameter first; cylinder, cone: diameter first, length third; membrane: "
                    "width, height, reach to both sides."});
    visit("face", o.face,
          FieldInfo{"", {}, "Shaded: the cut material; section: the data's grey values, as on a section."});
    visit("faceOpacity", o.faceOpacity, FieldInfo{"", {0, 1}, "Opacity of a section face."});
    visit("spares", o.spares,
          FieldInfo{"", {}, "What this cut leaves of structures; the first of one structure counts."});
    visit("model", o.model, FieldInfo{"", {}, "What the cut does with the instances of a model.", true});
    visit("membrane", o.membrane, FieldInfo{"", {}, "The sheet of a membrane; other shapes have none.", true});
  }
};

inline bool isMembrane(const Cut& cut) { return cut.shape == CutShape::Membrane; }
/// A membrane whose use is an image with what lies next to it. Several of them add up.
inline bool isInlay(const Cut& cut) { return isMembrane(cut) && cut.membrane->use == MembraneUse::Inlay; }

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::CutShape> {
  static constexpr std::string_view kNames[] = {"plane", "box", "sphere", "cylinder", "cone", "membrane", "everywhere"};
};
template <>
struct velum::EnumNames<velum::scene::CutFace> {
  static constexpr std::string_view kNames[] = {"shaded", "section"};
};
