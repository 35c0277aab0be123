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

/// Names the data from which forces come: equal keys, equal data.
struct DataKey {
  std::uint64_t volume = 0, labels = 0, model = 0;
  int timeStep = 0, channel = 0, copies = 1;
  scene::ModelFrame frame;  ///< how the model lies in the world
  bool operator==(const DataKey&) const = default;
};
DataKey dataKeyOf(const scene::Scene& scene);

/// What was measured of a sheet that rests.
struct SheetFigures {
  membrane::KeptWhole kept;
  std::vector<Advice> advice;
  membrane::LeftOut leftOut;
  membrane::ForceVoxels voxels;  ///< that they come from
  bool isWhole = true;  ///< false: only how much the sheet cuts was measured, which says whether the sheet is worse
                        ///< than a flat one
};

/// One membrane of a MembraneMover. Four things about the sheet are kept apart: which forces are asked for (Asked), how
/// the sheet moves (SheetMotion), where it last was (SheetPlace), and what is shown of it (Shown). GL thread where a
/// function says so.
class LiveSheet {
 public:
  LiveSheet(std::uint64_t id, const scene::Cut& cut, DataKey data, MembraneMover::Purpose purpose);

  std::uint64_t id() const { return mId; }
  const scene::Cut& cut() const { return mCut; }

  /// Takes over the cut, and the key of the data, as the scene has them now.
  void follow(const scene::Cut& cut, DataKey data);

  // Forces.
  bool needsForces() const { return mCut.enabled && mAsked.isDue; }
  /// True while hands drag or a new place is looked at: then forces are to come soon rather than exactly, see
  /// ForceMaker::preview().
  bool wantsPreview() const { return mAsked.byHands || mAsked.isLook; }
  /// wish() changes with everything on which forces depend; dataChange() changes with the data alone.
  std::uint64_t wish() const { return mAsked.wish; }
  std::uint64_t dataChange() const { return mAsked.dataChange; }
  /// The sheet whose sides the new forces are to keep, in the frame that is wanted; nothing: the forces choose sides by
  /// the least cut. GL thread.
  membrane::CurrentSheet current() const;
  void takeForces(std::shared_ptr<const MadeForces> made, std::uint64_t wish);
  void failForces(const std::string& error);
  /// makerOf(): what makes forces from the scene's data, null where none was kept. keepMaker(): keeps one, with those
  /// of some other time steps.
  std::shared_ptr<membrane::ForceMaker> makerOf(const scene::Scene& scene) const;
  void keepMaker(std::shared_ptr<membrane::ForceMaker> maker);

  // Motion. GL thread.
  bool isMoving() const;
  /// @throw gpu::GpuError when there is no memory; the next call begins the motion anew
  bool advance(double budgetMs);
  void reset();
  void releaseGpu();
  void resume();

  // Figures.
  /// True when the sheet rests where it is wanted, and figures that are asked for are not known.
  /// @param whole  all figures are asked for; else only figures that may say that a flat sheet is better
  bool needsFigures(bool whole) const;
  void takeFigures(SheetFigures figures, std::uint64_t wish);
  void failFigures() { mFigures = SheetFigures{}; }
  MembraneStatus status(bool isPlaying, bool isComputing) const;
  /// Of a sheet that rests; with its figures where they are known.
  MembraneReport report() const;

  // What is shown.
  /// The shape of the sheet in the frame that is wanted, as it is shown. GL thread while the sheet moves.
  scene::SheetShape shape() const { return seenPlace().in(mCut); }
  render::FrameSheet frameSheet();
  const std::shared_ptr<const membrane::SheetIndex>& index() const { return mShown.index; }
  /// A number that changes when the sheet stands otherwise in its frame.
  std::uint64_t shownCount() const { return mShown.count; }
  bool isIndexStale() const { return mCut.enabled && mShown.indexed != mShown.count; }
  void makeIndex();
  /// The shape that is to be written into the scene; each shape is given once.
  std::optional<scene::SheetShape> takeRest();
  bool hasRest() const;

 private:
  /// Which forces are asked for, and for what.
  struct Asked {
    bool isDue = true;
    bool isLook = false;      ///< a passive sheet hangs elsewhere: where data is large, a preview comes first
    bool byHands = false;     ///< hands drag pins or kernels: the sheet goes on from where it is, under previews
    bool keepsSides = false;  ///< material stays on its side of the sheet
    std::uint64_t wish = 1, dataChange = 1;
    std::string error;  ///< why forces could not be made; empty: nothing is wrong
  };
  /// What is shown of the sheet, and what was made to show it.
  struct Shown {
    std::uint64_t count = 1;  ///< shownCount(): goes up when the sheet's place differs
    std::shared_ptr<membrane::Sheet> sheet;
    std::shared_ptr<const membrane::SheetIndex> index;
    std::uint64_t uploaded = 0, indexed = 0;  ///< the count for which `sheet` was filled, and `index` made
    mutable SheetPlace read;                  ///< where the simulation was when `count` was `readAt`
    mutable std::uint64_t readAt = 0;
  };
  bool isActive() const { return mCut.membrane->repositioning == scene::Repositioning::Active; }
  bool isForEyes() const { return mPurpose == MembraneMover::Purpose::Show; }
  const SheetPlace& seenPlace() const;
  void adopt(const scene::SheetShape& saved);
  void forget();
  void begin();
  void move(double budgetMs);
  void failMotion();
  render::FrameSheet upload();
  void keepPlace();
  void afterSteps();
  void beginAgain();

  std::uint64_t mId;
  MembraneMover::Purpose mPurpose;
  scene::Cut mCut;  ///< as it is wanted
  DataKey mData;
  Asked mAsked;
  std::shared_ptr<const MadeForces> mForces;
  bool mBegins = false;  ///< a motion under mForces is to begin
  SheetMotion mMotion;
  SheetPlace mPlace;           ///< where the sheet last was; for a sheet that rests, where it rests
  scene::SheetShape mWritten;  ///< the shape that the scene holds
  std::optional<SheetFigures> mFigures;
  std::vector<std::shared_ptr<membrane::ForceMaker>> mMakers;  ///< for time steps of this volume, the one used last
                                                               ///< first
  Shown mShown;
};

}  // namespace velum::session
