#pragma once
#include <vector>

namespace velum::render {

constexpr int kBlueNoiseSize = 64;

/// A tile of blue noise, kBlueNoiseSize^2 ranks mapped to 0..1, by void and cluster [ULICHNEY]. Deterministic;
/// about 50 ms.
std::vector<float> makeBlueNoise();

}  // namespace velum::render
