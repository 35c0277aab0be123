// A sheet on the GPU is the one that the processor makes.
#include "membrane/sheet/Sheet.h"

#include <gtest/gtest.h>

#include "GlFixture.h"
#include "ProbeShaders.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "membrane/sheet/SheetIndex.h"
#include "shared/sheet.h"
#include "sheetShapes.h"

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
  sheet.grow();  // where there is too little room for a list, who comes first is in it
  auto first = rowsOf(sheet);
  for (int i = 0; i < 5; ++i) sheet.index();
  auto again = rowsOf(sheet);
  ASSERT_EQ(again.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i)
    ASSERT_EQ(again[i], first[i]) << "row " << i << " of " << kParticles.x * kParticles.y << " particles";
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

TEST_F(SheetGL, ProgramsFindWhatTheProcessorFinds) {
  ProbeShaders probes;
  probes.add("probe.comp", R"(layout(local_size_x = 64) in;
#define MEMBRANES 1
#include "shared/sheet.h"
layout(std430, binding = 1) readonly buffer RayBlock { vec4 rays[]; };
layout(std430, binding = 2) buffer OutBlock { vec4 found[]; };
layout(location = 0) uniform ivec4 particles;
layout(location = 1) uniform vec4 halfSize;
void main() {
  int i = int(gl_GlobalInvocationID.x);
  SheetPlan plan = SheetPlan(ivec4(0, particles.xy, 0), halfSize.xyz, 1.0);
  vec3 o = rays[2 * i].xyz;
  SheetHit hit = sheetCrossing(plan, o, rays[2 * i + 1].xyz, 0.0, 1000.0);
  found[i] = vec4(hit.t, float(hit.triangle), sheetIsAbove(plan, o) ? 1.0 : 0.0, sheetDistance(plan, o));
}
)");
  gpu::Program probe = probes.make({"probe.comp"});
  constexpr int kRays = 64 * 64;
  std::mt19937 random(8);
  std::uniform_real_distribution<float> u(-1.0f, 1.0f);
  for (const auto& [name, shape] : allSheets(kParticles, kSize))
    for (bool isCoherent : {true, false}) {
      // Neighbours go different ways, or nearly the same way, as those of a picture.
      std::vector<glm::vec4> rays;
      for (int i = 0; i < kRays; ++i) {
        glm::vec3 d = isCoherent ? glm::vec3(0.004f * float(i % 64) - 0.6f, 0.004f * float(i / 64) + 0.3f, -0.4f)
                                 : glm::vec3(u(random), u(random), u(random) * (i % 2 ? 1.0f : 0.05f));
        glm::vec3 o =
            isCoherent ? glm::vec3(50, -40, 22) : glm::vec3(u(random), u(random), u(random)) * glm::vec3(55, 40, 25);
        rays.emplace_back(o, 0.0f), rays.emplace_back(glm::normalize(d), 0.0f);
      }
      membrane::Sheet sheet(shape, kParticles, kSize);
      sheet.grow();
      membrane::SheetIndex index = membrane::makeSheetIndex(shape, kParticles, kSize);
      gpu::Buffer in("rays", std::span<const glm::vec4>(rays)), out("found", kRays * sizeof(glm::vec4));
      gpu::Texture texels = gpu::Texture::makeOfBuffer("rows", gpu::Format::Rgba32f, sheet.rows());
      texels.bindSampler(shared::kSheetUnit);
      in.bindStorage(1);
      out.bindStorage(2);
      probe.set(0, glm::ivec4(index.particles, 0, 0));
      probe.set(1, glm::vec4(glm::vec3(kSize * 0.5), 0.0f));
      gpu::dispatch(probe, {kRays / 64, 1, 1});
      gpu::barrier();
      std::vector<glm::vec4> found(kRays);
      out.read(0, kRays * sizeof(glm::vec4), found.data());
      shared::SheetPlan plan{{0, index.particles, 0}, glm::vec3(kSize * 0.5), 1.0f};
      int wrongT = 0, wrongTriangle = 0, wrongSide = 0, wrongDistance = 0, hits = 0;
      for (int i = 0; i < kRays; ++i) {
        glm::vec3 o(rays[std::size_t(2 * i)]), d(rays[std::size_t(2 * i + 1)]);
        shared::SheetHit hit = shared::sheetCrossing(plan, o, d, 0, 1000, {index.rows.data()});
        glm::vec4 f = found[std::size_t(i)];
        hits += hit.triangle >= 0;
        wrongT += std::abs(f.x - hit.t) > 1e-2f;
        wrongTriangle += int(f.y) != hit.triangle;
        wrongSide += (f.z == 1.0f) != shared::sheetIsAbove(plan, o, {index.rows.data()});
        wrongDistance += std::abs(f.w - shared::sheetDistance(plan, o, {index.rows.data()})) > 1e-3f;
      }
      // Rounding may send a ray in a few thousand over the edge of a triangle, or past a fold.
      EXPECT_LE(wrongT, kRays / 1000) << name << isCoherent << " of " << hits << " hits";
      EXPECT_LE(wrongTriangle, kRays / 500) << name << isCoherent;
      EXPECT_LE(wrongSide, kRays / 1000) << name << isCoherent;
      EXPECT_LE(wrongDistance, kRays / 500) << name << isCoherent;
      EXPECT_GT(hits, kRays / 20) << name << isCoherent;
    }
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
