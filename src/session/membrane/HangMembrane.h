#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/Fields.h"
#include "core/Task.h"
#include "scene/Cut.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// The arguments of the command that hangs a new membrane, as somebody types them: where it hangs, and what its sheet
/// leaves whole. What is left out is chosen as by newMembrane().
struct HangMembrane {
  static constexpr std::string_view kName = "membrane.hang";
  std::vector<double> values;              ///< low and high value
  std::vector<double> place;               ///< x, y, z: a place in the material that is meant, world
  std::vector<int> structures;             ///< label ids
  std::vector<std::string> types;          ///< paths of types of a model
  std::vector<std::string> sketch, avoid;  ///< strokes
  std::vector<double> axis;                ///< x, y, z: towards what is removed
  double position = -1.0, reach = 0.0;     ///< position: 0..1; reach: scene units
  std::string leastPiece;                  ///< voxels, or auto
  bool denoise = false;
  static void fields(auto& o, auto& visit) {
    visit("values", o.values, FieldInfo{"", {}, "Values from A to B are protected, in the volume's unit: A,B."});
    visit("place", o.place, FieldInfo{kLength, {}, "Material like that in a place is, world: x,y,z."});
    visit("structures", o.structures, FieldInfo{"", {0, 65535}, "Structures are, by their ids."});
    visit("types", o.types, FieldInfo{"", {}, "Types of a model are, by their paths or the ends of them."});
    visit("sketch", o.sketch, FieldInfo{"", {}, "What lies under strokes is: x,y,z:x,y,z@radius each."});
    visit("avoid", o.avoid, FieldInfo{"", {}, "Strokes over what the sheet may cut."});
    visit("axis", o.axis, FieldInfo{"", {}, "Normal of the frame, towards what is removed; nothing: to the eye."});
    visit(
        "position", o.position,
        FieldInfo{"", {-1, 1}, "Where along its axis, 0 to 1 of the data; below 0: where it keeps what it protects."});
    visit("reach", o.reach, FieldInfo{kLength, {0, 1e9}, "How far the sheet may go, both sides together; 0: enough."});
    visit("leastPiece", o.leastPiece, FieldInfo{"", {}, "What counts has so many voxels or more; auto."});
    visit("denoise", o.denoise, FieldInfo{"", {}, "On: noise is taken out before values say what is protected."});
  }
};

/// The membrane that is asked for, without an id. Some tenths of a second. Any thread. @throw ArgumentError that begins
/// with the name of the field that does not fit; Cancelled
scene::Cut hungMembrane(const scene::Scene& scene, const HangMembrane& asked, Progress& progress);

/// The size of the least piece that a text says: voxels, or -1 for "auto". @throw ArgumentError
int leastPieceOf(const std::string& text);

}  // namespace velum::session
