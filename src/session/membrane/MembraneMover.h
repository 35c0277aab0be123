#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/Clock.h"
#include "membrane/sheet/SheetIndex.h"
#include "render/SheetIndices.h"
#include "scene/Scene.h"
#include "session/Worker.h"
#include "session/membrane/MembraneReport.h"

namespace velum::session {

class LiveSheet;

/// Runs the membranes of a scene: decides what work is due, computes forces beside, steps the sheets a little at a
/// time, and hands them to pictures.
///
/// What a scene asks for is always answered: until the new forces are there, the sheet stays in the world where the
/// material holds it while its rest plane moves, and its rim goes with the frame. Passive sheets ([IMC] 3.3) then start
/// from flat, unseen for as long as they hardly move; active ones go on from where they are.
///
/// GL thread, but for what nextWork() hands out.
class MembraneMover : public Mover {
 public:
  /// Whom it plays for: eyes and hands, which want previews and figures soon; or the places alone where sheets rest,
  /// which are the same.
  enum class Purpose { Show, Rest };
  explicit MembraneMover(Purpose purpose = Purpose::Show);
  /// To be called before it follows membranes.
  void setPurpose(Purpose purpose);
  ~MembraneMover() override;

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
  /// Whether all figures are measured of sheets that rest; else only those that may say that a flat one is better.
  void setMeasures(bool measures) { mMeasures = measures; }
  /// Of the enabled membranes, in the order of the cuts, when they rest; figures where they were measured.
  std::vector<MembraneReport> reports() const;
  /// The least that any sheet in the frame of a cut must cut. Seconds. Any thread. @throw Cancelled
  membrane::KeptWholeLimit limit(int cut, Progress& progress) const;

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
  Purpose mPurpose = Purpose::Show;
  bool mMeasures = true;
  bool mPlaying = true;
  Clock::time_point mIndexedAt{};
};

}  // namespace velum::session
