#include "session/film/SubFrames.h"

#include <utility>

#include "core/Assert.h"
#include "core/ImageChannels.h"

namespace velum::session {

double subFrameShare(int subFrame, int subFrames, double shutter) {
  return ((subFrame + 0.5) / subFrames - 0.5) * shutter;
}

void MeanImage::add(const Image& image, bool isMiddle) {
  VELUM_ASSERT(mSum.empty() || mSum.size() == image.pixels.size(), "pictures of a frame have one size");
  mSum.resize(image.pixels.size());
  for (const ColorChannels& of : colorsOf(image))
    for (std::size_t at = 0; at < mSum.size(); at += image.channels.size()) {
      float alpha = of.alpha < 0 ? 1.0f : image.pixels[at + std::size_t(of.alpha)];
      for (std::size_t c : of.color) mSum[at + c] += image.pixels[at + c] * alpha;
      if (of.alpha >= 0) mSum[at + std::size_t(of.alpha)] += alpha;
    }
  if (isMiddle) mMiddle = image;
  ++mCount;
}

Image MeanImage::mean() {
  Image out = std::move(mMiddle);
  if (mCount < 2) return out;
  for (const ColorChannels& of : colorsOf(out))
    for (std::size_t at = 0; at < mSum.size(); at += out.channels.size()) {
      float weight = of.alpha < 0 ? float(mCount) : mSum[at + std::size_t(of.alpha)];
      for (std::size_t c : of.color) out.pixels[at + c] = weight > 0.0f ? mSum[at + c] / weight : 0.0f;
      if (of.alpha >= 0) out.pixels[at + std::size_t(of.alpha)] = weight / float(mCount);
    }
  return out;
}

}  // namespace velum::session
