// The view onto a cut's focus: its mask, then who hides it. [VE] 6.1, 6.2.
//
// OCCLUDERS: instances in the cut's region that lie before the mask are cleared, but for the type's share. Else spheres about
// the instances of the focus are drawn into the mask.
layout(local_size_x = 64) in;

#include "model/states.glsl"

layout(std140, binding = kFocusViewBinding) uniform FocusBlock { FocusView focus; };
layout(std430, binding = kMaskBinding) buffer MaskBlock { uint mask[]; };
layout(std430, binding = kReachBinding) readonly buffer ReachBlock { uint longest; };
layout(binding = kMaskUnit) uniform usamplerBuffer maskTexture;
layout(binding = kSeedUnit) uniform usamplerBuffer seedTexture;

#ifdef OCCLUDERS
/// Whether the sphere lies before the mask where the aperture opens it.
bool isBefore(vec3 q, float radius, ivec4 rect, float aperture) {
  float most = uintBitsToFloat(longest);
  bool isOpenAll = aperture >= 1.0 || focus.hasAperture == 0;
  ivec2 pixel = rect.xy;
  bool isFound = false;
  while (pixel.y <= rect.w && !isFound) {
    int at = pixel.y * focus.size.x + pixel.x;
    uint bits = texelFetch(maskTexture, at).r;
    if (bits != 0u && bits != kNoDepth && hidesFocus(focusDepths(focus, pixel, q, radius), uintBitsToFloat(bits)))
      isFound = isOpenAll || apertureOpens(aperture, focusDistance(pixel, texelFetch(seedTexture, at).r), most);
    pixel = pixel.x == rect.z ? ivec2(rect.x, pixel.y + 1) : pixel + ivec2(1, 0);
  }
  return isFound;
}
#endif

void main() {
  int index = firstIndex + int(gl_GlobalInvocationID.x);
  if (index >= endIndex) return;
  int slot = firstSlot + int(gl_WorkGroupID.y);
  uint instance = uint(slot * view.instanceCount + index);
  if (isRemoved(instance)) return;
  Place place = placeIn(index, slotShift(slot));
  MoleculeRow molecule = moleculeAt(place.molecule);
  TypeSpareRow spare = typeSpareOf(molecule.type, focus.cut);
  bool isFocus = spare.isFocus != 0.0;
  vec3 middle = place.position + turned(place.rotation, molecule.sphere.xyz);
  vec3 q = middle - focus.eye.xyz;
  float radius = molecule.sphere.w;
#ifdef OCCLUDERS
  if (isFocus || spare.aperture <= 0.0 || instanceRandom(numberOf(slot, index), 1u) < spare.viewShare) return;
  ivec4 rect = focusRect(focus, q, radius);
  if (any(greaterThan(rect.xy, rect.zw))) return;
  if (instanceAnswer(cutAt(focus.cut), 0.0, reachFor(focus.cut, radius), middle) != kCutRemoves) return;
  if (isBefore(q, radius, rect, spare.aperture))
    atomicOr(states[uint(view.stateWords) + (instance >> 5)], stateBit(instance));
#else
  if (!isFocus) return;
  ivec4 rect = focusRect(focus, q, radius);
  if (any(greaterThan(rect.xy, rect.zw))) return;
  ivec2 pixel = rect.xy;
  while (pixel.y <= rect.w) {
    vec2 depths = focusDepths(focus, pixel, q, radius);
    int at = pixel.y * focus.size.x + pixel.x;
    if (depths.x > 0.0 && focus.guidesDepth != 0) atomicMin(mask[at], floatBitsToUint(depths.x));
    if (depths.x > 0.0 && focus.guidesDepth == 0) atomicMax(mask[at], floatBitsToUint(depths.y));
    pixel = pixel.x == rect.z ? ivec2(rect.x, pixel.y + 1) : pixel + ivec2(1, 0);
  }
#endif
}
