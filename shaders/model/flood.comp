// How far each pixel of a focus's mask lies from its edge: jump flooding [JFA] from the pixels that are none of it.
layout(local_size_x = 8, local_size_y = 8) in;

#include "shared/bindings.h"
#include "shared/instance.h"

layout(std140, binding = kFocusViewBinding) uniform FocusBlock { FocusView focus; };
layout(std430, binding = kSeedBinding) writeonly buffer SeedBlock { uint seedsOut[]; };
layout(std430, binding = kReachBinding) buffer ReachBlock { uint longest; };
layout(binding = kMaskUnit) uniform usamplerBuffer maskTexture;
layout(binding = kSeedUnit) uniform usamplerBuffer seedTexture;

layout(location = 0) uniform int step_;   // pixels; 0: seeds are laid
layout(location = 1) uniform int isLast;  // 1: the longest distance is found, too

/// The nearest of the seeds that a pixel and eight about it have.
uint nearestSeed(ivec2 pixel, int at) {
  uint seed = texelFetch(seedTexture, at).r;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      ivec2 from = pixel + step_ * ivec2(x, y);
      if (x == 0 && y == 0) continue;
      bool isIn = all(greaterThanEqual(from, ivec2(0))) && all(lessThan(from, focus.size));
      if (isIn) seed = nearerSeed(pixel, seed, texelFetch(seedTexture, from.y * focus.size.x + from.x).r);
    }
  return seed;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  bool isIn = all(lessThan(pixel, focus.size));
  int at = pixel.y * focus.size.x + pixel.x;
  uint bits = isIn ? texelFetch(maskTexture, at).r : 0u;
  bool isInMask = bits != 0u && bits != kNoDepth;
  if (step_ == 0 && isIn) seedsOut[at] = isInMask ? kNoSeed : uint(pixel.x) | uint(pixel.y) << 16;
  // All others are their own seeds, and stay that. As a loop, of which no compiler knows that it has one turn at most:
  // software drivers leave a loop when no thread is in it, and run what stands under a condition all the same.
  int turns = isInMask && step_ != 0 ? focus.hasAperture : 0;
  for (int turn = 0; turn < turns; ++turn) {
    uint seed = nearestSeed(pixel, at);
    seedsOut[at] = seed;
    if (isLast != 0) atomicMax(longest, floatBitsToUint(focusDistance(pixel, seed)));
  }
}
