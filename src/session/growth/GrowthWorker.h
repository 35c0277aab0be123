#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "session/Worker.h"
#include "session/growth/Growths.h"

namespace velum::session {

/// What the last step of growing has taken.
struct GrowthFigures {
  int slabs = 0;
  double ms = 0.0;                                             ///< of growing, on the wall
  std::size_t smoothed = 0;                                    ///< voxels that joined at the step's end
  double leakDepth = 0.0, leakArea = 0.0, widestBefore = 0.0;  ///< of the slab that leaks, see growth::Leak
};

/// What growing is doing, for people.
struct GrowthStatus {
  bool isGrowing = false;
  int structure = 0;         ///< that grows, or grew last; 0: none
  std::int64_t voxels = 0;   ///< that it has got since its step began
  std::optional<Leak> leak;  ///< that holds it
  std::string error;         ///< one line; empty: nothing is wrong
  GrowthFigures figures = {};
};

/// Grows what a scene's growths ask for ([ACS] 4.2): beside, a little at a time, so that the window answers and shows
/// the front as it comes. What has grown is written into the scene's labels as it is found. Undo and edits of steps are
/// followed: what goes on from where it stands goes on, anything else begins again from the labels that were given. At
/// another time step of the volume structures are shown when all have been carried there, see growth::GrowOverTime.
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
  /// Stops what is growing. @return how far its step has come: what is to be held; nothing when nothing grows
  std::optional<Leak> stop() const;
  /// The leak that was found is no news any more.
  void acceptLeak();
  /// No leak of this structure is minded any more.
  void trust(int structure);
  /// Somebody has typed the values of this structure: they are meant, and it is only watched for leaks.
  void takeTypedRange(int structure);

 private:
  struct State;
  bool isDue() const;
  std::unique_ptr<State> mState;
};

}  // namespace velum::session
