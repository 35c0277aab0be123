// What one sample of the picture adds to the finish: the colour of its lit sphere, and its edges. [ACS] 4.4.
// Differs: edges are looked for in depth and ids, too, not in normals alone, and sample by sample, so that their mean is
// smooth.
layout(local_size_x = 8, local_size_y = 8) in;

#include "render/finish.glsl"

layout(binding = kSampleUnit) uniform usampler2D sampleTexture;
layout(binding = kLitSphereUnit) uniform sampler2D litSphereTexture;
layout(binding = kSphereOfUnit) uniform usamplerBuffer sphereOf;
layout(binding = kFinishImage, rgba32f) uniform image2D finishImage;  // rgb: lit spheres, premultiplied; a: edges; sums of all samples

layout(location = 0) uniform ivec4 tile;   // x, y: corner in the image; z, w: its size
layout(location = 1) uniform int isFirst;  // 1: nothing is there yet

// A jump of depth begins to count where it is longer than so many voxels, which noise moves surfaces by, and so many pixels.
const float kStepVoxels = 2.5;
const float kStepPixels = 3.0;
// How far a normal turns between two sides of a pixel before it is a crease. Noise bends them within a side, too.
const float kLeastCrease = 0.35;
const float kFullCrease = 0.95;

vec3 litSphereAt(Sample s) {
  float size = float(kSphereTexels);
  uint row = texelFetch(sphereOf, min(int(s.structure), textureSize(sphereOf) - 1)).r;
  vec2 at = clamp((vec2(s.normal.x, -s.normal.y) * 0.5 + 0.5) * size, 0.5, size - 0.5);
  return textureLod(litSphereTexture, vec2(at.x, at.y + float(row) * size) / vec2(size, size * float(finish.sphereRows)), 0.0).rgb;
}

/// Depths that lie on a plane have none. @param bend  second difference of depths
float jumpOf(vec2 bend, float depth) {
  bool isFlat = hasFlag(kFlagOrthographic);
  float along = isFlat ? depth : 1.0 / max(depth, 1e-9);
  float pixel = 2.0 * length(frame.up.xyz) / frame.pictureSize.y * (isFlat ? 1.0 : along);
  float least = max(kStepVoxels / frame.voxelsPerLength, kStepPixels * pixel * float(finish.reach));
  return smoothstep(least, 2.0 * least, length(bend) * (isFlat ? 1.0 : along * along));
}

/// How much the normal turns across the pixel, less what it does along either side.
float creaseOf(vec2 n[9]) {
  vec2 across = (n[2] + 2.0 * n[5] + n[8] - n[0] - 2.0 * n[3] - n[6]) * 0.25;
  vec2 down = (n[6] + 2.0 * n[7] + n[8] - n[0] - 2.0 * n[1] - n[2]) * 0.25;
  vec2 left = n[0] - 2.0 * n[3] + n[6];
  vec2 right = n[2] - 2.0 * n[5] + n[8];
  vec2 top = n[0] - 2.0 * n[1] + n[2];
  vec2 bottom = n[6] - 2.0 * n[7] + n[8];
  float rough = 0.25 * sqrt(dot(left, left) + dot(right, right) + dot(top, top) + dot(bottom, bottom));
  return smoothstep(kLeastCrease, kFullCrease, sqrt(dot(across, across) + dot(down, down)) - rough);
}

/// The edges next to a pixel by Sobel's kernel: of the outline, between structures, of depth and normals; 0..1.
float edgeAt(ivec2 pixel, Sample centre) {
  ivec2 last = textureSize(sampleTexture, 0) - 1;
  float own = solidity(centre);
  vec2 outline = vec2(0.0);
  vec2 between = vec2(0.0);
  vec2 bend = vec2(0.0);
  vec2 n[9];
  for (int i = 0; i < 9; ++i) {
    ivec2 to = ivec2(i % 3 - 1, i / 3 - 1);
    Sample s = unpackSample(texelFetch(sampleTexture, clamp(pixel + to * finish.reach, ivec2(0), last), 0));
    float solid = solidity(s);
    vec2 weight = vec2(to) * (2.0 - vec2(abs(to.yx)));
    bool same = isSame(s, centre);
    bool both = min(own, solid) > 0.5;
    outline += weight * solid;
    between += weight * (same ? 0.0 : min(own, solid));
    vec2 axis = vec2(to.y == 0 ? 1.0 : 0.0, to.x == 0 ? 1.0 : 0.0);
    bend += both ? axis * (s.depth - centre.depth) : vec2(0.0);
    n[i] = both && same ? s.normal : centre.normal;
  }
  // A jump next to the outline is the outline's.
  float edge = finish.steps * max(0.25 * length(outline), own * jumpOf(bend, centre.depth) * (dot(outline, outline) > 0.0 ? 0.0 : 1.0));
  edge = max(edge, finish.structures * 0.25 * length(between));
  return min(max(edge, finish.creases * own * creaseOf(n)), 1.0);
}

void main() {
  ivec2 inTile = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(inTile, tile.zw))) return;
  ivec2 pixel = tile.xy + inTile;
  Sample centre = unpackSample(texelFetch(sampleTexture, pixel, 0));
  vec4 sum = vec4(0.0);
  if (finish.litSphere > 0.0) sum.rgb = litSphereAt(centre) * centre.opacity;
  if (finish.contours > 0.0) sum.a = edgeAt(pixel, centre);
  if (isFirst == 0) sum += imageLoad(finishImage, pixel);
  imageStore(finishImage, pixel, sum);
}
