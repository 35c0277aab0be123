#pragma once
#include <limits>
#include <string>
#include <string_view>

#include "core/Fields.h"

namespace velum::scene {

/// What a cut leaves of a structure; of several spares of the same structure the first counts.
struct Spare {
  static constexpr std::string_view kKey = "structure";  ///< that a bare value stands for on the command line
  static constexpr double kEndless = std::numeric_limits<double>::infinity();

  int structure = 0;           ///< label id; 0: all that has no label, or everything where no labels are shown
  double distance = kEndless;  ///< how deep in the cut's removed side it is left, scene units; kEndless: all of it
  bool operator==(const Spare&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("structure", o.structure, FieldInfo{"", {0, 65535}, "Label id; 0: all that has no label."});
    visit("distance", o.distance,
          FieldInfo{kLength, {0}, "How deep in the removed side it is left; null: all of it.", false, true});
  }
};

/// What a cut leaves of the instances of a model, each of which it removes or keeps whole. An instance stays when its
/// fixed random number u is below a probability. That is `share`; with a falloff it is larger near the cut's surface,
/// or smaller beyond the surface ([VE] 3, 5; docs/PAPERS.md has the formula).
struct TypeSpare {
  static constexpr std::string_view kKey = "type";  ///< that a bare value stands for on the command line

  std::string type;    ///< path of a type, or of a compartment for all types below it; the longest that fits counts
  double share = 1.0;  ///< share of the type's instances in the removed side that stay, 0..1
  double distance = Spare::kEndless;  ///< how deep they stay, scene units; kEndless: wherever they are
  double falloff = 0.0;    ///< length from the surface over which more stay; below 0: fewer stay outside the surface
  double amount = 1.0;     ///< strength of the falloff at the surface, 0..1
  double exponent = 1.0;   ///< form of the falloff: 1 even; above 1 it lasts longer
  double viewShare = 0.0;  ///< share of those hiding the cut's focus that stay, 0..1; drawn apart from `share`
  double aperture = 1.0;   ///< how much of the view onto the focus is opened, 0 (nothing)..1 (all of it)
  bool operator==(const TypeSpare&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("type", o.type, FieldInfo{"", {}, "Path of a type, or of a compartment for all types below it."});
    visit("share", o.share, FieldInfo{"", {0, 1}, "Share of its instances that stay in what is removed."});
    visit("distance", o.distance, FieldInfo{kLength, {0}, "How deep they stay; null: wherever they are.", true, true});
    visit("falloff", o.falloff,
          FieldInfo{kLength, {-1e9, 1e9}, "Way over which more stay near the surface; below 0: fewer outside.", true});
    visit("amount", o.amount, FieldInfo{"", {0, 1}, "How far the falloff goes at the surface.", true});
    visit("exponent", o.exponent, FieldInfo{"", {0.01, 16}, "How the falloff runs; 1: evenly.", true});
    visit("viewShare", o.viewShare, FieldInfo{"", {0, 1}, "Share of those that hide the cut's focus that stay.", true});
    visit("aperture", o.aperture,
          FieldInfo{"", {0, 1}, "How much of the view onto the focus is opened; 1: all of it.", true});
  }
};

}  // namespace velum::scene
