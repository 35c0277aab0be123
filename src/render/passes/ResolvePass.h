#pragma once
#include "gpu/Framebuffer.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "render/FrameData.h"
#include "render/Gbuffer.h"
#include "render/passes/FinishPass.h"
#include "render/passes/GhostPass.h"
#include "render/passes/ProgramCache.h"
#include "render/passes/RayCastPass.h"

namespace velum::render {

/// From a Gbuffer to a picture: means of samples, finished, before the background or on paper. Not among a frame's
/// steps: it is done whenever somebody looks at the picture, complete or not. GL thread.
class ResolvePass {
 public:
  /// Needs the frame's parameters bound.
  void draw(const FrameData& data, const Gbuffer& gbuffer, const FinishPass& finish, const GhostPass& ghosts,
            const PictureProgress& progress);
  /// Scaled into a window's framebuffer, upright.
  void present(unsigned framebuffer, glm::ivec2 size) const { gpu::present(mTarget, framebuffer, size); }
  /// R, G, B, A; display-referred, straight alpha. Waits for the GPU.
  Image read() const;

 private:
  ProgramCache<ResolveVariant> mPrograms;
  gpu::Texture mPicture;
  gpu::Framebuffer mTarget;
};

}  // namespace velum::render
