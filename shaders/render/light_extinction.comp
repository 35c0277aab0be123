// The light grid's first step: mean extinction of each of its cells, as cut and as the structures are shown.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

#include "common/frame.glsl"
#include "common/cuts.glsl"
#include "common/volume.glsl"

layout(binding = 0, r32f) uniform writeonly image3D extinctionImage;

layout(location = 0) uniform ivec4 slice;  // x: first z
layout(location = 1) uniform vec4 texel;   // xyz: scene mm per grid cell axis are in sceneFrom*; w unused
layout(location = 2) uniform vec4 sceneX;  // scene step of one whole volume along tex x, y, z
layout(location = 3) uniform vec4 sceneY;
layout(location = 4) uniform vec4 sceneZ;
layout(location = 5) uniform vec4 scene0;  // scene position of tex 0

/// Slices let less of the material show, which then throws less of a shadow.
float shownExtinction(float extinction, vec3 p, uint structure) {
#ifdef MEMBRANES
  float length_ = 1.0 / frame.cellGrid.w;
  if (hasFlag(kFlagSlices)) return fadedDepth(extinction * length_, length_, sliceShare(p, structure)) / length_;
#endif
  return extinction;
}

float extinctionAt(vec3 tex) {
  vec3 p = scene0.xyz + tex.x * sceneX.xyz + tex.y * sceneY.xyz + tex.z * sceneZ.xyz;
  uint structure = 0u;
  float factor = 1.0;
#if LABELS == 2
  vec4 material = labelMaterial(p);
  structure = labelAt(p);
  if (frame.counts.x > 0 && !cutsKeep(p, structure)) return 0.0;
  return shownExtinction(smoothstep(0.35, 0.65, material.a) * material.a * 6.0 * frame.cellGrid.w, p, structure);
#else
#if LABELS == 1
  structure = labelAt(p);
  factor = structure == 0u ? frame.window.w : structureRow(structure).a;
#endif
  if (frame.counts.x > 0 && !cutsKeep(p, structure)) return 0.0;
#if MODE == 2
  return tableAt(tex) >= frame.step.z * float(kTransferSize - 1) ? shownExtinction(4.0 * frame.cellGrid.w, p, structure) : 0.0;
#else
  float x = tableAt(tex);
  return shownExtinction(extinctionBetween(x, x) * factor, p, structure);
#endif
#endif
}

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, slice.x);
  ivec3 grid = ivec3(frame.lightGrid.xyz);
  if (any(greaterThanEqual(cell, grid))) return;
  float sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    vec3 at = vec3(cell) + 0.25 + 0.5 * vec3(i & 1, i >> 1 & 1, i >> 2);
    sum += extinctionAt(at / vec3(grid));
  }
  imageStore(extinctionImage, cell, vec4(sum * 0.125));
}
