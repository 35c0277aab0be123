#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "velum/io/phantoms/Sample.h"
#include "velum/membrane/forces/Kernels.h"
#include "velum/session/membrane/MembraneEdit.h"

namespace velum::session {
namespace {

Progress sProgress;

/// A share of what two sets of voxels hold together: 1 where they are the same.
double diceOf(const std::vector<std::uint8_t>& mask, const LabelVolume& truth) {
  glm::ivec3 n = truth.dims();
  std::size_t both = 0, found = 0, all = 0, i = 0;
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x, ++i) {
        bool isTrue = truth.at({x, y, z}) != 0;
        both += isTrue && mask[i];
        found += mask[i] != 0;
        all += isTrue;
      }
  return 2.0 * double(both) / double(found + all);
}

/// Voxels of fibres spread over the data, each in the middle of one: where somebody would click.
std::vector<glm::ivec3> clicksOn(const LabelVolume& truth, int count) {
  glm::ivec3 n = truth.dims();
  std::vector<glm::ivec3> middles;
  for (int z = 2; z < n.z - 2; ++z)
    for (int y = 2; y < n.y - 2; ++y)
      for (int x = 2; x < n.x - 2; ++x) {
        bool isMiddle = truth.at({x, y, z}) != 0;
        for (int axis = 0; axis < 3 && isMiddle; ++axis)
          for (int side : {-1, 1}) {
            glm::ivec3 p(x, y, z);
            p[axis] += side;
            isMiddle = isMiddle && truth.at(p) != 0;
          }
        if (isMiddle) middles.push_back({x, y, z});
      }
  std::vector<glm::ivec3> clicks;
  for (int i = 0; i < count && !middles.empty(); ++i)
    clicks.push_back(middles[(std::size_t(i) * 2 + 1) * middles.size() / (std::size_t(count) * 2)]);
  return clicks;
}

TEST(ProtectInNoise, Explore) {
  int size = std::getenv("N") ? std::atoi(std::getenv("N")) : 128;
  double contrast = std::getenv("C") ? std::atof(std::getenv("C")) : 3.0;
  io::Sample sample = io::makeSample("fibres", size, sProgress, 0, contrast);
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(sample.volume));
  const Volume& volume = *scene.volume.data;
  membrane::Potential potential(scene);
  std::vector<double> dices;
  for (glm::ivec3 click : clicksOn(sample.labels, 24)) {
    scene::Membrane membrane;
    auto tissue =
        protectTissue(membrane, scene.volume, glm::dvec3(volume.worldFromVoxel * glm::dvec4(glm::dvec3(click), 1.0)));
    ASSERT_TRUE(tissue);
    std::printf("value %.0f low %.0f spread %.0f curve", tissue->value, tissue->low.value_or(-1), tissue->spread);
    for (auto p : membrane.field.byValue) std::printf(" %.0f:%.0f", p.value, p.strength);
    auto dice = [&] {
      return diceOf(potential.computeProtected(membrane.field, {{0, 0, 0}, volume.dims}, sProgress).mask,
                    sample.labels);
    };
    auto out = potential.computeLeftOut(membrane.field, sProgress);
    double d = dice();
    membrane.field.leastPiece = 1;
    double d1 = dice();
    bool denoise = membrane.field.denoise;
    membrane.field.denoise = false;
    std::printf(" denoise %d least %d (%zu pieces %zu voxels of %zu) dice %.3f all pieces %.3f raw %.3f\n", denoise,
                out.leastPiece, out.pieces, out.voxels, out.protectedVoxels, d, d1, dice());
    dices.push_back(d);
  }
  std::sort(dices.begin(), dices.end());
  std::printf("median %.3f\n", dices[dices.size() / 2]);
}

}  // namespace
}  // namespace velum::session
