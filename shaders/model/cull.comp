// Which instances are drawn, and by which of their levels. An instance is drawn that the cuts leave, that the window holds, and
// that what is drawn already does not hide. [VE] 3.
//
// WORDS: a thread looks at a word of 32 instances, of which few have their bit set: those that were seen last time, which come
// first. Else a group looks at a bundle of those that listed bundles hold (bundles.comp): at all that were not seen, when the
// depths of those that were are known. STATES: it is known already which of them cuts leave; GHOSTS: those are drawn that cuts
// have removed and that show as ghosts; NEAREST: what has a bit is drawn. Else it is worked out here. WHOLES: it looks at copies
// that are drawn as wholes, of which cuts leave what they leave ball by ball: a group at a listed block of them.
layout(local_size_x = 64) in;

#include "model/instances.glsl"
#include "common/line.glsl"
#if defined(WHOLES)
#elif defined(STATES) || defined(GHOSTS) || defined(NEAREST)
layout(std430, binding = kStateBinding) readonly buffer StateBlock { uint states[]; };
layout(binding = kTypeUnit) uniform samplerBuffer typeTexture;
#else
#include "model/kept.glsl"
#endif
#include "model/window.glsl"

layout(std430, binding = kSeenBinding) readonly buffer SeenBlock { uint seen[]; };
layout(binding = kDrawImage, rg32ui) uniform writeonly uimageBuffer drawImage;  // DrawRow
layout(std430, binding = kCountBinding) buffer CountBlock { uint counts[]; };
#ifndef WORDS
#include "model/bundles.glsl"
#ifdef WHOLES
layout(std430, binding = kCopyBinding) readonly buffer CopyBlock { uint blocks[]; };
layout(binding = kSlottedUnit) uniform usamplerBuffer slottedTexture;
layout(location = 2) uniform int listAt;  // where the listed ones stand
#endif
#endif

layout(location = 0) uniform int first;  // of this dispatch, words or listed bundles
layout(location = 1) uniform int end;

#if defined(STATES) || defined(GHOSTS)
bool isRemoved(uint instance) {
  uint word = states[instance >> 5] | states[uint(view.stateWords) + (instance >> 5)];
  return (word >> (instance & 31u) & 1u) != 0u;
}
#endif

#if !defined(WORDS) && !defined(WHOLES)
bool isOutlineHidden(Place place, MoleculeRow molecule) {
  LevelRow row = levelAt(molecule.outlineLevel);
  bool isHiddenSoFar = true;
  for (uint i = 0u; i < row.count && isHiddenSoFar; ++i) {
    vec4 ball = texelFetch(ballTexture, int(row.first + i));
    float radius = ball.w + molecule.outlineGrow;
    vec3 q = place.position - view.eye.xyz + turned(place.rotation, ball.xyz);
    float nearest = dot(q, view.forward.xyz) - radius;
    isHiddenSoFar = nearest > 0.0 && isHidden(pixelsOf(q, radius), nearest);
  }
  return isHiddenSoFar;
}
#endif

