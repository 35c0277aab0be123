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

/// Runs the membranes of a scene: decides what work is due, lets forces be computed beside, steps the sheets a little
/// at a time, and hands the sheets to pictures.
///
/// What a scene asks for is always answered at once: until the new forces are there, the sheet stays at its place in
/// the world, where the material holds it, while its rest plane moves, and its rim goes with the frame. Passive sheets
/// ([IMC] 3.3) then start from flat, and are not shown for as long as they hardly move; active sheets go on from where
/// they are.
///
/// GL thread, except the work that nextWork() hands out.
class MembraneMover : public Mover {
 public:
  /// For whom the sheets move. Show: for eyes and hands, which want previews and figures soon. Rest: only for the
  /// places where sheets rest; these are the same for both.
  enum class Purpose { Show, Rest };
  explicit MembraneMover(Purpose purpose = Purpose::Show);
  /// To be called before the mover follows a scene with membranes.
  void setPurpose(Purpose purpose);
  ~MembraneMover() override;

  void follow(const scene::Scene& scene) override;
  Work nextWork() override;
  /// A rest plane that has moved on is no reason: a steady drag would otherwise never see any forces.
  bool wantsCancel() const override;
  void endWork(const Finish& finish, const std::string& error = {}) override;
  /// Steps sheets for about so many milliseconds, at least one step, and brings the indices up to date.
  bool advance(double budgetMs) override;
  bool isMoving() const override;
  /// True while sheets have yet to come to rest where the scene asks for them; paused sheets are not waited for.
  bool isOnItsWay() const override;
  /// All sheets rest or are paused, and their figures are known.
  bool isSettled() const override;
  std::uint64_t shownCount() const override;
  void show(render::Frame& frame) override { frame.sheets = sheets(); }
  bool hasRests() const override;
  void complete(scene::Scene& scene) override;
  void releaseGpu() override;

  /// The sheets of the enabled membranes by the id of their cut, for a frame of the scene that was last followed.
  std::map<int, render::FrameSheet> sheets();
  /// The same sheets in the processor's memory, for sections: exact for sheets at rest, and brought up to date a few
  /// times a second while they move.
  render::SheetIndices indices() const;
  /// The index of a cut's sheet, whether the cut is enabled or not; nothing when the cut is no membrane.
  /// @param cut  its id, here and below
  std::shared_ptr<const membrane::SheetIndex> index(int cut) const;

  /// What a cut's membrane is doing; nothing when the cut is no membrane.
  std::optional<MembraneStatus> status(int cut) const;
  /// Whether all figures of sheets that rest are measured; else only figures that may say that a flat sheet is better.
  void setMeasures(bool measures) { mMeasures = measures; }
  /// Reports of the enabled membranes, in the order of the cuts, when their sheets rest; with figures where these were
  /// measured.
  std::vector<MembraneReport> reports() const;
  /// The least that any sheet in the frame of a cut must cut. Seconds. Any thread. @throw Cancelled
  membrane::KeptWholeLimit limit(int cut, Progress& progress) const;

  bool isPlaying() const { return mPlaying; }
  void setPlaying(bool playing) { mPlaying = playing; }
  /// Makes some steps while paused. @return false when all sheets rest
  bool stepOnce();
  /// Hangs the sheet of a cut flat again; it then moves anew from there.
  void reset(int cut);

  /// Where an active sheet has come to rest: a shape that is to be written into its cut.
  struct Rest {
    int cut = 0;  ///< id of the cut
    scene::SheetShape shape;
  };
  /// The rests of all active sheets since this was last asked.
  std::vector<Rest> takeRests();
  /// The scene with the shape of each sheet in its cut, for a picture that is made elsewhere.
  scene::Scene withShapes(scene::Scene scene) const;

 private:
  void keepUp();
  LiveSheet* find(std::uint64_t id);
  LiveSheet* sheetOf(int cut) const;
  bool isOf(const scene::Scene& scene) const;
  Work forcesWork(LiveSheet& sheet);
  Work measureWork(LiveSheet& sheet);
  void refreshIndices();

  std::vector<std::unique_ptr<LiveSheet>> mSheets;  ///< one for each membrane
  std::vector<std::unique_ptr<LiveSheet>> mGone;    ///< sheets without a membrane; advance() gives back what they have
                                                    ///< on the GPU
  scene::Scene mScene;
  unsigned mContext = 0;  ///< gpu::contextNumber() where the sheets are; 0: nowhere yet
  std::uint64_t mNextId = 1, mGoneCount = 0;
  /// The piece of work that is being done.
  struct Out {
    std::uint64_t id = 0;  ///< of the sheet for which it is done; 0: no work is being done
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
