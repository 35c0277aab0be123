#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/Fields.h"

/// The arguments of commands of growing: structures that are pulled where nothing is labelled, and how their growth is
/// corrected.
namespace velum::session {

inline constexpr FieldInfo kGrownInfo{"", {}, "Name or number of a structure that was grown."};

struct PullAt {
  static constexpr std::string_view kName = "growth.pullAt";
  glm::dvec3 place{0.0};
  double distance = 0.0;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("place", o.place, FieldInfo{kLength, {}, "On the cut's face: where a hand would press, world."});
    visit("distance", o.distance, FieldInfo{kLength, {0, 1e6}, "How far out of the cut's face."});
    visit("cut", o.cut, FieldInfo{"", {}, "Name or number of the cut it is pulled out of; nothing: the only one."});
  }
};

struct AddSeed {
  static constexpr std::string_view kName = "growth.addSeed";
  std::string structure;
  glm::dvec3 place{0.0};
  std::vector<glm::dvec3> more;
  static void fields(auto& o, auto& visit) {
    visit("structure", o.structure, kGrownInfo);
    visit("place", o.place, FieldInfo{kLength, {}, "From where it goes on, world."});
    visit("more", o.more, FieldInfo{kLength, {}, "More such places: of a stroke."});
  }
};

struct NotThis {
  static constexpr std::string_view kName = "growth.notThis";
  std::string structure;
  glm::dvec3 place{0.0};
  std::vector<glm::dvec3> more;
  static void fields(auto& o, auto& visit) {
    visit("structure", o.structure, kGrownInfo);
    visit("place", o.place, FieldInfo{kLength, {}, "In what it has leaked into, world."});
    visit("more", o.more, FieldInfo{kLength, {}, "More such places: of a stroke."});
  }
};

struct GrowOn {
  static constexpr std::string_view kName = "growth.growOn";
  std::string structure;
  static void fields(auto& o, auto& visit) { visit("structure", o.structure, kGrownInfo); }
};

struct StopGrowing {
  static constexpr std::string_view kName = "growth.stop";
  static void fields(auto&, auto&) {}
};

struct DrawBarrier {
  static constexpr std::string_view kName = "growth.barrier";
  std::string structure;
  std::vector<glm::dvec3> path;
  double radius = 3.0;
  static void fields(auto& o, auto& visit) {
    visit("structure", o.structure, kGrownInfo);
    visit("path", o.path, FieldInfo{kLength, {}, "Points along the stroke, world."});
    visit("radius", o.radius, FieldInfo{kLength, {0, 1e9}, "Half its width."});
  }
};

/// Changes any of the fields by which scene::Growth says how a structure grows.
struct ChangeGrowth {
  static constexpr std::string_view kName = "growth.change";
  std::string structure, field, value;
  static void fields(auto& o, auto& visit) {
    visit("structure", o.structure, kGrownInfo);
    visit("field", o.field, FieldInfo{"", {}, "Of `growths.N`: low, high, steepest, closing, fillHoles."});
    visit("value", o.value, FieldInfo{"", {}, "What it is to be."});
  }
};

struct ForgetGrown {
  static constexpr std::string_view kName = "growth.forget";
  std::string structure;
  static void fields(auto& o, auto& visit) { visit("structure", o.structure, kGrownInfo); }
};

}  // namespace velum::session
