// The end of a step: velocities from the corrected places ([PBD], algorithm line 13), and the largest speed.
#include "shared/cloth.h"
layout(local_size_x = kClothGroup, local_size_y = kClothGroup) in;

layout(std140, binding = kClothBinding) uniform ClothBlock { ClothParams cloth; };
layout(std430, binding = kPlaceBinding) buffer PlaceBlock { vec4 places[]; };
layout(std430, binding = kVelocityBinding) writeonly buffer VelocityBlock { vec4 velocities[]; };
#if ALONG
layout(std430, binding = kFromBinding) readonly buffer FromBlock { float corrected[]; };
#else
layout(std430, binding = kFromBinding) readonly buffer FromBlock { vec4 corrected[]; };
#endif
layout(std430, binding = kRestBinding) buffer RestBlock { uint fastest; };

layout(location = 0) uniform int measures;
layout(location = 1) uniform vec4 pace;  // share of the way

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, cloth.grid.xy))) return;
  int i = at.y * cloth.grid.x + at.x;
#if ALONG
  vec3 place = vec3(places[i].xy, corrected[i]);
#else
  vec3 place = corrected[i].xyz;
#endif
  place = mix(places[i].xyz, place, pace.x);
  vec3 velocity = (place - places[i].xyz) / cloth.step.x;
  velocities[i] = vec4(velocity, 0.0);
  places[i].xyz = place;
  if (measures != 0) atomicMax(fastest, floatBitsToUint(length(velocity)));
}
