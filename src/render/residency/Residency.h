#pragma once
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "gpu/Context.h"
#include "render/Frame.h"
#include "render/Streaming.h"
#include "render/residency/BrickLoader.h"
#include "render/residency/PageTable.h"
#include "render/residency/SlotStore.h"
#include "render/upload/VolumeUpload.h"
#include "scene/SceneFwd.h"

namespace velum::render {

/// The bricks of a streamed volume that are on the GPU, within a budget, side by side in one texture.
///
/// The whole volume lies there, too, as coarse as the volume in memory is: so there is a picture at once, and whatever
/// has not come yet is seen coarse. A frame has a level, the finest that any of it wants, whose bricks are its pages;
/// each page wants the level whose voxels are about as large as pixels where it lies. Rays leave marks on the pages
/// through which they come (bricks.glsl): gather() asks for what these want, receive() takes what has come. Pages that
/// no ray meets, behind what is opaque, are never read.
///
/// Cost: of a frame nothing that grows with the volume but the table of pages, a word for 32^3 voxels of the frame's
/// level. GL thread.
class Residency {
 public:
  /// True when values of a page may be seen. Any thread. @param texels  smallest and largest
  using MayShow = std::function<bool(glm::vec2 texels)>;

  /// @param layer  whose volume has finer levels  @param budgetBytes  of the textures; 0: as is usual
  /// @throw gpu::GpuError
  Residency(const scene::VolumeLayer& layer, const gpu::Limits& limits, double budgetBytes);
  ~Residency();

  /// Brings the next slab of the coarse volume. @return true when all of it is there
  bool step();
  double fractionDone() const;

  /// Chooses the frame's level by its camera, whose lengths are in the world's unit.
  void look(const Frame& frame);
  /// From which depth on, and how often, samples may be twice as far apart, as bricks there hold voxels that are
  /// larger: FrameParams::coarsening, world. {0, 0}: nowhere.
  glm::dvec2 coarsening() const;
  /// True when some page shows finer voxels than it wants, until those come. @param drops  shows coarser ones instead
  bool hasFiner(bool drops);
  /// True when not all bricks that are seen have room, and all is coarser.
  bool isShort() const { return mEye.coarser > 0; }
  /// True when gather() has found no room for bricks of the frame's level: looking again chooses one that has room, so
  /// that rays take no finer steps than there are voxels.
  bool isTooFine() const { return levelFor(mEye.nearestPixel * std::exp2(mEye.coarser)) > mTable.level(); }
  /// The next look() is at the same view, and as coarse as this one has become.
  void keepCoarse() { mStartCoarser = mEye.coarser; }
  /// The textures, and the volume of the frame's level.
  const GpuVolume& volume() const { return mVolume; }
  void bind() const { mTable.bind(); }
  /// Binds the marks for a dispatch that casts rays.
  void bindSeen() const { mSeen.bindStorage(shared::kSeenPageBinding); }
  void clearSeen() { mSeen.clear(); }

  /// What is drawn from now on shows all that is there.
  void noteDrawn() { mTable.forgetChanges(); }
  /// Where what is shown has changed since noteDrawn(): boxes that hold all samples that it may change, in texture
  /// coordinates of volume(). Nothing where that is all over.
  struct TexBox {
    glm::dvec3 low, high;
  };
  std::optional<std::vector<TexBox>> changes() const;

  /// Reads the marks, and asks for what the pages with marks want. Waits for the GPU.
  /// @return how many bricks are not there yet
  std::size_t gather(const MayShow& mayShow);
  /// Takes bricks that have come, for about that long. @return how many are not there yet
  std::size_t receive(double budgetMs, const MayShow& mayShow);
  /// True when gather() has asked for some of the bricks only, to find out how many of all will be seen: as soon as
  /// they are there it is to be called again.
  bool isSampling() const { return mIsSampling; }
  /// True when bricks have come, or pages want others, since the cells were brought up to date.
  bool hasNews() const { return mHasNews; }
  /// Brings the ranges of cells up to date.
  void updateCells();

  /// In words for people: what is not shown as fine as it is wanted, and why; empty when all is.
  std::string shortfall() const;
  /// How fine what rays meet is shown, as gather() found it last. Kept until bricks come or pages want others.
  const Streaming& streaming() const;
  /// Bricks on the GPU, and how many there is room for.
  std::size_t residentCount() const { return mResident.size(); }
  std::size_t slotCount() const { return mSlots.size(); }

 private:
  struct Slot {
    SlotPlace place;
    PageBrick brick;
    bool isUsed = false;
    std::uint64_t seen = 0;  ///< when rays came through it last: number of a gathering
  };
  /// By what it is chosen which level a page wants.
  struct Eye {
    glm::dvec3 eye{0.0}, forward{0.0, 0.0, 1.0};  ///< world
    double pixel = 0;                             ///< edge of a pixel: at distance 1, or anywhere if orthographic
    bool isOrthographic = false;
    double nearestPixel = 0;  ///< edge of a pixel where the data is nearest, world
    double coarser = 0;       ///< powers of two by which all is coarser, where there is no room
  };

  struct Wish {
    PageBrick brick;
    double urgency;
  };
  double urgencyOf(glm::ivec3 page, int level) const;
  std::vector<PageBrick> bricksOf(const std::vector<Wish>& wishes);
  void restartTable(int level);
  int levelFor(double pixelSize) const;
  int wantedAt(glm::ivec3 page) const;
  std::uint32_t bestSlot(glm::ivec3 page, bool mayBeFiner = true) const;
  void writeRow(std::uint32_t slot);
  void refreshPages(const PageBrick& brick);
  std::uint32_t freeSlot();
  void show(std::size_t page, std::uint32_t slot);
  void showNothing(std::size_t page, const BrickRanges& ranges, const MayShow& mayShow);
  glm::vec2 coarseRange(glm::dvec3 low, glm::dvec3 high) const;
  glm::vec2 brickRange(const PageBrick& brick, const BrickRanges& ranges, glm::dvec3 low, glm::dvec3 high) const;
  glm::vec2 cellRange(glm::ivec3 cell) const;

  Shared<Volume> mCoarse;
  PageGrid mGrid;
  TexelRecipe mRecipe;
  gpu::Limits mLimits;
  double mBudgetBytes;
  std::size_t mTexelBytes = 0;        ///< of a texel in both textures
  std::vector<std::uint32_t> mMarks;  ///< a bit a page that rays met
  GpuVolume mVolume;
  std::unique_ptr<VolumeUpload> mUpload;
  std::vector<glm::vec2> mCoarseRanges;  ///< of the cells of the coarse volume
  CellGrid mCoarseCells;
  static constexpr std::uint32_t kEmptySlot = 1, kFirstSlot = 2;
  std::vector<Slot> mSlots;  ///< the first is the coarse volume's; the next shows nothing
  float mEmptyTexel = 0;     ///< in all of it
  bool hasEmptyTexel = false;
  PageTable mTable;
  gpu::Buffer mSeen;
  std::unordered_map<std::uint64_t, std::uint32_t> mResident;  ///< slots by bricks
  std::unordered_map<std::uint64_t, BrickRanges> mKnown;       ///< ranges of bricks that were read
  std::unordered_set<std::uint64_t> mMissing, mFailed;
  std::string mError;  ///< of the first brick that failed
  std::uint64_t mTurn = 0;
  Eye mEye;
  double mStartCoarser = 0;  ///< Eye::coarser at the next look()
  bool mHasNews = false;
  bool mIsSampling = false;
  mutable std::optional<Streaming> mStreaming;
  std::unique_ptr<BrickLoader> mLoader;
};

}  // namespace velum::render
