// What one sample shows in a pixel, as the finish wants it: four words.
#include "common/frame.glsl"

/// One sample of a pixel.
struct Sample {
  vec2 normal;      // as the eye sees it: to the right, up; unit with its third part, which is towards the eye
  float depth;      // perspective: one over the distance along the line of sight; orthographic: that distance. Planes are straight
  uint ids;         // the structure; from bit 16 eight bits of what a line goes around,
  uint moreIds;     // and ten more of these
  float opacity;    // 0: nothing is seen
  float solid;      // opacity of a voxel of what is seen
  float size;       // across what a line goes around, pixels of a picture of 1000 rows, or of a smaller one, up to kLargestSize
};

// Sizes are kept as eighths of a power of two, in six bits.
const float kSmallestSize = 2.0;
const float kLargestSize = 469.0;

#ifdef FINISH
Sample unpackSample(uvec4 words) {
  float opacity = max(float(words.w >> 24) - 1.0, 0.0) / 254.0;
  float size = kSmallestSize * exp2(float(words.y >> 26) / 8.0);
  return Sample(unpackSnorm2x16(words.x), uintBitsToFloat(words.z), words.w & 0xffffffu, words.y >> 16 & 0x3ffu, opacity, unpackHalf2x16(words.y).x, size);
}
#else
/// @param group  what a line goes around: the instance, or several that are too small for one each
/// @param size  across it, pixels of a picture of 1000 rows, or of a smaller one
uvec4 packSample(Ray ray, Hit hit, uint group, float size) {
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
  uint mixed = group * 0x9e3779b1u;
  uint number = group < 256u ? group : mixed >> 24;
  uint more = group < 256u ? 0u : mixed >> 14 & 0x3ffu;
  uint sizeCode = uint(clamp(8.0 * log2(size / kSmallestSize) + 0.5, 0.0, 63.0));
  uint ids = hit.structure & 0xffffu | number << 16 | min(opacity, 255u) << 24;
  vec2 seen = vec2(dot(normal, right), dot(normal, up));
  uint rest = packHalf2x16(vec2(hit.solid, 0.0)) | more << 16 | sizeCode << 26;
  return found ? uvec4(packSnorm2x16(seen), rest, floatBitsToUint(depth), ids) : uvec4(0u);
}
#endif
