// How open the surroundings of what is seen are, at two radii, and how much of the key light comes to it: at one pixel of a few.
// [VE] 8.1. Neighbouring samples of the picture take other pixels.
layout(local_size_x = 8, local_size_y = 8) in;

#include "common/frame.glsl"
#include "common/noise.glsl"
#include "model/instances.glsl"

layout(std140, binding = kInstanceLightBinding) uniform InstanceLightBlock { InstanceView light; };
layout(std140, binding = kInstanceShadeBinding) uniform InstanceShadeBlock { InstanceShade shade; };
layout(binding = kDepthUnit) uniform usamplerBuffer depthTexture;
layout(binding = kShadowUnit) uniform usamplerBuffer shadowTexture;
layout(binding = kOpenImage, rgba32f) uniform writeonly image2D openImage;  // openness, share of the light, depth

layout(location = 0) uniform ivec2 corner;  // of this dispatch

float depthOf(ivec2 pixel) {
  ivec2 at = clamp(pixel, ivec2(0), view.size - 1);
  uint bits = texelFetch(depthTexture, at.y * view.size.x + at.x).r;
  return bits == kNoDepth ? kCutFar : uintBitsToFloat(bits);
}

/// How much of what is around, up to a radius, stands before the surface.
float occlusionAt(ivec2 pixel, float depth, vec3 hit, vec3 normal, float radius, float noise) {
  float pixels = min(radius * pixelsPerLength(depth), kOpenReach * view.pictureSize.y);
  if (pixels < 1.0) return 0.0;
  float sum = 0.0;
  for (int i = 0; i < shade.occlusionTaps; ++i) {
    float r = sqrt((float(i) + 0.5 + 0.4 * (noise - 0.5)) / float(shade.occlusionTaps));
    float turn = 6.2831853 * noise + 2.39996323 * float(i);
    ivec2 at = pixel + ivec2(round(r * pixels * vec2(cos(turn), sin(turn))));
    float there = depthOf(at);
    if (there >= kCutFar) continue;
    vec3 offset;
    vec3 ray = rayOf(at, offset);
    vec3 d = offset + there * ray - hit;
    float far = length(d);
    float rise = dot(d, normal) / max(far, 1e-9);
    sum += clamp((rise - 0.12) * 1.6, 0.0, 1.0) * (1.0 - smoothstep(radius, 2.2 * radius, far));
  }
  return sum / float(shade.occlusionTaps);
}

/// Share of the key light that comes through.
float lightAt(vec3 scenePoint, vec3 normal, float noise) {
  if (shade.hasLight == 0) return 1.0;
  // Off the surface, as far as the light's view is coarse.
  vec3 p = scenePoint + normal * (1.5 * shade.lightTexel) - light.eye.xyz;
  float depth = dot(p, light.forward.xyz) - 2.0 * shade.lightTexel;
  vec2 at = vec2(dot(p, light.right.xyz) / dot(light.right.xyz, light.right.xyz), dot(p, light.up.xyz) / dot(light.up.xyz, light.up.xyz));
  vec2 pixel = (vec2(at.x, -at.y) * 0.5 + 0.5) * light.pictureSize - light.shift;
  float lit = 0.0;
  for (int i = 0; i < 5; ++i) {
    float turn = 6.2831853 * noise + 2.39996323 * float(i);
    ivec2 texel = ivec2(round(pixel + 2.0 * sqrt(float(i) / 5.0) * vec2(cos(turn), sin(turn))));
    bool isInside = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, light.size));
    uint bits = isInside ? texelFetch(shadowTexture, texel.y * light.size.x + texel.x).r : kNoDepth;
    lit += bits == kNoDepth || uintBitsToFloat(bits) >= depth ? 1.0 : 0.0;
  }
  return lit / 5.0;
}

/// The normal of what is seen, as wide as pixels: from depths, so that balls of a coarse level do not show.
vec3 wideNormal(ivec2 pixel, float depth, vec3 hit) {
  vec3 sides[4];
  for (int i = 0; i < 4; ++i) {
    ivec2 at = pixel + 2 * ivec2(i == 0 ? 1 : i == 1 ? -1 : 0, i == 2 ? 1 : i == 3 ? -1 : 0);
    vec3 offset;
    vec3 ray = rayOf(at, offset);
    sides[i] = offset + depthOf(at) * ray - hit;
  }
  vec3 across = dot(sides[0], sides[0]) < dot(sides[1], sides[1]) ? sides[0] : -sides[1];
  vec3 down = dot(sides[2], sides[2]) < dot(sides[3], sides[3]) ? sides[2] : -sides[3];
  vec3 normal = cross(down, across);
  return dot(normal, normal) > 0.0 ? normalize(normal) : -view.forward.xyz;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy) + corner;
  if (any(greaterThanEqual(at, imageSize(openImage)))) return;
  ivec2 pixel = min(at * kOpenStep + shade.openShift, view.size - 1);
  float depth = depthOf(pixel);
  vec4 result = vec4(1.0, 1.0, depth, 0.0);
  if (depth < kCutFar) {
    vec3 offset;
    vec3 ray = rayOf(pixel, offset);
    vec3 hit = offset + depth * ray;
    vec3 toEye = -normalize(ray);
    vec3 normal = wideNormal(pixel, depth, hit);
    normal = normalize(normal * sign(dot(normal, toEye) + 1e-9) + toEye);
    ivec2 inPicture = pixel + ivec2(view.shift);
    float noise = noiseAt(inPicture, shade.noise);
    if (frame.occlusionStrength > 0.0) {
      float near = occlusionAt(pixel, depth, hit, normal, 0.15 * shade.radius, noise);
      float far = occlusionAt(pixel, depth, hit, normal, shade.radius, fract(noise + 0.5));
      result.x = clamp(1.0 - 1.1 * near, 0.0, 1.0) * clamp(1.0 - 1.2 * far, 0.0, 1.0);
    }
    if (frame.shadowStrength > 0.0) result.y = lightAt(hit + view.eye.xyz, normal, noise);
  }
  imageStore(openImage, at, result);
}
