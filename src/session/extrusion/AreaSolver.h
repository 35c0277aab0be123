#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "render/kept/StructureHits.h"
#include "session/bar/Dial.h"

namespace velum::session {

/// What a solver of areas has come to.
struct SolvedArea : Solved {
  double distance = 0.0;  ///< how far the structure stands out of each of the cuts, scene units; 0: not at all
};

/// The ids of the cuts out of whose faces structures can stand: all that are on, but for inlays and cuts everywhere.
std::vector<int> cutsToPullFrom(const scene::Scene& scene);

/// What makes the handle of a structure's bar set an area: how far it must stand out of cuts for something of it to be
/// left on so many pixels, seen or not: the depths at which rays meet it are the thresholds of a Dial ([ACS] 3). Labels
/// are taken as they are: what grows on demand is not grown further.
///
/// To be made when a handle is taken hold of, and asked at every step of the pointer. Any thread.
class AreaSolver {
 public:
  /// @param cuts  the ids of those out of which it stands, all equally far
  /// @param hits  render::structureHits() of the scene and these cuts; of other structures, too
  AreaSolver(const scene::Scene& scene, std::vector<int> cuts, int structure,
             const std::vector<render::StructureHit>& hits);

  int structure() const { return mStructure; }
  /// Of pixels.
  CountRange range() const { return mRange; }
  /// @param wanted  pixels; rounded, and brought into the range
  SolvedArea solve(double wanted) const;

 private:
  std::string words(const Solved& solved) const;

  scene::Scene mScene;
  std::vector<int> mCuts;
  int mStructure;
  Dial mDial;  ///< its number is the distance
  CountRange mRange;
};

}  // namespace velum::session
