#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/Fields.h"
#include "scene/Ids.h"

namespace velum::scene {

/// Most marks in a scene, and most points of one; addMark() and files keep to these limits.
constexpr std::size_t kMostMarks = 1000, kMostMarkPoints = 1000;

/// What a mark is, and what its points are, in their order.
/// Distance: from the first point to the second. Angle: at the second of three. Path: how long the way along all points
/// is. Area: of the polygon of all points. Arrow: from its end to its head. Label: words beside a point. Name: the name
/// of a structure or of a type of the model, beside it; with no point where it is seen best. Circle: values in a
/// circle, or in a ball where it has no normal (its middle and a point of its rim). Box: values in a box along the
/// volume's axes (two corners). Region: values, volume and surface of a structure; no points. Profile: values along a
/// line.
enum class MarkKind { Distance, Angle, Path, Area, Arrow, Label, Name, Circle, Box, Region, Profile };

/// How few and how many points a mark of a kind has.
struct MarkPoints {
  std::size_t least, most;
};
constexpr MarkPoints markPoints(MarkKind kind) {
  switch (kind) {
    case MarkKind::Angle:
      return {3, 3};
    case MarkKind::Path:
      return {2, kMostMarkPoints};
    case MarkKind::Area:
      return {3, kMostMarkPoints};
    case MarkKind::Label:
      return {1, 1};
    case MarkKind::Name:
      return {0, 1};
    case MarkKind::Region:
      return {0, 0};
    default:
      return {2, 2};
  }
}

/// Something written on the picture that is bound to places in the world: a measure, an arrow, words with a leader.
struct Mark {
  int id = 0;  ///< number by which the mark is known: from 1, unique in a scene, see addMark(); 0: none yet
  MarkKind kind = MarkKind::Distance;
  std::vector<glm::dvec3> points;  ///< world, scene units; how many: markPoints()
  bool alongSurface = false;       ///< Distance, Path: along the surface that is seen, not through the air
  glm::dvec3 normal{0.0};          ///< Circle: of its plane, world, any length; 0: it is a ball
  int structure = 0;               ///< Name, Region: id of the structure; Label: of that it belongs to; 0: none
  std::string type;                ///< Name, Label: the same, path of a type or compartment of the model; empty: none
  // What each point follows, in their order; lists may be shorter. A point that follows something is its middle.
  std::vector<int> pointInstances;   ///< numbers of the model's instances; -1: none
  std::vector<int> pointStructures;  ///< ids of structures; 0: none
  std::string text;  ///< UTF-8: of a Label its words, of others what stands in place of the name, or before the value
  std::optional<glm::dvec2> wordsAt;  ///< middle of the words from the place that they belong to, shares of the
                                      ///< picture's height, x to the right, y down; none: they find their own place
  int timeStep = -1;                  ///< at which it is seen; -1: at each
  bool visible = true;
  std::optional<glm::vec3> color;  ///< sRGB; none: as other lettering
  double opacity = 1.0;            ///< 0..1
  bool operator==(const Mark&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("id", o.id,
          FieldInfo{"", {0, kMostId}, "Number by which the mark is known, unique in a scene; 0: a new one."});
    visit("kind", o.kind, FieldInfo{"", {}, "What it is, and what its points are."});
    visit("points", o.points,
          FieldInfo{kLength, {}, "Places in the world to which it is bound.", false, false, kMostMarkPoints});
    visit("alongSurface", o.alongSurface,
          FieldInfo{"", {}, "On: a way is measured along the surface that is seen, not through the air.", true});
    visit("normal", o.normal, directionInfo("Of the plane of a circle; 0,0,0: it is a ball.", true));
    visit("structure", o.structure,
          FieldInfo{"", {0, 1e9}, "Id of the structure that it names, measures or points at; 0: none.", true});
    visit("type", o.type,
          FieldInfo{"", {}, "Path of the model's type or compartment that it names or points at.", true});
    visit("pointInstances", o.pointInstances,
          FieldInfo{"",
                    {-1, 2e9},
                    "Numbers of the model's instances whose middles its points are, in their order; -1: none.",
                    true,
                    false,
                    kMostMarkPoints});
    visit("pointStructures", o.pointStructures,
          FieldInfo{"",
                    {0, 1e9},
                    "Ids of the structures whose middles its points are, in their order; 0: none.",
                    true,
                    false,
                    kMostMarkPoints});
    visit("text", o.text,
          FieldInfo{"", {}, "Words of a label; of others what stands for the name, or before the value.", true});
    visit("wordsAt", o.wordsAt,
          FieldInfo{"",
                    {-100, 100},
                    "Middle of the words from the place that they belong to, in shares of the picture's height; null: "
                    "they find their own place.",
                    true});
    visit("timeStep", o.timeStep, FieldInfo{"", {-1, 1e9}, "Time step at which it is seen; -1: at each.", true});
    visit("visible", o.visible, FieldInfo{"", {}, "Off: it is not drawn, but still measured."});
    visit("color", o.color, FieldInfo{"", {0, 1}, "sRGB colour; null: as other lettering.", true});
    visit("opacity", o.opacity, FieldInfo{"", {0, 1}, "Opacity.", true});
  }
};

/// Appends a mark under a new id, whatever id it had. @return the new id
/// @throw ArgumentError where there are kMostMarks, or it has too few or too many points for its kind
int addMark(std::vector<Mark>& marks, Mark mark);

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::MarkKind> {
  static constexpr std::string_view kNames[] = {"distance", "angle",  "path", "area",   "arrow",  "label",
                                                "name",     "circle", "box",  "region", "profile"};
};
