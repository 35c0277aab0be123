// What one sample shows in a pixel, as the finish wants it: four words.
#include "common/frame.glsl"

/// One sample of a pixel.
struct Sample {
  vec2 normal;      // as the eye sees it: to the right, up; unit with its third part, which is towards the eye
  float depth;      // perspective: one over the distance along the line of sight; orthographic: that distance. Planes are straight
  uint ids;         // the structure; from bit 16 eight bits of what a line goes around
  float opacity;    // 0: nothing is seen
  float solid;      // opacity of a voxel of what is seen
};

#ifdef FINISH
Sample unpackSample(uvec4 words) {
  float opacity = max(float(words.w >> 24) - 1.0, 0.0) / 254.0;
  return Sample(unpackSnorm2x16(words.x), uintBitsToFloat(words.z), words.w & 0xffffffu, opacity, uintBitsToFloat(words.y));
}
#else
/// @param group  what a line goes around: the instance, or several that are too small for one each
uvec4 packSample(Ray ray, Hit hit, uint group) {
  bool found = hit.distance < kFar && hit.color.a > 0.0;
  // The frame of the pixel's own line of sight: what is seen edge-on is the rim of the lit sphere all over the picture.
  vec3 toEye = -ray.direction;
  vec3 right = normalize(frame.right.xyz - toEye * dot(frame.right.xyz, toEye));
  vec3 up = cross(toEye, right);
  vec3 normal = dot(hit.normal, toEye) < 0.0 ? -hit.normal : hit.normal;
  float along = max(hit.distance * dot(ray.direction, frame.forward.xyz), 1e-9);
  float depth = hasFlag(kFlagOrthographic) ? along : 1.0 / along;
  uint opacity = uint(clamp(hit.color.a, 0.0, 1.0) * 254.0 + 0.5) + 1u;
  // Instances of models have larger numbers than fit: neighbours hardly ever come to the same.
  uint number = group < 256u ? group : group * 0x9e3779b1u >> 24;
  uint ids = hit.structure & 0xffffu | number << 16 | min(opacity, 255u) << 24;
  vec2 seen = vec2(dot(normal, right), dot(normal, up));
  return found ? uvec4(packSnorm2x16(seen), floatBitsToUint(hit.solid), floatBitsToUint(depth), ids) : uvec4(0u);
}
#endif
