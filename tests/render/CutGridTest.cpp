#include "render/upload/CutGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cutShapes.h"
#include "render/FrameSetup.h"
#include "render/upload/CutSheets.h"
#include "scene/Scene.h"

namespace velum::render {
namespace {

constexpr std::size_t kOutside = std::size_t(shared::kCutGrid) * shared::kCutGrid * shared::kCutGrid;

/// Cuts of all shapes but membranes, in and about a box of edge 1.
std::vector<shared::CutData> randomCuts(int count, unsigned seed) {
  std::mt19937 random(seed);
  auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  scene::Scene scene;
  auto shapes = everyShapeButMembranes();
  for (int i = 0; i < count; ++i) {
    scene::Cut cut;
    cut.shape = shapes[std::size_t(i) % shapes.size()];
    cut.centre = {number(-0.7, 0.7), number(-0.7, 0.7), number(-0.7, 0.7)};
    cut.axis = {number(-1, 1), number(-1, 1), number(0.1, 1)};
    double most = 0.5 / std::cbrt(count);
    cut.size = {number(0.02, most), number(0.02, most), number(0.02, most)};
    // Planes take corners off, and one ball all that is around it.
    if (cut.shape == scene::CutShape::Plane) cut.centre = 0.6 * glm::normalize(cut.axis);
    if (i == 0) cut.shape = scene::CutShape::Sphere, cut.centre = {}, cut.size = glm::dvec3(1.3), cut.invert = true;
    scene::addCut(scene, cut);
  }
  return makeCutData(scene, glm::dvec3(0.0), {});
}

std::size_t cellOf(glm::vec3 tex) {
  glm::ivec3 cell = glm::min(glm::ivec3(tex * float(shared::kCutGrid)), glm::ivec3(shared::kCutGrid - 1));
  return std::size_t(cell.x + shared::kCutGrid * (cell.y + shared::kCutGrid * cell.z));
}

bool anyRemoves(const std::vector<shared::CutData>& cuts, std::span<const std::uint32_t> of, glm::vec3 p) {
  return std::any_of(of.begin(), of.end(), [&](std::uint32_t i) { return shared::cutRemoves(cuts[i], p, {}); });
}

/// A box of edge about 1, sheared and turned.
glm::mat4 shearedBox() {
  return {{0.9f, 0.1f, 0.0f, 0.0f}, {0.2f, 1.0f, -0.1f, 0.0f}, {0.0f, 0.3f, 0.8f, 0.0f}, {-0.5f, -0.6f, -0.4f, 1.0f}};
}

TEST(CutGrid, TheCutsOfACellRemoveWhatAllRemove) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  for (int count : {10, 100, 400}) {
    auto cuts = randomCuts(count, unsigned(count));
    CutGrid grid = makeCutGrid(cuts, shearedBox(), false);
    auto all = grid.cutsIn(kOutside);
    ASSERT_EQ(all.size(), cuts.size());
    int removed = 0;
    for (int i = 0; i < 4000; ++i) {
      glm::vec3 tex(share(random), share(random), share(random));
      glm::vec3 p(shearedBox() * glm::vec4(tex, 1.0f));
      bool removes = anyRemoves(cuts, all, p);
      ASSERT_EQ(anyRemoves(cuts, grid.cutsIn(cellOf(tex)), p), removes);
      removed += removes;
    }
    EXPECT_GT(removed, 100);
    EXPECT_LT(removed, 3500) << "something is left to tell apart";
  }
}

TEST(CutGrid, WhereCutsSpareEachThatRemovesAPointIsListed) {
  auto cuts = randomCuts(60, 7);
  CutGrid grid = makeCutGrid(cuts, shearedBox(), true);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  for (int i = 0; i < 4000; ++i) {
    glm::vec3 tex(share(random), share(random), share(random));
    glm::vec3 p(shearedBox() * glm::vec4(tex, 1.0f));
    auto list = grid.cutsIn(cellOf(tex));
    ASSERT_TRUE(std::is_sorted(list.begin(), list.end()));
    for (std::uint32_t cut = 0; cut < cuts.size(); ++cut)
      ASSERT_TRUE(!shared::cutRemoves(cuts[cut], p, {}) || std::binary_search(list.begin(), list.end(), cut));
  }
}

TEST(CutGrid, SmallCutsAreInFewCells) {
  scene::Scene scene;
  for (int i = 0; i < 100; ++i) {
    scene::Cut cut;
    cut.shape = scene::CutShape::Sphere;
    cut.centre = {0.45 * std::sin(i), 0.45 * std::cos(i * 1.7), 0.45 * std::sin(i * 2.3)};
    cut.size = glm::dvec3(0.03);
    scene::addCut(scene, cut);
  }
  CutGrid grid = makeCutGrid(makeCutData(scene, glm::dvec3(0.0), {}), shearedBox(), false);
  std::size_t listed = grid.texels.size() - kOutside - 2 - 100;
  EXPECT_LT(double(listed) / double(kOutside), 2.0) << "cuts a cell";
}

}  // namespace
}  // namespace velum::render
