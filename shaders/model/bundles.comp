// What may show: what the window holds and what is drawn does not hide.
// COPIES: a thread looks at a copy that has a slot. BLOCKS: a thread looks at a block of copies. Else a thread looks at a bundle
// of instances, and a row of groups is a listed copy.
layout(local_size_x = 64) in;

#include "model/instances.glsl"
#include "model/window.glsl"
#include "model/bundles.glsl"

layout(std430, binding = kCopyBinding) buffer CopyBlock { uint copies[]; };  // slots, or blocks, by their depth, then the listed ones

layout(location = 0) uniform int first;  // of this dispatch: by their depth; else listed copies
layout(location = 1) uniform int end;
layout(location = 2) uniform int listAt; // where the listed ones stand

/// Whether all of a sphere lies beside the window or behind what is drawn.
bool isOut(vec4 sphere, vec3 shift) {
  vec3 q = sphere.xyz + shift - view.eye.xyz;
  float depth = dot(q, view.forward.xyz);
  if (depth + sphere.w <= 0.0 || isAside(q, depth, sphere.w)) return true;
  return depth > sphere.w && isHidden(pixelsOf(q, sphere.w), depth - sphere.w);
}

#ifdef BLOCKS
/// The sphere around all copies of a block.
vec4 blockSphere(ivec3 from) {
  vec3 half_ = 0.5 * view.copyStep.xyz * vec3(min(ivec3(kBlockEdge), ivec3(view.copiesX, view.copiesY, view.copiesZ) - from) - 1);
  return vec4(view.copySphere.xyz + view.copyStep.xyz * vec3(from) + half_, view.copySphere.w + length(half_));
}
#endif

void main() {
#if defined(COPIES) || defined(BLOCKS)
  int place = first + int(gl_GlobalInvocationID.x);
  if (place >= end) return;
  uint copy = copies[place];
#ifdef BLOCKS
  if (isOut(blockSphere(blockOrigin(int(copy))), vec3(0.0))) return;
#else
  if ((view.copies > 1 || isCrowd()) && isOut(view.copySphere, slotShift(int(copy)))) return;
#endif
  copies[uint(listAt) + atomicAdd(copyCount, 1u)] = copy;
#else
  int bundle = int(gl_GlobalInvocationID.x);
  int place = first + int(gl_WorkGroupID.y);
  // As a loop: software drivers leave one that no thread is in, and run what stands under a condition all the same.
  int turns = place < end && place < int(copyCount) && bundle * kBundle < view.instanceCount ? 1 : 0;
  for (int turn = 0; turn < turns; ++turn) {
    uint slot = copies[listAt + place];
    if (isOut(texelFetch(bundleTexture, bundle), slotShift(int(slot)))) return;
    bundles[atomicAdd(bundleCount, 1u)] = BundleRow(slot, uint(bundle));
  }
#endif
}
