#pragma once
#include <string>
#include <string_view>

#include "scene/Cut.h"
#include "scene/SceneFwd.h"

/// The arguments of commands of cuts. A cut is named, or numbered by its id.
namespace velum::session {

/// As commands name it: by its name where no other has it, else by number.
std::string cutKey(const scene::Scene& scene, int id);
/// The counterpart. @param key  empty: the only cut  @throw ArgumentError that says which there are
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
