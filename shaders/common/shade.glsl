// Phong with a soft hemisphere, shadow and occlusion from the light grid.
#include "common/frame.glsl"

layout(binding = kLightUnit) uniform sampler3D lightTexture;  // r: light that reaches a cell, g: openness of its surroundings

/// @param normal  unit, out of the material; towardsEye unit; tex 0..1 in the light grid, already off the surface
vec3 shadeSurface(vec3 albedo, vec3 normal, vec3 towardsEye, vec3 tex) {
  if (!hasFlag(kFlagShaded)) return albedo;
  float shadow = 1.0;
  float openness = 1.0;
  if (hasFlag(kFlagLightGrid)) {
    vec2 grid = textureLod(lightTexture, tex, 0.0).rg;
    shadow = mix(1.0, grid.r, frame.key.w);
    openness = mix(1.0, grid.g, frame.hemisphere.w);
  }
  float sky = 0.7 + 0.3 * dot(normal, frame.hemisphere.xyz);
  float lambert = max(dot(normal, frame.key.xyz), 0.0);
  vec3 halfway = normalize(frame.key.xyz + towardsEye);
  float highlight = pow(max(dot(normal, halfway), 0.0), frame.light.w) * step(1e-4, lambert);
  // Light that has passed through material is warm, as in tissue.
  vec3 ambient = albedo * (frame.light.x * sky * openness);
  vec3 diffuse = albedo * (frame.light.y * lambert * shadow * mix(1.0, openness, 0.5));
  return ambient + diffuse + vec3(frame.light.z * highlight * shadow);
}
