// The light grid's coarser levels.
#include <vector>

#include "GlFixture.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "shared/frame.h"

namespace velum {
namespace {

class LightMeansGL : public GlTest {};

/// Where drivers make them, cells of odd numbers fall out, and all that is behind them is displaced by half a cell.
TEST_F(LightMeansGL, KeepASlopeInItsPlaceWhateverTheGridsSize) {
  const glm::dvec3 kSlope(2, -1, 0.5);
  auto slopeAt = [&](glm::dvec3 place) { return 3.0 + glm::dot(place, kSlope); };
  gpu::Program program({"render/light_means.comp"});
  for (glm::ivec3 size : {glm::ivec3(32, 16, 8), glm::ivec3(37, 5, 3), glm::ivec3(95, 71, 59), glm::ivec3(7, 1, 15)}) {
    int levels = gpu::levelCountOf(size);
    gpu::Texture grid = gpu::Texture::make3d("test", gpu::Format::R32f, size, gpu::Filter::Linear, levels);
    auto valuesOf = [&](int level) {
      glm::ivec3 cells = grid.size(level);
      std::vector<float> values;
      for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
          for (int x = 0; x < cells.x; ++x)
            values.push_back(float(slopeAt((glm::dvec3(x, y, z) + 0.5) / glm::dvec3(cells))));
      return values;
    };
    grid.write({0, 0, 0}, size, valuesOf(0).data());
    for (int level = 1; level < levels; ++level) {
      program.set(0, level);
      grid.bindSampler(shared::kLightExtinctionUnit);
      grid.bindImage(shared::kLightImage, gpu::Access::Write, level);
      gpu::dispatch(program, (grid.size(level) + 3) / 4);
      gpu::barrier();
      std::vector<float> wanted = valuesOf(level), seen(wanted.size());
      grid.read(seen.data(), seen.size() * sizeof(float), level);
      // A cell of which a part counts counts with its own mean.
      glm::dvec3 before = glm::notEqual(grid.size(level - 1) % grid.size(level), glm::ivec3(0));
      double most = 1e-4 + 0.3 * glm::dot(before / glm::dvec3(grid.size(level - 1)), glm::abs(kSlope));
      for (std::size_t i = 0; i < seen.size(); ++i)
        ASSERT_NEAR(seen[i], wanted[i], most) << size.x << " x " << size.y << " x " << size.z << ", level " << level;
      grid.write({0, 0, 0}, grid.size(level), wanted.data(), level);
    }
  }
}

}  // namespace
}  // namespace velum
