#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "scene/Membrane.h"
#include "scene/SceneFwd.h"
#include "session/command/CutCommands.h"

/// The arguments of commands of membranes: what a sheet protects, what hands put on it, where it hangs.
namespace velum::session {

inline constexpr FieldInfo kMembraneInfo{"", {}, "Name or number of the membrane; nothing: the only cut."};

struct ProtectValues {
  static constexpr std::string_view kName = "membrane.protectValues";
  double low = 0.0, high = 0.0, strength = 100.0;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("low", o.low, FieldInfo{"", {}, "From this value on, in the volume's unit."});
    visit("high", o.high, FieldInfo{"", {}, "Up to this one."});
    visit("strength", o.strength, FieldInfo{"", {-1000, 1000}, "Below 0 it draws the sheet to them."});
    visit("cut", o.cut, kMembraneInfo);
  }
};

struct ProtectAt {
  static constexpr std::string_view kName = "membrane.protectAt";
  glm::dvec3 place{0.0};
  double strength = 100.0;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("place", o.place, FieldInfo{kLength, {}, "In the material that is meant, world."});
    visit("strength", o.strength, FieldInfo{"", {-1000, 1000}, "Below 0 it draws the sheet to it; 0 lets it through."});
    visit("cut", o.cut, kMembraneInfo);
  }
};

struct PushSheet {
  static constexpr std::string_view kName = "membrane.kernel";
  glm::dvec3 centre{0.0};
  double radius = 0.0, strength = 500.0;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("centre", o.centre, FieldInfo{kLength, {}, "Middle of the ball, world."});
    visit("radius", o.radius, FieldInfo{kLength, {0, 1e6}, "Its radius; 0: a twelfth of the frame's mean edge."});
    visit("strength", o.strength,
          FieldInfo{"", {-1000, 1000}, "Above 0 it pushes the sheet away, below 0 it draws it."});
    visit("cut", o.cut, kMembraneInfo);
  }
};

struct PinSheet {
  static constexpr std::string_view kName = "membrane.pin";
  glm::dvec3 place{0.0};
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("place", o.place,
          FieldInfo{kLength, {}, "Where the sheet is held: its point there when it hangs flat, world."});
    visit("cut", o.cut, kMembraneInfo);
  }
};

struct ChooseRule {
  static constexpr std::string_view kName = "membrane.rule";
  scene::KernelRule rule = scene::KernelRule::Sided;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("rule", o.rule, FieldInfo{"", {}, "Along the frame's normal by the least cut, or the paper's."});
    visit("cut", o.cut, kMembraneInfo);
  }
};

struct MoveToKeep {
  static constexpr std::string_view kName = "membrane.moveToKeep";
  bool keepsReach = false;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("keepsReach", o.keepsReach, FieldInfo{"", {}, "On: only the place is looked for."});
    visit("cut", o.cut, kMembraneInfo);
  }
};

}  // namespace velum::session
