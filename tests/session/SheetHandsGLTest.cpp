// What hands put on a membrane: pins hold it, kernels push and pull it, by either rule.
#include "GlFixture.h"
#include "makeVolume.h"
#include "membrane/sheet/Simulation.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/Membranes.h"

namespace velum::session {
namespace {

scene::Scene emptyScene(scene::KernelRule rule) {
  glm::ivec3 dims(48, 48, 32);
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(
      dims, SampleType::Int16, [](glm::ivec3) { return 0.0; }, centredFrame(dims)));
  scene::Cut cut;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.axis = {0, 0, 1};
  cut.size = {48, 48, 24};
  setRule(*cut.membrane, rule);
  if (rule == scene::KernelRule::Paper) cut.membrane->cloth.particles = {24, 24};  // comes to rest sooner
  scene.cuts = {cut};
  return scene;
}

class SheetHandsGL : public GlTest {
 protected:
  /// The sheet's z over a place, in the frame, which is the world's but for its middle.
  static membrane::HeightOver settle(scene::Scene scene) {
    Progress progress;
    EXPECT_TRUE(settleMembranes(scene, {}, progress).at(0).atRest);
    return membrane::heightOf(scene.cuts[0].membrane->shape);
  }
  /// How far the nearest of the sheet's particles is from a place.
  static double distanceToParticle(scene::Scene scene, glm::dvec3 place) {
    Progress progress;
    settleMembranes(scene, {}, progress);
    double nearest = 1e30;
    for (glm::vec3 p : scene.cuts[0].membrane->shape.places)
      nearest = std::min(nearest, glm::length(glm::dvec3(p) - place));
    return nearest;
  }
};
constexpr double kExact = 1e-6 * 48;  // a millionth of the frame

TEST_F(SheetHandsGL, ASidedSheetPassesThroughItsPinsAndFallsOffSmoothly) {
  scene::Scene scene = emptyScene(scene::KernelRule::Sided);
  const glm::dvec3 pins[] = {{0.3, -0.2, 8}, {-15.1, 12.7, -3}, {9.9, 3.3, 5}};
  for (glm::dvec3 pin : pins) scene.cuts[0].membrane->pins.push_back({{0.5, 0.5}, pin});
  auto height = settle(scene);
  for (glm::dvec3 pin : pins) EXPECT_NEAR(height(pin), pin.z, kExact);
  double steepest = 0.0;
  for (double x = -23; x < 23; x += 0.5) steepest = std::max(steepest, std::abs(height({x + 0.5, 0}) - height({x, 0})));
  EXPECT_LT(steepest, 1.0) << "a pin raises a hill, no needle";
  EXPECT_NEAR(height({22.0, -22.0}), 0.0, 0.1);
}

TEST_F(SheetHandsGL, APapersSheetHasAParticleInThePin) {
  scene::Scene scene = emptyScene(scene::KernelRule::Paper);
  scene.cuts[0].membrane->pins = {{{0.5, 0.5}, {2.3, -1.2, 4}}};
  EXPECT_LT(distanceToParticle(scene, {2.3, -1.2, 4}), kExact);
}

TEST_F(SheetHandsGL, APapersPinHoldsTheParticleThatItNames) {
  scene::Scene scene = emptyScene(scene::KernelRule::Paper);
  glm::ivec2 n(24, 31);
  scene.cuts[0].membrane->cloth.particles = n;
  scene.cuts[0].membrane->pins = {{{0.31, 0.74}, {-8.1, 10.2, 4}}, {{0.8, 0.2}, {14, -13, -3}}};
  Progress progress;
  settleMembranes(scene, {}, progress);
  const auto& shape = scene.cuts[0].membrane->shape;
  ASSERT_EQ(shape.particles, n);
  // 23 meshes along x, 30 along y.
  EXPECT_LT(glm::length(glm::dvec3(shape.places[22 * 24 + 7]) - glm::dvec3(-8.1, 10.2, 4)), kExact);
  EXPECT_LT(glm::length(glm::dvec3(shape.places[6 * 24 + 18]) - glm::dvec3(14, -13, -3)), kExact);
}

TEST_F(SheetHandsGL, APinOutsideOfTheFrameHoldsNothing) {
  scene::Scene scene = emptyScene(scene::KernelRule::Sided);
  scene.cuts[0].membrane->pins = {{{0.5, 0.5}, {40, 0, 8}}};
  EXPECT_NEAR(settle(scene)({20, 0}), 0.0, 1e-3);
}

TEST_F(SheetHandsGL, AKernelThatRepelsKeepsTheSheetOffItsMiddleByEitherRule) {
  for (auto rule : {scene::KernelRule::Sided, scene::KernelRule::Paper})
    for (double z : {-3.0, 3.0}) {
      scene::Scene scene = emptyScene(rule);
      scene.cuts[0].membrane->field.kernels = {{{0, 0, z}, 8.0, 500.0}};
      double h = settle(scene)({0, 0});
      EXPECT_LT(h * z, 0.0) << "away from its middle, by " << enumName(rule);
      EXPECT_GT(std::abs(h), rule == scene::KernelRule::Sided ? 5.0 - 0.5 : 2.0);  // around the ball, or out of its box
    }
}

TEST_F(SheetHandsGL, AKernelThatAttractsDrawsTheSheetToItsMiddleByEitherRule) {
  for (auto rule : {scene::KernelRule::Sided, scene::KernelRule::Paper})
    for (double z : {-3.0, 3.0}) {
      scene::Scene scene = emptyScene(rule);
      scene.cuts[0].membrane->field.kernels = {{{0, 0, z}, 8.0, -1000.0}};
      double h = settle(scene)({0, 0});
      EXPECT_GT(h / z, 0.7) << enumName(rule) << " " << z;
      EXPECT_LT(h / z, 1.1) << enumName(rule) << " " << z;
    }
}

TEST_F(SheetHandsGL, ASidedKernelThatAttractsLetsGoOfTheSheetThatItsBallDoesNotReach) {
  scene::Scene scene = emptyScene(scene::KernelRule::Sided);
  scene.cuts[0].membrane->field.kernels = {{{0, 0, 9}, 8.0, -1000.0}};
  EXPECT_NEAR(settle(scene)({0, 0}), 0.0, 1e-3);
}

}  // namespace
}  // namespace velum::session
