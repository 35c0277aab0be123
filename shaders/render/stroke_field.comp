// The direction of strokes in each cell, smoothed over its neighbours, and first phases.
layout(local_size_x = 8, local_size_y = 8) in;

#include "render/strokes.glsl"

layout(binding = kStrokeUnit) uniform sampler2D turnTexture;
layout(binding = kStrokeImage, rgba32f) uniform writeonly image2D strokeImage;

const int kReach = 3;

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  if (cell.x >= finish.cellsX || cell.y >= finish.cellsY) return;
  vec4 sum = vec4(0.0);
  for (int j = -kReach; j <= kReach; ++j)
    for (int i = -kReach; i <= kReach; ++i) {
      ivec2 at = clamp(cell + ivec2(i, j), ivec2(0), ivec2(finish.cellsX, finish.cellsY) - 1);
      sum += texelFetch(turnTexture, at, 0) * exp(-0.25 * float(i * i + j * j));
    }
  vec3 tensor = sum.xyz / max(sum.w, 1e-6);
  // What is flat is hatched from lower left to upper right, as right hands do.
  tensor += 0.03 * vec3(1.0, -1.0, 1.0);
  // Strokes go along the stronger curvature, round the form; their phase grows across it.
  float along = 0.5 * atan(2.0 * tensor.y, tensor.x - tensor.z);
  vec2 across = vec2(-sin(along), cos(along));
  vec2 middle = cellMiddle(cell);
  float wave = kTurn / finish.strokePixels;
  imageStore(strokeImage, cell, vec4(across, mod(wave * vec2(dot(middle, across), dot(middle, crossed(across))), kTurn)));
}
