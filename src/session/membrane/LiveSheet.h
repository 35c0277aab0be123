#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "membrane/forces/Forces.h"
#include "membrane/forces/KeptWhole.h"
#include "membrane/sheet/Sheet.h"
#include "membrane/sheet/SheetIndex.h"
#include "membrane/sheet/Simulation.h"
#include "scene/Cut.h"
#include "scene/Membrane.h"
#include "scene/SceneFwd.h"
#include "scene/SheetShape.h"
#include "session/membrane/MembranePlayer.h"

namespace velum::session {

/// Which data forces come from.
struct DataKey {
  std::uint64_t volume = 0, labels = 0, model = 0;
  int timeStep = 0, channel = 0, copies = 1;
  bool operator==(const DataKey&) const = default;
};
DataKey dataKeyOf(const scene::Scene& scene);

/// Forces, the cut for whose frame they were made, and the time step whose data they are of.
struct MadeForces {
  membrane::Forces forces;
  scene::Cut cut;
  int timeStep = 0;
};

/// One membrane of a MembranePlayer: what is wanted of it, its forces, its simulation, what is shown of it.
class LiveSheet {
 public:
  LiveSheet(std::uint64_t id, const scene::Cut& cut, DataKey data);

  std::uint64_t id() const { return mId; }
  const scene::Cut& cut() const { return mCut; }

  /// The cut, or the data, as the scene has it now.
  void follow(const scene::Cut& cut, DataKey data);

  bool needsForces() const { return mCut.enabled && mNeedsForces; }
  /// Hands drag: forces are to come soon rather than exactly, see ForceMaker::preview().
  bool wantsPreview() const { return mGoesOn || mWantsLook; }
  /// Another number with every change of what forces depend on; and of the data alone.
  std::uint64_t wish() const { return mWish; }
  std::uint64_t dataChange() const { return mDataChange; }
  /// The sheet whose sides are kept, in the frame that is wanted; nothing: by the least cut.
  membrane::CurrentSheet current() const;
  void takeForces(std::shared_ptr<const MadeForces> made, std::uint64_t wish);
  void failForces(const std::string& error);
  /// What makes forces from data, if it is there; and that it is to be kept, as some time steps before it are.
  std::shared_ptr<membrane::ForceMaker> makerOf(const scene::Scene& scene) const;
  void keepMaker(std::shared_ptr<membrane::ForceMaker> maker);

  bool isMoving() const;
  bool advance(double budgetMs);
  void reset();

  /// What is to be measured: the sheet rests where it is wanted, and its figures are not known.
  bool needsFigures() const;
  void takeFigures(const membrane::KeptWhole& figures, std::vector<Advice> advice, const membrane::LeftOut& leftOut,
                   std::uint64_t wish);
  void failFigures() { mFigures = membrane::KeptWhole{}; }
  MembraneStatus status(bool isPlaying, bool isComputing) const;

  /// As it stands in the frame that is wanted.
  scene::SheetShape shape() const;
  render::FrameSheet frameSheet();
  const std::shared_ptr<const membrane::SheetIndex>& index() const { return mIndex; }
  /// Another number when the sheet stands otherwise in its frame.
  std::uint64_t shownCount() const { return mShown; }
  bool isIndexStale() const { return mCut.enabled && mIndexed != mShown; }
  void makeIndex();
  /// The shape to be written into the scene, once.
  std::optional<scene::SheetShape> takeRest();
  bool hasRest() const;
  void releaseGpu();

 private:
  /// What the simulation is doing.
  enum class Motion {
    None,     ///< There is none.
    Unseen,   ///< It has begun from flat, and lies too nearly flat yet to be shown.
    Shown,    ///< It is what is shown.
    Dragged,  ///< So, and where it rests depends on how it came there: a passive sheet will start from flat once more.
  };
  bool isActive() const { return mCut.membrane->repositioning == scene::Repositioning::Active; }
  bool isAtRest() const { return mMotion == Motion::None || mSimulation->isAtRest(); }
  /// The simulation is what is shown; otherwise it is mKept.
  bool movesInSight() const { return mMotion != Motion::Unseen && !isAtRest(); }
  void adopt(const scene::SheetShape& shape);
  void begin();
  void beginAgain();
  void keepShape();
  scene::SheetShape known() const;

  std::uint64_t mId;
  scene::Cut mCut;  ///< as it is wanted
  DataKey mData;
  std::uint64_t mWish = 1, mDataChange = 1;
  bool mNeedsForces = true;
  std::string mError;
  std::shared_ptr<const MadeForces> mForces;
  bool mBegin = false;      ///< the simulation is to begin with mForces
  bool mGoesOn = false;     ///< from where the sheet is: hands drag something, and see what comes of it at once
  bool mWantsLook = false;  ///< a passive sheet hangs elsewhere: where data is large, a preview comes first
  bool mKeepSides = false;  ///< the next forces leave material on its side of the sheet
  // What moves.
  std::optional<membrane::Simulation> mSimulation{std::in_place};
  Motion mMotion = Motion::None;
  scene::Cut mMovingCut;
  int mMovingStep = 0;  ///< time step of its forces
  double mStepMs = 0;
  // What is known of it here, where it last was, in the frame of mKeptCut. Empty: flat.
  scene::SheetShape mKept;
  scene::Cut mKeptCut;
  int mKeptStep = -1;          ///< time step of its forces; -1: not known
  scene::SheetShape mWritten;  ///< that the scene holds
  std::optional<membrane::KeptWhole> mFigures;
  membrane::LeftOut mLeftOut;
  std::vector<Advice> mAdvice;                                 ///< that goes with them
  std::vector<std::shared_ptr<membrane::ForceMaker>> mMakers;  ///< of this volume's time steps, the last one first
  // What is shown.
  std::shared_ptr<membrane::Sheet> mSheet;
  std::shared_ptr<const membrane::SheetIndex> mIndex;
  std::uint64_t mShown = 1;  ///< counts places that differ
  std::uint64_t mIndexed = 0, mUploaded = 0;
  mutable scene::SheetShape mRead;  ///< where the simulation was when mShown was mReadAt
  mutable std::uint64_t mReadAt = 0;
};

/// The cuts stand in the same place of the world.
bool haveSameFrame(const scene::Cut& a, const scene::Cut& b);

}  // namespace velum::session
