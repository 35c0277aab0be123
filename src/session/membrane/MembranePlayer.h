#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/Clock.h"
#include "membrane/forces/KeptWhole.h"
#include "membrane/sheet/SheetIndex.h"
#include "render/SheetIndices.h"
#include "scene/Scene.h"
#include "session/Player.h"
#include "session/membrane/Advice.h"

namespace velum::session {

/// What a membrane is doing, for people.
struct MembraneStatus {
  enum class Phase {
    Computing,  ///< forces are on their way; the sheet keeps those that it has
    Settling,
    Paused,
    Resting
  };
  Phase phase = Phase::Resting;
  std::size_t kernels = 0;      ///< of the whole volume
  double forcesMs = 0;          ///< that it took to make the forces
  glm::ivec2 particles{0};      ///< of the sheet as it is
  int steps = 0;                ///< since it began to move
  double speed = 0;             ///< largest speed, length/s
  double stepMs = 0;            ///< that a step takes
  bool isMeasured = false;      ///< the figures below are those of the sheet as it rests
  double keptWhole = 1.0;       ///< cut area of the sheet by that of the plane: 0 cuts nothing
  membrane::Shares shares;      ///< of what the plane would cut
  membrane::Fate fate;          ///< of all that is protected
  bool wantsAdvice = false;     ///< little is kept
  std::vector<Advice> advice;   ///< where something helps then, the best first
  membrane::LeftOut leftOut;    ///< of what is protected by value: specks
  std::int64_t planePairs = 0;  ///< cut area: pairs of neighbouring protected voxels that the plane separates
  std::int64_t sheetPairs = 0;  ///< and that the sheet does
  double meanDistance = 0;      ///< of the sheet from the rest plane
  std::string error;            ///< why there are no forces; empty: nothing is wrong
};

class LiveSheet;

/// Runs the membranes of a scene: decides what work is due, computes forces beside, steps the sheets a little at a
/// time, and hands them to pictures.
///
/// What a scene asks for is always answered: until the new forces are there, the sheet stays in the world where the
/// material holds it while its rest plane moves, and its rim goes with the frame. Passive sheets ([IMC] 3.3) then start
/// from flat, unseen for as long as they hardly move; active ones go on from where they are.
///
/// GL thread, but for what nextWork() hands out.
class MembranePlayer : public Player {
 public:
  MembranePlayer();
  ~MembranePlayer() override;

  void follow(const scene::Scene& scene) override;
  Work nextWork() override;
  /// Not because a rest plane has moved on: a steady drag would otherwise never see any forces.
  bool wantsCancel() const override;
  void endWork(const Finish& finish, const std::string& error = {}) override;
  /// Steps sheets for about so long, at least one step, and brings indices up to date.
  bool advance(double budgetMs) override;
  bool isMoving() const override;
  /// Sheets have yet to come to rest where the scene asks for them; those that are paused are not waited for.
  bool isOnItsWay() const override;
  /// All sheets rest, their figures are known.
  bool isSettled() const override;
  std::uint64_t shownCount() const override;
  void show(render::Frame& frame) override { frame.sheets = sheets(); }
  bool hasRests() const override;
  void complete(scene::Scene& scene) override;
  /// What was at rest comes back as it was; what moved starts anew.
  void releaseGpu() override;

  /// Of the enabled membranes, for a frame of the scene that was last followed, by the id of the cut.
  std::map<int, render::FrameSheet> sheets();
  /// The same on the processor, for sections: at rest as the sheets are, and a few times a second while they move.
  render::SheetIndices indices() const;
  /// Of a cut, whether enabled or not; nothing when it is no membrane. @param cut  its id, here and below
  std::shared_ptr<const membrane::SheetIndex> index(int cut) const;

  /// Of a cut; nothing when it is no membrane.
  std::optional<MembraneStatus> status(int cut) const;

  bool isPlaying() const { return mPlaying; }
  void setPlaying(bool playing) { mPlaying = playing; }
  /// Some steps while paused. @return false when all rest
  bool stepOnce();
  /// Hangs the sheet of a cut flat again, from where it goes anew.
  void reset(int cut);

  /// Where active sheets have come to rest since this was last asked: what is to be written into their cuts.
  struct Rest {
    int cut = 0;  ///< its id
    scene::SheetShape shape;
  };
  std::vector<Rest> takeRests();
  /// The scene with the shape of each sheet in its cut, for a picture that is made elsewhere.
  scene::Scene withShapes(scene::Scene scene) const;

 private:
  LiveSheet* find(std::uint64_t id);
  LiveSheet* sheetOf(int cut) const;
  bool isOf(const scene::Scene& scene) const;
  Work forcesWork(LiveSheet& sheet);
  Work measureWork(LiveSheet& sheet);
  void refreshIndices();

  std::vector<std::unique_ptr<LiveSheet>> mSheets;  ///< a membrane each
  std::vector<std::unique_ptr<LiveSheet>> mGone;    ///< what they have on the GPU is given back by advance()
  scene::Scene mScene;
  std::uint64_t mNextId = 1, mGoneCount = 0;
  /// What is being computed.
  struct Out {
    std::uint64_t id = 0;  ///< of the sheet; 0: nothing is
    std::uint64_t data = 0, wish = 0;
    bool isMeasure = false, isPreview = false;
  };
  Out mOut;
  bool mPlaying = true;
  Clock::time_point mIndexedAt{};
};

}  // namespace velum::session
