// Which cells can show anything: a cell's range of values (with a one-voxel halo) against the transfer function, its
// labels against the structures that are visible. Writes 0 for content and 255 for none; skip_distance.comp spreads it.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

#include "common/frame.glsl"

layout(binding = kExtinctionUnit) uniform usampler2D extinctionTexture;
layout(std430, binding = kCellBinding) readonly buffer CellBlock { vec2 cellRange[]; };
layout(std430, binding = kCellLabelBinding) readonly buffer CellLabelBlock { uvec2 cellLabels[]; };  // 64-bit set of id % 64; bit 0: none

layout(binding = 0, rg8ui) uniform writeonly uimage3D skipImage;

layout(location = 0) uniform ivec4 mode;          // x: 0 opacity, 1 iso, 2 labels only; y: labels present
layout(location = 1) uniform ivec4 visibleSet;    // xy: ids (mod 64) that are visible; zw: that some cut spares

/// True when the transfer function is not zero somewhere between two table positions: its running sum differs.
bool hasOpacity(vec2 range) {
  vec2 x = clamp(range, 0.0, 1.0) * float(kTransferSize - 1);
  int a = max(int(x.x - 0.01), 0);
  int b = min(int(x.y + 0.01) + 1, kTransferSize);
  return texelFetch(extinctionTexture, ivec2(a, 0), 0).r != texelFetch(extinctionTexture, ivec2(b, 0), 0).r;
}

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID);
  ivec3 grid = ivec3(frame.cellGrid.xyz);
  if (any(greaterThanEqual(cell, grid))) return;
  int index = (cell.z * grid.y + cell.y) * grid.x + cell.x;
  vec2 range = cellRange[index] * frame.tablePerTexel + frame.tableOffset;
  range = vec2(min(range.x, range.y), max(range.x, range.y));
  bool content = mode.x == 0 ? hasOpacity(range) : mode.x == 1 ? range.x <= frame.isoValue && range.y >= frame.isoValue : true;
  bool spared = content && (visibleSet.z & 1) != 0;  // without labels all of it has none
  if (mode.y != 0) {
    uvec2 labels = cellLabels[index];
    content = content && any(notEqual(labels & uvec2(visibleSet.xy), uvec2(0u)));
    spared = content && any(notEqual(labels & uvec2(visibleSet.zw), uvec2(0u)));
  }
  imageStore(skipImage, cell, uvec4(content ? 0u : 255u, spared ? 0u : 255u, 0u, 0u));
}
