#pragma once
#include <limits>
#include <string_view>

#include "velum/core/Fields.h"

namespace velum::scene {

/// What a cut leaves of a structure: of several of one structure the first counts.
struct Spare {
  static constexpr std::string_view kKey = "structure";  ///< that a bare value stands for on the command line
  static constexpr double kEndless = std::numeric_limits<double>::infinity();

  int structure = 0;           ///< label id; 0: all that has no label, or everything where no labels are shown
  double distance = kEndless;  ///< how deep in the removed side of the cut it is left, scene units; kEndless: all of it
  double share = 1.0;          ///< of its instances that are left, 0..1; material of a volume is left unless it is 0
  bool operator==(const Spare&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("structure", o.structure, FieldInfo{"", {0, 65535}, "Label id; 0: all that has no label."});
    visit("distance", o.distance,
          FieldInfo{kLength, {0}, "How deep in the removed side it is left; null: all of it.", false, true});
    visit("share", o.share, FieldInfo{"", {0, 1}, "Share of its instances that are left."});
  }
};

}  // namespace velum::scene
