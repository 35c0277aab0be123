#include "io/phantoms/Vessels.h"

#include <algorithm>

namespace velum::io {

float phantom::vesselOrgan(Vec p) {
  float body = ellipsoid(p, Vec(0.0f, 0.0f, 4.0f), Vec(57.0f, 47.0f, 51.0f));
  return smoothMax(body, -sphere(p, Vec(0.0f, 6.0f, -66.0f), 24.0f), 14.0f);
}

phantom::Tree phantom::growVessels(Vec root, float rootRadiusMm, float leastRadiusMm, float pitchMm,
                                   std::uint64_t seed) {
  TreeOptions options;
  options.root = root;
  options.rootRadiusMm = rootRadiusMm;
  options.leastRadiusMm = leastRadiusMm;
  options.seed = seed;
  options.wobble = 0.09f;
  return growTree(scatter(boxAround(Vec(0.0f), Vec(64.0f)), pitchMm, vesselOrgan, 2.0f, seed), options);
}

using namespace phantom;

namespace {

constexpr float kExtentMm = 128.0f, kPitchMm = 11.0f;

std::vector<Layer> buildScene(float spacing) {
  // A tube thinner than this would fall apart between the voxels.
  float least = std::max(0.45f, 0.9f * spacing);
  Tree arteries = growVessels(Vec(-7.0f, 4.0f, -63.5f), 4.4f, least, kPitchMm, 11);
  Tree veins = growVessels(Vec(8.0f, 8.0f, -63.5f), 5.4f, least, kPitchMm, 23);
  pushApart(veins, arteries, std::max(0.8f, 1.2f * spacing));

  Layer tissue{0, 300.0f};
  tissue.solids.push_back({boxAround(Vec(0.0f), Vec(64.0f)), vesselOrgan});
  tissue.texture = [](Vec p) { return 40.0f * roughNoise(p / 9.0f, 5); };
  tissue.edge = 3.0f;
  Layer blue{2, 1150.0f}, red{1, 1600.0f};
  blue.tubes = segments(veins);
  red.tubes = segments(arteries);
  return {tissue, blue, red};
}

}  // namespace

/// Two vascular trees that fill an organ without touching, with Murray's radii, in the noise of an angiography.
Sample makeVessels(int size, Progress& progress) {
  Grid grid{glm::ivec3(size), Vec(kExtentMm / float(size))};
  Description description{"vessels",
                          SampleType::UInt16,
                          Modality::Angiography,
                          "",
                          {{1, "arterial tree", {0.84f, 0.16f, 0.15f}}, {2, "venous tree", {0.20f, 0.38f, 0.80f}}}};
  std::vector<Layer> layers = buildScene(grid.spacing.x);
  return fill(description, grid, progress, [&](const Slice& slice) {
    std::fill(slice.values.begin(), slice.values.end(), 140.0f);
    paint(slice, layers);
    std::uint64_t first = grid.index(0, 0, slice.z);
    // Photon noise grows with the root of the signal.
    for (std::size_t i = 0; i < slice.values.size(); ++i)
      slice.values[i] += (14.0f + 0.9f * std::sqrt(slice.values[i])) * gaussian(hash(0x7e55e1, first + i));
  });
}

}  // namespace velum::io
