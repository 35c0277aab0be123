// What one sample of the picture adds to the finish: the colour of its lit sphere [LITSPHERE], and its edges. [ACS] 4.4.
// Differs: edges are looked for in depth and ids, too, not in normals alone, and sample by sample, so that their mean is
// smooth.
//
// MODEL is there when all that is seen is a model of molecules.
layout(local_size_x = 8, local_size_y = 8) in;

#include "render/finish.glsl"

layout(binding = kSampleUnit) uniform usampler2D sampleTexture;
layout(binding = kLitSphereUnit) uniform sampler2D litSphereTexture;
layout(binding = kSphereOfUnit) uniform usamplerBuffer sphereOf;
layout(binding = kFinishImage, rgba32f) uniform image2D finishImage;  // rgb: lit spheres, premultiplied; a: edges; sums of all samples

layout(location = 0) uniform ivec4 tile;   // x, y: corner in the image; z, w: its size
layout(location = 1) uniform int isFirst;  // 1: nothing is there yet

#ifdef MODEL
#include "render/edges_model.glsl"
#else
#include "render/edges_data.glsl"
#endif

// Sizes between which lit spheres come to show a form, pixels of a picture of 1000 rows, or of a smaller one. What is small has
// none of its own: light and shade on each of many would be grain.
const float kNoForm = 8.0, kFullForm = 40.0;

vec3 litSphereAt(Sample s) {
  float size = float(kSphereTexels);
  uint row = texelFetch(sphereOf, min(int(s.ids & 0xffffu), textureSize(sphereOf) - 1)).r;
  float form = smoothstep(kNoForm, kFullForm, s.size);
  vec2 at = clamp((form * vec2(s.normal.x, -s.normal.y) * 0.5 + 0.5) * size, 0.5, size - 0.5);
  return textureLod(litSphereTexture, vec2(at.x, at.y + float(row) * size) / vec2(size, size * float(finish.sphereRows)), 0.0).rgb;
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
