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
/// and that show as ghosts; Nearest: all that are looked at.
enum class CullBy { Cuts, Membranes, States, Ghosts, Nearest };

/// The defines of the program that culls: by what it culls, and whether it looks at words of bits of instances or at
/// bundles.
gpu::Defines cullDefines(CullBy by, bool isOfWords);
/// What instances a program draws: those of molecules, or copies as wholes, without or with sheets among the cuts.
enum class DrawOf { Molecules, Wholes, WholesWithMembranes };
gpu::Defines splatDefines(DrawOf of, bool isLarge);
/// What bundles.comp looks at.
enum class ListOf { Bundles, Copies, Blocks };
gpu::Defines listDefines(ListOf of);
/// The defines of the focus program of InstanceStates.
gpu::Defines focusDefines(bool hasMembranes, bool isOfOccluders);

/// How many instances have numbers: those of each copy that has a slot, slot by slot, then, in a crowd, a number for
/// each copy as a whole.
struct InstanceRoom {
  std::uint32_t instances = 0;  ///< of one copy
  int slots = 1;
  int wholes = 0;  ///< 0: copies are no crowd, and each has a slot
  /// The number of the first whole copy: the bits of wholes begin with a word.
  std::uint32_t firstWhole() const { return (instances * std::uint32_t(slots) + 31) / 32 * 32; }
  std::uint32_t count() const {
    return wholes == 0 ? instances * std::uint32_t(slots) : firstWhole() + std::uint32_t(wholes);
  }
  bool operator==(const InstanceRoom&) const = default;
};

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
  const gpu::Program& bundles(ListOf of);
  const gpu::Program& cull(CullBy by, bool isOfWords);
  const gpu::Program& cullWholes(bool isOfWords);
  const gpu::Program& splat(DrawOf of, bool isLarge);
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
    bool isCrowd = false;  ///< Some copies are drawn as wholes.
  };
  /// Starts compiling the programs that a picture needs, side by side, see gpu::Program. @return true when all of them
  /// are
  bool compile(const Need& need);

 private:
  std::map<std::pair<CullBy, bool>, gpu::Program> mCull;
  std::map<ListOf, gpu::Program> mBundles;
  std::map<std::pair<DrawOf, bool>, gpu::Program> mSplat;
  std::map<bool, gpu::Program> mCullWholes, mClip;
  std::map<std::pair<bool, bool>, gpu::Program> mFocus;
  gpu::Program mArguments, mPyramid, mSeen, mFlood, mShown;
};

/// Which instances are looked at: those that were seen last time; all others, bundle by bundle; those that were nearest
/// in some pixel while depths were drawn, and only these can own one. The same of copies that are drawn as wholes,
/// block by block.
enum class CullPhase { SeenBefore, Others, Nearest, SeenWholes, OtherWholes, NearestWholes };
constexpr bool isOfWholes(CullPhase phase) { return phase >= CullPhase::SeenWholes; }
constexpr bool isOfNearest(CullPhase phase) { return phase == CullPhase::Nearest || phase == CullPhase::NearestWholes; }
/// Drawn before there is a pyramid of this view.
constexpr bool isOfSeen(CullPhase phase) { return phase == CullPhase::SeenBefore || phase == CullPhase::SeenWholes; }
constexpr bool isOfOthers(CullPhase phase) { return phase == CullPhase::Others || phase == CullPhase::OtherWholes; }

/// Ranges of copies, or of blocks of them, the nearest first: each is drawn before the next is looked at, and has twice
/// as many. @param most  of a range
std::vector<std::pair<int, int>> copyRounds(int copies, int most = 1 << 30);

/// The nearest ball of all instances in each pixel of a view: its depth along the view, its instance and its number.
/// Drawn by compute shaders, as most balls cover only a pixel or two ([VE] 2.2; Differs: there they are rasterised).
/// Cost: a look at each copy; at each bundle of a copy that may show; at each instance of such a bundle; the pixels of
/// all balls of seen instances, twice; four bytes of depth a pixel for the pyramid. Memory: a few bits an instance, and
/// lists that have room for some instances, which are filled and drawn as often as it takes. GL thread.
///
/// A view is drawn by: begin(); the list of SeenBefore; makePyramid(); then, for each of copyRounds(), listCopies(),
/// listBundles(), the list of Others, makePyramid(); and, where owners are wanted, the list of Nearest, then
/// noteSeen(). In a crowd the lists of wholes come after those of the same kind, and for each of the rounds of blocks
/// listBlocks(), the list of OtherWholes, makePyramid(). A list is drawn by openList(), cull(), closeList() and
/// drawList(). The result does not depend on which instances were seen before; knowing them only makes it faster.
class InstanceTarget {
 public:
  /// @param hasOwners  the target also keeps which instance and ball are in each pixel, not only their depth; else what
  /// was nearest in some pixel counts as seen
  InstanceTarget(const char* label, bool hasOwners) : mLabel(label), mHasOwners(hasOwners) {}

