// Instances of a model as a view sees them.
#include "shared/bindings.h"
#include "shared/instance.h"

layout(std140, binding = kInstanceViewBinding) uniform InstanceViewBlock { InstanceView view; };
layout(binding = kInstanceUnit) uniform samplerBuffer instanceTexture;
layout(binding = kMoleculeUnit) uniform samplerBuffer moleculeTexture;
layout(binding = kLevelUnit) uniform usamplerBuffer levelTexture;
layout(binding = kBallUnit) uniform samplerBuffer ballTexture;
layout(binding = kSlotUnit) uniform samplerBuffer slotTexture;

/// Where an instance stands.
struct Place {
  vec3 position;
  vec4 rotation;
  int molecule;
};

bool isCrowd() { return view.firstWhole != kNoInstance; }
bool isWhole(uint instance) { return instance >= view.firstWhole; }

/// From the first copy to that in a slot. Who has one copy does not ask.
vec3 slotShift(int slot) {
  if (view.copies == 1 && !isCrowd()) return vec3(0.0);
  return texelFetch(slotTexture, slot).xyz;
}

/// The number of an instance over all copies, modulo 2^32, whatever slot its copy has: by it is decided who stays.
uint numberOf(int slot, int row) {
  uint copy = isCrowd() ? floatBitsToUint(texelFetch(slotTexture, slot).w) : uint(slot);
  return copy * uint(view.instanceCount) + uint(row);
}

/// From the first copy to another one, by its number.
vec3 copyShift(int copy) {
  int layer = copy / (view.copiesX * view.copiesY);
  int inLayer = copy - layer * view.copiesX * view.copiesY;
  int line = inLayer / view.copiesX;
  return vec3(inLayer - line * view.copiesX, line, layer) * view.copyStep.xyz;
}

/// The first copy of a block along each axis. @param block  its number in the grid of blocks
ivec3 blockOrigin(int block) {
  ivec2 blocks = (ivec2(view.copiesX, view.copiesY) + kBlockEdge - 1) / kBlockEdge;
  int line = block / blocks.x;
  return kBlockEdge * ivec3(block - line * blocks.x, line % blocks.y, line / blocks.y);
}

/// @param row  of the instances of a copy
Place placeIn(int row, vec3 shift) {
  vec4 first = texelFetch(instanceTexture, 2 * row);
  return Place(first.xyz + shift, texelFetch(instanceTexture, 2 * row + 1), int(floatBitsToUint(first.w)));
}

/// @param instance  of those in slots
Place placeOf(uint instance) {
  if (view.copies == 1 && !isCrowd()) return placeIn(int(instance), vec3(0.0));
  int slot = int(instance / uint(view.instanceCount));
  return placeIn(int(instance) - slot * view.instanceCount, slotShift(slot));
}

/// The copy that an instance of a crowd is of.
uint copyNumber(uint instance) {
  if (isWhole(instance)) return instance - view.firstWhole;
  return floatBitsToUint(texelFetch(slotTexture, int(instance / uint(view.instanceCount))).w);
}

/// @param instance  a copy that is drawn as a whole
Place wholePlace(uint instance) {
  return Place(copyShift(int(instance - view.firstWhole)), vec4(0.0, 0.0, 0.0, 1.0), view.wholeMolecule);
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
  return spherePixels(view.right, view.up, view.forward, view.isOrthographic, view.pictureSize, q, radius) - view.shift.xyxy;
}

/// The ray of a pixel of the window; its depth grows by one with each length of it. @param offset  of its beginning from the eye
vec3 rayOf(ivec2 pixel, out vec3 offset) {
  vec2 at = vec2(2.0, -2.0) * (vec2(pixel) + view.shift) / view.pictureSize + vec2(-1.0, 1.0);
  vec3 across = at.x * view.right.xyz + at.y * view.up.xyz;
  offset = view.isOrthographic != 0 ? across : vec3(0.0);
  return view.isOrthographic != 0 ? view.forward.xyz : view.forward.xyz + across;
}

/// Depth at which a ray meets a ball; below 0 where it does not.
float ballDepth(vec3 q, float radius, vec3 offset, vec3 ray) { return ballDepths(q, radius, offset, ray).x; }

/// Pixels that a length takes at a depth.
float pixelsPerLength(float depth) {
  float perLength = 0.5 * view.pictureSize.y / length(view.up.xyz);
  return view.isOrthographic != 0 ? perLength : perLength / max(depth, 1e-6);
}
