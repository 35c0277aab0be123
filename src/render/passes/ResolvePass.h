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

/// Makes a picture from a Gbuffer: means of the samples, with the finish, in front of the background or on paper. Not
/// one of a frame's steps: it is done whenever the picture is looked at, complete or not. GL thread.
class ResolvePass {
 public:
  /// The programs of another one, see FrameWork::takePrograms().
  void takePrograms(ResolvePass& other) { std::swap(mPrograms, other.mPrograms); }
  /// The caller must have bound the frame's parameters. @param fine  in floats; else in 256 levels, with noise that
  /// hides the steps of the background
  void draw(const FrameData& data, const Gbuffer& gbuffer, const FinishPass& finish, const GhostPass& ghosts,
            const PictureProgress& progress, bool fine);
  /// Shows the picture in a window's framebuffer, scaled, upright.
  void present(unsigned framebuffer, glm::ivec2 size) const { gpu::present(mTarget, framebuffer, size); }
  /// The picture: R, G, B, A; display-referred, straight alpha. Waits for the GPU.
  Image read() const;

 private:
  ProgramCache<ResolveVariant> mPrograms;
  gpu::Texture mPicture;
  gpu::Framebuffer mTarget;
  bool mIsFine = false;
};

}  // namespace velum::render
