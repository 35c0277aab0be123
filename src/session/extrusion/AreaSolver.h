#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "render/kept/StructureHits.h"
#include "scene/Scene.h"

namespace velum::session {

/// On how many pixels something of a structure can be left, however far it stands out of some cuts.
struct AreaRange {
  std::uint64_t least = 0, most = 0;
  std::uint64_t total = 0;  ///< whose rays meet it
  bool operator==(const AreaRange&) const = default;
};

/// What a solver of areas has come to.
struct SolvedArea {
  scene::Scene scene;     ///< with the extrusions set
  double distance = 0.0;  ///< how far it stands out of each of the cuts, scene units; 0: not at all
  std::uint64_t wanted = 0, reached = 0;
  std::string words;  ///< one short sentence for people
};

/// The ids of the cuts out of whose faces structures can stand: all that are on, but for inlays and cuts everywhere.
std::vector<int> cutsToPullFrom(const scene::Scene& scene);

/// What makes the handle of a structure's bar set an area: how far it must stand out of cuts for something of it to be
/// left on so many pixels, seen or not. As the k-th smallest share leaves k instances (RenderedSolver), the k-th
/// smallest of the depths at which rays meet it leaves it on k pixels ([ACS] 3). Labels are taken as they are: what
/// grows on demand is not grown further.
///
/// To be made when a handle is taken hold of, and asked at every step of the pointer. Any thread.
class AreaSolver {
 public:
  /// @param cuts  the ids of those out of which it stands, all equally far
  /// @param hits  render::structureHits() of the scene and these cuts; of other structures, too
  AreaSolver(const scene::Scene& scene, std::vector<int> cuts, int structure,
             const std::vector<render::StructureHit>& hits);

  int structure() const { return mStructure; }
  AreaRange range() const { return mRange; }
  /// @param wanted  pixels; rounded, and brought into the range
  SolvedArea solve(double wanted) const;

 private:
  std::string words(std::uint64_t wanted, std::uint64_t reached) const;

  scene::Scene mScene;
  std::vector<int> mCuts;
  int mStructure;
  AreaRange mRange;
  std::vector<float> mDepths;  ///< ascending, of the pixels between the least and the most
};

}  // namespace velum::session
