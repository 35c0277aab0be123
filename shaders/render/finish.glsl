// What all of the finish's shaders read.
#include "shared/finish.h"
#include "render/sample.glsl"

layout(std140, binding = kFinishBinding) uniform FinishBlock { FinishParams finish; };

// Opacity of a voxel: a haze has less, in which it is chance how deep a ray is half lost, a surface more.
const float kHaze = 0.04;
const float kSurface = 0.12;

/// How far something counts as a surface: what is thin has no edges, nor has a haze, however deep.
float solidity(Sample s) { return clamp(3.0 * s.opacity - 0.8, 0.0, 1.0) * smoothstep(kHaze, kSurface, s.solid); }

/// Sizes in a pixel: they are in pixels of a picture of 1000 rows, or of a smaller one.
float unitsOfSizes() { return min(finish.unitsPerPixel, 1.0); }

// Sizes between which strokes come to follow the form and to be as dark as it is, in distances from stroke to stroke.
const float kNoRoom = 3.0, kFullRoom = 8.0;

/// How far what is seen has room for strokes, 0..1: on what is small they would be all that is seen.
float roomOf(Sample s) {
  float inStrokes = s.size / (finish.strokePixels * unitsOfSizes());
  return s.opacity > 0.0 ? smoothstep(kNoRoom, kFullRoom, inStrokes) : 1.0;
}

bool isSame(Sample a, Sample b) { return a.ids == b.ids && a.moreIds == b.moreIds; }

uint hashOf(uvec2 p) {
  uint h = p.x * 0x8da6b343u ^ p.y * 0xd8163841u;
  h = (h ^ h >> 15) * 0x2c1b3c6du;
  h = (h ^ h >> 12) * 0x297a2d39u;
  return h ^ h >> 15;
}

float randomOf(ivec2 p) { return float(hashOf(uvec2(p)) >> 8) / 16777216.0; }

/// Smooth noise, 0..1, of wavelength 2.
float noiseAt(vec2 p) {
  vec2 whole = floor(p);
  vec2 part = p - whole;
  part = part * part * (3.0 - 2.0 * part);
  ivec2 at = ivec2(whole);
  float low = mix(randomOf(at), randomOf(at + ivec2(1, 0)), part.x);
  float high = mix(randomOf(at + ivec2(0, 1)), randomOf(at + ivec2(1, 1)), part.x);
  return mix(low, high, part.y);
}
