// Instances of a model as a view sees them.
#include "shared/bindings.h"
#include "shared/instance.h"

layout(std140, binding = kInstanceViewBinding) uniform InstanceViewBlock { InstanceView view; };
layout(binding = kInstanceUnit) uniform samplerBuffer instanceTexture;
layout(binding = kMoleculeUnit) uniform samplerBuffer moleculeTexture;
layout(binding = kLevelUnit) uniform usamplerBuffer levelTexture;
layout(binding = kBallUnit) uniform samplerBuffer ballTexture;

/// Where an instance stands.
struct Place {
  vec3 position;
  vec4 rotation;
  int molecule;
};

/// From the first copy to another one. Software drivers divide thread by thread: who has one copy does not ask.
vec3 copyShift(int copy) {
  if (view.copies == 1) return vec3(0.0);
  int layer = copy / (view.copiesX * view.copiesY);
  int inLayer = copy - layer * view.copiesX * view.copiesY;
  int line = inLayer / view.copiesX;
  return vec3(inLayer - line * view.copiesX, line, layer) * view.copyStep.xyz;
}

/// @param row  of the instances of a copy
Place placeIn(int row, vec3 shift) {
  vec4 first = texelFetch(instanceTexture, 2 * row);
  return Place(first.xyz + shift, texelFetch(instanceTexture, 2 * row + 1), int(floatBitsToUint(first.w)));
}

/// @param instance  over all copies
Place placeOf(uint instance) {
  if (view.copies == 1) return placeIn(int(instance), vec3(0.0));
  int copy = int(instance / uint(view.instanceCount));
  return placeIn(int(instance) - copy * view.instanceCount, copyShift(copy));
}

MoleculeRow moleculeAt(int molecule) {
  MoleculeRow row;
  row.sphere = texelFetch(moleculeTexture, 3 * molecule);
  uvec4 words = floatBitsToUint(texelFetch(moleculeTexture, 3 * molecule + 1));
  row.type = words.x;
  row.firstLevel = words.y;
  row.levelCount = words.z;
  row.reach = uintBitsToFloat(words.w);
  vec4 outline = texelFetch(moleculeTexture, 3 * molecule + 2);
  row.outlineLevel = floatBitsToUint(outline.x);
  row.outlineGrow = outline.y;
  return row;
}

LevelRow levelAt(uint level) {
  uvec4 words = texelFetch(levelTexture, int(level));
  return LevelRow(words.x, words.y, uintBitsToFloat(words.z), uintBitsToFloat(words.w));
}

/// The pixels of the window whose rays may meet a sphere: x, y from; z, w to, in pixels. @param q  its middle as seen from the eye
vec4 pixelsOf(vec3 q, float radius) {
  float depth = dot(q, view.forward.xyz);
  vec2 half_ = vec2(length(view.right.xyz), length(view.up.xyz));
  vec2 at = vec2(dot(q, view.right.xyz), dot(q, view.up.xyz)) / half_;
  vec2 low = at - radius;
  vec2 high = at + radius;
  if (view.isOrthographic == 0) {
    vec2 root = radius * sqrt(max(at * at + depth * depth - radius * radius, 0.0));
    float below = max(depth * depth - radius * radius, 1e-30);
    low = (at * depth - root) / below;
    high = (at * depth + root) / below;
  }
  // Rows run downwards.
  vec2 from = vec2(low.x, -high.y) / half_;
  vec2 to = vec2(high.x, -low.y) / half_;
  return (vec4(from, to) * 0.5 + 0.5) * view.pictureSize.xyxy - view.shift.xyxy;
}

/// The ray of a pixel of the window; its depth grows by one with each length of it. @param offset  of its beginning from the eye
vec3 rayOf(ivec2 pixel, out vec3 offset) {
  vec2 at = vec2(2.0, -2.0) * (vec2(pixel) + view.shift) / view.pictureSize + vec2(-1.0, 1.0);
  vec3 across = at.x * view.right.xyz + at.y * view.up.xyz;
  offset = view.isOrthographic != 0 ? across : vec3(0.0);
  return view.isOrthographic != 0 ? view.forward.xyz : view.forward.xyz + across;
}

/// Depth at which a ray meets a ball; below 0 where it does not. By the point of the ray next to the middle: differences of
/// squared distances from the eye would leave nothing of a small ball.
float ballDepth(vec3 q, float radius, vec3 offset, vec3 ray) {
  precise vec3 toMiddle = q - offset;
  precise float squared = dot(ray, ray);
  precise float nearest = dot(toMiddle, ray) / squared;
  precise vec3 aside = toMiddle - nearest * ray;
  precise float left = radius * radius - dot(aside, aside);
  precise float depth = nearest - sqrt(max(left, 0.0) / squared);
  return left >= 0.0 ? depth : -1.0;
}

/// Pixels that a length takes at a depth.
float pixelsPerLength(float depth) {
  float perLength = 0.5 * view.pictureSize.y / length(view.up.xyz);
  return view.isOrthographic != 0 ? perLength : perLength / max(depth, 1e-6);
}
