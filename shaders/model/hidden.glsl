// What a pyramid of farthest depths says.
#include "model/instances.glsl"

layout(binding = kPyramidUnit) uniform sampler2D pyramidTexture;

/// The farthest depth in some pixels of the window, or a farther one. @param from, to  both in the window
float farthestIn(ivec2 from, ivec2 to) {
  from /= kPyramidTile;
  to /= kPyramidTile;
  int level = 0;
  while (level + 1 < view.levelCount && any(greaterThan((to >> level) - (from >> level), ivec2(1)))) ++level;
  ivec2 end = max(ivec2(view.tilesX, view.tilesY) >> level, ivec2(1)) - 1;
  from = min(from >> level, end);
  to = min(to >> level, end);
  float farthest = 0.0;
  for (int y = from.y; y <= to.y; ++y)
    for (int x = from.x; x <= to.x; ++x) farthest = max(farthest, texelFetch(pyramidTexture, ivec2(x, y), level).r);
  return farthest;
}
