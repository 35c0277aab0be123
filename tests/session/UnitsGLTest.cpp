// A virus and a survey are drawn as a patient is: the same phantom at 1 angstrom, 1 mm and 1 km a voxel.
#include <functional>

#include "RenderFixture.h"
#include "cutShapes.h"
#include "io/phantoms/Sample.h"
#include "scene/Units.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/DefaultField.h"
#include "session/membrane/Membranes.h"

namespace velum::session {
namespace {

constexpr glm::ivec2 kUnitsSize(72, 60);

/// Everything at once: a phantom with labels, a mesh, light with shadows.
class UnitsGL : public RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    io::Sample sample = io::makeSample("torso", 40, mProgress);
    mScene = sceneOf(std::move(sample.volume));
    mScene.labels.data = Shared<LabelVolume>(std::move(sample.labels));
    scene::completeStructures(mScene.labels);
    mScene.labels.tint = 0.5;
    mScene.volume.transfer.colors = {{-100, {0.6f, 0.3f, 0.2f}}, {400, {1.0f, 0.95f, 0.85f}}};
    mScene.volume.transfer.opacities = {{-150, 0.0}, {50, 0.1}, {300, 0.6}, {700, 0.95}};
    mScene.volume.transfer.gradientOpacities = {{0, 0.6}, {20, 1.0}};
    mScene.volume.transfer.unitDistance = spacingOf(*mScene.volume.data).x;
    mScene.rayCast.isoValue = 200;
    mScene.lighting.shaded = true;
    mScene.lighting.shadow = mScene.lighting.occlusion = 0.7;
    mScene.camera = scene::frameCamera(mScene, scene::StandardView::Oblique, 1.2);
    scene::placeSections(mScene);
  }

  /// The scene with a voxel of so much of its unit.
  static scene::Scene withVoxelOf(scene::Scene scene, double voxel, LengthUnit unit = LengthUnit::Millimetre) {
    double factor = voxel / spacingOf(*scene.volume.data).x;
    scene::scaleLengths(scene, factor);
    scene.unit = unit;
    auto scaled = [&](glm::dmat4 m) {
      for (int column = 0; column < 4; ++column) m[column] = glm::dvec4(glm::dvec3(m[column]) * factor, m[column].w);
      return m;
    };
    Volume volume = *scene.volume.data;
    volume.worldFromVoxel = scaled(volume.worldFromVoxel);
    LabelVolume labels(scene.labels.data->dims(), scaled(scene.labels.data->worldFromVoxel()));
    std::vector<std::uint16_t> ids(voxelCount(volume));
    scene.labels.data->read({0, 0, 0}, labels.dims(), ids);
    labels.write({0, 0, 0}, labels.dims(), ids);
    scene.volume.data = Shared<Volume>(std::move(volume));
    scene.labels.data = Shared<LabelVolume>(std::move(labels));
    return scene;
  }

  /// @param finish  what is to be done to a scene once it has its size
  void expectSamePictures(const std::string& what, const std::function<void(scene::Scene&)>& finish = {}) {
    SCOPED_TRACE(what);
    auto picture = [&](double voxel, LengthUnit unit) {
      scene::Scene scene = withVoxelOf(mScene, voxel, unit);
      if (finish) finish(scene);
      return drawWith(renderer(), scene, kUnitsSize, kAllLayers);
    };
    Image wanted = picture(1.0, LengthUnit::Millimetre);
    EXPECT_GT(coverageOf(wanted), 0.1);
    struct Case {
      const char* name;
      double voxel;
      LengthUnit unit;
    };
    for (Case c : {Case{"1 angstrom", 1.0, LengthUnit::Angstrom},
                   Case{"1 angstrom in mm", 1e-7, LengthUnit::Millimetre}, Case{"1 km", 1e6, LengthUnit::Millimetre}}) {
      Image is = picture(c.voxel, c.unit);
      Difference off = differenceOf(wanted, is);
      EXPECT_LE(off.largest, 1.0) << c.name << ", at " << off.where.x << ", " << off.where.y;
      expectSameDepths(wanted, is, c.voxel, c.name);
    }
  }

  scene::Cut cutOf(scene::CutShape shape) const {
    scene::Cut cut = makeCut(mScene, shape);
    if (shape == scene::CutShape::Membrane) {
      cut.membrane->field = defaultField(mScene);
      cut.membrane->cloth.particles = {24, 24};
      cut.membrane->cloth.finest = 40;
    }
    return cut;
  }

  Progress mProgress;
  scene::Scene mScene;

 private:
  /// The layers are in the scene's unit.
  static void expectSameDepths(const Image& wanted, const Image& is, double voxel, const char* name) {
    int wrong = 0, shown = 0;
    for (int y = 0; y < kUnitsSize.y; ++y)
      for (int x = 0; x < kUnitsSize.x; ++x) {
        float a = sampleOf(wanted, {x, y}, "Z"), b = sampleOf(is, {x, y}, "Z");
        if (!std::isfinite(a) && !std::isfinite(b)) continue;
        ++shown;
        wrong += !(std::abs(double(b) / voxel - double(a)) < 0.02);
      }
    EXPECT_LE(wrong, shown / 500) << name << ": depths off by more than a fiftieth of a voxel";
  }
};

TEST_F(UnitsGL, AVolumeWithoutCutsIsDrawnTheSame) { expectSamePictures("volume"); }

TEST_F(UnitsGL, AnIsosurfaceAndAMaximumAreDrawnTheSame) {
  for (auto mode : {scene::RenderMode::Iso, scene::RenderMode::Mip}) {
    mScene.rayCast.mode = mode;
    expectSamePictures(std::string(enumName(mode)));
  }
}

TEST_F(UnitsGL, EveryShapeOfCutIsDrawnTheSame) {
  for (auto shape : everyShapeButMembranes()) {
    mScene.cuts.clear();
    scene::Cut cut = cutOf(shape);
    cut.face = scene::CutFace::Section;
    cut.spares = {{3}, {1, 4.5 * spacingOf(*mScene.volume.data).x}};
    scene::addCut(mScene, cut);
    expectSamePictures(std::string(enumName(shape)));
  }
}

TEST_F(UnitsGL, AMembraneSettlesAndIsDrawnTheSame) {
  for (auto use : {scene::MembraneUse::Clip, scene::MembraneUse::Inlay}) {
    mScene.cuts.clear();
    scene::Cut cut = cutOf(scene::CutShape::Membrane);
    cut.membrane->use = use;
    cut.membrane->look = scene::SheetLook::Grid;
    scene::addCut(mScene, cut);
    expectSamePictures(std::string(enumName(use)), [&](scene::Scene& scene) {
      settleMembranes(scene, {}, mProgress);
      double highest = 0;
      for (const auto& p : scene.cuts[0].membrane->shape.places) highest = std::max(highest, std::abs(double(p.z)));
      EXPECT_GT(highest, 2.0 * spacingOf(*scene.volume.data).x) << "the sheet hangs flat";
    });
  }
}

}  // namespace
}  // namespace velum::session
