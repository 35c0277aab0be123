// More cuts than a word has bits: each of them takes and spares by itself.
#include <map>

#include "RenderFixture.h"
#include "render/kept/KeptVoxels.h"
#include "render/section/SectionImage.h"
#include "scene/Project.h"

namespace velum {
namespace {

constexpr glm::ivec3 kManyCutsDims(40, 12, 40);
constexpr glm::ivec2 kManyCutsSize(80, 80);  // two pixels a millimetre
constexpr int kSide = 8;                     // cuts along x and z
constexpr int kCuts = kSide * kSide;
constexpr double kPitch = 5.0;

/// A block of two structures, each a half of its depth, and 64 boxes that take all of it but for the lines between
/// them.
class ManyCutsGL : public RenderTest {
 protected:
  static glm::dvec3 middleOf(int cut) {
    return {(cut % kSide + 0.5) * kPitch - 20.0, 0.0, (cut / kSide + 0.5) * kPitch - 20.0};
  }
  /// @param spares  by cut
  static scene::Scene sceneSparing(const std::map<int, scene::Spare>& spares) {
    scene::Scene scene = sceneOf(makeVolume(
        kManyCutsDims, SampleType::UInt8, [](glm::ivec3) { return 100; }, centredFrame(kManyCutsDims)));
    makeSolid(scene);
    scene.labels.data = Shared<LabelVolume>(makeLabels(
        kManyCutsDims, [](glm::ivec3 p) { return p.y < 6 ? 2 : 9; }, scene.volume.data->worldFromVoxel));
    scene::completeStructures(scene.labels);
    for (int i = 0; i < kCuts; ++i) {
      scene::Cut box;
      box.shape = scene::CutShape::Box;
      box.axis = {0, 0, 1};
      box.size = {kPitch - 1.0, 100, kPitch - 1.0};
      box.centre = middleOf(i);
      if (spares.contains(i)) box.spares = {spares.at(i)};
      scene::addCut(scene, box);
    }
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.target = glm::dvec3(0.0);
    scene.camera.height = 40;
    lookAlong(scene, {0, -1, 0});
    return scene;
  }
  static glm::ivec2 pixelOf(const scene::Scene& scene, glm::dvec3 world) {
    return glm::ivec2(scene::pixelFromWorld(scene.camera, glm::dvec2(kManyCutsSize), world).value());
  }
};

TEST_F(ManyCutsGL, AStructureThatOneOfThemSparesIsWholeThereAndNowhereElse) {
  for (int spared : {0, 31, 32, 33, 34, 63}) {
    SCOPED_TRACE(spared);
    int other = (spared + 37) % kCuts;  // spares the half in front
    scene::Scene scene = sceneSparing({{spared, {9}}, {other, {2}}});
    Image image = draw(scene, kManyCutsSize, kAllLayers);
    Progress progress;
    auto kept = render::keptVoxels(scene, kManyCutsDims, scene.volume.data->worldFromVoxel, progress);
    auto view = scene::makeSectionPlane(scene, scene::SectionKind::Coronal, glm::dvec2(kManyCutsSize));
    scene::Scene bare = scene;
    bare.cuts.clear();
    for (double y : {-3.0, 3.0}) {
      scene.sections.crosshair.y = bare.sections.crosshair.y = y;
      auto section = render::drawSection(scene, scene::SectionKind::Coronal, kManyCutsSize);
      auto whole = render::drawSection(bare, scene::SectionKind::Coronal, kManyCutsSize);
      for (int i = 0; i < kCuts; ++i) {
        glm::dvec3 place = middleOf(i);
        place.y = y;
        bool isWhole = i == (y > 0 ? spared : other);
        glm::ivec3 voxel(glm::floor(place + 0.5 * glm::dvec3(kManyCutsDims)));
        auto at = std::size_t((voxel.z * kManyCutsDims.y + voxel.y) * kManyCutsDims.x + voxel.x);
        ASSERT_EQ(kept[at] != 0, isWhole) << "voxel of cut " << i << " at depth " << y;
        glm::ivec2 pixel(glm::floor(scene::sectionPixelFromWorld(view, place)));
        auto p = std::size_t(pixel.y * kManyCutsSize.x + pixel.x);
        ASSERT_EQ(section.pixels[p] == whole.pixels[p], isWhole) << "section of cut " << i << " at depth " << y;
      }
    }
    for (int i = 0; i < kCuts; ++i) {
      glm::ivec2 pixel = pixelOf(scene, middleOf(i));
      int id = i == spared ? 9 : i == other ? 2 : 0;
      ASSERT_EQ(sampleOf(image, pixel, "A") > 0.9f, id != 0) << "cut " << i;
      ASSERT_EQ(sampleOf(image, pixel, "id"), float(id)) << "cut " << i;
      if (id == 0) continue;
      EXPECT_NEAR(vectorOf(image, pixel, "position").y, id == 9 ? 0.0 : -6.0, 0.51)
          << "where its half begins, by a step";
      EXPECT_EQ(renderer().pick(pixel).structure, id);
    }
    EXPECT_GT(sampleOf(image, {kManyCutsSize.x / 2, kManyCutsSize.y / 2}, "A"), 0.9f)
        << "between the boxes nothing is taken";
  }
}

TEST_F(ManyCutsGL, ADepthThatOneOfThemSparesIsItsOwn) {
  for (int spared : {31, 32, 63}) {
    scene::Scene scene = sceneSparing({{spared, {2, 1.0}}});
    Image image = draw(scene, kManyCutsSize);
    for (int i = 0; i < kCuts; ++i) {
      // Half a millimetre off the box's side, 3.5 mm off its middle.
      glm::dvec3 edge = middleOf(i) + glm::dvec3(0.5 * (kPitch - 1.0) - 0.5, 0, 0);
      EXPECT_EQ(sampleOf(image, pixelOf(scene, edge), "A") > 0.9f, i == spared) << i;
      EXPECT_EQ(sampleOf(image, pixelOf(scene, middleOf(i)), "A"), 0.0f) << i;
    }
  }
}

}  // namespace
}  // namespace velum
