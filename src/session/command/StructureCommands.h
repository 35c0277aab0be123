#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/Scene.h"

/// The arguments of commands of labelled structures. Structures are named, or numbered by their ids.
namespace velum::session {

/// How commands name structures: by name where no other structure has the name, else by id.
std::vector<std::string> structureNames(const scene::Scene& scene, const std::vector<int>& ids);
/// The counterpart of structureNames(). @throw ArgumentError that says which structures there are
std::vector<int> structureIds(const scene::Scene& scene, const std::vector<std::string>& names);

inline constexpr FieldInfo kStructuresInfo{"", {}, "Their names or numbers, with commas between them."};

struct ShowStructures {
  static constexpr std::string_view kName = "structure.show";
  std::vector<std::string> structures;
  bool visible = true;
  static void fields(auto& o, auto& visit) {
    visit("structures", o.structures, kStructuresInfo);
    visit("visible", o.visible, FieldInfo{"", {}, "Off: they are hidden."});
  }
};

struct ShowLabels {
  static constexpr std::string_view kName = "structure.showLabels";
  bool visible = true;
  static void fields(auto& o, auto& visit) {
    visit("visible", o.visible, FieldInfo{"", {}, "Off: they are hidden, all structures with them."});
  }
};

struct InvertStructures {
  static constexpr std::string_view kName = "structure.invert";
  std::vector<std::string> structures;
  static void fields(auto& o, auto& visit) { visit("structures", o.structures, kStructuresInfo); }
};

struct SoloStructure {
  static constexpr std::string_view kName = "structure.solo";
  std::string structure;
  std::vector<std::string> shown;
  double unlabelled = 1.0;
  static void fields(auto& o, auto& visit) {
    visit("structure", o.structure, FieldInfo{"", {}, "Its name or number."});
    visit("shown", o.shown, FieldInfo{"", {}, "Structures that show again where it was alone; nothing: all."});
    visit("unlabelled", o.unlabelled, FieldInfo{"", {0, 1}, "Opacity that what has no label gets back then."});
  }
};

struct ColorStructures {
  static constexpr std::string_view kName = "structure.color";
  std::vector<std::string> structures;
  glm::vec3 color{1.0f};
  static void fields(auto& o, auto& visit) {
    visit("structures", o.structures, kStructuresInfo);
    visit("color", o.color, FieldInfo{"", {0, 1}, "sRGB."});
  }
};

struct SetStructureOpacity {
  static constexpr std::string_view kName = "structure.opacity";
  std::vector<std::string> structures;
  double opacity = 1.0;
  static void fields(auto& o, auto& visit) {
    visit("structures", o.structures, kStructuresInfo);
    visit("opacity", o.opacity, FieldInfo{"", {0, 1}, "A factor on a material's, or that of a solid surface."});
  }
};

struct ShowStructuresAs {
  static constexpr std::string_view kName = "structure.showAs";
  std::vector<std::string> structures;
  scene::ShowAs showAs = scene::ShowAs::Material;
  static void fields(auto& o, auto& visit) {
    visit("structures", o.structures, kStructuresInfo);
    visit("showAs", o.showAs, FieldInfo{"", {}, "By the transfer function, or as a surface of their colour."});
  }
};

struct SetStructureSphere {
  static constexpr std::string_view kName = "structure.litSphere";
  std::vector<std::string> structures;
  std::string litSphere;
  static void fields(auto& o, auto& visit) {
    visit("structures", o.structures, kStructuresInfo);
    visit("litSphere", o.litSphere, FieldInfo{"", {}, "Its name; nothing: that of the finish."});
  }
};

struct SmoothStructures {
  static constexpr std::string_view kName = "structure.smooth";
  std::vector<std::string> structures;
  double deviation = 0.0;
  static void fields(auto& o, auto& visit) {
    visit("structures", o.structures, kStructuresInfo);
    visit("deviation", o.deviation,
          FieldInfo{kLength, {0, 1e6}, "Of a Gaussian over their shapes; 0: as in the file."});
  }
};

struct RenameStructure {
  static constexpr std::string_view kName = "structure.rename";
  std::string structure, name;
  static void fields(auto& o, auto& visit) {
    visit("structure", o.structure, FieldInfo{"", {}, "Its name or number."});
    visit("name", o.name, FieldInfo{"", {}, "What it is to be called."});
  }
};

struct SpareStructures {
  static constexpr std::string_view kName = "structure.spare";
  std::vector<std::string> structures;
  bool whole = true;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("structures", o.structures, kStructuresInfo);
    visit("whole", o.whole, FieldInfo{"", {}, "Off: the cut goes through them again."});
    visit("cut", o.cut, FieldInfo{"", {}, "Name or number of the cut that spares them; nothing: the only one."});
  }
};

struct ProtectStructures {
  static constexpr std::string_view kName = "structure.protect";
  std::vector<std::string> structures;
  double strength = 0.0;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("structures", o.structures, kStructuresInfo);
    visit(
        "strength", o.strength,
        FieldInfo{"", {-1000, 1000}, "Above 0 the sheet keeps them whole, below 0 it is drawn to them; 0: no force."});
    visit("cut", o.cut, FieldInfo{"", {}, "Name or number of the membrane; nothing: the only cut."});
  }
};

}  // namespace velum::session
