// Instances that cuts have removed, over what the picture shows, behind what is nearer. [VE] 8.3.
layout(local_size_x = 8, local_size_y = 8) in;

#include "common/frame.glsl"
#include "model/instances.glsl"

layout(std430, binding = kOwnerBinding) readonly buffer OwnerBlock { uint owners[]; };
layout(std430, binding = kBallBinding) readonly buffer BallBlock { uint balls[]; };
layout(binding = kDepthUnit) uniform usamplerBuffer depthTexture;
layout(binding = kTypeUnit) uniform samplerBuffer typeTexture;
layout(binding = kPictureIdUnit) uniform usampler2D idTexture;
layout(binding = kPictureSurfaceUnit) uniform sampler2D surfaceTexture;
layout(binding = kGhostImage, rgba32f) uniform image2D ghostImage;  // the sum of samples, premultiplied

layout(location = 0) uniform float opacity;
layout(location = 1) uniform ivec2 corner;  // of the dispatch

// Radius in pixels from which on an instance has a line of its own; smaller ones of a type have one together.
const float kLeastOutlined = 4.5;

/// What a line goes around. @return x: by number; y: kType* of it; 0, 0: nothing
uvec2 groupAt(ivec2 pixel) {
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, view.size))) return uvec2(0u);
  int at = pixel.y * view.size.x + pixel.x;
  uint owner = owners[at];
  if (owner == kNoInstance) return uvec2(0u);
  MoleculeRow molecule = moleculeAt(placeOf(owner).molecule);
  float depth = uintBitsToFloat(texelFetch(depthTexture, at).r);
  bool isSmall = molecule.sphere.w * pixelsPerLength(depth) < kLeastOutlined;
  return uvec2(isSmall ? 2u * molecule.type + 2u : 2u * owner + 3u, uint(texelFetch(typeTexture, int(molecule.type)).a));
}

/// The share of its neighbours that are of another one, from where a line shows.
float lineAt(ivec2 pixel, uint group) {
  float others = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 step_ = i < 2 ? ivec2(2 * i - 1, 0) : ivec2(0, 2 * i - 5);
    others += groupAt(pixel + step_).x != group ? 0.5 : 0.0;
  }
  return min(others, 1.0);
}

vec4 ghostAt(ivec2 pixel) {
  uvec2 group = groupAt(pixel);
  if (group.y == 0u) return vec4(0.0);
  int at = pixel.y * view.size.x + pixel.x;
  float depth = uintBitsToFloat(texelFetch(depthTexture, at).r);
  vec3 offset;
  vec3 ray = rayOf(pixel, offset);
  bool isBehind = texelFetch(idTexture, pixel, 0).g != 0u && texelFetch(surfaceTexture, pixel, 0).w < depth * length(ray);
  if (isBehind) return vec4(0.0);
  Place place = placeOf(owners[at]);
  MoleculeRow molecule = moleculeAt(place.molecule);
  vec3 color = texelFetch(typeTexture, int(molecule.type)).rgb;
  float line = lineAt(pixel, group.x);
  // Lines are as strong as three layers of the filling: they are all that there is, or have to be told from it.
  float strong = 1.0 - (1.0 - opacity) * (1.0 - opacity) * (1.0 - opacity);
  if (group.y == uint(kTypeContour)) return vec4(color * 0.45, 1.0) * (line * strong);
  vec4 ball = texelFetch(ballTexture, int(balls[at]));
  vec3 middle = place.position - view.eye.xyz + turned(place.rotation, ball.xyz);
  vec3 normal = (offset + depth * ray - middle) / max(ball.w, 1e-12);
  float lit = 0.75 + 0.25 * clamp(dot(normal, frame.keyLight.xyz), -1.0, 1.0);
  return vec4(mix(color * lit, color * 0.45, 0.6 * line), 1.0) * mix(opacity, strong, 0.6 * line);
}

void main() {
  ivec2 pixel = corner + ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, view.size))) return;
  imageStore(ghostImage, pixel, imageLoad(ghostImage, pixel) + ghostAt(pixel));
}