/// Draws one, where it shows.
void cullOne(uint instance, uint number, Place place) {
  MoleculeRow molecule = moleculeAt(place.molecule);
#ifndef WHOLES
  float shows = texelFetch(typeTexture, int(molecule.type)).a;
#ifdef GHOSTS
  if (shows < kTypeFilled || !isRemoved(instance)) return;
#elif !defined(NEAREST)
  if (shows == kTypeHidden) return;
#endif
#ifdef STATES
  if (isRemoved(instance)) return;
#endif
#endif
  // Exactly: by which level it is drawn must not depend on whether it was seen before, which is another program.
  precise vec3 middle = place.position + turned(place.rotation, molecule.sphere.xyz);
  float radius = molecule.reach;
  // The window.
  precise vec3 q = middle - view.eye.xyz;
  precise float depth = dot(q, view.forward.xyz);
  precise float nearest = depth - radius;
  if (depth + radius <= 0.0 || isAside(q, depth, radius)) return;
  vec4 pixels = vec4(0.0, 0.0, vec2(view.size));
  if (nearest > 0.0 || view.isOrthographic != 0) {
    pixels = pixelsOf(q, radius);
    if (any(lessThan(pixels.zw, vec2(-0.5))) || any(greaterThan(pixels.xy, vec2(view.size) - 0.5))) return;
  }
#ifndef WORDS
  if (nearest > 0.0 && isHidden(pixels, nearest)) return;
#endif
#if !defined(STATES) && !defined(GHOSTS) && !defined(NEAREST) && !defined(WHOLES)
  if (!cutsLeave(number, molecule.type, middle, molecule.sphere.w)) return;
#endif
  // The coarsest level that is fine enough where the instance is nearest.
  precise float perLength = pixelsPerLength(nearest);
#ifdef WHOLES
  // Where nothing opens it, half of what lies in it and on its other side is never seen.
  vec3 along = view.isOrthographic != 0 ? view.forward.xyz : q;
  uvec3 towards = uvec3(greaterThan(along, vec3(0.0)));
  uint side = view.showsInside != 0 ? 0u : 1u + towards.x + 2u * towards.y + 4u * towards.z;
  const uint rows = uint(kWholeRows);
#else
  const uint side = 0u, rows = 1u;
#endif
  uint finest = molecule.firstLevel + side;
  uint level = finest + rows * (molecule.levelCount - 1u);
  LevelRow row = levelAt(level);
  while (level > finest && row.error * perLength > view.detail) row = levelAt(level -= rows);
#if !defined(WORDS) && !defined(WHOLES)
  // Closer to its shape than the sphere around it: what shows in its gaps lies behind many that nobody sees.
  if (nearest > 0.0 && level <= molecule.outlineLevel && isOutlineHidden(place, molecule)) return;
#endif
  int list = row.count == 1u ? kDrawOne : row.count <= uint(kFewSpheres) ? kDrawFew : kDrawMany;
  if (row.radius * perLength > view.largeRadius) list = kDrawLarge;
  int slot = int(atomicAdd(counts[list], 1u));
  imageStore(drawImage, drawSlot(list, slot, view.drawRoom), uvec4(instance, level, 0u, 0u));
}

void main() {
#ifdef WORDS
  int index = first + int(lineThread());
  if (index >= end) return;
  for (uint bits = seen[index]; bits != 0u; bits &= bits - 1u) {
    uint instance = uint(32 * index + findLSB(bits));
#ifdef WHOLES
    cullOne(instance, instance, wholePlace(instance));
#else
    int slot = int(instance / uint(view.instanceCount));
    int row = int(instance) - slot * view.instanceCount;
    cullOne(instance, numberOf(slot, row), placeIn(row, slotShift(slot)));
#endif
  }
#else
  int place = first + int(lineGroup());
  int inBundle = int(gl_LocalInvocationIndex);
  // As a loop: software drivers leave one that no thread is in, and run what stands under a condition all the same.
#ifdef WHOLES
  int turns = place < end && place < int(copyCount) ? 1 : 0;
  for (int turn = 0; turn < turns; ++turn) {
    ivec3 at = blockOrigin(int(blocks[listAt + place])) + inBundle / ivec3(1, kBlockEdge, kBlockEdge * kBlockEdge) % kBlockEdge;
    int copy = (at.z * view.copiesY + at.y) * view.copiesX + at.x;
    if (any(greaterThanEqual(at.xy, ivec2(view.copiesX, view.copiesY))) || copy >= view.allCopies) return;
    if ((texelFetch(slottedTexture, copy >> 5).r >> (copy & 31) & 1u) != 0u) return;
    uint instance = view.firstWhole + uint(copy);
    if ((seen[instance >> 5] >> (instance & 31u) & 1u) != 0u) return;
    cullOne(instance, instance, wholePlace(instance));
  }
#else
  int turns = place < end && place < int(bundleCount) ? 1 : 0;
  for (int turn = 0; turn < turns; ++turn) {
    BundleRow bundle = bundles[place];
    int order = int(bundle.bundle) * kBundle + inBundle;
    if (order >= view.instanceCount) return;
    int index = int(texelFetch(orderTexture, order).r);
    uint instance = bundle.slot * uint(view.instanceCount) + uint(index);
    if ((seen[instance >> 5] >> (instance & 31u) & 1u) != 0u) return;
    cullOne(instance, numberOf(int(bundle.slot), index), placeIn(index, slotShift(int(bundle.slot))));
  }
#endif
#endif
}
