// Indexing a sheet, third step, one group: where each cell's list begins. The counts are 0 again after it.
layout(local_size_x = 64) in;

#include "membrane/sheet.glsl"

shared uint sums[kSheetScanGroup];

void main() {
  int n = particles.x * particles.y;
  int me = int(gl_LocalInvocationID.x);
  int share = (n + kSheetScanGroup - 1) / kSheetScanGroup;
  int from = me * share;
  int to = min(from + share, n);
  uint sum = 0u;
  for (int i = from; i < to; ++i) sum += counts[i];
  sums[me] = sum;
  barrier();
  uint first = 0u;
  for (int i = 0; i < me; ++i) first += sums[i];
  uint room = uint(particles.z);
  for (int i = from; i < to; ++i) {
    uint count = counts[i];
    uint kept = first >= room ? 0u : min(count, room - first);
    if (kept < count) counts[n] = 1u;
    sheetRows[2 * n + i] = vec4(float(first), float(kept), 0.0, 0.0);
    counts[i] = 0u;
    first += count;
  }
}
