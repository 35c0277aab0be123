#pragma once
#include "FrameData.h"
#include "Gbuffer.h"
#include "RayCastPass.h"
#include "velum/gpu/Framebuffer.h"
#include "velum/gpu/Program.h"
#include "velum/gpu/Texture.h"

namespace velum::render {

/// From a Gbuffer to a picture: means of samples, before the background. Not among a frame's steps: it is done whenever
/// somebody looks at the picture, complete or not. GL thread.
class ResolvePass {
 public:
  ResolvePass() : mProgram({"render/resolve.comp"}) {}
  /// Needs the frame's parameters bound.
  void draw(const FrameData& data, const Gbuffer& gbuffer, const PictureProgress& progress);
  /// Scaled into a window's framebuffer, upright.
  void present(unsigned framebuffer, glm::ivec2 size) const { gpu::present(mTarget, framebuffer, size); }
  /// R, G, B, A; display-referred, straight alpha. Waits for the GPU.
  Image read() const;

 private:
  gpu::Program mProgram;
  gpu::Texture mPicture;
  gpu::Framebuffer mTarget;
};

}  // namespace velum::render
