#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "session/command/StructureCommands.h"

/// The arguments of commands of extrusions: structures that stand out of cuts.
namespace velum::session {

struct PullStructure {
  static constexpr std::string_view kName = "extrusion.pull";
  std::string structure;
  double distance = 0.0;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("structure", o.structure, FieldInfo{"", {}, "Name or number of what is pulled."});
    visit("distance", o.distance, FieldInfo{kLength, {0, 1e6}, "How far out of the cut's face; 0 puts it back."});
    visit("cut", o.cut, FieldInfo{"", {}, "Name or number of the cut it is pulled out of; nothing: the only one."});
  }
};

struct PutBack {
  static constexpr std::string_view kName = "extrusion.putBack";
  std::vector<std::string> structures;
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("structures", o.structures, kStructuresInfo);
    visit("cut", o.cut, FieldInfo{"", {}, "Name or number of the cut they stand out of; nothing: all of them."});
  }
};

struct PutAllBack {
  static constexpr std::string_view kName = "extrusion.putAllBack";
  static void fields(auto&, auto&) {}
};

struct AddJoinedPlane {
  static constexpr std::string_view kName = "extrusion.addPlane";
  std::string cut;
  static void fields(auto& o, auto& visit) {
    visit("cut", o.cut, FieldInfo{"", {}, "Name or number of the plane it is joined to; nothing: the only one."});
  }
};

}  // namespace velum::session
