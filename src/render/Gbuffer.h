#pragma once
#include <glm/glm.hpp>

#include "core/Image.h"
#include "gpu/Framebuffer.h"
#include "gpu/Texture.h"
#include "render/FrameData.h"
#include "render/Renderer.h"

namespace velum::render {

/// What each pixel of a window shows. Written by the ray caster, read by all later steps: the picture, layers, picking.
/// Colours are summed over all samples so far; the rest is that of the first sample, whose ray goes through the pixel's
/// middle. GL thread.
class Gbuffer {
 public:
  /// Makes the textures of a size; their contents are lost where the size changes.
  /// @param keepsSample  with the texture of what the sample being cast shows
  void resize(glm::ivec2 size, bool keepsSample);
  void clear();
  /// Keeps the sums of the samples so far, and brings them back in a rectangle: x, y of its corner; width, height.
  void keepColor();
  void restoreColor(glm::ivec4 rect) { mColor.copyFrom(mKept, {rect.x, rect.y, 0}, {rect.z, rect.w, 1}); }
  glm::ivec2 size() const { return glm::ivec2(mColor.size()); }
  explicit operator bool() const { return bool(mColor); }
  /// Binds them as images of a dispatch: kColorImage, kSurfaceImage, kIdImage, kSampleImage.
  void bindImages() const;
  const gpu::Texture& color() const { return mColor; }
  /// Structure; instance + 1, 0: nothing is seen.
  const gpu::Texture& ids() const { return mIds; }
  /// Binds ids and surface as samplers: kPictureIdUnit, kPictureSurfaceUnit.
  void bindSamplers() const;
  /// Binds what the sample cast last shows, as packed by render/sample.glsl: kSampleUnit.
  void bindSample() const { mSample.bindSampler(shared::kSampleUnit); }

  /// Appends the layers of Renderer::read() to an image, after its own channels. Waits for the GPU.
  void appendLayers(const FrameData& data, const Layers& layers, Image& image) const;
  /// What a pixel shows. Waits for the GPU.
  Pick pick(const FrameData& data, glm::ivec2 pixel) const;
  /// What each pixel shows. Waits for the GPU.
  PixelIds idsOfPixels(const FrameData& data, bool withDistances) const;

 private:
  gpu::Texture mColor;    ///< Premultiplied, the sum of the samples so far.
  gpu::Texture mKept;     ///< The sums as they were; no texture before somebody keeps them.
  gpu::Texture mSurface;  ///< Normal, scene frame; distance along the ray.
  gpu::Texture mIds;      ///< Structure, with the face of a cut; instance + 1, 0: nothing is seen: see shared/frame.h.
  gpu::Texture mSample;   ///< What the last sample shows; no texture where the frame has no finish.
};

}  // namespace velum::render
