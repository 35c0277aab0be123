#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "gpu/Buffer.h"
#include "gpu/Context.h"
#include "gpu/Texture.h"
#include "model/CopySlots.h"
#include "model/InstanceSet.h"
#include "model/InstanceTarget.h"
#include "render/FrameData.h"
#include "render/passes/Pass.h"
#include "shared/instance.h"

namespace velum::render {

/// Holds what the passes that work on a model's instances share: the model on the GPU, whose key is the model, its
/// levels and its place; the rows of its types for each frame; the programs. Draws nothing itself.
class ModelPass : public Pass {
 public:
  explicit ModelPass(const gpu::Limits& limits)
      : Pass("Model"), mIsSoftware(limits.isSoftware), mMostTexels(limits.textureBuffer) {}
  void prepare(FrameData& data) override;
  void compile(const FrameData& data) override;
  bool isReady() override;
  void addSteps(const FrameData&, int, WorkQueue&) override {}
  void bind(const FrameData& data) const override;

  /// The programs of another one, see FrameWork::takePrograms().
  void takePrograms(ModelPass& other) { std::swap(mPrograms, other.mPrograms); }
  /// True when the frame has a model.
  bool isDrawn() const { return mKey.has_value(); }
  /// What the frame needs: by what instances are culled, and whether some cut is a membrane or keeps instances in view.
  const model::InstancePrograms::Need& need() const { return mNeed; }
  /// True when the frame needs to know what becomes of each instance, which StatePass finds out.
  bool hasStates() const { return isDrawn() && mNeed.by == model::CullBy::States; }
  model::InstancePrograms& programs() { return mPrograms; }
  /// Which copies have slots in the frame, and how many numbers instances take.
  const model::CopySlots& copies() const { return mCopies; }
  const model::InstanceRoom& instanceRoom() const { return mRoom; }
  /// The eye's view in a sample of the picture.
  shared::InstanceView eyeView(const FrameData& data, int sample) const;
  /// [types][enabled cuts]
  const std::vector<shared::TypeSpareRow>& spareRows() const { return mSpareRows; }
  bool isSoftware() const { return mIsSoftware; }
  /// About how many instances a dispatch looks at.
  std::uint32_t atATime() const;
  /// How many instances a list of draws may have room for.
  std::uint32_t listRoom() const;

 private:
  struct Key {
    std::uint64_t model = 0, levels = 0;
    model::Placement placement;
    bool isCrowd = false;
    bool operator==(const Key&) const = default;
  };
  void checkCount(const scene::ModelLayer& layer) const;
  Shared<LevelSet> levelsOf(const scene::ModelLayer& layer);
  void writeRows(const FrameData& data);
  void placeCopies(const FrameData& data);

  const bool mIsSoftware;
  const std::size_t mMostTexels;  ///< Most texels of a buffer's texture.
  model::InstancePrograms mPrograms;
  model::InstancePrograms::Need mNeed;
  bool mHidesTypes = false;  ///< some type is switched off
  std::optional<Key> mKey;
  Shared<LevelSet> mOwnLevels;  ///< Levels made here for a model that came without.
  std::uint64_t mOwnLevelsOf = 0;
  model::InstanceSet mSet;
  model::InstanceRoom mRoom;
  model::CopySlots mCopies;
  std::vector<shared::TypeSpareRow> mSpareRows;
  gpu::Buffer mTypes, mTypeSpares;
  gpu::Texture mTypeTexels, mTypeSpareTexels;
};

}  // namespace velum::render
