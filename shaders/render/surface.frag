// Opaque surfaces, cut like everything else.
#include "common/frame.glsl"
#include "common/cuts.glsl"
#include "common/shade.glsl"

layout(location = 0) in vec3 scenePoint;
layout(location = 1) in vec3 sceneNormal;
layout(location = 0) out vec4 color;
layout(location = 1) out vec4 aux;  // normal, distance along the ray
layout(location = 2) out uvec4 id;  // structure, instance, what a contour goes around

layout(location = 0) uniform vec4 albedo;  // a: 0 draws it unlit (outlines)
layout(location = 1) uniform int instance;

void main() {
  // Before anything is discarded: neighbours that are gone have no differences.
  vec3 flatNormal = cross(dFdx(scenePoint), dFdy(scenePoint));
  if (albedo.a > 0.0 && !cutsKeep(scenePoint, 0u)) discard;
  vec3 toPoint = hasFlag(kFlagOrthographic) ? frame.forward.xyz : normalize(scenePoint - frame.eye.xyz);
  vec3 normal = length(sceneNormal) > 0.0 ? sceneNormal : flatNormal;
  normal = length(normal) > 0.0 ? normalize(normal) : -toPoint;  // a line has none
  if (dot(normal, toPoint) > 0.0) normal = -normal;
  color = vec4(albedo.a > 0.0 ? shadeSurface(albedo.rgb, normal, -toPoint, lightTexAt(scenePoint, normal, 1.0)) : albedo.rgb, 1.0);
  id = uvec4(0u, uint(instance), uint(instance), 0u);
  aux = vec4(normal, dot(scenePoint - frame.eye.xyz, toPoint));
}
