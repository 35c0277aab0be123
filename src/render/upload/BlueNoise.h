#pragma once
#include <vector>

namespace velum::render {

/// A tile of blue noise, kNoiseEdge^2 ranks mapped to 0..1, by void and cluster [ULICHNEY]. Deterministic;
/// about 50 ms.
std::vector<float> makeBlueNoise();

}  // namespace velum::render
