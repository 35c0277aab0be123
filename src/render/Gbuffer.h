#pragma once
#include <glm/glm.hpp>

#include "core/Image.h"
#include "gpu/Framebuffer.h"
#include "gpu/Texture.h"
#include "render/FrameData.h"
#include "render/Renderer.h"

namespace velum::render {

/// What each pixel of a window shows. Written by the ray caster, read by all that comes after it: the picture, layers,
/// picking. Colours are of all samples so far; the rest is of the first, through the pixel's middle. GL thread.
class Gbuffer {
 public:
  /// Makes pictures of a size; what they hold is lost where it is another.
  /// @param keepsSample  with that of what the sample shows that is cast
  void resize(glm::ivec2 size, bool keepsSample);
  void clear();
  glm::ivec2 size() const { return glm::ivec2(mColor.size()); }
  explicit operator bool() const { return bool(mColor); }
  /// As images of a dispatch: kColorImage, kSurfaceImage, kIdImage, kSampleImage.
  void bindImages() const;
  const gpu::Texture& color() const { return mColor; }
  /// Structure; instance + 1, 0: nothing is seen.
  const gpu::Texture& ids() const { return mIds; }
  /// What is seen as samplers: kPictureIdUnit, kPictureSurfaceUnit.
  void bindSamplers() const;
  /// What the sample shows that was cast last, as render/sample.glsl packs it: kSampleUnit.
  void bindSample() const { mSample.bindSampler(shared::kSampleUnit); }

  /// The layers of Renderer::read after a picture's own channels. Waits for the GPU.
  void appendLayers(const FrameData& data, const Layers& layers, Image& image) const;
  /// What is in a pixel. Waits for the GPU.
  Pick pick(const FrameData& data, glm::ivec2 pixel) const;
  /// The type of the model that each pixel shows; -1: none. Waits for the GPU.
  std::vector<std::int32_t> typesOfPixels(const FrameData& data) const;

 private:
  gpu::Texture mColor;    ///< Premultiplied, the sum of the samples so far.
  gpu::Texture mSurface;  ///< Normal, scene frame; distance along the ray.
  gpu::Texture mIds;      ///< Structure; instance + 1, 0: nothing is seen.
  gpu::Texture mSample;   ///< None where the frame has no finish.
};

}  // namespace velum::render