  /// Where the numbers of instances change, it is forgotten which were seen before. @param listRoom  the most instances
  /// that a list may have room for
  void resize(glm::ivec2 size, const InstanceRoom& instances, std::uint32_t listRoom);
  /// Forgets which instances were seen before; to be called for another model.
  void forget();
  glm::ivec2 size() const { return mSize; }
  std::uint32_t bundlesOfCopy() const;
  /// How many blocks of copies a round may have.
  int mostBlocks() const { return int(mRoom) / kCopiesOfBlock; }

  /// @param slots  all that are in use, @param blocks  of copies of which some are drawn as wholes; the nearest first
  void begin(const shared::InstanceView& view, const std::vector<std::uint32_t>& slots,
             const std::vector<std::uint32_t>& blocks);
  /// Lists those of a range of copies with slots that may show, and no bundle.
  void listCopies(InstancePrograms& programs, int first, int end);
  /// Lists those of a range of blocks that may show.
  void listBlocks(InstancePrograms& programs, int first, int end);
  /// How many copies, or blocks, are listed. Waits for the GPU.
  int listedCopies() const;
  /// Lists bundles of a range of the listed copies, which may be longer than the list.
  void listBundles(InstancePrograms& programs, int first, int end);
  /// How many bundles are listed. Waits for the GPU.
  std::uint32_t listedBundles() const;

  /// How many words of 32 instances a phase looks at, or bundles, or blocks, at most.
  /// @param listed  copies, or blocks
  std::uint32_t itemsOf(CullPhase phase, int listed) const;
  /// How many of them a list has room for.
  std::uint32_t itemsOfList(CullPhase phase) const;
  /// Empties the list of draws.
  void openList();
  /// Adds instances to it. Callers must have bound the frame's cuts and spares, or its InstanceStates.
  /// @param first, end  of the phase's items
  void cull(InstancePrograms& programs, CullBy by, CullPhase phase, std::uint32_t first, std::uint32_t end);
  /// To be called when the list is complete.
  void closeList(InstancePrograms& programs);
  /// How many groups each kind of draws takes. Waits for the GPU.
  std::array<std::uint32_t, 4> groupCounts() const;
  /// What is drawn from a list: of which instances, in which phase, of which kind of draws.
  struct Draws {
    DrawOf of = DrawOf::Molecules;
    CullPhase phase = CullPhase::SeenBefore;
    int list = 0;
  };
  /// Draws all groups of a kind.
  void drawList(InstancePrograms& programs, const Draws& draws);
  /// Draws some groups of a kind.
  void drawGroups(InstancePrograms& programs, const Draws& draws, std::uint32_t first, std::uint32_t count);
  void makePyramid(InstancePrograms& programs);
  void noteSeen(InstancePrograms& programs);

  /// For shaders that read the result: bind the view, the depths as texels, owners and balls as storage blocks.
  void bindView(unsigned binding) const;
  void bindDepths(unsigned unit) const { mDepthTexels.bindSampler(unit); }
  void bindOwners() const;
  const gpu::Buffer& depths() const { return mDepths; }
  const gpu::Buffer& owners() const { return mOwners; }

 private:
  static constexpr int kCopiesOfBlock = 64;
  void bindCounts() const;
  const gpu::Program& bindDraws(InstancePrograms& programs, const Draws& draws, std::uint32_t first) const;
  void look(InstancePrograms& programs, ListOf of, glm::ivec2 groups, int first, int end) const;
  void emptyBundles();

  const char* mLabel;
  bool mHasOwners;
  glm::ivec2 mSize{0}, mTiles{0};
  InstanceRoom mInstances;
  std::uint32_t mRoom = 0;  ///< Instances that a list has room for: whole bundles.
  int mSlots = 0;           ///< That are in use.
  int mBlockCount = 0;      ///< Of blocks by their depth.
  gpu::Buffer mView, mDepths, mOwners, mBalls, mSeen, mNearest;
  gpu::Buffer mDraws, mCounts, mBundles;
  gpu::Buffer mOrder, mBlocks;  ///< Slots, and blocks, by their depth, then the listed ones.
  gpu::Texture mDepthTexels, mPyramid, mDrawTexels;
};

}  // namespace velum::model
