// Chebyshev distance of every cell to the nearest with content, one axis at a time, up to kReach cells.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

#include "common/frame.glsl"

layout(binding = 0, rg8ui) uniform readonly uimage3D fromImage;
layout(binding = 1, rg8ui) uniform writeonly uimage3D toImage;
layout(location = 0) uniform ivec4 axis;  // xyz: unit step

const int kReach = 12;

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID);
  ivec3 grid = ivec3(frame.cellGrid.xyz);
  if (any(greaterThanEqual(cell, grid))) return;
  uvec2 best = min(imageLoad(fromImage, cell).rg, uvec2(kReach));
  for (int k = 1; k < kReach; ++k) {
    if (uint(k) >= max(best.x, best.y)) break;
    ivec3 a = cell + k * axis.xyz;
    ivec3 b = cell - k * axis.xyz;
    // Outside the grid there is nothing to find.
    uvec2 da = all(lessThan(a, grid)) ? imageLoad(fromImage, a).rg : uvec2(255u);
    uvec2 db = all(greaterThanEqual(b, ivec3(0))) ? imageLoad(fromImage, b).rg : uvec2(255u);
    best = min(best, max(min(da, db), uvec2(k)));
  }
  imageStore(toImage, cell, uvec4(best, 0u, 0u));
}
