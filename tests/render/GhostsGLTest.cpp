// What cuts have removed, as ghosts: [VE] 8.3.
#include "FocusFixture.h"
#include "plateSurface.h"

namespace velum {
namespace {

TEST_F(FocusGL, GhostsShowWhatIsRemovedWhereNothingIsNearer) {
  // Two atoms on a ray, one beside them.
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(modelOfAtoms({{0, -20, 0}, {0, 20, 0}, {30, 0, 0}}, kResidue));
  scene.lighting.shaded = false;
  scene.rayCast.samplesPerPixel = 1;
  scene.background.transparent = true;
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
  scene.camera.projection = scene::Projection::Orthographic;
  scene.camera.height = 100;
  scene.camera.target = {0, 0, 0};
  scene.camera.eye = {0, -500, 0};
  scene.model.ghosts = scene::Ghosts::Filled;
  scene.model.ghostOpacity = 0.5;
  scene::Cut plane;
  plane.axis = {0, -1, 0};
  plane.centre = {0, -10, 0};
  scene::addCut(scene, plane);
  glm::ivec2 size(100, 100), middle(50, 50);
  auto ghostAt = [&](const Image& image) { return sampleOf(image, middle, "ghosts.A"); };
  Image front = draw(scene, size, kLayers);
  EXPECT_NEAR(ghostAt(front), 0.5f, 0.01f) << "before the atom behind it";
  EXPECT_EQ(sampleOf(front, middle, "instance"), 2.0f) << "ids are of what stays";
  EXPECT_EQ(sampleOf(front, {80, 50}, "ghosts.A"), 0.0f);
  scene.cuts[0].invert = true;
  Image behind = draw(scene, size, kLayers);
  EXPECT_EQ(ghostAt(behind), 0.0f) << "behind the atom that stays";
  EXPECT_NEAR(sampleOf(behind, {80, 50}, "ghosts.A"), 0.5f, 0.01f) << "alone before the background";
  EXPECT_NEAR(sampleOf(behind, {80, 50}, "A"), 0.5f, 0.01f);
  scene.model.ghosts = scene::Ghosts::Contour;
  Image lines = draw(scene, size, kLayers);
  EXPECT_EQ(sampleOf(lines, {80, 50}, "ghosts.A"), 0.0f) << "within the line";
  int inked = 0;
  for (int x = 70; x < 90; ++x) inked += sampleOf(lines, {x, 50}, "ghosts.A") > 0.3f;
  EXPECT_GE(inked, 2);
  EXPECT_LE(inked, 4);
  scene.model.types = {{.type = "root.atom", .ghosts = scene::Ghosts::None}};
  EXPECT_EQ(sampleOf(draw(scene, size, kLayers), {80, 50}, "ghosts.A"), 0.0f) << "not of this type";
}

TEST_F(FocusGL, GhostsOfAllAreWhereThePlainPictureShowsAll) {
  ModelMaker maker;
  maker.instances = 900;
  scene::Scene plain;
  plain.unit = LengthUnit::Angstrom;
  plain.model.data = Shared<Model>(maker.make());
  plain.lighting.shaded = false;
  plain.rayCast.samplesPerPixel = 1;
  plain.background.transparent = true;
  plain.camera = scene::frameCamera(plain, scene::StandardView::Oblique, 1.0);
  scene::Scene ghosts = plain;
  ghosts.model.ghosts = scene::Ghosts::Filled;
  ghosts.model.ghostOpacity = 1.0;
  scene::Cut all;
  all.shape = scene::CutShape::Everywhere;
  scene::addCut(ghosts, all);
  glm::ivec2 size(120, 120);
  // Nothing was seen before; all was; something else was.
  for (double turn : {0.0, 0.0, 0.7}) {
    ghosts.camera.eye.x += turn * glm::length(plain.camera.eye - plain.camera.target);
    plain.camera = ghosts.camera;
    Image wanted = draw(plain, size, kLayers), image = draw(ghosts, size, kLayers);
    int wrong = 0, shown = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        bool isShown = sampleOf(wanted, {x, y}, "instance") > 0.0f;
        shown += isShown;
        wrong += isShown != (sampleOf(image, {x, y}, "ghosts.A") > 0.99f);
      }
    EXPECT_GT(shown, 2000);
    EXPECT_EQ(wrong, 0);
  }
}

TEST_F(FocusGL, LinesOfGhostsHaveOneColourHoweverStrongTheyAre) {
  scene::Scene scene = focusScene(17, 60);
  scene.model.ghosts = scene::Ghosts::Contour;
  scene.cuts[0].model.spares[0].share = 0.0;
  scene.cuts[0].model.focus.reset();
  glm::ivec2 size(100, 80);
  scene.model.ghostOpacity = 0.9;
  Image strong = draw(scene, size, kLayers);
  scene.model.ghostOpacity = 0.1;
  Image weak = draw(scene, size, kLayers);
  // Before black nothing is brighter than the lines' own colour, as far as they cover it.
  scene.background.transparent = false;
  scene.background.top = scene.background.bottom = glm::vec3(0.0f);
  Image before = draw(scene, size, kLayers);
  int lined = 0, free = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      float share = sampleOf(weak, {x, y}, "ghosts.A");
      auto colorIn = [&](const Image& image) {
        return glm::vec3(sampleOf(image, {x, y}, "ghosts.R"), sampleOf(image, {x, y}, "ghosts.G"),
                         sampleOf(image, {x, y}, "ghosts.B"));
      };
      // Floats all the way: what is left is their rounding.
      EXPECT_LT(glm::length(colorIn(weak) - colorIn(strong)), 1e-4f) << x << ", " << y;
      // A grey level for the picture's bytes, half of one for the background's noise.
      glm::vec3 wanted = share * colorIn(weak), found(colorOf(before, {x, y}));
      EXPECT_LT(glm::length(found - wanted), 1.5f * std::sqrt(3.0f) / 255.0f) << x << ", " << y;
      ++(share > 0.0f ? lined : free);
    }
  EXPECT_GT(lined, 200);
  EXPECT_GT(free, 200);
}

