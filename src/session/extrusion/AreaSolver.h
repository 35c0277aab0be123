#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "render/kept/StructureHits.h"
#include "session/bar/Dial.h"

namespace velum::session {

/// What a solver of areas has found.
struct SolvedArea : Solved {
  double distance = 0.0;  ///< how far the structure stands out of each of the cuts, scene units; 0: it does not stand
                          ///< out
};

/// The ids of the cuts out of whose faces structures can stand: all cuts that are on, except inlays and cuts
/// everywhere.
std::vector<int> cutsToPullFrom(const scene::Scene& scene);

/// Lets the handle of a structure's bar set an area: finds how far the structure must stand out of some cuts for a part
/// of it to be left on so many pixels, whether or not other things hide it there. The depths at which rays meet the
/// structure are the thresholds of a Dial ([ACS] 3). Labels are taken as they are: regions that grow on demand are not
/// grown further.
///
/// To be made when a handle is taken hold of, and asked at every step of the pointer. Any thread.
class AreaSolver {
 public:
  /// @param cuts  ids of the cuts out of which the structure stands, out of all equally far
  /// @param hits  render::structureHits() of the scene and these cuts; hits of other structures may be among them
  AreaSolver(const scene::Scene& scene, std::vector<int> cuts, int structure,
             const std::vector<render::StructureHit>& hits);

  int structure() const { return mStructure; }
  /// On how many pixels the structure can be left.
  CountRange range() const { return mRange; }
  /// @param wanted  pixels; rounded, and brought into the range
  SolvedArea solve(double wanted) const;

 private:
  std::string words(const Solved& solved) const;

  scene::Scene mScene;
  std::vector<int> mCuts;
  int mStructure;
  Dial mDial;  ///< whose number is the distance
  CountRange mRange;
};

}  // namespace velum::session
