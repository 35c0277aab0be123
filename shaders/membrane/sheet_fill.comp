// Indexing a sheet, fourth step: the meshes into the lists of the cells that they may touch, in any order.
layout(local_size_x = 64) in;

#include "membrane/sheet.glsl"

layout(std430, binding = kSheetValuesBinding) buffer ValueBlock { float values[]; };

void main() {
  int v = theParticle(true);
  if (v < 0) return;
  SheetPlan plan = thePlan();
  MeshBox box = boxOf(v);
  ivec4 cells = sheetCellsWithin(plan, box.low.xy, box.high.xy);
  for (int y = cells.y; y <= cells.w; ++y)
    for (int x = cells.x; x <= cells.z; ++x) {
      uint turn = atomicAdd(counts[y * particles.x + x], 1u);
      vec4 cell = sheetCell(plan, x, y);
      if (turn < uint(cell.y)) values[4 * sheetLists(plan) + int(cell.x) + int(turn)] = float(v);
    }
}
