#include "io/phantoms/Phantom.h"

#include <gtest/gtest.h>

#include "io/phantoms/Heart.h"

/// What phantoms are made with. The painter leaves out what it can: here every voxel is asked.
namespace velum::io::phantom {
namespace {

struct Painted {
  std::vector<float> values;
  std::vector<std::uint16_t> labels;
};

Painted paintAll(const Grid& grid, std::span<const Layer> layers) {
  Painted out;
  std::size_t slice = std::size_t(grid.dims.x) * std::size_t(grid.dims.y);
  for (int z = 0; z < grid.dims.z; ++z) {
    std::vector<float> values(slice, 0.0f);
    std::vector<std::uint16_t> labels(slice, 0);
    paint({grid, z, values, labels}, layers);
    out.values.insert(out.values.end(), values.begin(), values.end());
    out.labels.insert(out.labels.end(), labels.begin(), labels.end());
  }
  return out;
}

TEST(Painter, LeavesNothingOutByItsBoxesAndLeaps) {
  const Grid grid{{61, 45, 33}, {1.0f, 1.3f, 2.1f}};
  struct Ball {
    Vec centre;
    float radius;
  };
  const Ball balls[] = {{{0.3f, -2.0f, 1.1f}, 11.0f}, {{16.0f, 7.5f, -9.0f}, 7.2f}, {{-20.0f, -11.0f, 14.0f}, 4.4f}};
  for (float stretch : {1.0f, 2.0f}) {  // a distance may be said twice as long as it is
    auto distanceTo = [&](Vec p) {
      float nearest = 1e9f;
      for (const Ball& ball : balls) nearest = std::min(nearest, stretch * sphere(p, ball.centre, ball.radius));
      return nearest;
    };
    Layer layer{3, 100.0f};
    for (const Ball& ball : balls)
      layer.solids.push_back({boxAround(ball.centre, Vec(ball.radius)),
                              [=](Vec p) { return stretch * sphere(p, ball.centre, ball.radius); }});
    Painted got = paintAll(grid, std::span(&layer, 1));
    float edgeMm = 0.75f * layer.edge * (1.0f + 1.3f + 2.1f) / 3.0f;
    for (int z = 0; z < grid.dims.z; ++z)
      for (int y = 0; y < grid.dims.y; ++y)
        for (int x = 0; x < grid.dims.x; ++x) {
          float depth = glm::clamp(0.5f - 0.5f * distanceTo(grid.at(x, y, z)) / edgeMm, 0.0f, 1.0f);
          float coverage = depth * depth * (3.0f - 2.0f * depth);
          std::size_t i = grid.index(x, y, z);
          ASSERT_NEAR(got.values[i], 100.0f * coverage, 1e-3f) << x << " " << y << " " << z << ", " << stretch;
          ASSERT_EQ(got.labels[i], coverage >= 0.5f ? 3 : 0) << x << " " << y << " " << z << ", " << stretch;
        }
  }
}

TEST(Painter, ValuesAreRoundedToTheNearestWholeNumber) {
  const Grid grid{{8, 2, 1}, Vec(1.0f)};
  const float written[] = {0.4f, 0.6f, -0.4f, -0.6f, 99.5f, 254.7f, 1e9f, -1e9f};
  auto valuesOf = [&](SampleType type) {
    Progress progress;
    Sample sample = fill({"values", type, Modality::Unknown, "", {}}, grid, progress, [&](const Slice& slice) {
      for (std::size_t i = 0; i < slice.values.size(); ++i) slice.values[i] = written[i % 8];
    });
    std::vector<double> out;
    for (int x = 0; x < 8; ++x) out.push_back(valueAt(sample.volume, {x, 1, 0}));
    return out;
  };
  EXPECT_EQ(valuesOf(SampleType::UInt8), (std::vector<double>{0, 1, 0, 0, 100, 255, 255, 0}));
  EXPECT_EQ(valuesOf(SampleType::Int16), (std::vector<double>{0, 1, 0, -1, 100, 255, 32767, -32768}));
}

TEST(Beat, RestIsWhereMovedCameFrom) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    heart::Beat beat(random.uniform());
    Vec rest = 60.0f * Vec(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    EXPECT_LT(glm::length(beat.rest(beat.moved(rest)) - rest), 0.02f) << "mm, phase " << i;
  }
}

}  // namespace
}  // namespace velum::io::phantom