TEST_F(FocusGL, GhostsAreAsStrongHoweverManySamplesThereAre) {
  scene::Scene scene = focusScene(16, 60);
  scene.model.ghosts = scene::Ghosts::Filled;
  scene.model.ghostOpacity = 0.4;
  scene.cuts[0].model.spares[0].share = 0.0;
  scene.cuts[0].model.focus.reset();
  Image one = draw(scene, kSize, kLayers);
  scene.rayCast.samplesPerPixel = 5;
  Image five = draw(scene, kSize, kLayers);
  double sums[2] = {0.0, 0.0}, colors[2] = {0.0, 0.0};
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      sums[0] += double(sampleOf(one, {x, y}, "ghosts.A"));
      sums[1] += double(sampleOf(five, {x, y}, "ghosts.A"));
      colors[0] += double(sampleOf(one, {x, y}, "A"));
      colors[1] += double(sampleOf(five, {x, y}, "A"));
    }
  EXPECT_GT(sums[0], 1000.0);
  EXPECT_NEAR(sums[1] / sums[0], 1.0, 0.02) << "edges move by less than a pixel";
  EXPECT_NEAR(colors[1] / colors[0], 1.0, 0.02) << "as they are blended into the picture";
}

TEST_F(FocusGL, GhostsAndSurfacesHideEachOtherAlongEachRay) {
  // In a wide view: far off its axis depth and distance differ by a third.
  std::vector<glm::vec3> places;
  for (int z = -4; z <= 4; ++z)
    for (int x = -4; x <= 4; ++x) places.emplace_back(6 * x, -10 + (x + z) % 5, 6 * z);
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(modelOfAtoms(places, kResidue));
  scene.model.detail = 0.1;
  scene.model.ghosts = scene::Ghosts::Filled;
  scene.model.ghostOpacity = 0.5;
  scene::Cut all;
  all.shape = scene::CutShape::Everywhere;
  scene::addCut(scene, all);
  scene.surfaces = {plateSurface(40, -10)};
  scene.lighting.shaded = false;
  scene.rayCast.samplesPerPixel = 1;
  scene.background.transparent = true;
  scene.camera.target = {0, 0, 0};
  scene.camera.projection = scene::Projection::Perspective;
  scene.camera.fieldOfViewDeg = 80;
  lookAlong(scene, {0, -1, 0}, 40);
  // The surface is no model's: the cut leaves it.
  scene.cuts[0].spares = {{0, scene::Spare::kEndless}};
  glm::ivec2 size(120, 120);
  Image image = draw(scene, size, kLayers);
  int before = 0, behind = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      TestRay ray = rayThrough(scene.camera, size, {x + 0.5, y + 0.5});
      double face = (-10.0 - ray.origin.y) / ray.direction.y, ghost = std::numeric_limits<double>::infinity();
      for (const glm::vec3& place : places)
        if (Meeting m = meet(ray, {glm::dvec3(place), double(radiusOf(kResidue))}, 0.0); m.isThere)
          ghost = std::min(ghost, m.enters);
      if (!std::isfinite(ghost) || std::abs(ghost - face) < 0.05) continue;
      EXPECT_EQ(sampleOf(image, {x, y}, "ghosts.A") > 0.3f, ghost < face) << x << ", " << y;
      ++(ghost < face ? before : behind);
    }
  EXPECT_GT(before, 1000);
  EXPECT_GT(behind, 500);
}

}  // namespace
}  // namespace velum
