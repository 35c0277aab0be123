// Which instances cuts remove by where these stand, once for all that asks in a frame. [VE] 3 and 5.
layout(local_size_x = 64) in;

#include "model/states.glsl"

void main() {
  int index = firstIndex + int(gl_GlobalInvocationID.x);
  if (index >= endIndex) return;
  int slot = firstSlot + int(gl_WorkGroupID.y);
  uint instance = uint(slot * view.instanceCount + index);
  Place place = placeIn(index, slotShift(slot));
  MoleculeRow molecule = moleculeAt(place.molecule);
  vec3 middle = place.position + turned(place.rotation, molecule.sphere.xyz);
  bool isHidden = texelFetch(typeTexture, int(molecule.type)).a == kTypeHidden;
  if (isHidden || !cutsLeave(numberOf(slot, index), molecule.type, middle, molecule.sphere.w))
    atomicOr(states[instance >> 5], stateBit(instance));
}
