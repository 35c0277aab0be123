#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/HalvedLabels.h"
#include "gpu/Buffer.h"
#include "gpu/Context.h"
#include "gpu/Texture.h"
#include "render/upload/ShareTexels.h"

namespace velum::render {

/// The labels of a streamed volume on the GPU (shaders/common/labels.glsl): what LabelUpload and ShareUpload make of
/// whole grids, brick by brick. A brick at which structures meet has a slot of the textures, with two voxels of what is
/// around it; all bricks that are one structure's alone, with all around them, share a slot of that structure. So
/// memory grows with the borders of structures, and with the grid only by a word a brick. Where borders have no room
/// the labels are drawn in voxels twice as long, and so on, and that is said. Follows edits brick by brick. GL thread;
/// works on all cores.
class LabelBricks {
 public:
  explicit LabelBricks(const gpu::Limits& limits) : mLimits(limits) {}
  /// Chooses slots for the scene's labels. @throw gpu::GpuError when there is no room for them, however coarse
  void begin(const scene::Scene& scene, bool isAlone);
  /// Makes and sends some bricks. @return true when the textures agree with the scene
  bool step();
  void bind() const;

  /// The labels as they are drawn: the scene's, or coarser ones.
  const LabelVolume& labels() const { return *mField->cover().labels(); }
  /// In words for people: how much coarser they are drawn, and why; empty when they are not.
  std::string shortfall() const;
  /// Sets of the scene for which begin() was called last.
  const StructureSets& sets() const { return mSets; }
  /// How many slots are in use.
  std::size_t slotCount() const { return mUsed; }
  /// How many bytes were sent since the last begin().
  std::size_t bytesSent() const { return mBytesSent; }

 private:
  struct SlotTexels {
    std::vector<std::uint16_t> ids;
    std::vector<std::uint8_t> covers, shares, means;
  };
  std::shared_ptr<const StructureField> fieldOf(const scene::Scene& scene);
  void placeAll(std::shared_ptr<const StructureField> field, StructureSets sets);
  std::size_t mostSlots() const;
  void restart(glm::ivec3 grid);
  void place(const std::vector<std::size_t>& bricks);
  std::uint32_t takeSlot();
  void makeRoom();
  void setPage(std::size_t brick, std::uint32_t slot);
  std::uint32_t slotOfOnly(std::uint16_t id);
  std::optional<std::uint16_t> onlyAround(glm::ivec3 index) const;
  SlotTexels texelsOf(glm::ivec3 index) const;
  SlotTexels texelsOfOnly(std::uint16_t id) const;
  void send(std::uint32_t slot, const SlotTexels& texels);

  gpu::Limits mLimits;
  std::vector<HalvedLabels> mHalves;             ///< each of the one before, down to those that are drawn
  std::uint64_t mPlacedId = 0;                   ///< of the scene's labels at the last begin()
  std::shared_ptr<const StructureField> mField;  ///< the field that the textures show, once no brick is stale
  StructureSets mSets;
  ShareLayout mLayout;
  std::vector<std::uint32_t> mPages;             ///< by brick, x fastest: its slot
  std::map<std::size_t, std::uint32_t> mOwn;     ///< slots of bricks that have one to themselves
  std::map<std::uint16_t, std::uint32_t> mOnly;  ///< slots of structures, for what is theirs alone
  std::set<std::size_t> mStale;                  ///< bricks, of mOwn
  std::set<std::uint16_t> mStaleOnly;            ///< structures, of mOnly
  std::vector<std::uint32_t> mFree;
  std::size_t mUsed = 0, mRoom = 0;  ///< slots, free ones included; that the textures have
  std::size_t mFirstChanged = 0, mEndChanged = 0, mBytesSent = 0;
  gpu::Texture mIds, mCovers, mShares, mPageTexels;
  gpu::Buffer mPageBuffer;
};

}  // namespace velum::render
