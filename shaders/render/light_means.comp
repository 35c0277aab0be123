// Means of the light grid's extinction over cells twice as long, from one level to the next. Drivers that are asked to
// make levels leave out the last cell of an odd number, or share it out, as they like: shadows would lie elsewhere with each.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

#include "shared/frame.h"

layout(binding = kLightExtinctionUnit) uniform sampler3D extinctionTexture;
layout(binding = kLightImage, r32f) uniform writeonly image3D meanImage;

layout(location = 0) uniform int level;  // that is made

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID);
  ivec3 size = imageSize(meanImage);
  if (any(greaterThanEqual(cell, size))) return;
  // The cells of the level before that it lies over, those at its ends by their share.
  vec3 perCell = vec3(textureSize(extinctionTexture, level - 1)) / vec3(size);
  vec3 from = vec3(cell) * perCell;
  vec3 to = from + perCell;
  ivec3 first = ivec3(from + 1e-3);
  ivec3 last = ivec3(to - 1e-3);
  float sum = 0.0;
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x) {
        vec3 share = min(to, vec3(x, y, z) + 1.0) - max(from, vec3(x, y, z));
        sum += texelFetch(extinctionTexture, ivec3(x, y, z), level - 1).r * share.x * share.y * share.z;
      }
  imageStore(meanImage, cell, vec4(sum / (perCell.x * perCell.y * perCell.z)));
}
