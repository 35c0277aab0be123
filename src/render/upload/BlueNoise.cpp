#include "render/upload/BlueNoise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "shared/frame.h"

namespace velum::render {

namespace {

constexpr int kSize = shared::kNoiseEdge;
constexpr int kCount = kSize * kSize;

/// Points on a torus and the Gaussian crowding that they make at every place.
class Crowd {
 public:
  Crowd() : mKernel(kCount), mEnergy(kCount, 0.0f), mOn(kCount, false) {
    constexpr float kSigma = 1.9f;  // Ulichney's 1.5 to 1.9; the larger keeps low frequencies lower
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        int dx = std::min(x, kSize - x), dy = std::min(y, kSize - y);
        mKernel[std::size_t(y * kSize + x)] = std::exp(-float(dx * dx + dy * dy) / (2 * kSigma * kSigma));
      }
  }
  void set(int at, bool on) {
    mOn[std::size_t(at)] = on;
    float sign = on ? 1.0f : -1.0f;
    int ax = at % kSize, ay = at / kSize;
    for (int y = 0; y < kSize; ++y) {
      const float* row = &mKernel[std::size_t(((y - ay) & (kSize - 1)) * kSize)];
      for (int x = 0; x < kSize; ++x) mEnergy[std::size_t(y * kSize + x)] += sign * row[(x - ax) & (kSize - 1)];
    }
  }
  int tightest() const { return extreme(true); }
  int emptiest() const { return extreme(false); }

 private:
  int extreme(bool on) const {
    int best = -1;
    for (int i = 0; i < kCount; ++i) {
      if (mOn[std::size_t(i)] != on) continue;
      if (best < 0 || (on ? mEnergy[std::size_t(i)] > mEnergy[std::size_t(best)]
                          : mEnergy[std::size_t(i)] < mEnergy[std::size_t(best)]))
        best = i;
    }
    return best;
  }
  std::vector<float> mKernel, mEnergy;
  std::vector<bool> mOn;
};

}  // namespace

std::vector<float> makeBlueNoise() {
  // Start from a few scattered points and even them out.
  Crowd crowd;
  std::vector<int> start;
  std::uint32_t state = 12345;
  std::vector<bool> used(kCount, false);
  while (int(start.size()) < kCount / 10) {
    state = state * 1664525u + 1013904223u;
    int at = int(state >> 8) & (kCount - 1);
    if (used[std::size_t(at)]) continue;
    used[std::size_t(at)] = true;
    start.push_back(at);
    crowd.set(at, true);
  }
  for (int turn = 0; turn < kCount; ++turn) {
    int from = crowd.tightest();
    crowd.set(from, false);
    int to = crowd.emptiest();
    crowd.set(to, true);
    if (from == to) break;
  }
  // Rank the points downwards from the tightest cluster, the rest upwards into the largest void.
  std::vector<int> rank(kCount, -1);
  Crowd falling = crowd;
  for (int r = int(start.size()) - 1; r >= 0; --r) {
    int at = falling.tightest();
    falling.set(at, false);
    rank[std::size_t(at)] = r;
  }
  for (int r = int(start.size()); r < kCount; ++r) {
    int at = crowd.emptiest();
    crowd.set(at, true);
    rank[std::size_t(at)] = r;
  }
  std::vector<float> noise(kCount);
  for (int i = 0; i < kCount; ++i) noise[std::size_t(i)] = (float(rank[std::size_t(i)]) + 0.5f) / float(kCount);
  return noise;
}

}  // namespace velum::render
