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

/// Which instances are drawn: what cuts leave, worked out as they are culled, with sheets among the cuts or without;
/// what InstanceStates has left; what it has removed and shows as ghosts.
enum class CullBy { Cuts, Membranes, States, Ghosts };

/// What the program is compiled for that culls: by what; of what was seen before, or of all else.
gpu::Defines cullDefines(CullBy by, bool isOfSeen);
/// And those of InstanceStates.
gpu::Defines focusDefines(bool hasMembranes, bool isOfOccluders);

/// Some instances of some copies: a range of those of one copy.
struct InstancePart {
  std::uint32_t first = 0, end = 0;
  int firstCopy = 0, copies = 1;
};
/// All of them. @param most  in a part, about
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

  /// What a picture shows.
  struct Need {
    CullBy by = CullBy::Cuts;
    bool hasMembranes = false, hasFocus = false, hasGhosts = false;
  };
  /// Has the programs for it compiled side by side, see gpu::Program. @return true when all of them are
  bool compile(const Need& need);

 private:
  std::map<std::pair<CullBy, bool>, gpu::Program> mCull;
  std::map<bool, gpu::Program> mSplat, mClip;
  std::map<std::pair<bool, bool>, gpu::Program> mFocus;
  gpu::Program mArguments, mPyramid, mSeen, mFlood, mShown;
};

/// Which instances a pass over all of them takes.
enum class CullPhase { SeenBefore, Others, All };

/// What of instances is nearest in each pixel of a view: depth along the view, instance, ball. Drawn by compute, as
/// most balls are of a pixel or two ([VE] 2.2; Differs: there they are rasterised). Cost: one look at each instance,
/// twice; balls of what is seen times their pixels, twice; four bytes of depth a pixel for the pyramid. GL thread.
///
/// A view is drawn by: begin(); cull() all instances for SeenBefore; drawLists() their depths; makePyramid(); cull()
/// for Others; drawLists(); and, where owners are wanted, drawLists() of both once more, then noteSeen(). Whatever was
/// seen before, the result is the same; it only comes sooner.
class InstanceTarget {
 public:
  /// @param hasOwners  who is in each pixel, not only how far it is
  InstanceTarget(const char* label, bool hasOwners) : mLabel(label), mHasOwners(hasOwners) {}

  /// @param instances  of one copy. What was seen before is forgotten where these are others.
  void resize(glm::ivec2 size, std::uint32_t instances, int copies);
  /// Forgets what was seen before: another model.
  void forget();
  glm::ivec2 size() const { return mSize; }

  void begin(const shared::InstanceView& view);
  /// All parts of a phase; of SeenBefore they are of words of 32 instances over all copies. @param most  of one of
  /// them, about
  std::vector<InstancePart> partsOf(CullPhase phase, std::uint32_t most) const;
  /// The frame's cuts and spares, or its InstanceStates, are bound.
  void cull(InstancePrograms& programs, CullBy by, CullPhase phase, const InstancePart& part);
  /// Lists of a phase are complete.
  void closeLists(InstancePrograms& programs, CullPhase phase);
  /// Groups that a list of a phase takes. Waits for the GPU.
  std::array<std::uint32_t, 4> groupCounts(CullPhase phase) const;
  /// All groups of a list, as many as there are.
  void drawList(InstancePrograms& programs, CullPhase phase, int list, bool owners);
  /// Some of them.
  void drawGroups(InstancePrograms& programs, CullPhase phase, int list, bool owners, std::uint32_t first,
                  std::uint32_t count);
  void makePyramid(InstancePrograms& programs);
  void noteSeen(InstancePrograms& programs);

  /// For who reads the result: the view, depths as texels, owners and balls as blocks.
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
  std::uint32_t mInstances = 0, mCount = 0;  ///< Of a copy, of all.
  int mCopies = 1;
  gpu::Buffer mView, mDepths, mOwners, mBalls, mSeen, mNearest;
  gpu::Texture mDepthTexels, mPyramid;
  std::array<Lists, 2> mLists;
};

}  // namespace velum::model
