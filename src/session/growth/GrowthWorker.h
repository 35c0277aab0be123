#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "session/Worker.h"
#include "session/growth/Growths.h"

namespace velum::session {

/// Time and voxels that the last step of growing has taken.
struct GrowthFigures {
  int slabs = 0;
  double ms = 0.0;                                             ///< time of growing, by the clock on the wall
  std::size_t smoothed = 0;                                    ///< voxels that joined when the step's end was smoothed
  double leakDepth = 0.0, leakArea = 0.0, widestBefore = 0.0;  ///< of the slab in which the step leaks, see
                                                               ///< growth::Leak
};

/// What the worker is growing, for people.
struct GrowthStatus {
  bool isGrowing = false;
  int structure = 0;         ///< id of the structure that grows, or grew last; 0: none
  std::int64_t voxels = 0;   ///< that the structure has got since its step began
  std::optional<Leak> leak;  ///< the leak before which the step is held
  std::string error;         ///< one line; empty: nothing is wrong
  GrowthFigures figures = {};
};

/// Grows the regions that a scene's growths ask for ([ACS] 4.2): beside the document, a little at a time, so that the
/// window answers and shows the front as it comes. Labels that have grown are written into the scene as they are found.
/// Undo and edits of steps are followed: where the new steps go on from what has grown, growing goes on; otherwise it
/// begins again from the labels that were given. At another time step of the volume, structures are shown when all of
/// them have been carried there, see growth::GrowOverTime.
class GrowthWorker : public Worker {
 public:
  GrowthWorker();
  ~GrowthWorker() override;

  void follow(const scene::Scene& scene) override;
  Work nextWork() override;
  bool wantsCancel() const override;
  void endWork(const Finish& finish, const std::string& error) override;
  bool isOnItsWay() const override { return isDue(); }
  bool isSettled() const override { return !isDue(); }
  bool hasRests() const override;
  void complete(scene::Scene& scene) override;

  bool isGrowing() const { return isDue(); }
  GrowthStatus status() const;
  /// Tells where the step that is growing is to be held so that growing stops there; changes nothing itself, see
  /// holdGrowth(). @return how far that step has come; nothing when nothing grows
  std::optional<Leak> stop() const;
  /// Forgets the leak that was found: the user knows of it.
  void acceptLeak();
  /// From now on this structure may grow through leaks.
  void trust(int structure);
  /// Says that somebody has typed the range of values of this structure: the range is meant, so that the structure is
  /// only watched for jumps.
  void takeTypedRange(int structure);

 private:
  struct State;
  bool isDue() const;
  std::unique_ptr<State> mState;
};

}  // namespace velum::session
