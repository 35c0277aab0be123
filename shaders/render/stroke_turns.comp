// Which way the surface turns in each cell of strokes, from the normals of a sample: how much they change along x and y.
layout(local_size_x = 8, local_size_y = 8) in;

#include "render/finish.glsl"

layout(binding = kSampleUnit) uniform usampler2D sampleTexture;
layout(binding = kStrokeImage, rgba32f) uniform writeonly image2D turnImage;  // xx, xy, yy of the cell's tensor; its weight

layout(location = 0) uniform ivec2 windowOrigin;

const int kAlong = 5;  // places along an edge of twice the cell

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  if (cell.x >= finish.cellsX || cell.y >= finish.cellsY) return;
  vec2 middle = (vec2(cell + ivec2(finish.firstCellX, finish.firstCellY)) + 0.5) * finish.cellPixels - vec2(windowOrigin);
  ivec2 last = textureSize(sampleTexture, 0) - 1;
  vec3 tensor = vec3(0.0);
  float weight = 0.0;
  float room = 0.0;
  for (int j = 0; j < kAlong - 1; ++j)
    for (int i = 0; i < kAlong - 1; ++i) {
      vec2 at = middle + (vec2(i, j) - 2.0) * 0.5 * finish.cellPixels;
      Sample a = unpackSample(texelFetch(sampleTexture, clamp(ivec2(at), ivec2(0), last), 0));
      Sample b = unpackSample(texelFetch(sampleTexture, clamp(ivec2(at + vec2(0.5 * finish.cellPixels, 0.0)), ivec2(0), last), 0));
      Sample c = unpackSample(texelFetch(sampleTexture, clamp(ivec2(at + vec2(0.0, 0.5 * finish.cellPixels)), ivec2(0), last), 0));
      float solid = min(solidity(a), min(solidity(b), solidity(c)));
      vec2 x = b.normal - a.normal;
      vec2 y = c.normal - a.normal;
      // What turns at once is an edge, not a bend.
      bool bends = isSame(a, b) && isSame(a, c) && dot(x, x) < 0.8 && dot(y, y) < 0.8;
      tensor += bends ? solid * vec3(dot(x, x), dot(x, y), dot(y, y)) : vec3(0.0);
      weight += bends ? solid : 0.0;
      room += bends ? solid * roomOf(a) : 0.0;
    }
  tensor /= max(weight, 1.0);
  // What is small has no form that strokes could go round.
  room /= max(weight, 1e-6);
  // A sharp bend says no more of directions than a clear one.
  float share = room * room / (tensor.x + tensor.z + 0.004);
  imageStore(turnImage, cell, vec4(tensor * share, 1.0) * min(weight, 4.0));
}
