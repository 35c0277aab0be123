// A tile of blue noise, which repeats over the picture.
#include "shared/frame.h"

layout(std140, binding = kNoiseBinding) uniform NoiseBlock { vec4 noiseTile[kNoiseEdge * kNoiseEdge / 4]; };

/// A pixel's own number, 0..1. @param turn  of the sample: is added, as on a circle
float noiseAt(ivec2 inPicture, float turn) {
  ivec2 at = inPicture & (kNoiseEdge - 1);
  return fract(noiseTile[(at.y * kNoiseEdge + at.x) >> 2][at.x & 3] + turn);
}
