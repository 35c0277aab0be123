// The frame's uniforms and the rays of its pixels.
#include "shared/frame.h"

// NVIDIA's compiler unrolls loops whose ends it does not know, each of those within each other, and takes two to four times
// as long (see "On a GPU" in docs/PERFORMANCE.md).
#ifdef NOT_UNROLLED
#pragma optionNV(unroll none)
#endif

layout(std140, binding = kFrameBinding) uniform FrameBlock { FrameParams frame; };

// Programs that read the data are compiled for their frame's flags, other than switches (see DataVariant).
#ifdef FLAGS
bool hasFlag(uint bit) { return (((bit & kSwitches) != 0u ? frame.flags : FLAGS) & bit) != 0u; }
#else
bool hasFlag(uint bit) { return (frame.flags & bit) != 0u; }
#endif

struct Ray {
  vec3 origin;
  vec3 direction;  // unit
};

/// The ray through a position of the whole picture, in pixels from its top left corner.
Ray rayThrough(vec2 pixel) {
  vec2 at = vec2(2.0, -2.0) * pixel / frame.pictureSize + vec2(-1.0, 1.0);
  vec3 across = at.x * frame.right.xyz + at.y * frame.up.xyz;
  if (hasFlag(kFlagOrthographic)) return Ray(frame.eye.xyz + across, frame.forward.xyz);
  return Ray(frame.eye.xyz, normalize(frame.forward.xyz + across));
}
