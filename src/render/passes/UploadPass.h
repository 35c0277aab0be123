#pragma once
#include <memory>
#include <optional>

#include "gpu/Context.h"
#include "render/FrameData.h"
#include "render/passes/Pass.h"
#include "render/residency/Residency.h"
#include "render/upload/CutSheets.h"
#include "render/upload/LabelBricks.h"
#include "render/upload/LabelUpload.h"
#include "render/upload/ShareUpload.h"
#include "render/upload/VolumeUpload.h"

namespace velum::render {

/// Brings the data of a scene to the GPU: the volume slab by slab, those labels that have changed, and the sheets of
/// membranes. The key of a volume is VolumeKey; labels and sheets keep keys of their own.
class UploadPass : public Pass {
 public:
  /// @param data  with the memory that those data may take that can be shown coarser
  UploadPass(const gpu::Limits& limits, const gpu::Limits& data)
      : Pass("Upload"), mLimits(data), mLabels(limits), mShares(limits), mBricks(data) {}

  void prepare(FrameData& data) override;
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  void bind(const FrameData& data) const override;
  void took(double ms) override { mMs += ms; }

  /// Called when all steps are done: fills in `data` what there is to draw, and brings labels and sheets.
  void complete(FrameData& data);
  /// Time of the last upload of a volume.
  double ms() const { return mMs; }
  /// Time of uploads for this frame alone.
  double frameMs() const { return mMs - mMsBefore; }
  std::size_t labelBytes() const { return mLabelBytes; }
  /// In words for people: of a frame with label bricks, how much coarser they are drawn; else empty.
  std::string labelShortfall(const FrameData& data) const { return data.hasLabelBricks ? mBricks.shortfall() : ""; }

 private:
  struct Uploaded {
    VolumeKey key;
    GpuVolume volume;                      ///< Of a volume that is not streamed.
    std::unique_ptr<Residency> residency;  ///< Of one that is; else nullptr.
  };
  const Uploaded* drawnFor(const FrameData& data) const;
  bool stepWhole();
  void startWhole(const scene::VolumeLayer& layer, const VolumeKey& key);

  gpu::Limits mLimits;
  std::optional<Uploaded> mWhole, mQuick;  ///< mQuick is for previews until mWhole is there.
  std::unique_ptr<VolumeUpload> mUpload;
  std::unique_ptr<Residency> mStreamed;  ///< On its way, as mUpload.
  VolumeKey mUploadKey;
  LabelUpload mLabels;
  ShareUpload mShares;
  LabelBricks mBricks;  ///< Instead of mShares and the texture of mLabels, where the volume is streamed.
  std::size_t mLabelBytes = 0;
  CutSheets mSheets;
  gpu::Texture mNoVolume, mNoLabels, mNoShares;
  gpu::Buffer mNoCells;
  double mMs = 0, mMsBefore = 0;
};

}  // namespace velum::render
