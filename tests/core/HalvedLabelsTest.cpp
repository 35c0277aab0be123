// Labels in voxels twice as long.
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "core/HalvedLabels.h"

namespace velum {
namespace {

/// Blobs of a few ids, uneven sizes.
LabelVolume blobs(glm::ivec3 dims) {
  LabelVolume labels(dims, glm::dmat4(1.0));
  std::vector<std::uint16_t> ids;
  glm::ivec3 p;
  for (p.z = 0; p.z < dims.z; ++p.z)
    for (p.y = 0; p.y < dims.y; ++p.y)
      for (p.x = 0; p.x < dims.x; ++p.x) {
        bool isThread = p.y == 40 && p.z == 11;
        bool isBall = glm::length(glm::dvec3(p) - glm::dvec3(70, 30, 20)) < 17.0;
        ids.push_back(isThread ? 5 : isBall ? 2 : (p.x * 7 + p.y * 3 + p.z) % 97 == 0 ? 9 : 0);
      }
  labels.write(glm::ivec3(0), dims, ids);
  return labels;
}

/// That each voxel has as many of its eight as any other id, and is none of 0 where another has as many.
void expectHalved(const LabelVolume& fine, const LabelVolume& halved) {
  ASSERT_EQ(halved.dims(), (fine.dims() + 1) / 2);
  glm::ivec3 p;
  for (p.z = 0; p.z < halved.dims().z; ++p.z)
    for (p.y = 0; p.y < halved.dims().y; ++p.y)
      for (p.x = 0; p.x < halved.dims().x; ++p.x) {
        std::map<int, int> counts;
        for (int i = 0; i < 8; ++i) {
          glm::ivec3 q = 2 * p + glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
          if (glm::all(glm::lessThan(q, fine.dims()))) ++counts[fine.at(q)];
        }
        int own = counts[halved.at(p)];
        for (auto [id, count] : counts)
          ASSERT_TRUE(count < own || (count == own && (halved.at(p) != 0 || id == 0)))
              << p.x << ' ' << p.y << ' ' << p.z << ": " << id;
      }
}

TEST(HalvedLabels, HaveTheIdThatMostOfEightHave) {
  Shared<LabelVolume> fine(blobs({101, 66, 39}));
  HalvedLabels halves;
  expectHalved(*fine, *halves.update(fine));
  EXPECT_EQ(halves.update(fine)->at({50, 20, 5}), 0);  // two of eight are the thread's
  glm::dvec4 corner = halves.update(fine)->worldFromVoxel() * glm::dvec4(-0.5, -0.5, -0.5, 1.0);
  EXPECT_EQ(corner, glm::dvec4(-0.5, -0.5, -0.5, 1.0));
}

TEST(HalvedLabels, FollowEdits) {
  LabelVolume labels = blobs({101, 66, 39});
  HalvedLabels halves;
  Shared<LabelVolume> before(labels), first = halves.update(before);
  std::vector<std::uint16_t> ids(9 * 8 * 7, 3);
  labels.write({60, 29, 28}, {9, 8, 7}, ids);
  Shared<LabelVolume> after(std::move(labels));
  expectHalved(*after, *halves.update(after));
  EXPECT_EQ(halves.update(after)->brickId({0, 1, 0}), first->brickId({0, 1, 0}));
}

}  // namespace
}  // namespace velum
