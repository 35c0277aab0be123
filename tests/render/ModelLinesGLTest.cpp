// The lines of cell models: how wide each kind is, and where there are none.
#include "FinishFixture.h"
#include "makeModel.h"

namespace velum {
namespace {

constexpr double kWidth = 12.0;                // of the finish, pixels of a picture of 1000 rows
constexpr double kStrong = 1.6, kFine = 0.85;  // of it
constexpr double kView = 12.0;                 // of the picture, angstrom
constexpr float kAside = 1.2f;                 // less than an atom's radius

class ModelLinesGL : public FinishFixture {
 protected:
  /// Two white atoms that meet in the picture's middle, seen from the front. @param deep  how far the right one is
  /// behind
  static scene::Scene pair(bool inTwoCompartments, float deep = 0.0f) {
    ModelBuilder builder("pair");
    for (int i = 0; i < 2; ++i) {
      MoleculeType type;
      type.name = "atom" + std::to_string(i);
      type.color = glm::vec3(1.0f);
      type.compartment = builder.compartment(std::vector<std::string>{inTwoCompartments && i > 0 ? "b" : "a"});
      std::uint32_t molecule = builder.addMolecule(builder.addType(type), {{glm::vec3(0.0f), std::uint8_t(6), 0}});
      builder.addInstance(molecule, {i > 0 ? kAside : -kAside, i > 0 ? deep : 0.0f, 0.0f}, glm::quat(1, 0, 0, 0));
    }
    scene::Scene scene;
    scene.unit = LengthUnit::Angstrom;
    scene.model.data = Shared<Model>(builder.build());
    scene.lighting.shaded = false;
    scene.background.top = scene.background.bottom = glm::vec3(1.0f);
    scene.camera.target = {0, 0, 0};
    lookAlong(scene, {0, -1, 0});
    seenFromFront(scene);
    scene.camera.height = kView;
    scene.finish.contours = 1.0;
    scene.finish.contourWidth = kWidth;
    return scene;
  }
  static double pixels(double widths, int rows) { return widths * kWidth * rows / 1000.0; }
};

TEST_F(ModelLinesGL, OutlinesAreStrongAndLinesBetweenInstancesFineInPicturesOfAnySize) {
  for (int rows : {120, 240, 480, 960}) {
    Image left = intensity(pair(false), {rows, rows});
    Line fine = lineAlong(left, {rows / 2 - rows / 12, rows / 2}, {1, 0});
    Line outline = lineAlong(left, {rows / 2 - int(kAside * float(rows) / kView), rows / 2}, {-1, 0});
    EXPECT_EQ(outline.runs, 1) << rows;
    EXPECT_NEAR(outline.ink, pixels(kStrong, rows), 0.12 * pixels(kStrong, rows) + 0.3) << rows;
    EXPECT_NEAR(fine.ink - outline.ink, pixels(kFine, rows), 0.12 * pixels(kFine, rows) + 0.3) << rows;
  }
}

TEST_F(ModelLinesGL, CompartmentsHaveAStrongerLineBetweenThemThanInstances) {
  auto inkBetween = [&](const scene::Scene& scene) {
    return meanInk(intensity(scene, {240, 240}), {100, 115}, {140, 125});
  };
  EXPECT_GT(inkBetween(pair(true)), 1.2 * inkBetween(pair(false)));
}

TEST_F(ModelLinesGL, ADeepStepHasAStrongLine) {
  auto inkBetween = [&](float deep) {
    return meanInk(intensity(pair(false, deep), {240, 240}), {100, 115}, {150, 125});
  };
  EXPECT_GT(inkBetween(400.0f), 1.4 * inkBetween(0.0f));
}

TEST_F(ModelLinesGL, InstancesOfAFewPixelsHaveNoLinesBetweenThem) {
  scene::Scene scene = pair(false);
  scene.camera.height = 1000.0;  // an atom is three pixels of a picture of 1000 rows
  Image left = intensity(scene, {1000, 1000});
  EXPECT_LT(1.0 - double(sampleOf(left, {500, 500}, "G")), 0.55) << "half of an outline at most";
  scene.finish.contourSteps = 0.0;
  scene.background.top = scene.background.bottom = glm::vec3(0.5f);
  EXPECT_LT(meanInk(intensity(scene, {1000, 1000}), {480, 480}, {520, 520}), 0.002);
}

}  // namespace
}  // namespace velum
