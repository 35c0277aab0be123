#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/ModelLayer.h"
#include "scene/SceneFwd.h"
#include "session/model/ModelEdit.h"

/// The arguments of commands of the types of a model. Types and compartments are named by their paths.
namespace velum::session {

/// How commands name types: by their paths.
std::vector<std::string> typeNames(const scene::Scene& scene, const TypeNumbers& types);
/// The counterpart of typeNames(); a compartment stands for all types in it. @throw ArgumentError that says which type
/// was likely meant
TypeNumbers typeNumbers(const scene::Scene& scene, const std::vector<std::string>& names);

/// How the name of a step calls rows of a list of types and compartments: "capsid", "all types", "3 rows".
std::string rowsLabel(const scene::Scene& scene, const std::vector<std::string>& paths);

inline constexpr FieldInfo kTypesInfo{"", {}, "Paths of types or compartments, with commas between them."};

struct ShowTypes {
  static constexpr std::string_view kName = "model.show";
  std::vector<std::string> types;
  bool visible = true;
  static void fields(auto& o, auto& visit) {
    visit("types", o.types, kTypesInfo);
    visit("visible", o.visible, FieldInfo{"", {}, "Off: they are hidden."});
  }
};

struct ShowModel {
  static constexpr std::string_view kName = "model.showModel";
  bool visible = true;
  static void fields(auto& o, auto& visit) {
    visit("visible", o.visible, FieldInfo{"", {}, "Off: it is hidden, all types with it."});
  }
};

struct BringToSize {
  static constexpr std::string_view kName = "model.bringToSize";
  static void fields(auto&, auto&) {}
};

struct ColorTypes {
  static constexpr std::string_view kName = "model.color";
  std::vector<std::string> types;
  glm::vec3 color{1.0f};
  static void fields(auto& o, auto& visit) {
    visit("types", o.types, kTypesInfo);
    visit("color", o.color, FieldInfo{"", {0, 1}, "sRGB."});
  }
};

struct TakePaletteColor {
  static constexpr std::string_view kName = "model.paletteColor";
  std::vector<std::string> types;
  static void fields(auto& o, auto& visit) { visit("types", o.types, kTypesInfo); }
};

struct ResetTypes {
  static constexpr std::string_view kName = "model.reset";
  std::vector<std::string> types;
  static void fields(auto& o, auto& visit) { visit("types", o.types, kTypesInfo); }
};

struct SoloTypes {
  static constexpr std::string_view kName = "model.solo";
  std::vector<std::string> types, shown;
  static void fields(auto& o, auto& visit) {
    visit("types", o.types, kTypesInfo);
    visit("shown", o.shown, FieldInfo{"", {}, "Types that show again where they were alone; nothing: all."});
  }
};

struct SetTypeGhosts {
  static constexpr std::string_view kName = "model.ghosts";
  std::vector<std::string> types;
  scene::Ghosts ghosts = scene::Ghosts::None;
  bool asModel = false;
  static void fields(auto& o, auto& visit) {
    visit("types", o.types, kTypesInfo);
    visit("ghosts", o.ghosts, FieldInfo{"", {}, "How instances show that cuts have removed."});
    visit("asModel", o.asModel, FieldInfo{"", {}, "On: as the whole model's do."});
  }
};

struct ProtectTypes {
  static constexpr std::string_view kName = "model.protect";
  std::vector<std::string> types;
  double strength = 100.0;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("types", o.types, kTypesInfo);
    visit("strength", o.strength, FieldInfo{"", {-1000, 1000}, "Below 0 it draws the sheet to them; 0 ends it."});
    visit("cut", o.cut, FieldInfo{"", {}, "Name or number of the membrane; nothing: the only cut."});
  }
};

struct SetTypeTarget {
  static constexpr std::string_view kName = "model.target";
  std::string type;
  std::string visible;
  bool isAny = false;
  static void fields(auto& o, auto& visit) {
    visit("type", o.type, FieldInfo{"", {}, "Path of a type or compartment."});
    visit("visible", o.visible,
          FieldInfo{"", {}, "So many of its instances are to be seen: 400, or a share such as 20%."});
    visit("isAny", o.isAny, FieldInfo{"", {}, "On: any number will do again."});
  }
};

