// Brings the phases of neighbouring cells together, so that their strokes are one. A step of several.
layout(local_size_x = 8, local_size_y = 8) in;

#include "render/strokes.glsl"

layout(binding = kStrokeUnit) uniform sampler2D strokeTexture;
layout(binding = kStrokeImage, rgba32f) uniform writeonly image2D strokeImage;

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  if (cell.x >= finish.cellsX || cell.y >= finish.cellsY) return;
  vec4 own = texelFetch(strokeTexture, cell, 0);
  float wave = kTurn / finish.strokePixels;
  vec4 sum = vec4(0.0);  // of the first family: cosine, sine; of the second
  for (int i = 0; i < 9; ++i) {
    ivec2 to = ivec2(i % 3 - 1, i / 3 - 1);
    ivec2 at = clamp(cell + to, ivec2(0), ivec2(finish.cellsX, finish.cellsY) - 1);
    Strokes other = towards(texelFetch(strokeTexture, at, 0), own.xy);
    vec2 way = vec2(cell - at) * finish.cellPixels;
    vec2 across = 0.5 * (own.xy + other.across);
    vec2 phase = other.phase + wave * vec2(dot(way, across), dot(way, crossed(across)));
    float weight = exp(-0.5 * float(to.x * to.x + to.y * to.y)) * abs(dot(own.xy, other.across));
    sum += weight * vec4(cos(phase.x), sin(phase.x), cos(phase.y), sin(phase.y));
  }
  vec2 phase = vec2(atan(sum.y, sum.x + 1e-9), atan(sum.w, sum.z + 1e-9));
  imageStore(strokeImage, cell, vec4(own.xy, phase));
}
