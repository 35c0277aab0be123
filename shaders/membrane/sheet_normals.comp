// Indexing a sheet, first step: the normals of its particles, and no mesh counted yet.
layout(local_size_x = 64) in;

#include "membrane/sheet.glsl"

/// Twice the area of a triangle of three particles, along its normal; 0 where one of them is beyond the rim.
vec3 areaOf(ivec2 a, ivec2 b, ivec2 c) {
  ivec2 low = min(a, min(b, c));
  ivec2 high = max(a, max(b, c));
  if (any(lessThan(low, ivec2(0))) || any(greaterThanEqual(high, particles.xy))) return vec3(0.0);
  vec3 p = sheetRows[a.y * particles.x + a.x].xyz;
  return cross(sheetRows[b.y * particles.x + b.x].xyz - p, sheetRows[c.y * particles.x + c.x].xyz - p);
}

void main() {
  int v = theParticle(false);
  if (v < 0) return;
  ivec2 at = ivec2(v % particles.x, v / particles.x);
  // The six triangles around a particle, counterclockwise.
  vec3 sum = areaOf(at, at + ivec2(1, 0), at + ivec2(1, 1)) + areaOf(at, at + ivec2(1, 1), at + ivec2(0, 1)) +
             areaOf(at, at + ivec2(0, 1), at + ivec2(-1, 0)) + areaOf(at, at + ivec2(-1, 0), at + ivec2(-1, -1)) +
             areaOf(at, at + ivec2(-1, -1), at + ivec2(0, -1)) + areaOf(at, at + ivec2(0, -1), at + ivec2(1, 0));
  float len = length(sum);
  sheetRows[particles.x * particles.y + v] = vec4(len > 0.0 ? sum / len : vec3(0.0, 0.0, 1.0), 0.0);
  counts[v] = 0u;
  if (v == 0) counts[particles.x * particles.y] = 0u;
}
