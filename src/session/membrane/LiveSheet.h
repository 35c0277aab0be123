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
#include "scene/Cut.h"
#include "scene/SceneFwd.h"
#include "scene/SheetShape.h"
#include "session/membrane/MembraneMover.h"
#include "session/membrane/SheetMotion.h"
#include "session/membrane/SheetPlace.h"

namespace velum::session {

/// Which data forces come from.
struct DataKey {
  std::uint64_t volume = 0, labels = 0, model = 0;
  int timeStep = 0, channel = 0, copies = 1;
  bool operator==(const DataKey&) const = default;
};
DataKey dataKeyOf(const scene::Scene& scene);

/// What was measured of a sheet at rest.
struct SheetFigures {
  membrane::KeptWhole kept;
  std::vector<Advice> advice;
  membrane::LeftOut leftOut;
  bool isWhole = true;  ///< false: only how much the sheet cuts, which says whether it is worse than flat
};

/// One membrane of a MembraneMover. Four things, each with its owner: what forces are asked for (Asked), how the sheet
/// moves (SheetMotion), where it last was (SheetPlace), and what is shown of it (Shown). GL thread where it says so.
class LiveSheet {
 public:
  LiveSheet(std::uint64_t id, const scene::Cut& cut, DataKey data, MembraneMover::Purpose purpose);

  std::uint64_t id() const { return mId; }
  const scene::Cut& cut() const { return mCut; }

  /// The cut, or the data, as the scene has it now.
  void follow(const scene::Cut& cut, DataKey data);

  // Forces.
  bool needsForces() const { return mCut.enabled && mAsked.isDue; }
  /// Hands drag: forces are to come soon rather than exactly, see ForceMaker::preview().
  bool wantsPreview() const { return mAsked.byHands || mAsked.isLook; }
  /// Another number with every change of what forces depend on; and of the data alone.
  std::uint64_t wish() const { return mAsked.wish; }
  std::uint64_t dataChange() const { return mAsked.dataChange; }
  /// The sheet whose sides are kept, in the frame that is wanted; nothing: by the least cut. GL thread.
  membrane::CurrentSheet current() const;
  void takeForces(std::shared_ptr<const MadeForces> made, std::uint64_t wish);
  void failForces(const std::string& error);
  /// What makes forces from data, if it is there; and that it is to be kept, as some time steps before it are.
  std::shared_ptr<membrane::ForceMaker> makerOf(const scene::Scene& scene) const;
  void keepMaker(std::shared_ptr<membrane::ForceMaker> maker);

  // Motion. GL thread.
  bool isMoving() const;
  bool advance(double budgetMs);
  void reset();
  void releaseGpu();

  // Figures.
  /// The sheet rests where it is wanted, and figures of it are asked for that are not known.
  /// @param whole  all of them; else only where they may say that a flat sheet is better
  bool needsFigures(bool whole) const;
  void takeFigures(SheetFigures figures, std::uint64_t wish);
  void failFigures() { mFigures = SheetFigures{}; }
  MembraneStatus status(bool isPlaying, bool isComputing) const;
  /// Of a sheet at rest; figures where they are known.
  MembraneReport report() const;

  // What is shown.
  /// As it stands in the frame that is wanted. GL thread while it moves.
  scene::SheetShape shape() const { return seenPlace().in(mCut); }
  render::FrameSheet frameSheet();
  const std::shared_ptr<const membrane::SheetIndex>& index() const { return mShown.index; }
  /// Another number when the sheet stands otherwise in its frame.
  std::uint64_t shownCount() const { return mShown.count; }
  bool isIndexStale() const { return mCut.enabled && mShown.indexed != mShown.count; }
  void makeIndex();
  /// The shape to be written into the scene, once.
  std::optional<scene::SheetShape> takeRest();
  bool hasRest() const;

 private:
  /// What forces are asked for, and what those that come are for.
  struct Asked {
    bool isDue = true;
    bool isLook = false;      ///< a passive sheet hangs elsewhere: where data is large, a preview comes first
    bool byHands = false;     ///< hands drag pins or kernels: the sheet goes on from where it is, under previews
    bool keepsSides = false;  ///< material stays on its side of the sheet
    std::uint64_t wish = 1, dataChange = 1;
    std::string error;  ///< why there are none; empty: nothing is wrong
  };
  /// What is shown, and what was made for showing.
  struct Shown {
    std::uint64_t count = 1;  ///< counts places that differ
    std::shared_ptr<membrane::Sheet> sheet;
    std::shared_ptr<const membrane::SheetIndex> index;
    std::uint64_t uploaded = 0, indexed = 0;  ///< counts of these
    mutable SheetPlace read;                  ///< where the simulation was when the count was readAt
    mutable std::uint64_t readAt = 0;
  };
  bool isActive() const { return mCut.membrane->repositioning == scene::Repositioning::Active; }
  bool isForEyes() const { return mPurpose == MembraneMover::Purpose::Show; }
  const SheetPlace& seenPlace() const;
  void adopt(const scene::SheetShape& saved);
  void forget();
  void begin();
  void keepPlace();
  void beginAgain();

  std::uint64_t mId;
  MembraneMover::Purpose mPurpose;
  scene::Cut mCut;  ///< as it is wanted
  DataKey mData;
  Asked mAsked;
  std::shared_ptr<const MadeForces> mForces;
  bool mBegins = false;  ///< a motion is to begin, under mForces
  SheetMotion mMotion;
  SheetPlace mPlace;           ///< where it last was; where it rests, when it rests
  scene::SheetShape mWritten;  ///< that the scene holds
  std::optional<SheetFigures> mFigures;
  std::vector<std::shared_ptr<membrane::ForceMaker>> mMakers;  ///< of this volume's time steps, the last one first
  Shown mShown;
};

}  // namespace velum::session
