// A bit for each instance of the model that some pixel of the finished picture shows.
layout(local_size_x = 8, local_size_y = 8) in;

#include "shared/bindings.h"
#include "shared/instance.h"

layout(std430, binding = kStateBinding) buffer StateBlock { uint states[]; };
layout(binding = kPictureIdUnit) uniform usampler2D idTexture;  // structure; instance + 1

layout(location = 0) uniform int firstInstance;  // the number of the model's first
layout(location = 1) uniform int firstWord;      // of these bits
layout(location = 2) uniform int firstRow;       // of this dispatch

uint instanceIn(ivec2 pixel) {
  uint number = texelFetch(idTexture, pixel, 0).g;
  return number > uint(firstInstance) ? number - 1u - uint(firstInstance) : kNoInstance;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow);
  if (any(greaterThanEqual(pixel, textureSize(idTexture, 0)))) return;
  uint instance = instanceIn(pixel);
  // Neighbours mostly show the same.
  if (instance == kNoInstance || (pixel.x > 0 && instanceIn(pixel - ivec2(1, 0)) == instance)) return;
  uint word = uint(firstWord) + (instance >> 5);
  uint bit = 1u << (instance & 31u);
  if ((states[word] & bit) == 0u) atomicOr(states[word], bit);
}
