#pragma once

namespace velum::gpu {

/// An order of groups in which those that lie next to each other, which take about as long, run on different threads of
/// a software driver, which gives each of its threads a run of groups: the n-th group is n * stride % count.
struct Strided {
  int count = 1;  ///< Some more than were asked for, so that the stride comes to all.
  int stride = 1;
};
Strided stridedGroups(int groups);

}  // namespace velum::gpu
