#include "gpu/Strided.h"

#include <algorithm>
#include <numeric>
#include <thread>

namespace velum::gpu {

Strided stridedGroups(int groups) {
  static const int threads = std::max(1, int(std::thread::hardware_concurrency()));
  Strided order{std::max(groups, 1), threads};
  while (std::gcd(order.count, order.stride) != 1) ++order.count;
  return order;
}

}  // namespace velum::gpu
