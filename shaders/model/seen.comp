// A bit for each instance that some pixel shows.
layout(local_size_x = 64) in;

#include "shared/bindings.h"
#include "shared/instance.h"
#include "common/line.glsl"

layout(std430, binding = kOwnerBinding) readonly buffer OwnerBlock { uint owners[]; };
layout(std430, binding = kSeenBinding) buffer SeenBlock { uint seen[]; };

layout(location = 0) uniform int pixelCount;

void main() {
  int at = int(lineThread());
  if (at >= pixelCount) return;
  uint owner = owners[at];
  // Neighbours mostly show the same.
  if (owner == kNoInstance || (at > 0 && owners[at - 1] == owner)) return;
  uint bit = 1u << (owner & 31u);
  if ((seen[owner >> 5] & bit) == 0u) atomicOr(seen[owner >> 5], bit);
}
