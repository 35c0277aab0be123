// The light grid's second step: for each cell near material, how much of the key light reaches it (r) and how open its
// surroundings are (g). Cells far from any material are not looked at: nobody shades there.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

#include "common/frame.glsl"

layout(binding = kLightExtinctionUnit) uniform sampler3D extinctionTexture;
layout(binding = kLightImage, rg8) uniform image3D lightImage;

layout(location = 0) uniform int firstLayer;    // z of the first cells
layout(location = 1) uniform int keepsOpenness; // 1: no turn of the light changes it
layout(location = 2) uniform vec4 keyTex;       // step of one cell size towards the key light, in grid texture coordinates
layout(location = 3) uniform vec4 cellTex;      // one cell size along each texture axis, in grid texture coordinates
layout(location = 4) uniform float reachCells;  // of occlusion

/// Mean extinction of so many cells around a place: who takes long steps over single cells meets some of a row of them
/// and misses others, and the shadow's edge is a saw.
float extinctionAround(vec3 tex, float cells) {
  if (any(lessThan(tex, vec3(0.0))) || any(greaterThan(tex, vec3(1.0)))) return 0.0;
  return textureLod(extinctionTexture, tex, log2(max(cells, 1.0))).r;
}
float extinctionAt(vec3 tex) { return extinctionAround(tex, 1.0); }

/// How many steps of a cell's size towards the key light it is from a place to where the box ends.
float cellsToEnd(vec3 tex) {
  vec3 d = mix(keyTex.xyz, vec3(1e-9), lessThan(abs(keyTex.xyz), vec3(1e-9)));
  vec3 exit = (step(0.0, d) - tex) / d;
  return min(exit.x, min(exit.y, exit.z));
}

/// Of a step, what is looked at around its middle: neighbours overlap still, and a surface shades itself less than by
/// all of it.
const float kWide = 0.75;

/// Transmittance towards the key light, up to the end of the box; steps grow, so that a far blocker costs no more than a
/// near one.
float shadowAt(vec3 tex, int steps) {
  float end = cellsToEnd(tex);
  float depth = 0.0;
  float from = 1.0;
  float stride = 1.0;
  for (int i = 0; i < steps; ++i) {
    float to = min(from + stride, end);
    if (to <= from || depth > 5.0) break;
    depth += extinctionAround(tex + 0.5 * (from + to) * keyTex.xyz, kWide * (to - from)) * (to - from) * frame.lightCell;
    from = to;
    stride = min(stride * 1.12, 4.0);
  }
  return exp(-depth);
}

/// Mean transmittance to the occlusion reach over 14 directions (faces and corners of a cube).
float opennessAt(vec3 tex, int directions) {
  float sum = 0.0;
  for (int i = 0; i < directions; ++i) {
    vec3 d = i < 6 ? vec3(i >> 1 == 0, i >> 1 == 1, i >> 1 == 2) * ((i & 1) == 0 ? 1.0 : -1.0)
                   : (vec3((i - 6) & 1, (i - 6) >> 1 & 1, (i - 6) >> 2) * 2.0 - 1.0) * 0.57735;
    float depth = 0.0;
    float stride = reachCells / 4.0;
    for (int k = 0; k < 4; ++k) depth += extinctionAt(tex + d * cellTex.xyz * (stride * (float(k) + 0.6) + 0.7));
    sum += exp(-depth * stride * frame.lightCell);
  }
  return clamp(sum / 14.0 * 1.6, 0.0, 1.0);
}

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, firstLayer);
  ivec3 grid = ivec3(frame.lightGrid.xyz);
  if (any(greaterThanEqual(cell, grid))) return;
  vec3 tex = (vec3(cell) + 0.5) / vec3(grid);
  float near = 0.0;
  vec3 lean = vec3(0.0);  // towards the material
  for (int i = 0; i < 8; ++i) {
    vec3 corner = vec3(i & 1, i >> 1 & 1, i >> 2) * 2.0 - 1.0;
    float extinction = extinctionAt(tex + corner * 1.6 / vec3(grid));
    near += extinction;
    lean += corner * extinction;
  }
  // The cells along a slanting surface lie in steps. Light that starts next to the surface meets more of it on one step
  // than on the next, which shows as rings; what starts a cell farther off meets as much on all of them. Between two
  // surfaces there is nowhere to go, and fog has no surface.
  vec3 away = -lean / max(near, 1e-6) * min(0.25 * near * frame.lightCell, 1.0);
  vec3 from = tex + away / max(length(away), 1.0) * cellTex.xyz;
  // Counts of 0 instead of branches: a software driver runs both sides of a branch, but leaves a loop early.
  bool isShadowed = near > 0.0 && frame.shadowStrength > 0.0;
  bool isOccluded = near > 0.0 && frame.occlusionStrength > 0.0;
  bool isKept = keepsOpenness != 0;
  float shadow = shadowAt(from, isShadowed ? 40 : 0);
  float openness = opennessAt(from, isOccluded && !isKept ? 14 : 0);
  openness = isKept ? imageLoad(lightImage, cell).g : isOccluded ? openness : 1.0;
  imageStore(lightImage, cell, vec4(shadow, openness, 0.0, 0.0));
}
