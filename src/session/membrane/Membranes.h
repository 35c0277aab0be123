#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/Mesh.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "membrane/forces/KeptWhole.h"
#include "membrane/forces/Limit.h"
#include "scene/Scene.h"
#include "session/membrane/Advice.h"

namespace velum::session {

/// What became of one membrane.
struct MembraneReport {
  int cut = 0;  ///< its id
  std::string name;
  std::size_t kernels = 0;  ///< of the whole volume
  glm::ivec2 particles{0};  ///< of the sheet at rest
  int steps = 0;
  bool atRest = false;
  double stepMs = 0;  ///< mean time of a step with all its iterations, on the wall
  double kernelsMs = 0, leastCutMs = 0, totalMs = 0;
  std::optional<membrane::KeptWhole> kept;        ///< when asked for
  std::optional<membrane::KeptWholeLimit> limit;  ///< when asked for
  std::optional<membrane::LeftOut> leftOut;       ///< with `kept`
  std::vector<Advice> advice;  ///< with `kept`, where it is wanted and something helps, the best first
};

/// What to find out beside settling.
struct MembraneQuestions {
  bool kept = false;
  bool limit = false;  ///< takes seconds
};

/// Lets the sheets of all enabled membranes come to rest, and puts them into the scene: passive ones from the flat
/// sheet, active ones from their shape where they have one. The same scene gives the same sheets on one driver. On the
/// context that is current, GL thread; seconds on a software driver. @throw Cancelled
std::vector<MembraneReport> settleMembranes(scene::Scene& scene, MembraneQuestions questions, Progress& progress);

/// True when a picture of the scene needs settleMembranes() first.
bool hasMembranes(const scene::Scene& scene);

/// Settles the sheets of picture after picture of an animation: anew where the data or a cut is another one than in the
/// picture before, and active ones from where they were in it. GL thread.
class SheetsOverTime {
 public:
  /// The scene with its sheets at rest. On the current context. @throw Cancelled
  scene::Scene settle(const scene::Scene& step, Progress& progress);

 private:
  scene::Scene withShapes(scene::Scene step) const;
  std::optional<scene::Scene> mWanted;
  std::map<int, scene::SheetShape> mShapes;  ///< by the id of the cut
};

/// The sheet of a membrane as a surface, world: of its shape, flat when that is empty. Any thread.
Mesh sheetMesh(const scene::Cut& cut);

/// The scene's volume (its current time step) with everything that the cuts remove set to the smallest value of its
/// data, membranes as their shapes are. Any thread. @throw Cancelled, ArgumentError without a volume
Volume clippedVolume(const scene::Scene& scene, Progress& progress);

/// What helps a membrane with these figures, where it keeps little. Any thread. @throw Cancelled
std::vector<Advice> adviceFor(const membrane::KeptWhole& figures, const membrane::Potential& potential,
                              const scene::Scene& scene, const scene::Cut& cut, Progress& progress);

/// How much of what a membrane protects its sheet keeps whole, and what becomes of all of it. Any thread. @throw
/// Cancelled
membrane::KeptWhole measureMembrane(const membrane::Potential& potential, const scene::Cut& cut,
                                    const scene::SheetShape& shape, Progress& progress);

}  // namespace velum::session
