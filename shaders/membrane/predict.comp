// Where each particle would go without constraints ([IMC] eq. 1), under the kernels around it, the pull back to the rest plane
// and damping. Cost: particles times the kernels that reach one, whatever the number of kernels.
#include "shared/cloth.h"
layout(local_size_x = kClothGroup, local_size_y = kClothGroup) in;

layout(std140, binding = kClothBinding) uniform ClothBlock { ClothParams cloth; };
layout(std430, binding = kPlaceBinding) readonly buffer PlaceBlock { vec4 places[]; };
layout(std430, binding = kVelocityBinding) readonly buffer VelocityBlock { vec4 velocities[]; };
#if ALONG
layout(std430, binding = kToBinding) writeonly buffer ToBlock { float predicted[]; };
#else
layout(std430, binding = kToBinding) writeonly buffer ToBlock { vec4 predicted[]; };
#endif
layout(std430, binding = kKernelBinding) readonly buffer KernelBlock { vec2 kernels[]; };
layout(std430, binding = kUserKernelBinding) readonly buffer UserKernelBlock { ClothKernel userKernels[]; };

/// Sum over the kernels of the lattice ([IMC] eq. 2), in units of strength.
vec3 latticeForce(vec3 place) {
  vec3 q = (cloth.kernelFromLocal * vec4(place, 1.0)).xyz;
  float reach = cloth.axisX.w;
  ivec3 first = ivec3(ceil(q - reach));
  ivec3 from = max(first, ivec3(0));
  ivec3 to = min(first + cloth.lattice.w, cloth.lattice.xyz);
  vec3 force = vec3(0.0);
  for (int z = from.z; z < to.z; ++z)
    for (int y = from.y; y < to.y; ++y)
      for (int x = from.x; x < to.x; ++x) {
        vec2 strength = kernels[(z * cloth.lattice.y + y) * cloth.lattice.x + x];
        vec3 delta = q - vec3(x, y, z);
#if ALONG
        vec3 mm = delta * cloth.spacing.xyz;
        float above = (mm.x * cloth.axisX.z + mm.y * cloth.axisY.z + mm.z * cloth.axisZ.z) / (reach * cloth.spacing.w);
        force.z += kernelTent(delta, vec3(reach)) * (strength.x + kernelSide(above) * strength.y);
#else
        vec3 away = vec3(kernelForce(delta.x, reach), kernelForce(delta.y, reach), kernelForce(delta.z, reach));
        bool inside = all(lessThan(abs(delta), vec3(reach)));
        force += inside ? strength.y * away : vec3(0.0);
#endif
      }
#if ALONG
  return force;
#else
  return force.x * cloth.axisX.xyz + force.y * cloth.axisY.xyz + force.z * cloth.axisZ.xyz;
#endif
}

/// The same over the user's own kernels, boxes along the rest plane's axes. @param lift  of the rest plane
vec3 userForce(vec3 place, out float lift) {
  vec3 force = vec3(0.0);
  lift = 0.0;
  for (int i = 0; i < cloth.grid.z; ++i) {
    ClothKernel kernel = userKernels[i];
    vec3 delta = place - kernel.place.xyz;
    float width = kernel.place.w;
#if ALONG
    force.z += kernelTent(delta, vec3(width)) * (kernel.strength.x + kernelSide(delta.z / width) * kernel.strength.y);
    lift += kernel.strength.z * liftAt(length(delta.xy) / width);
#else
    vec3 away = vec3(kernelForce(delta.x, width), kernelForce(delta.y, width), kernelForce(delta.z, width));
    if (all(lessThan(abs(delta), vec3(width)))) force += kernel.strength.y * away;
#endif
  }
  return force;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, cloth.grid.xy))) return;
  int i = at.y * cloth.grid.x + at.x;
  vec4 place = places[i];
  if (place.w > 0.0) {
    float lift;
    vec3 force = (latticeForce(place.xyz) + userForce(place.xyz, lift)) * cloth.step.w;
    force.z -= cloth.step.z * (place.z - lift);
    vec3 way = (velocities[i].xyz + cloth.step.x * force) * (cloth.step.y * cloth.step.x);
    float len = length(way);
    place.xyz += way * min(1.0, cloth.halfSize.w / max(len, 1e-6 * cloth.halfSize.w));
  }
#if ALONG
  predicted[i] = place.z;
#else
  predicted[i] = place;
#endif
}
