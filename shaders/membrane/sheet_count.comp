// Indexing a sheet, second step: how many meshes may touch each cell.
layout(local_size_x = 64) in;

#include "membrane/sheet.glsl"

void main() {
  int v = theParticle(true);
  if (v < 0) return;
  MeshBox box = boxOf(v);
  ivec4 cells = sheetCellsWithin(thePlan(), box.low.xy, box.high.xy);
  for (int y = cells.y; y <= cells.w; ++y)
    for (int x = cells.x; x <= cells.z; ++x) atomicAdd(counts[y * particles.x + x], 1u);
}
