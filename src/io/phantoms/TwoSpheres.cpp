#include "io/phantoms/Phantom.h"

namespace velum::io {

using namespace phantom;

/// The synthetic dataset of [IMC] fig. 5: two spheres on either side of the slice z = 0, each reaching a little
/// through it, so that a plane cuts both and a sheet that is pushed away from both keeps them whole.
Sample makeTwoSpheres(int size, Progress& progress) {
  Grid grid{glm::ivec3(size), Vec(128.0f / float(size))};
  constexpr float kRadiusMm = 26.0f, kValue = 1000.0f, kNoise = 8.0f;
  const Vec upper(-29.0f, 0.0f, 14.0f), lower(29.0f, 0.0f, -14.0f);
  Description description{"two-spheres",
                          SampleType::Int16,
                          Modality::Unknown,
                          "",
                          {{1, "upper sphere", {0.90f, 0.55f, 0.25f}}, {2, "lower sphere", {0.30f, 0.60f, 0.85f}}}};
  auto layerOf = [&](std::uint16_t label, Vec centre) {
    Layer layer{label, kValue};
    layer.solids.push_back({boxAround(centre, Vec(kRadiusMm)), [=](Vec p) { return sphere(p, centre, kRadiusMm); }});
    layer.edge = 4.0f;  // Soft, so that gradients are defined over a few voxels on both sides.
    return layer;
  };
  std::vector<Layer> layers{layerOf(1, upper), layerOf(2, lower)};
  return fill(description, grid, progress, [&](const Slice& slice) {
    paint(slice, layers);
    std::uint64_t first = grid.index(0, 0, slice.z);
    for (std::size_t i = 0; i < slice.values.size(); ++i) slice.values[i] += kNoise * gaussian(hash(0x2511, first + i));
  });
}

}  // namespace velum::io
