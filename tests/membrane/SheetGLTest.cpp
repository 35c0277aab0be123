// A sheet on the GPU is the one that the processor makes.
#include "velum/membrane/Sheet.h"

#include <gtest/gtest.h>

#include "GlFixture.h"
#include "sheetShapes.h"
#include "velum/gpu/Program.h"
#include "velum/membrane/SheetIndex.h"

namespace velum {
namespace {

constexpr glm::ivec2 kParticles(31, 26);
const glm::dvec3 kSize(120, 90, 50);

class SheetGL : public GlTest {
 protected:
  static std::vector<glm::vec4> rowsOf(const membrane::Sheet& sheet) {
    std::vector<glm::vec4> rows(sheet.rowCount());
    sheet.rows().read(0, rows.size() * sizeof(rows[0]), rows.data());
    return rows;
  }
  static void expectSame(const std::vector<glm::vec4>& rows, const membrane::SheetIndex& index,
                         const std::string& name) {
    ASSERT_GE(rows.size(), index.rows.size()) << name;
    std::size_t count = std::size_t(index.particles.x) * std::size_t(index.particles.y);
    int wrong = 0;
    for (std::size_t i = 0; i < index.rows.size() && wrong < 3; ++i) {
      bool isNormal = i >= count && i < 2 * count, isCell = i >= 2 * count && i < 3 * count;
      // Sums in another order; edges of cells are whole numbers; unused floats after the last list may be anything.
      float most = isNormal ? 1e-5f : isCell ? 1e-4f : 0.0f;
      if (i + 1 == index.rows.size()) continue;
      for (int c = 0; c < (i < 2 * count ? 3 : 4); ++c) wrong += std::abs(rows[i][c] - index.rows[i][c]) > most;
      EXPECT_EQ(wrong, 0) << name << ": row " << i << " of " << count << " particles";
    }
  }
};

TEST_F(SheetGL, IsIndexedLikeTheProcessorDoes) {
  for (const auto& [name, shape] : allSheets(kParticles, kSize)) {
    membrane::Sheet sheet(shape, kParticles, kSize);
    sheet.grow();
    expectSame(rowsOf(sheet), membrane::makeSheetIndex(shape, kParticles, kSize), name);
    EXPECT_EQ(sheet.shape(), membrane::fitShape(shape, kParticles, kSize)) << name;
  }
}

TEST_F(SheetGL, PlacesWrittenByAProgramAreIndexedOnTheGpu) {
  membrane::Sheet sheet({}, kParticles, kSize);
  auto before = sheet.revision();
  scene::SheetShape dome = domeSheet(kParticles, kSize);
  std::vector<glm::vec4> places;
  for (glm::vec3 p : dome.places) places.emplace_back(p, 0.0f);
  gpu::Buffer written("written", std::span<const glm::vec4>(places));
  written.copyTo(sheet.rows(), 0);
  sheet.index();
  EXPECT_NE(sheet.revision(), before);
  expectSame(rowsOf(sheet), membrane::makeSheetIndex(sheet.shape(), kParticles, kSize), "dome");
}

TEST_F(SheetGL, IndexingTwiceChangesNothing) {
  membrane::Sheet sheet(crumpledSheet(kParticles, kSize, 9), kParticles, kSize);
  auto first = rowsOf(sheet);
  for (int i = 0; i < 5; ++i) sheet.index();
  EXPECT_EQ(rowsOf(sheet), first);
}

TEST_F(SheetGL, GrowsWhenItIsStretchedBeyondMeasure) {
  scene::SheetShape wild = crumpledSheet(kParticles, kSize, 3, 1.0f);
  membrane::Sheet sheet(wild, kParticles, kSize);
  std::size_t small = sheet.rowCount();
  EXPECT_TRUE(sheet.grow());
  EXPECT_GT(sheet.rowCount(), small);
  EXPECT_FALSE(sheet.grow());
  expectSame(rowsOf(sheet), membrane::makeSheetIndex(wild, kParticles, kSize), "wild");
  membrane::Sheet calm({}, kParticles, kSize);
  EXPECT_FALSE(calm.grow());
}

TEST_F(SheetGL, AnotherShapeMayHaveOtherParticles) {
  membrane::Sheet sheet(domeSheet({9, 12}, kSize), kParticles, kSize);
  EXPECT_EQ(sheet.particles(), glm::ivec2(9, 12));
  sheet.setShape({}, {40, 20}, kSize * 2.0);
  EXPECT_EQ(sheet.particles(), glm::ivec2(40, 20));
  expectSame(rowsOf(sheet), membrane::makeSheetIndex({}, {40, 20}, kSize * 2.0), "flat");
}

}  // namespace
}  // namespace velum
