// Indexing a sheet, last step: lists in ascending order, so that the same sheet gives the same picture, and how high the
// meshes of each cell are.
layout(local_size_x = 64) in;

#include "membrane/sheet.glsl"

layout(std430, binding = kSheetValuesBinding) buffer ValueBlock { float values[]; };

void main() {
  int v = theParticle(false);
  if (v < 0) return;
  SheetPlan plan = thePlan();
  int row = 2 * sheetParticles(plan) + v;
  vec4 cell = sheetRows[row];
  int first = 4 * sheetLists(plan) + int(cell.x);
  int count = int(cell.y);
  for (int i = 1; i < count; ++i) {
    float entry = values[first + i];
    int at = i;
    while (at > 0 && values[first + at - 1] > entry) {
      values[first + at] = values[first + at - 1];
      --at;
    }
    values[first + at] = entry;
  }
  float low = kSheetFar;
  float high = -kSheetFar;
  for (int i = 0; i < count; ++i) {
    MeshBox box = boxOf(int(values[first + i]));
    low = min(low, box.low.z);
    high = max(high, box.high.z);
  }
  sheetRows[row] = vec4(cell.xy, low - sheetSlack(plan), high + sheetSlack(plan));
}