struct MeetTargets {
  static constexpr std::string_view kName = "model.meetTargets";
  std::string size = "1280x960";
  static void fields(auto& o, auto& visit) {
    visit("size", o.size, FieldInfo{"", {}, "Of the pictures in which instances are counted, WIDTHxHEIGHT in pixels."});
  }
};

struct LetSee {
  static constexpr std::string_view kName = "model.letSee";
  std::string type;
  std::string visible;
  std::vector<std::string> cuts;
  std::string size = "1280x960";
  static void fields(auto& o, auto& visit) {
    visit("type", o.type, FieldInfo{"", {}, "Path of a type or compartment."});
    visit("visible", o.visible,
          FieldInfo{"", {}, "So many of its instances are to be seen: 400, or a share such as 20%."});
    visit("cuts", o.cuts, FieldInfo{"", {}, "Cuts that leave more or fewer; nothing: all that are on."});
    visit("size", o.size, FieldInfo{"", {}, "Of the pictures in which instances are counted, WIDTHxHEIGHT in pixels."});
  }
};

struct SetDrawn {
  static constexpr std::string_view kName = "model.setDrawn";
  std::string type, drawn;
  std::vector<std::string> cuts;
  static void fields(auto& o, auto& visit) {
    visit("type", o.type, FieldInfo{"", {}, "Path of a type or compartment."});
    visit("drawn", o.drawn, FieldInfo{"", {}, "Cuts leave so many of its instances: 400, or a share such as 20%."});
    visit("cuts", o.cuts, FieldInfo{"", {}, "Cuts that leave more or fewer; nothing: all that are on."});
  }
};

struct LetFollow {
  static constexpr std::string_view kName = "model.letFollow";
  std::vector<std::string> types;
  static void fields(auto& o, auto& visit) { visit("types", o.types, kTypesInfo); }
};

struct LeaveTypes {
  static constexpr std::string_view kName = "model.leave";
  std::vector<std::string> types;
  double share = 1.0;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("types", o.types, kTypesInfo);
    visit("share", o.share, FieldInfo{"", {0, 1}, "Of their instances a cut leaves so much."});
    visit("cut", o.cut, FieldInfo{"", {}, "Name or number of the cut; nothing: the only one."});
  }
};

/// Sets any of the fields that scene::TypeSpare has beside its type.
struct LeaveTypesBy {
  static constexpr std::string_view kName = "model.leaveBy";
  std::vector<std::string> types;
  std::string field, value;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("types", o.types, kTypesInfo);
    visit("field", o.field,
          FieldInfo{"", {}, "Of `cuts.N.model.spares.N`: share, falloff, amount, exponent, aperture."});
    visit("value", o.value, FieldInfo{"", {}, "What it is to be."});
    visit("cut", o.cut, FieldInfo{"", {}, "Name or number of the cut; nothing: the only one."});
  }
};

struct LeaveAsAbove {
  static constexpr std::string_view kName = "model.leaveAsAbove";
  std::vector<std::string> types;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("types", o.types, kTypesInfo);
    visit("cut", o.cut, FieldInfo{"", {}, "Name or number of the cut; nothing: the only one."});
  }
};

struct ShowUncut {
  static constexpr std::string_view kName = "model.showUncut";
  static void fields(auto&, auto&) {}
};

struct ShowUnthinned {
  static constexpr std::string_view kName = "model.showUnthinned";
  static void fields(auto&, auto&) {}
};

struct KeepInView {
  static constexpr std::string_view kName = "model.keepInView";
  std::string type;
  bool kept = true;
  static void fields(auto& o, auto& visit) {
    visit("type", o.type, FieldInfo{"", {}, "Path of a type or compartment."});
    visit("kept", o.kept, FieldInfo{"", {}, "Off: it may be hidden again."});
  }
};

}  // namespace velum::session
