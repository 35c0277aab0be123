// Which copies, then which bundles of instances of these, may show: those that the window holds and what is drawn does not hide.
// COPIES: a thread looks at a copy. Else a thread looks at a bundle, and a row of groups is a listed copy.
layout(local_size_x = 64) in;

#include "model/instances.glsl"
#include "model/window.glsl"
#include "model/bundles.glsl"

layout(std430, binding = kCopyBinding) buffer CopyBlock { uint copies[]; };  // all by their depth, then the listed ones

layout(location = 0) uniform int first;  // of this dispatch: copies by their depth; else listed copies
layout(location = 1) uniform int end;

/// Whether all of a sphere lies beside the window or behind what is drawn.
bool isOut(vec4 sphere, vec3 shift) {
  vec3 q = sphere.xyz + shift - view.eye.xyz;
  float depth = dot(q, view.forward.xyz);
  if (depth + sphere.w <= 0.0 || isAside(q, depth, sphere.w)) return true;
  return depth > sphere.w && isHidden(pixelsOf(q, sphere.w), depth - sphere.w);
}

void main() {
#ifdef COPIES
  int place = first + int(gl_GlobalInvocationID.x);
  if (place >= end) return;
  uint copy = copies[place];
  if (view.copies > 1 && isOut(view.copySphere, copyShift(int(copy)))) return;
  copies[uint(view.copies) + atomicAdd(copyCount, 1u)] = copy;
#else
  int bundle = int(gl_GlobalInvocationID.x);
  int place = first + int(gl_WorkGroupID.y);
  // As a loop: software drivers leave one that no thread is in, and run what stands under a condition all the same.
  int turns = place < end && place < int(copyCount) && bundle * kBundle < view.instanceCount ? 1 : 0;
  for (int turn = 0; turn < turns; ++turn) {
    uint copy = copies[view.copies + place];
    if (isOut(texelFetch(bundleTexture, bundle), copyShift(int(copy)))) return;
    bundles[atomicAdd(bundleCount, 1u)] = BundleRow(copy, uint(bundle));
  }
#endif
}
