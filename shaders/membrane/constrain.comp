// One pass over all constraints: each particle gathers what its own ask of it (Jacobi), so that no order of threads
// matters. Stretch on every mesh edge, both diagonals of a mesh among them; bending of every pair of adjacent triangles,
// summed up beforehand (it is linear, see BendStencil); both also over strides of 2, 4, ... particles, which makes
// a fine mesh as stiff as a coarse one. Then what may not be: leaving the rest plane's box, or the room between protected
// structures. ALONG 1: particles move along the normal only, and their height is all that is passed on. What limits it are
// loads: 8 a stride for stretching, twice 25 for bending, which is why only some passes bend.
#include "shared/cloth.h"
layout(local_size_x = kClothGroup, local_size_y = kClothGroup) in;

#if ALONG
#define PLACE float
#define HEIGHT(place) place
#else
#define PLACE vec4
#define HEIGHT(place) place.z
#endif

layout(std140, binding = kClothBinding) uniform ClothBlock { ClothParams cloth; };
layout(std430, binding = kPlaceBinding) readonly buffer PlaceBlock { vec4 places[]; };
layout(std430, binding = kFromBinding) readonly buffer FromBlock { PLACE from[]; };
layout(std430, binding = kToBinding) writeonly buffer ToBlock { PLACE to[]; };
layout(std430, binding = kRoomBinding) readonly buffer RoomBlock { vec2 room[]; };
layout(std430, binding = kBendBinding) readonly buffer BendBlock { float bend[]; };

layout(location = 0) uniform int bends;

#if ALONG
float stretchOf(ivec2 at, float place, int stride) {
  vec2 mesh = 2.0 * cloth.halfSize.xy / vec2(cloth.grid.xy - 1);
  float sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    int cell = i < 4 ? i : i + 1;  // around the middle of nine
    ivec2 other = clamp(at + stride * (ivec2(cell % 3, cell / 3) - 1), ivec2(0), cloth.grid.xy - 1);
    vec2 inPlane = vec2(other - at) * mesh;
    float rest2 = max(dot(inPlane, inPlane), 1e-12 * dot(mesh, mesh));
    float d = from[other.y * cloth.grid.x + other.x] - place;
    bool isHeld = any(equal(other, ivec2(0))) || any(equal(other, cloth.grid.xy - 1));
    sum += d * (1.0 - inversesqrt((rest2 + d * d) / rest2)) * (isHeld ? 1.0 : 0.5);
  }
  return sum / 8.0;
}
#else
vec3 stretchOf(ivec2 at, vec4 place, int stride) {
  vec2 mesh = 2.0 * cloth.halfSize.xy / vec2(cloth.grid.xy - 1);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 8; ++i) {
    int cell = i < 4 ? i : i + 1;
    ivec2 other = clamp(at + stride * (ivec2(cell % 3, cell / 3) - 1), ivec2(0), cloth.grid.xy - 1);
    vec3 way = stretchCorrection(place, from[other.y * cloth.grid.x + other.x], length(vec2(other - at) * mesh));
    sum += other != at ? way : vec3(0.0);
  }
  return sum / 8.0;
}
#endif

PLACE bendOf(ivec2 at, int level) {
  int stride = 1 << level;
  int row = bendClass(at.y, cloth.grid.y, stride) * kBendClasses + bendClass(at.x, cloth.grid.x, stride);
  int first = row * kStencil * kStencil;
  PLACE sum = PLACE(0.0);
  for (int y = 0; y < kStencil; ++y)
    for (int x = 0; x < kStencil; ++x) {
      // Outside the weight is 0.
      ivec2 other = clamp(at + stride * (ivec2(x, y) - kStencil / 2), ivec2(0), cloth.grid.xy - 1);
      sum += bend[first + y * kStencil + x] * from[other.y * cloth.grid.x + other.x];
    }
  return sum;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, cloth.grid.xy))) return;
  int i = at.y * cloth.grid.x + at.x;
  PLACE place = from[i];
  if (places[i].w > 0.0) {
    PLACE way = PLACE(0.0);
    for (int level = 0; level < cloth.grid.w; ++level) {
#if ALONG
      way += cloth.stretch[level].x * stretchOf(at, place, 1 << level);
#else
      way.xyz += cloth.stretch[level].x * stretchOf(at, place, 1 << level);
#endif
      if (bends != 0) way -= cloth.stretch[level].y * bendOf(at, level);
    }
#if ALONG
    place += way;
#else
    place.xyz = clamp(place.xyz + way.xyz, -cloth.halfSize.xyz, cloth.halfSize.xyz);
#endif
    HEIGHT(place) = clamp(HEIGHT(place), max(room[i].x, -cloth.halfSize.z), min(room[i].y, cloth.halfSize.z));
  }
  to[i] = place;
}
