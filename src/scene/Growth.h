#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "core/Fields.h"

namespace velum::scene {

/// A stroke that growing does not enter.
struct Barrier {
  std::vector<glm::dvec3> path;
  double radius = 3.0;
  bool operator==(const Barrier&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("path", o.path, FieldInfo{kLength, {}, "Points along the stroke."});
    visit("radius", o.radius, FieldInfo{kLength, {0, 1e9}, "Half its width."});
  }
};

/// A step by which a structure has grown out of the volume on demand ([ACS] 4.2). The steps of a scene, one after the
/// other, make its grown labels, voxel by voxel the same however a drag was cut into pieces: files hold the steps.
///
/// A step begins at its seeds and at what the structure has already, and takes all voxels that are joined to them by
/// faces through voxels with values of its range that no structure owns and that lie in the removed side of the plane,
/// no deeper than `distance` ([ACS] Prop. 1 and 3). Where places in `others` are said not to be of the structure, each
/// of those voxels goes to the kind of seed (own or other) from which the cheapest path leads to it, by steps of value.
/// At the end of the step the grown structure may be smoothed.
struct Growth {
  static constexpr double kEndless = std::numeric_limits<double>::infinity();

  int structure = 0;               ///< label id of the structure that grows
  std::vector<glm::dvec3> seeds;   ///< places in voxels that were clicked on
  std::vector<glm::dvec3> others;  ///< places in voxels that are said not to be of the structure
  double low = 0.0, high = 0.0;    ///< values that belong to the structure, the volume's unit, both ends included
  double steepest = kEndless;      ///< gradient magnitude at which growing stops, value/length
  int within = 0;                  ///< structure from which voxels are taken; 0: from unlabelled voxels
  int channel = 0, timeStep = 0;   ///< of the volume, where was clicked; carried to other time steps
  glm::dvec3 centre{0.0};          ///< a point of the plane out of which the structure is pulled
  glm::dvec3 axis{0.0};            ///< towards the plane's removed side; zero: it grows everywhere
  double distance = kEndless;      ///< how deep in the removed side the structure goes
  std::vector<Barrier> barriers;   ///< strokes that growing does not enter
  double closing = 0.0;    ///< radius of the closing after growing: gaps too small for such balls are filled; 0: none
  bool fillHoles = false;  ///< holes that the structure encloses become part of it
  bool operator==(const Growth&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("structure", o.structure, FieldInfo{"", {1, 65535}, "Label that it grows."});
    visit("seeds", o.seeds, FieldInfo{kLength, {}, "Places that were clicked on."});
    visit("others", o.others,
          FieldInfo{kLength, {}, "Places that are not of it: what is nearer to one of them by values is left out."});
    visit("low", o.low, FieldInfo{"", {}, "Smallest value that belongs to it, the volume's unit."});
    visit("high", o.high, FieldInfo{"", {}, "Largest value that belongs to it."});
    visit("steepest", o.steepest,
          FieldInfo{"", {0}, "Gradient magnitude, value per length, at which it stops; null: at none.", false, true});
    visit("within", o.within,
          FieldInfo{"", {0, 65535}, "Structure of which it takes a connected part; 0: of what has no label."});
    visit("channel", o.channel, FieldInfo{"", {0, 1e9}, "Channel whose values are meant."});
    visit("timeStep", o.timeStep,
          FieldInfo{"", {0, 1e9}, "Time step whose values are meant; it is carried to others."});
    visit("centre", o.centre, FieldInfo{kLength, {}, "A point of the plane out of which it is pulled."});
    visit("axis", o.axis, FieldInfo{"", {}, "Towards the plane's removed side; 0 0 0: it grows everywhere."});
    visit("distance", o.distance,
          FieldInfo{kLength, {0}, "How deep in the removed side it grows; null: all of it.", false, true});
    visit("barriers", o.barriers, FieldInfo{"", {}, "Strokes that it does not enter."});
    visit(
        "closing", o.closing,
        FieldInfo{kLength, {0, 1e9}, "Radius of balls that find no way into it when it has grown; 0: none are tried."});
    visit("fillHoles", o.fillHoles, FieldInfo{"", {}, "What it encloses becomes part of it."});
  }
};

}  // namespace velum::scene
