// Where the samples of a picture lie in a pixel.
#include "render/FrameSetup.h"

#include <gtest/gtest.h>

#include <cmath>

namespace velum::render {
namespace {

TEST(FrameSetup, ThePicturesOfFewSamplesAreNotDisplaced) {
  for (int samples = 1; samples <= 64; ++samples) {
    Frame frame;
    frame.pictureSize = {40, 30};
    frame.scene.rayCast.samplesPerPixel = samples;
    shared::FrameParams params{};
    params.texFromScene = glm::mat4(1.0f);
    glm::dvec2 sum(0.0);
    for (int sample = 0; sample < samples; ++sample) {
      setSample(params, frame, sample);
      glm::dvec2 place(params.subpixel);
      if (sample == 0) {
        EXPECT_EQ(place, glm::dvec2(0.0)) << "layers and counts are of a pixel's middle";
      }
      EXPECT_LT(std::max(std::abs(place.x), std::abs(place.y)), 0.75);
      sum += place;
    }
    EXPECT_LT(glm::length(sum) / samples, 1e-6) << samples;
  }
}

}  // namespace
}  // namespace velum::render
