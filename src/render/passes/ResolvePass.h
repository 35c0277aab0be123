#pragma once
#include "FinishPass.h"
#include "FrameData.h"
#include "Gbuffer.h"
#include "GhostPass.h"
#include "ProgramCache.h"
#include "RayCastPass.h"
#include "velum/gpu/Framebuffer.h"
#include "velum/gpu/Program.h"
#include "velum/gpu/Texture.h"

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
