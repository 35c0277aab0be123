// Which instances are drawn, and by which of their levels. An instance is drawn that the cuts leave, that the window holds, and
// that what is drawn already does not hide. [VE] 3.
//
// In two phases: first those that were seen last time, then, when their depths are known, all others. SEEN: a thread looks at
// a word of 32 instances; few of them were seen. STATES: it is known already which of them cuts leave; GHOSTS: those are drawn
// that cuts have removed and that show as ghosts. Else it is worked out here.
layout(local_size_x = 64) in;

#include "model/instances.glsl"
#if defined(STATES) || defined(GHOSTS)
layout(std430, binding = kStateBinding) readonly buffer StateBlock { uint states[]; };
layout(binding = kTypeUnit) uniform samplerBuffer typeTexture;
#else
#include "model/kept.glsl"
#endif
#include "model/hidden.glsl"

layout(std430, binding = kSeenBinding) readonly buffer SeenBlock { uint seen[]; };
layout(binding = kDrawImage, rg32ui) uniform writeonly uimageBuffer drawImage;  // DrawRow
layout(std430, binding = kCountBinding) buffer CountBlock { uint counts[]; };
layout(binding = kDepthUnit) uniform usamplerBuffer depthTexture;

layout(location = 0) uniform int phase;       // 0: seen last time; 1: all others; 2: all, whatever hides them
layout(location = 1) uniform int firstIndex;  // of this dispatch: SEEN: words of 32 instances; else instances of a copy
layout(location = 2) uniform int endIndex;
layout(location = 3) uniform int firstCopy;

#if defined(STATES) || defined(GHOSTS)
bool isRemoved(uint instance) {
  uint word = states[instance >> 5] | states[uint(view.stateWords) + (instance >> 5)];
  return (word >> (instance & 31u) & 1u) != 0u;
}
#endif

// So many pixels along each edge are looked at by themselves: tiles around what is small have gaps.
const int kFewPixels = 16;

/// Whether all that is drawn in the pixels lies before a depth.
bool isHidden(vec4 pixels, float nearest) {
  ivec2 last = view.size - 1;
  // Rays go through the middles of pixels: what no middle lies in is not seen.
  ivec2 from = max(ivec2(ceil(pixels.xy - 0.01)), ivec2(0));
  ivec2 to = min(ivec2(floor(pixels.zw + 0.01)), last);
  if (any(lessThan(to, from))) return true;
  if (all(lessThan(to - from, ivec2(kFewPixels)))) {
    // Within the circle that a sphere is, nearly: its outline bulges by less than a pixel.
    uint bits = floatBitsToUint(nearest);
    vec2 middle = 0.5 * (pixels.xy + pixels.zw);
    vec2 reach = 0.5 * (pixels.zw - pixels.xy) + 0.5;
    ivec2 pixel = from;
    bool isOpen = false;
    while (pixel.y <= to.y && !isOpen) {
      vec2 d = (vec2(pixel) - middle) / reach;
      isOpen = dot(d, d) <= 1.0 && texelFetch(depthTexture, pixel.y * view.size.x + pixel.x).r > bits;
      pixel = pixel.x == to.x ? ivec2(from.x, pixel.y + 1) : pixel + ivec2(1, 0);
    }
    return !isOpen;
  }
  return nearest > farthestIn(from, to);
}

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

/// Whether a sphere lies beyond one of the planes through the eye and an edge of the window. What is next to the eye has no
/// pixels by which one could tell.
bool isAside(vec3 q, float depth, float radius) {
  if (view.isOrthographic != 0) return false;
  vec2 half_ = vec2(length(view.right.xyz), length(view.up.xyz));
  vec2 at = vec2(dot(q, view.right.xyz), dot(q, view.up.xyz)) / half_;
  // Edges of the window as slopes; rows run downwards.
  vec2 from = (2.0 * (view.shift - 1.0) / view.pictureSize - 1.0) * half_;
  vec2 to = (2.0 * (vec2(view.size) + view.shift) / view.pictureSize - 1.0) * half_;
  vec2 low = vec2(from.x, -to.y);
  vec2 high = vec2(to.x, -from.y);
  vec2 below = (low * depth - at) / sqrt(1.0 + low * low);
  vec2 above = (at - high * depth) / sqrt(1.0 + high * high);
  return any(greaterThan(max(below, above), vec2(radius)));
}

/// Whether all of a copy lies beside the window or, where depths are known, behind what is drawn.
bool isCopyOut(vec3 shift) {
  vec3 q = view.copySphere.xyz + shift - view.eye.xyz;
  float radius = view.copySphere.w;
  float depth = dot(q, view.forward.xyz);
  if (depth + radius <= 0.0 || isAside(q, depth, radius)) return true;
  return phase == 1 && depth > radius && isHidden(pixelsOf(q, radius), depth - radius);
}

/// Draws one, where it shows.
void cullOne(uint instance, Place place) {
  MoleculeRow molecule = moleculeAt(place.molecule);
  float shows = texelFetch(typeTexture, int(molecule.type)).a;
#ifdef GHOSTS
  if (shows < kTypeFilled || !isRemoved(instance)) return;
#else
  if (shows == kTypeHidden) return;
#endif
#ifdef STATES
  if (isRemoved(instance)) return;
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
  if (phase == 1 && nearest > 0.0 && isHidden(pixels, nearest)) return;
#if !defined(STATES) && !defined(GHOSTS)
  if (!cutsLeave(instance, molecule.type, middle, molecule.sphere.w)) return;
#endif
  // The coarsest level that is fine enough where the instance is nearest.
  precise float perLength = pixelsPerLength(nearest);
  uint level = molecule.firstLevel + molecule.levelCount - 1u;
  LevelRow row = levelAt(level);
  while (level > molecule.firstLevel && row.error * perLength > view.detail) row = levelAt(--level);
  // Closer to its shape than the sphere around it: what shows in its gaps lies behind many that nobody sees.
  if (phase == 1 && nearest > 0.0 && level <= molecule.outlineLevel && isOutlineHidden(place, molecule)) return;
  int list = row.count == 1u ? kDrawOne : row.count <= uint(kFewSpheres) ? kDrawFew : kDrawMany;
  if (row.radius * perLength > view.largeRadius) list = kDrawLarge;
  int slot = int(atomicAdd(counts[list], 1u));
  imageStore(drawImage, drawSlot(list, slot, view.instanceCount * view.copies), uvec4(instance, level, 0u, 0u));
}

void main() {
  int index = firstIndex + int(gl_GlobalInvocationID.x);
  if (index >= endIndex) return;
#ifdef SEEN
  for (uint bits = seen[index]; bits != 0u; bits &= bits - 1u) {
    uint instance = uint(32 * index + findLSB(bits));
    cullOne(instance, placeOf(instance));
  }
#else
  // A row of groups is a copy: nothing has to be divided.
  int copy = firstCopy + int(gl_WorkGroupID.y);
  vec3 shift = copyShift(copy);
  if (view.copies > 1 && isCopyOut(shift)) return;
  uint instance = uint(copy * view.instanceCount + index);
  if (phase == 1 && (seen[instance >> 5] >> (instance & 31u) & 1u) != 0u) return;
  cullOne(instance, placeIn(index, shift));
#endif
}
