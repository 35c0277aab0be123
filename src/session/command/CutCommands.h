#pragma once
#include <string>
#include <string_view>

#include "core/Fields.h"
#include "scene/Cut.h"
#include "scene/SceneFwd.h"

/// The arguments of commands of cuts. A cut is named, or numbered by its id.
namespace velum::session {

/// How commands name a cut: by its name where no other cut has the name, else by its id.
std::string cutKey(const scene::Scene& scene, int id);
/// The counterpart of cutKey(). @param key  empty: the only cut  @throw ArgumentError that says which cuts there are
scene::Cut& cutOf(scene::Scene& scene, const std::string& key);
const scene::Cut& cutOf(const scene::Scene& scene, const std::string& key);

inline constexpr FieldInfo kCutInfo{"", {}, "Its name or number; nothing: the only one."};

struct AddCut {
  static constexpr std::string_view kName = "cut.add";
  scene::CutShape shape = scene::CutShape::Plane;
  std::string name;
  static void fields(auto& o, auto& visit) {
    visit("shape", o.shape,
          FieldInfo{"", {}, "Of a membrane the place is looked for where it keeps what it protects."});
    visit("name", o.name, FieldInfo{"", {}, "Nothing: its shape with a number."});
  }
};

struct CutAlongView {
  static constexpr std::string_view kName = "cut.alongView";
  static void fields(auto&, auto&) {}
};

struct RemoveCut {
  static constexpr std::string_view kName = "cut.remove";
  std::string cut;
  static void fields(auto& o, auto& visit) { visit("cut", o.cut, kCutInfo); }
};

struct DuplicateCut {
  static constexpr std::string_view kName = "cut.duplicate";
  std::string cut;
  static void fields(auto& o, auto& visit) { visit("cut", o.cut, kCutInfo); }
};

struct FlipCut {
  static constexpr std::string_view kName = "cut.flip";
  std::string cut;
  static void fields(auto& o, auto& visit) { visit("cut", o.cut, kCutInfo); }
};

struct EnableCut {
  static constexpr std::string_view kName = "cut.enable";
  std::string cut;
  bool enabled = true;
  static void fields(auto& o, auto& visit) {
    visit("cut", o.cut, kCutInfo);
    visit("enabled", o.enabled, FieldInfo{"", {}, "Off: it takes nothing away."});
  }
};

struct RenameCut {
  static constexpr std::string_view kName = "cut.rename";
  std::string cut, name;
  static void fields(auto& o, auto& visit) {
    visit("cut", o.cut, kCutInfo);
    visit("name", o.name, FieldInfo{"", {}, "What it is to be called."});
  }
};

struct PlaceCut {
  static constexpr std::string_view kName = "cut.place";
  glm::dvec3 centre{0.0}, axis{0.0, -1.0, 0.0}, size{100.0};
  double spinDeg = 0.0;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("centre", o.centre,
          FieldInfo{kLength, {}, "A point of the plane; middle of other shapes, apex of the cone."});
    visit("axis", o.axis, FieldInfo{"", {}, "Normal of the plane, axis of the others."});
    visit("size", o.size, FieldInfo{kLength, {0, 1e9}, "Edges; diameter first and length third of round shapes."});
    visit("spinDeg", o.spinDeg, FieldInfo{"deg", {-360, 360}, "Turn of a box about its axis."});
    visit("cut", o.cut, kCutInfo);
  }
};
/// The command that puts a cut where it is now. @param key  of the cut, see cutKey()
PlaceCut placeOf(const scene::Cut& cut, const std::string& key);

struct MoveCutInList {
  static constexpr std::string_view kName = "cut.moveInList";
  std::string cut;
  int by = 1;
  static void fields(auto& o, auto& visit) {
    visit("cut", o.cut, kCutInfo);
    visit("by", o.by, FieldInfo{"", {-64, 64}, "Rows down; below 0 it goes up."});
  }
};

}  // namespace velum::session
