// The areas of structures against pictures of them.
#include <algorithm>
#include <map>

#include "GlFixture.h"
#include "PyramidSource.h"
#include "makeModel.h"
#include "makeVolume.h"
#include "render/Renderer.h"
#include "session/extrusion/AreaSolver.h"
#include "session/model/PictureCounter.h"
#include "session/structure/StructureAreas.h"

namespace velum::session {

namespace {

const glm::ivec2 kStructureAreasSize(96, 72);

/// Two solid balls, the second mostly behind the first, and a plane that takes half of both. Voxels as they are: labels
/// alone would be drawn smoothed.
scene::Scene twoBalls() {
  glm::ivec3 dims(40, 60, 40);
  LabelVolume labels = makeLabels(
      dims,
      [](glm::ivec3 v) {
        glm::dvec3 p(v);
        return glm::distance(p, glm::dvec3(20, 15, 20)) < 11   ? 3
               : glm::distance(p, glm::dvec3(20, 45, 22)) < 12 ? 7
                                                               : 0;
      },
      centredFrame(dims));
  scene::Scene scene;
  scene.labels.data = Shared<LabelVolume>(std::move(labels));
  scene::completeStructures(scene.labels);
  scene.labels.unlabelled = 0.0;
  scene.volume.data = Shared<Volume>(makeVolume(
      dims, SampleType::UInt8, [](glm::ivec3) { return 9; }, centredFrame(dims)));
  scene.volume.transfer.colors = {{0, glm::vec3(0.8f)}};
  scene.volume.transfer.opacities = {{0, 0.999}, {1, 0.999}};
  scene.volume.transfer.unitDistance = 0.02;
  scene.camera =
      scene::frameCamera(scene, scene::StandardView::Anterior, double(kStructureAreasSize.x) / kStructureAreasSize.y);
  scene::Cut cut;
  cut.id = 1;
  cut.axis = {0.2, 0.1, 1.0};
  scene.cuts = {cut};
  return scene;
}

class StructureAreasGL : public GlTest {
 protected:
  static render::Renderer& renderer() {
    static auto* one = new render::Renderer(context());  // its programs take a driver for processors seconds to compile
    return *one;
  }
  std::map<int, StructureArea> areasOf(const scene::Scene& scene, const Image& picture) {
    std::map<int, StructureArea> areas;
    auto hits = render::structureHits(scene, kStructureAreasSize, {1}, mProgress);
    for (const StructureArea& area : structureAreas(scene, hits, picture)) areas[area.structure] = area;
    return areas;
  }
  Image draw(const scene::Scene& scene) {
    return PictureCounter(renderer(), kStructureAreasSize, context().limits(), mProgress).structures(scene);
  }

  Progress mProgress;
};

}  // namespace

TEST_F(StructureAreasGL, AStreamedVolumeChangesNone) {
  scene::Scene whole = twoBalls(), streamed = whole;
  auto source = std::make_shared<PyramidSource>(*whole.volume.data, 3, glm::ivec3(16));
  streamed.volume.data = Shared<Volume>(streamedVolume(source, 2));
  EXPECT_EQ(areasOf(streamed, draw(streamed)), areasOf(whole, draw(whole)));
}

TEST_F(StructureAreasGL, RaysAndPicturesTellTheSame) {
  scene::Scene scene = twoBalls();
  Image picture = draw(scene);
  auto areas = areasOf(scene, picture);
  std::map<int, std::uint64_t> met, seen;
  for (const auto& hit : render::structureHits(scene, kStructureAreasSize, {1}, mProgress)) ++met[hit.structure];
  std::size_t column =
      std::size_t(std::find(picture.channels.begin(), picture.channels.end(), "id") - picture.channels.begin());
  for (std::size_t i = column; i < picture.pixels.size(); i += picture.channels.size()) ++seen[int(picture.pixels[i])];
  for (int id : {3, 7}) {
    EXPECT_EQ(areas[id].count.visible(), seen[id]);
    // The picture's rays take steps of half a voxel: at an outline they may meet what a walk from voxel to voxel does
    // not.
    EXPECT_NEAR(double(areas[id].count.total()), double(met[id]), 3.0) << id;
    EXPECT_GT(areas[id].count.clipped(), 50u) << id;
  }
  EXPECT_LT(areas[3].count.hidden(), areas[3].count.visible() / 20) << "nothing stands before the first";
  EXPECT_GT(areas[7].count.hidden(), areas[7].count.visible());
  // Without cuts nothing is clipped, and what shows or is hidden is all.
  scene.cuts.clear();
  auto whole = areasOf(scene, draw(scene));
  for (int id : {3, 7}) {
    EXPECT_EQ(whole[id].count.clipped(), 0u);
    EXPECT_NEAR(double(whole[id].count.total()), double(areas[id].count.total()), 3.0);
  }
}

TEST_F(StructureAreasGL, APictureOfWhatWasSolvedShowsAsMuch) {
  scene::Scene scene = twoBalls();
  AreaSolver solver(scene, {1}, 3, render::structureHits(scene, kStructureAreasSize, {1}, mProgress));
  std::uint64_t before = 0;
  for (double share : {0.0, 0.3, 0.7, 1.0}) {
    SolvedArea solved =
        solver.solve(double(solver.range().least) + share * double(solver.range().most - solver.range().least));
    StructureArea area = areasOf(solved.scene, draw(solved.scene))[3];
    // Along an end face a sample of the picture may lie just beyond it, and a walk's middle of a voxel before it.
    EXPECT_NEAR(double(area.count.left()), double(solved.reached), 0.02 * double(solver.range().total));
    EXPECT_NEAR(double(area.count.visible()), double(solved.reached), 0.05 * double(solver.range().total));
    EXPECT_GE(area.count.visible(), before);
    before = area.count.visible();
  }
}

TEST_F(StructureAreasGL, InstancesAreCountedInWindowsAsInOnePicture) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.instances = 600}.make());
  scene.camera =
      scene::frameCamera(scene, scene::StandardView::Oblique, double(kStructureAreasSize.x) / kStructureAreasSize.y);
  scene::Cut ball;
  ball.shape = scene::CutShape::Sphere;
  ball.size = glm::dvec3(250.0);
  scene::addCut(scene, ball);
  gpu::Limits limits = context().limits();
  PictureCounter inOne(renderer(), kStructureAreasSize, limits, mProgress);
  limits.texture2d = 40;  // three windows beside each other, two below each other
  PictureCounter inWindows(renderer(), kStructureAreasSize, limits, mProgress);
  const render::InstanceBits &one = inOne.count(scene), &several = inWindows.count(scene);
  EXPECT_EQ(several.removed, one.removed);
  EXPECT_EQ(several.shown, one.shown);
  EXPECT_GT(std::count_if(one.shown.begin(), one.shown.end(), [](std::uint32_t word) { return word != 0; }), 10);
}

}  // namespace velum::session
