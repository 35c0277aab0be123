#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <utility>
#include <vector>

#include "gpu/Buffer.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "model/InstanceSet.h"

namespace velum::shared {
struct InstanceView;
}

namespace velum::model {

/// Which instances are drawn. Cuts, Membranes: those that the cuts leave, worked out while they are culled, without or
/// with sheets among the cuts; States: those that InstanceStates leaves; Ghosts: those that InstanceStates has removed
/// and that show as ghosts.
enum class CullBy { Cuts, Membranes, States, Ghosts };

/// The defines of the program that culls: by what it culls, and whether it takes the instances seen before or all
/// others.
gpu::Defines cullDefines(CullBy by, bool isOfSeen);
/// The defines of the focus program of InstanceStates.
gpu::Defines focusDefines(bool hasMembranes, bool isOfOccluders);

/// Some instances of some copies: a range of the instances of a copy, the same in each of the copies.
struct InstancePart {
  std::uint32_t first = 0, end = 0;
  int firstCopy = 0, copies = 1;
};
/// Parts that make up all instances of all copies. @param most  about how many instances a part has at most
std::vector<InstancePart> instanceParts(std::uint32_t instances, int copies, std::uint32_t most);

/// The programs that draw instances into a target. GL thread.
class InstancePrograms {
 public:
  const gpu::Program& cull(CullBy by, bool isOfSeen);
  const gpu::Program& splat(bool isLarge);
  const gpu::Program& arguments();
  const gpu::Program& pyramid();
  const gpu::Program& seen();
  const gpu::Program& clip(bool hasMembranes);
  const gpu::Program& focus(bool hasMembranes, bool isOfOccluders);
  const gpu::Program& flood();
  const gpu::Program& shown();

  /// What a picture needs programs for.
  struct Need {
    CullBy by = CullBy::Cuts;
    bool hasMembranes = false, hasFocus = false, hasGhosts = false;
  };
  /// Starts compiling the programs that a picture needs, side by side, see gpu::Program. @return true when all of them
  /// are
  bool compile(const Need& need);

 private:
  std::map<std::pair<CullBy, bool>, gpu::Program> mCull;
  std::map<bool, gpu::Program> mSplat, mClip;
  std::map<std::pair<bool, bool>, gpu::Program> mFocus;
  gpu::Program mArguments, mPyramid, mSeen, mFlood, mShown;
};

/// Which instances a pass over all instances takes.
enum class CullPhase { SeenBefore, Others, All };

/// The nearest ball of all instances in each pixel of a view: its depth along the view, its instance and its number.
/// Drawn by compute shaders, as most balls cover only a pixel or two ([VE] 2.2; Differs: there they are rasterised).
/// Cost: a look at each instance, twice; the pixels of all balls of seen instances, twice; four bytes of depth a pixel
/// for the pyramid. GL thread.
///
/// A view is drawn by: begin(); cull() all instances for SeenBefore; drawList() for their depths; makePyramid(); cull()
/// for Others; drawList(); and, where owners are wanted, drawList() for both phases once more, then noteSeen(). The
/// result does not depend on which instances were seen before; knowing them only makes it faster.
class InstanceTarget {
 public:
  /// @param hasOwners  the target also keeps which instance and ball are in each pixel, not only their depth
  InstanceTarget(const char* label, bool hasOwners) : mLabel(label), mHasOwners(hasOwners) {}

  /// @param instances  instances of one copy. Where their number changes, it is forgotten which instances were seen
  /// before.
  void resize(glm::ivec2 size, std::uint32_t instances, int copies);
  /// Forgets which instances were seen before; to be called for another model.
  void forget();
  glm::ivec2 size() const { return mSize; }

  void begin(const shared::InstanceView& view);
  /// All parts of a phase; for SeenBefore the parts count words of 32 instances over all copies. @param most  about how
  /// many instances a part has at most
  std::vector<InstancePart> partsOf(CullPhase phase, std::uint32_t most) const;
  /// Callers must have bound the frame's cuts and spares, or its InstanceStates.
  void cull(InstancePrograms& programs, CullBy by, CullPhase phase, const InstancePart& part);
  /// To be called when all parts of a phase are culled: completes its lists.
  void closeLists(InstancePrograms& programs, CullPhase phase);
  /// How many groups each list of a phase takes. Waits for the GPU.
  std::array<std::uint32_t, 4> groupCounts(CullPhase phase) const;
  /// Draws all groups of a list.
  void drawList(InstancePrograms& programs, CullPhase phase, int list, bool owners);
  /// Draws some groups of a list.
  void drawGroups(InstancePrograms& programs, CullPhase phase, int list, bool owners, std::uint32_t first,
                  std::uint32_t count);
  void makePyramid(InstancePrograms& programs);
  void noteSeen(InstancePrograms& programs);

  /// For shaders that read the result: bind the view, the depths as texels, owners and balls as storage blocks.
  void bindView(unsigned binding) const;
  void bindDepths(unsigned unit) const { mDepthTexels.bindSampler(unit); }
  void bindOwners() const;
  const gpu::Buffer& depths() const { return mDepths; }
  const gpu::Buffer& owners() const { return mOwners; }

 private:
  /// The lists of draws of a phase.
  struct Lists {
    gpu::Buffer draws, counts;
    gpu::Texture drawTexels;
  };
  Lists& listsOf(CullPhase phase) { return mLists[phase == CullPhase::Others ? 1 : 0]; }
  const Lists& listsOf(CullPhase phase) const { return mLists[phase == CullPhase::Others ? 1 : 0]; }
  void bindLists(const Lists& lists) const;

  const char* mLabel;
  bool mHasOwners;
  glm::ivec2 mSize{0}, mTiles{0};
  std::uint32_t mInstances = 0, mCount = 0;  ///< Instances of one copy, and of all copies.
  int mCopies = 1;
  gpu::Buffer mView, mDepths, mOwners, mBalls, mSeen, mNearest;
  gpu::Texture mDepthTexels, mPyramid;
  std::array<Lists, 2> mLists;
};

}  // namespace velum::model
