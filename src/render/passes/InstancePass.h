#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "gpu/Buffer.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "model/InstanceSet.h"
#include "model/InstanceStates.h"
#include "model/InstanceTarget.h"
#include "render/FrameData.h"
#include "render/passes/Pass.h"
#include "render/passes/SurfacePass.h"
#include "shared/instance.h"

namespace velum::render {

/// The instances of a model, for rays to stop at: who is nearest in each pixel (model::InstanceTarget), then its
/// colour, light and ids, drawn into the surfaces' target. Every instance is asked of the cuts in every sample of every
/// frame; what is kept is the model on the GPU, with the model, its levels and its place for a key, and which instances
/// were seen last, which changes no picture.
class InstancePass : public Pass {
 public:
  InstancePass(const SurfacePass& surfaces, const gpu::Limits& limits)
      : Pass("Instances"), mSurfaces(surfaces), mIsSoftware(limits.isSoftware), mMostTexels(limits.textureBuffer) {}
  void prepare(FrameData& data) override;
  void compile(const FrameData& data) override;
  bool isReady() override;
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  void bind(const FrameData& data) const override;
  void took(double ms) override;

  /// What of the model is in force in a frame that has some: of it the instances' states are known.
  bool hasStates() const { return mHasStates; }
  model::InstanceStates& states() { return mStates; }
  model::InstancePrograms& programs() { return mPrograms; }
  /// Draws what InstanceStates has removed into a target, as it is seen in a sample; others may, too.
  void addGhosts(model::InstanceTarget& target, const FrameData& data, int sample, WorkQueue& queue);
  /// The rows of the set and of its types.
  void bindRows() const;

 private:
  model::InstancePrograms::Need need() const;
  model::CullBy culledBy() const;
  using Phase = model::CullPhase;
  struct Key {
    std::uint64_t model = 0, levels = 0;
    model::Placement placement;
    bool operator==(const Key&) const = default;
  };
  void makeSet(const FrameData& data);
  void writeRows(const FrameData& data);
  /// Work that counts for nothing in the pace.
  template <class Run>
  void add(WorkQueue& queue, Run run);
  shared::InstanceView viewOf(const FrameData& data, int sample) const;
  void addStates(const FrameData& data, WorkQueue& queue);
  void addFocus(const FrameData& data, const model::FocusRow& row, WorkQueue& queue);
  void addPhase(model::InstanceTarget& target, model::CullBy by, Phase phase, WorkQueue& queue);
  std::uint32_t atATime() const;
  void addDraws(model::InstanceTarget& target, Phase phase, bool owners, WorkQueue& queue);
  bool drawNext(model::InstanceTarget& target, Phase phase, bool owners);
  void beginShading(const FrameData& data, int sample);
  void addStrips(const gpu::Program& program, glm::ivec2 size, WorkQueue& queue);
  void bindShading() const;

  const SurfacePass& mSurfaces;
  const bool mIsSoftware;
  const std::size_t mMostTexels;  ///< Of a buffer.
  model::InstancePrograms mPrograms;
  gpu::Program mOpenness, mShade;
  gpu::Texture mOpen;  ///< Openness, light and depth at one pixel of a few.
  std::optional<Key> mKey;
  Shared<LevelSet> mOwnLevels;  ///< Made here, of a model that came without.
  std::uint64_t mOwnLevelsOf = 0;
  model::InstanceSet mSet;
  std::uint32_t mCount = 0;  ///< Instances of all copies.
  model::InstanceStates mStates;
  bool mHasStates = false, mHasMembranes = false, mHasFocus = false, mHasGhosts = false;
  model::InstanceTarget mEye{"eye's view of instances", true}, mLight{"light's view of instances", false};
  std::vector<shared::TypeSpareRow> mSpareRows;  ///< [types][enabled cuts]
  gpu::Buffer mTypes, mTypeSpares;
  gpu::Texture mTypeTexels, mTypeSpareTexels;
  gpu::UniformBuffer<shared::InstanceView> mLightView{"light's view"};
  gpu::UniformBuffer<shared::InstanceShade> mShadeParams{"shade of instances"};
  shared::InstanceView mLightParams{};
  bool mHasLight = false;
  /// How many groups of a list a software driver draws at a time.
  struct Pace {
    std::uint32_t next = 128;
    bool isKnown = false;
  };
  struct Piece {
    int list;              ///< -1: of none
    std::uint32_t groups;  ///< 0: it counts for nothing
  };
  std::array<Pace, 4> mPace;
  std::deque<Piece> mHandedOver;  ///< What is with the driver.
  /// Where drawing in pieces is.
  struct Place {
    std::array<std::uint32_t, 4> groups{};
    int list = 0;
    std::uint32_t next = 0;
    bool isKnown = false;
  } mPlace;
};

}  // namespace velum::render
