#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/Fields.h"
#include "scene/Mark.h"

/// The arguments of commands of marks: measures, arrows and labels that are bound to places of the world. Their fields
/// are set as any other: set lettering.marks[#1].visible false.
namespace velum::session {

inline constexpr FieldInfo kMarksInfo{"",    {},    "Their ids, with commas between them: 1,2 or #1.",
                                      false, false, scene::kMostMarks};

struct AddMark {
  static constexpr std::string_view kName = "mark.add";
  scene::MarkKind kind = scene::MarkKind::Label;
  std::vector<glm::dvec3> points;
  std::string text, structure, type;
  bool alongSurface = false;
  std::vector<int> pointInstances;
  std::vector<std::string> pointStructures;
  glm::dvec3 normal = scene::Mark().normal;
  static void fields(auto& o, auto& visit) {
    visit("kind", o.kind, FieldInfo{"", {}, "What it is; how many points it has follows."});
    visit(
        "points", o.points,
        FieldInfo{kLength, {}, "Places in the world: x,y,z;x,y,z;... or JSON.", false, false, scene::kMostMarkPoints});
    visit("text", o.text, FieldInfo{"", {}, "Words of a label; of others in place of the name or before the value."});
    visit("structure", o.structure,
          FieldInfo{"", {}, "Name or number of what a name or a region is of, or a label points at; nothing: none."});
    visit("type", o.type,
          FieldInfo{"", {}, "Path of the type or compartment that a name is of, or a label points at; nothing: none."});
    visit("alongSurface", o.alongSurface,
          FieldInfo{"", {}, "On: a way is measured along the surface that is seen, not through the air."});
    visit("pointInstances", o.pointInstances,
          FieldInfo{"",
                    {-1, 2e9},
                    "Numbers of the model's instances that its points follow, in their order; -1: none. Points that "
                    "follow something need no place.",
                    false,
                    false,
                    scene::kMostMarkPoints});
    visit("pointStructures", o.pointStructures,
          FieldInfo{"",
                    {},
                    "Names or numbers of the structures that its points follow, in their order; 0: none.",
                    false,
                    false,
                    scene::kMostMarkPoints});
    visit("normal", o.normal, directionInfo("Of the plane of a circle; 0,0,0: it is a ball."));
  }
};

struct RemoveMarks {
  static constexpr std::string_view kName = "mark.remove";
  std::vector<std::string> marks;
  static void fields(auto& o, auto& visit) { visit("marks", o.marks, kMarksInfo); }
};

struct FollowMarks {
  static constexpr std::string_view kName = "mark.follow";
  std::vector<std::string> marks;
  bool follow = true;
  static void fields(auto& o, auto& visit) {
    visit("marks", o.marks, kMarksInfo);
    visit("follow", o.follow, FieldInfo{"", {}, "Off: their points stay where they are now."});
  }
};

struct DuplicateMarks {
  static constexpr std::string_view kName = "mark.duplicate";
  std::vector<std::string> marks;
  static void fields(auto& o, auto& visit) { visit("marks", o.marks, kMarksInfo); }
};

struct ShowMarks {
  static constexpr std::string_view kName = "mark.show";
  std::vector<std::string> marks;
  bool visible = true;
  static void fields(auto& o, auto& visit) {
    visit("marks", o.marks, kMarksInfo);
    visit("visible", o.visible, FieldInfo{"", {}, "Off: they are hidden, but still measured."});
  }
};

struct ChooseLetteringStyle {
  static constexpr std::string_view kName = "lettering.style";
  std::string style;
  static void fields(auto& o, auto& visit) {
    visit("style", o.style, FieldInfo{"", {}, "screen, journal, atlas, blackboard or poster."});
  }
};

}  // namespace velum::session
