// Phong with a soft hemisphere, shadow and occlusion from the light grid.
#include "common/frame.glsl"

layout(binding = kLightUnit) uniform sampler3D lightTexture;  // r: light that reaches a cell, g: openness of its surroundings

/// Where the light on a surface is looked up, in texture coordinates of the light grid: off the material, so that no cell
/// that is in part material is asked, whose share changes along a surface like wood grain.
/// @param steepness  1: there is a surface, 0: fog
vec3 lightTexAt(vec3 scenePoint, vec3 normal, float steepness) {
  return (frame.texFromScene * vec4(scenePoint + normal * ((1.0 + 0.5 * steepness) * frame.lightCell), 1.0)).xyz;
}

/// @param normal  unit, out of the material; towardsEye unit; tex as lightTexAt()
vec3 shadeSurface(vec3 albedo, vec3 normal, vec3 towardsEye, vec3 tex) {
  if (!hasFlag(kFlagShaded)) return albedo;
  float shadow = 1.0;
  float openness = 1.0;
  if (hasFlag(kFlagLightGrid)) {
    vec2 grid = textureLod(lightTexture, tex, 0.0).rg;
    shadow = mix(1.0, grid.r, frame.shadowStrength);
    openness = mix(1.0, grid.g, frame.occlusionStrength);
  }
  float sky = 0.7 + 0.3 * dot(normal, frame.pictureUp.xyz);
  float lambert = max(dot(normal, frame.keyLight.xyz), 0.0);
  vec3 halfway = normalize(frame.keyLight.xyz + towardsEye);
  float highlight = pow(max(dot(normal, halfway), 0.0), frame.shininess) * step(1e-4, lambert);
  // Light that has passed through material is warm, as in tissue.
  vec3 ambient = albedo * (frame.ambient * sky * openness);
  vec3 diffuse = albedo * (frame.diffuse * lambert * shadow * mix(1.0, openness, 0.5));
  return ambient + diffuse + vec3(frame.specular * highlight * shadow);
}
