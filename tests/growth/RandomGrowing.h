#pragma once
#include <random>

#include "core/LabelVolume.h"
#include "core/Volume.h"
#include "makeVolume.h"
#include "scene/Growth.h"

namespace velum::growth {

/// Draws volumes, seeds, ranges and planes. The same seed draws the same.
class RandomGrowing {
 public:
  explicit RandomGrowing(unsigned seed) : mRandom(seed) {}

  double number(double low, double high) { return std::uniform_real_distribution<>(low, high)(mRandom); }
  int whole(int low, int high) { return std::uniform_int_distribution<>(low, high)(mRandom); }
  glm::dvec3 direction() {
    glm::dvec3 d(number(-1, 1), number(-1, 1), number(-1, 1));
    // Now and then along an axis, where whole layers lie at one depth.
    if (whole(0, 3) == 0) d = glm::dvec3(0.0), d[whole(0, 2)] = whole(0, 1) ? 2.0 : -0.5;
    return d;
  }
  glm::ivec3 voxel(glm::ivec3 dims) { return {whole(0, dims.x - 1), whole(0, dims.y - 1), whole(0, dims.z - 1)}; }
  glm::ivec3 dims() {
    glm::ivec3 d(whole(1, 150), whole(1, 40), whole(1, 40));
    if (whole(0, 3) == 0) d[whole(0, 2)] = 1;
    return d;
  }
  glm::dmat4 frame(glm::ivec3 dims) {
    glm::dvec3 spacing(number(0.4, 1.0), number(0.4, 2.0), number(0.5, 3.0));
    if (whole(0, 2) == 0) spacing.x = -spacing.x;
    return centredFrame(dims, spacing, whole(0, 1) ? 0.0 : number(-3, 3), {number(-90, 90), 10.0, -3.0});
  }
  /// Blobs of some voxels with noise, 0 to 100.
  Volume volume(SampleType type, glm::ivec3 dims, int channels = 1) {
    glm::dvec3 waves(number(0.1, 0.9), number(0.1, 0.9), number(0.1, 0.9));
    auto noise = unsigned(whole(1, 1000));
    auto valueOf = [&](glm::ivec3 v) {
      glm::dvec3 p = glm::dvec3(v) * waves;
      double smooth = std::sin(p.x + 0.5 * p.z) + std::sin(p.y - 0.3 * p.x) + std::sin(p.z + 0.2 * p.y);
      return 50.0 + 12.0 * smooth + 12.0 * hashNoise(v, noise);
    };
    // Each sample of a voxel in turn, so that channels differ.
    glm::ivec3 wide(dims.x * channels, dims.y, dims.z);
    bool isFloat = type == SampleType::Float32 || type == SampleType::Float64;
    Volume v = makeVolume(wide, type, valueOf, frame(dims), isFloat ? 0.37 : 1.0, isFloat ? -3.0 : 0.0);
    v.dims = dims;
    v.channels = channels;
    return v;
  }
  /// Three structures and much without a label.
  LabelVolume labels(const Volume& volume) {
    auto seed = unsigned(whole(1, 1000));
    glm::ivec3 cell(whole(2, 20), whole(2, 9), whole(2, 9));
    return makeLabels(
        volume.dims,
        [&](glm::ivec3 v) {
          double noise = hashNoise(v / cell, seed);
          return noise < 0.06 ? 1 : noise < 0.12 ? 2 : noise < 0.2 ? 3 : 0;
        },
        volume.worldFromVoxel);
  }

 private:
  std::mt19937 mRandom;
};

}  // namespace velum::growth
