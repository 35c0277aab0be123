// How far each pixel of a focus's mask lies from its edge: jump flooding [JFA] from the pixels that are none of it.
layout(local_size_x = 8, local_size_y = 8) in;

#include "shared/bindings.h"
#include "shared/instance.h"

layout(std140, binding = kFocusViewBinding) uniform FocusBlock { FocusView focus; };
layout(std430, binding = kSeedBinding) writeonly buffer SeedBlock { uint seedsOut[]; };
layout(std430, binding = kReachBinding) buffer ReachBlock { uint longest; };
layout(binding = kMaskUnit) uniform usamplerBuffer maskTexture;
layout(binding = kSeedUnit) uniform usamplerBuffer seedTexture;

layout(location = 0) uniform int step_;  // pixels; 0: seeds are laid; -1: the longest distance is found

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, focus.size))) return;
  int at = pixel.y * focus.size.x + pixel.x;
  uint bits = texelFetch(maskTexture, at).r;
  bool isInMask = bits != 0u && bits != kNoDepth;
  if (step_ == 0) {
    seedsOut[at] = isInMask ? kNoSeed : uint(pixel.x) | uint(pixel.y) << 16;
    return;
  }
  uint seed = texelFetch(seedTexture, at).r;
  if (step_ < 0) {
    if (isInMask) atomicMax(longest, floatBitsToUint(focusDistance(pixel, seed)));
    return;
  }
  for (int i = 0; i < 9; ++i) {
    ivec2 from = pixel + step_ * ivec2(i % 3 - 1, i / 3 - 1);
    bool isIn = all(greaterThanEqual(from, ivec2(0))) && all(lessThan(from, focus.size));
    if (isIn) seed = nearerSeed(pixel, seed, texelFetch(seedTexture, from.y * focus.size.x + from.x).r);
  }
  seedsOut[at] = seed;
}
