#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/Fields.h"
#include "core/Task.h"
#include "scene/Growth.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// The arguments of the command that grows a structure out of the volume, as somebody types them.
struct GrowStructure {
  static constexpr std::string_view kName = "growth.grow";
  static constexpr std::pair<std::string_view, std::string_view> kRenamed{"seeds", "seed"};  ///< see Command::renamed
  std::vector<glm::dvec3> seeds, others;           ///< places on the structure; places that do not belong to it
  std::vector<std::string> strokes, otherStrokes;  ///< lines over the structure; lines over what is not of it
  std::vector<double> range, plane;                ///< low and high value; normal and n.p
  double distance = scene::Growth::kEndless, steepest = scene::Growth::kEndless, closing = 0.0;
  int within = 0;
  bool fillHoles = false, guard = false;
  std::string name;
  static void fields(auto& o, auto& visit) {
    visit("seed", o.seeds,
          FieldInfo{kLength, {}, "A place on the structure, or several, world: x,y,z or [[x,y,z],...]."});
    visit("range", o.range,
          FieldInfo{"", {}, "Values that belong to it: A,B; nothing: the material at the first seed."});
    visit("strokes", o.strokes, FieldInfo{"", {}, "Lines over it, x,y,z;x,y,z;... each: all that has its values."});
    visit("others", o.others, FieldInfo{kLength, {}, "Places that are not of it, where it leaks."});
    visit("otherStrokes", o.otherStrokes, FieldInfo{"", {}, "The same for lines."});
    visit("plane", o.plane, FieldInfo{"", {}, "It grows where n.p > d only: nx,ny,nz,d."});
    visit("distance", o.distance, FieldInfo{kLength, {0}, "No deeper than so much away from the plane.", false, true});
    visit("steepest", o.steepest, FieldInfo{"", {0}, "It stops where the gradient is as large.", false, true});
    visit("closing", o.closing, FieldInfo{kLength, {0, 1e9}, "Gaps that no ball of this radius gets into are closed."});
    visit("within", o.within,
          FieldInfo{"", {0, 65535}, "A part of the structure with this label; 0: of what has none."});
    visit("fillHoles", o.fillHoles, FieldInfo{"", {}, "On: what it encloses becomes part of it."});
    visit("guard", o.guard, FieldInfo{"", {}, "On: it stops before it leaks into what it touches."});
    visit("name", o.name, FieldInfo{"", {}, "Of the structure; nothing: Region with a number."});
  }
};

/// The step of growth that is asked for, for a structure whose id is free. Any thread.
/// @throw ArgumentError that begins with the name of the field that does not fit; InputError without a volume, or where
/// a brick of it cannot be read
scene::Growth stepOf(const scene::Scene& scene, const GrowStructure& asked);
/// Adds a step of growth to the scene, and a row for its structure.
void addGrowth(scene::Scene& scene, const scene::Growth& step, const std::string& name);

}  // namespace velum::session
