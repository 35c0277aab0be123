// Farthest depths of tiles of pixels, then of tiles of these. A level's last texels hold what is left over by halving.
layout(local_size_x = 8, local_size_y = 8) in;

#include "model/instances.glsl"

layout(binding = kDepthUnit) uniform usamplerBuffer depthTexture;
layout(binding = kPyramidUnit) uniform sampler2D pyramidTexture;
layout(binding = kPyramidImage, r32f) uniform writeonly image2D levelImage;

layout(location = 0) uniform int level;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = max(ivec2(view.tilesX, view.tilesY) >> level, ivec2(1));
  if (any(greaterThanEqual(at, size))) return;
  float farthest = 0.0;
  if (level == 0) {
    ivec2 from = at * kPyramidTile;
    ivec2 to = min(from + kPyramidTile, view.size);
    uint bits = 0u;
    // Bits of positive numbers are in their order, and those of nothing come last.
    for (int y = from.y; y < to.y; ++y)
      for (int x = from.x; x < to.x; ++x) bits = max(bits, texelFetch(depthTexture, y * view.size.x + x).r);
    farthest = bits == kNoDepth ? kCutFar : uintBitsToFloat(bits);
  } else {
    ivec2 before = max(ivec2(view.tilesX, view.tilesY) >> (level - 1), ivec2(1));
    ivec2 from = min(2 * at, before - 1);
    ivec2 to = ivec2(at.x == size.x - 1 ? before.x - 1 : 2 * at.x + 1, at.y == size.y - 1 ? before.y - 1 : 2 * at.y + 1);
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x) farthest = max(farthest, texelFetch(pyramidTexture, ivec2(x, y), level - 1).r);
  }
  imageStore(levelImage, at, vec4(farthest));
}
