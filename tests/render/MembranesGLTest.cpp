// Membranes in pictures: what they remove is what shaders/shared/sheet.h says on the processor, and sections keep their
// laws.
#include "FrameSetup.h"
#include "RenderFixture.h"
#include "sheetShapes.h"
#include "upload/CutSheets.h"

namespace velum {
namespace {

constexpr glm::ivec3 kDims(40, 36, 44);
constexpr glm::ivec2 kSize(64, 64);
constexpr glm::ivec2 kParticles(18, 21);
const glm::dvec3 kFrame(34, 38, 22);

scene::Cut membraneOf(const scene::SheetShape& shape, glm::dvec3 axis = {0.2, -1, 0.1}, glm::dvec3 size = kFrame) {
  scene::Cut cut;
  cut.id = 1;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.centre = {1, 2, -1};
  cut.axis = axis;
  cut.spinDeg = 12;
  cut.size = size;
  cut.membrane->cloth.particles = kParticles;
  cut.membrane->shape = shape;
  return cut;
}

scene::Cut planeOf(const scene::Cut& membrane) {
  scene::Cut plane = membrane;
  plane.shape = scene::CutShape::Plane;
  return plane;
}

class MembranesGL : public RenderTest {
 protected:
  static scene::Scene solidScene(double turnRad = 0.3) {
    scene::Scene scene = sceneOf(makeVolume(
        kDims, SampleType::UInt8, [](glm::ivec3) { return 100.0; }, centredFrame(kDims, {1, 1.1, 0.9}, turnRad)));
    makeSolid(scene);
    lookAlong(scene, {0.35, -1, 0.3}, 100);
    return scene;
  }
  /// Soft material with structure, lit.
  static scene::Scene softScene() {
    scene::Scene scene = sceneOf(makeVolume(
        kDims, SampleType::Int16,
        [](glm::ivec3 p) { return 300 + 250 * std::sin(0.5 * p.x) * std::cos(0.4 * p.y) * std::sin(0.45 * p.z + 1); },
        centredFrame(kDims)));
    scene.volume.transfer.colors = {{0, {0.5f, 0.2f, 0.1f}}, {600, {1, 0.9f, 0.8f}}};
    scene.volume.transfer.opacities = {{200, 0}, {400, 0.3}, {550, 0.9}};
    scene.lighting.shaded = true;
    lookAlong(scene, {0.35, -1, 0.3}, 100);
    return scene;
  }

  /// The cuts of a scene as the processor asks them.
  struct Cuts {
    explicit Cuts(const scene::Scene& scene)
        : sheets(render::makeCpuSheets(scene, {})), data(render::makeCutData(scene, {0, 0, 0}, sheets.plans)) {}
    bool keep(glm::vec3 p) const {
      return std::none_of(data.begin(), data.end(),
                          [&](const auto& cut) { return shared::cutRemoves(cut, p, sheets.view()); });
    }
    /// Millimetres of a stretch of a ray that no cut removes: stretch by stretch between all crossings.
    double keptLength(const TestRay& ray, glm::dvec2 stretch) const {
      glm::vec3 o(ray.origin), d(ray.direction);
      std::vector<double> ends{stretch.x, stretch.y};
      for (const auto& cut : data) {
        if (cut.kind.x == shared::kCutMembrane) {
          float t = float(stretch.x);
          while ((t = shared::membraneCrossing(cut, o, d, t, float(stretch.y), sheets.view()).t) < stretch.y) {
            ends.push_back(t);
            t += 1e-3f;
          }
        } else {
          glm::vec2 inside = shared::cutInterval(cut, o, d);
          ends.push_back(std::clamp(double(inside.x), stretch.x, stretch.y));
          ends.push_back(std::clamp(double(inside.y), stretch.x, stretch.y));
        }
      }
      std::sort(ends.begin(), ends.end());
      double length = 0;
      for (std::size_t i = 1; i < ends.size(); ++i)
        if (keep(glm::vec3(ray.at(0.5 * (ends[i - 1] + ends[i]))))) length += ends[i] - ends[i - 1];
      return length;
    }
    render::CpuSheets sheets;
    std::vector<shared::CutData> data;
  };

  /// A pixel shows something exactly where something is kept, and never at a removed position.
  void expectAgrees(const scene::Scene& scene, const std::string& what) {
    Image image = draw(scene, kSize, kAllLayers);
    Cuts cuts(scene);
    int doubtful = 0, wrong = 0, shown = 0, empty = 0;
    for (int y = 0; y < kSize.y && wrong < 3; ++y)
      for (int x = 0; x < kSize.x && wrong < 3; ++x) {
        // Rays a hundredth of a pixel beside tell where rounding may decide.
        double least = 1e9, most = 0;
        for (int k = 0; k < 5; ++k) {
          glm::dvec2 shift(k == 1 ? 0.01 : k == 2 ? -0.01 : 0.0, k == 3 ? 0.01 : k == 4 ? -0.01 : 0.0);
          TestRay ray = rayThrough(scene.camera, kSize, glm::dvec2(x + 0.5, y + 0.5) + shift);
          glm::dvec2 box = boxInterval(*scene.volume.data, ray);
          double length = box.x < box.y ? cuts.keptLength(ray, box) : 0.0;
          least = std::min(least, length), most = std::max(most, length);
        }
        float alpha = sampleOf(image, {x, y}, "A");
        std::string where = what + ", pixel " + std::to_string(x) + ", " + std::to_string(y) + ", kept " +
                            std::to_string(most) + " mm, alpha " + std::to_string(alpha);
        if (most == 0.0) {
          EXPECT_EQ(alpha, 0.0f) << where << ": shown, but everything is cut away";
          wrong += alpha != 0.0f;
          ++empty;
        } else if (least > 0.05) {
          EXPECT_GT(alpha, 0.9f) << where << ": empty, but something is kept";
          wrong += alpha <= 0.9f;
          ++shown;
        } else {
          ++doubtful;
        }
        if (alpha == 0.0f) continue;
        glm::vec3 p = vectorOf(image, {x, y}, "position");
        for (const auto& cut : cuts.data) {
          float distance = shared::cutDistance(cut, p, cuts.sheets.view());
          EXPECT_GE(distance, -0.02f) << where << ": the position lies in what is removed";
          wrong += distance < -0.02f;
        }
      }
    EXPECT_LT(doubtful, kSize.x * kSize.y / 12) << what << ": the test has decided too little";
    EXPECT_GT(shown, 100) << what;
  }
};

TEST_F(MembranesGL, AFlatOneGivesThePictureOfThePlane) {
  for (int mode = 0; mode < 3; ++mode)
    for (glm::dvec3 eye : {glm::dvec3(0.35, -1, 0.3), glm::dvec3(0.2, 1, 0.4), glm::dvec3(1, 0.05, 0.1)})
      for (bool invert : {false, true}) {
        scene::Scene scene = softScene(), plane;
        // The light grid takes a second; once is enough.
        if (mode != 0 || invert) scene.lighting.shadow = scene.lighting.occlusion = 0;
        scene.rayCast.mode = scene::RenderMode(mode);
        scene.rayCast.isoValue = 420;
        lookAlong(scene, eye, 100);
        scene.cuts = {membraneOf({})};
        scene.cuts[0].invert = invert;
        plane = scene;
        plane.cuts = {planeOf(scene.cuts[0])};
        Image whole = draw(plane, kSize, kAllLayers), image = draw(scene, kSize, kAllLayers);
        expectSame(image, whole, 1.0, "mode " + std::to_string(mode) + (invert ? " inverted" : ""));
      }
}

TEST_F(MembranesGL, EverySheetRemovesWhatTheProcessorSays) {
  const std::pair<const char*, glm::dvec3> kViews[] = {
      {"front", {0.35, -1, 0.3}}, {"behind", {0.1, 1, 0.2}}, {"along", {1, 0.2, 0.05}}};
  for (const auto& [name, shape] : allSheets(kParticles, kFrame))
    for (auto [view, eye] : kViews)
      for (bool invert : {false, true}) {
        scene::Scene scene = solidScene();
        scene.camera.projection = invert ? scene::Projection::Orthographic : scene::Projection::Perspective;
        scene.camera.height = 55;
        lookAlong(scene, eye, 100);
        scene.cuts = {membraneOf(shape)};
        scene.cuts[0].invert = invert;
        expectAgrees(scene, name + " from " + view + (invert ? " inverted" : ""));
      }
}

TEST_F(MembranesGL, AnEyeInsideSeesTheSame) {
  for (const auto& [name, shape] : allSheets(kParticles, kFrame)) {
    scene::Scene scene = solidScene();
    scene.camera.fieldOfViewDeg = 90;
    scene.cuts = {membraneOf(shape)};
    for (glm::dvec3 eye : {glm::dvec3(2, -8, 1), glm::dvec3(-4, -3, 5), glm::dvec3(3, 9, -2)}) {
      scene.camera.eye = eye;
      scene.camera.target = eye + glm::dvec3(-3, 10, 2);
      expectAgrees(scene, name + " from inside");
    }
  }
}

TEST_F(MembranesGL, SeveralAndOtherCutsTogether) {
  scene::Scene scene = solidScene();
  scene.cuts = {membraneOf(wavySheet(kParticles, kFrame)),
                membraneOf(foldedSheet({30, 30}, {30, 30, 20}), {1, 0.3, 0.2}, {30, 30, 20})};
  scene.cuts[1].centre = {12, 0, 0};
  scene::completeCuts(scene);
  expectAgrees(scene, "two membranes");
  scene::Cut box;
  box.shape = scene::CutShape::Box;
  box.centre = {-6, 4, 8};
  box.size = {14, 30, 14};
  scene.cuts.push_back(box);
  expectAgrees(scene, "two membranes and a box");
  scene.cuts[0].enabled = false;
  expectAgrees(scene, "one of them off");
}

TEST_F(MembranesGL, LeapingAndEarlyEndsChangeNothing) {
  for (int mode = 0; mode < 3; ++mode)
    for (auto use : {scene::MembraneUse::Clip, scene::MembraneUse::Inlay}) {
      scene::Scene scene = softScene();
      scene.lighting.shadow = scene.lighting.occlusion = 0;
      scene.rayCast.mode = scene::RenderMode(mode);
      scene.rayCast.isoValue = 420;
      scene.cuts = {membraneOf(foldedSheet({30, 30}, kFrame))};
      scene.cuts[0].membrane->use = use;
      scene.cuts[0].membrane->look = scene::SheetLook::Surface;
      Image fast = draw(scene);
      scene.rayCast.skipEmpty = scene.rayCast.stopOpaque = false;
      expectSame(fast, draw(scene), 1.5, "mode " + std::to_string(mode) + " use " + std::to_string(int(use)));
    }
}

TEST_F(MembranesGL, TheFaceHasTheNormalOfTheSheet) {
  scene::Scene scene = solidScene(0.0);
  scene.lighting.shaded = true;
  scene.lighting.shadow = scene.lighting.occlusion = 0;
  // z = h (1 - u^2)(1 - v^2) in the frame, whose normal is known.
  scene.cuts = {membraneOf(domeSheet({60, 60}, kFrame), {0, -1, 0})};
  glm::dmat4 world = scene::worldFromCut(scene.cuts[0]);
  Image image = draw(scene, kSize, kAllLayers);
  int onFace = 0;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      if (sampleOf(image, {x, y}, "A") == 0.0f) continue;
      glm::dvec3 p(glm::inverse(world) * glm::dvec4(vectorOf(image, {x, y}, "position"), 1.0));
      double u = p.x / 17, v = p.y / 19, h = 0.8 * 11;
      if (std::max(std::abs(u), std::abs(v)) > 0.9 || std::abs(p.z - h * (1 - u * u) * (1 - v * v)) > 0.4) continue;
      glm::dvec3 normal = glm::normalize(glm::dvec3(h * 2 * u * (1 - v * v) / 17, h * 2 * v * (1 - u * u) / 19, 1.0));
      EXPECT_GT(glm::dot(glm::dmat3(world) * normal, glm::dvec3(vectorOf(image, {x, y}, "normal"))), 0.995)
          << x << ", " << y;
      ++onFace;
    }
  EXPECT_GT(onFace, 400);
}

TEST_F(MembranesGL, WhatItSparesStaysWhole) {
  scene::Scene scene = solidScene(0.0);
  auto inBall = [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - glm::dvec3(20, 10, 22)) < 7; };
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      kDims, [&](glm::ivec3 p) { return inBall(p) ? 4 : 0; }, scene.volume.data->worldFromVoxel));
  scene::completeStructures(scene.labels);
  // The sheet dents inwards, so that all of the ball is above it.
  scene::SheetShape bowl = domeSheet(kParticles, kFrame);
  for (auto& p : bowl.places) p.z = -p.z;
  scene.cuts = {membraneOf(bowl, {0, -1, 0})};
  scene.cuts[0].spares = {{4}};
  Cuts cuts(scene);
  Image image = draw(scene, kSize, kAllLayers);
  int spared = 0;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      if (sampleOf(image, {x, y}, "A") == 0.0f) continue;
      glm::vec3 p = vectorOf(image, {x, y}, "position");
      bool isRemoved = shared::cutDistance(cuts.data[0], p, cuts.sheets.view()) < -0.05f;
      bool isBall = std::lround(sampleOf(image, {x, y}, "id")) == 4;
      EXPECT_TRUE(isBall || !isRemoved) << x << ", " << y;
      spared += isRemoved && isBall;
    }
  EXPECT_GT(spared, 150);
}

TEST_F(MembranesGL, ALiveSheetShowsAsItsShapeWouldAndItsStepsMakeFramesDiffer) {
  scene::Scene saved = softScene();
  saved.cuts = {membraneOf(wavySheet(kParticles, kFrame))};
  Image wanted = draw(saved);
  render::Frame frame = frameOf(saved, {96, 96});
  frame.scene.cuts[0].membrane->shape = {};
  auto sheet = std::make_shared<membrane::Sheet>(scene::SheetShape{}, kParticles, kFrame);
  frame.sheets[frame.scene.cuts[0].id] = {sheet, sheet->revision()};
  Progress progress;
  renderer().render(frame, progress);
  Image flat = renderer().read();
  EXPECT_GT(differenceOf(flat, wanted).mean, 0.5);
  sheet->setShape(saved.cuts[0].membrane->shape, kParticles, kFrame);
  EXPECT_TRUE(renderer().work(frame, 0.0)) << "a frame is a moment: this one is complete";
  frame.sheets[frame.scene.cuts[0].id] = {sheet, sheet->revision()};
  renderer().render(frame, progress);
  expectSame(renderer().read(), wanted, 1.0, "live");
  // Made for another frame it is not this cut's.
  frame.scene.cuts[0].size.x += 1;
  frame.scene.cuts[0].membrane->shape = saved.cuts[0].membrane->shape;
  EXPECT_NO_THROW(renderer().render(frame, progress));
  saved.cuts[0].size.x += 1;
  Image other = renderer().read();
  expectSame(other, draw(saved), 0.0, "of another frame");
}

/// A soft block in which an inlay with a folded and a waving sheet hangs.
class InlaysGL : public MembranesGL {
 protected:
  static scene::Scene sectionScene(double opacity = 0.5) {
    scene::Scene scene = softScene();
    scene.lighting.shadow = scene.lighting.occlusion = 0;
    scene.volume.windowLevel = 300;
    scene.volume.windowWidth = 700;
    scene.cuts = {membraneOf(wavySheet(kParticles, kFrame), {0, -1, 0})};
    scene.cuts[0].membrane->use = scene::MembraneUse::Inlay;
    scene.cuts[0].membrane->inlayOpacity = opacity;
    return scene;
  }
  static scene::Membrane& membrane(scene::Scene& scene) { return *scene.cuts[0].membrane; }
  /// Pixels whose position lies before, on and behind the inlay.
  struct Sides {
    int front = 0, on = 0, behind = 0;
  };
  Sides sidesOf(const scene::Scene& scene) {
    Image image = draw(scene, kSize, kAllLayers);
    glm::dmat4 local = glm::inverse(scene::worldFromCut(scene.cuts[0]));
    Sides sides;
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x) {
        if (sampleOf(image, {x, y}, "A") < 0.02f) continue;
        double z = (local * glm::dvec4(vectorOf(image, {x, y}, "position"), 1.0)).z;
        ++(z > 0.1 ? sides.front : z < -0.1 ? sides.behind : sides.on);
      }
    return sides;
  }
};

TEST_F(InlaysGL, EmphasisAtItsEndsShowsOneSideOnly) {
  scene::Scene scene = sectionScene(0.0);
  Sides both = sidesOf(scene);
  EXPECT_GT(both.front, 100);
  EXPECT_GT(both.behind, 100);
  membrane(scene).emphasis = -1;
  Sides behind = sidesOf(scene);
  EXPECT_EQ(behind.front, 0);
  EXPECT_GT(behind.behind, both.behind);
  membrane(scene).emphasis = 1;
  Sides front = sidesOf(scene);
  EXPECT_EQ(front.behind, 0);
  EXPECT_GT(front.front, 100);
  // Turned round, the other side is in front.
  scene.cuts[0].invert = true;
  EXPECT_EQ(sidesOf(scene).front, 0);
}

TEST_F(InlaysGL, NothingIsKeptButBetweenSheetAndInlay) {
  scene::Scene scene = sectionScene(0.0);
  Cuts cuts(scene);
  Image image = draw(scene, kSize, kAllLayers);
  int shown = 0;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      if (sampleOf(image, {x, y}, "A") < 0.02f) continue;
      ++shown;
      EXPECT_GE(shared::cutDistance(cuts.data[0], vectorOf(image, {x, y}, "position"), cuts.sheets.view()), -0.02f);
    }
  EXPECT_GT(shown, 300);
}

TEST_F(InlaysGL, AnOpaqueInlayHidesWhatIsBehindIt) {
  scene::Scene scene = sectionScene(1.0);
  EXPECT_EQ(sidesOf(scene).behind, 0);
  Image with = draw(scene);
  membrane(scene).emphasis = 1;  // what is behind is not even there
  // Where the sheet touches the section, rounding tells which side a sample is on.
  EXPECT_LT(differenceOf(draw(scene), with).mean, 0.01);
  // From behind, the side in front is hidden.
  membrane(scene).emphasis = 0;
  lookAlong(scene, {0.1, 1, 0.2}, 100);
  EXPECT_EQ(sidesOf(scene).front, 0);
}

TEST_F(InlaysGL, TheImageHasTheGreyOfItsVoxels) {
  // Values that change along x and z only, so that the section's depth does not matter.
  Volume v = makeVolume(
      kDims, SampleType::Int16, [](glm::ivec3 p) { return -200.0 + 20 * p.x + 10 * p.z; }, centredFrame(kDims));
  glm::dmat4 voxelFromWorld = glm::inverse(v.worldFromVoxel);
  scene::Scene scene = sceneOf(std::move(v));
  scene.volume.transfer.opacities = {{-200, 0}, {2000, 0}};
  scene.volume.windowLevel = 350;
  scene.volume.windowWidth = 700;
  scene.cuts = {membraneOf(domeSheet(kParticles, kFrame), {0, -1, 0})};
  scene.cuts[0].membrane->use = scene::MembraneUse::Inlay;
  glm::dmat4 local = glm::inverse(scene::worldFromCut(scene.cuts[0]));
  for (double opacity : {1.0, 0.5}) {
    scene.cuts[0].membrane->inlayOpacity = opacity;
    Image image = draw(scene, kSize, kAllLayers);
    int checked = 0;
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x) {
        if (sampleOf(image, {x, y}, "A") == 0.0f) continue;
        glm::dvec3 p(vectorOf(image, {x, y}, "position")), q(local * glm::dvec4(p, 1.0));
        EXPECT_NEAR(q.z, 0, 1e-3);
        EXPECT_LE(std::abs(q.x), 17.01);
        EXPECT_LE(std::abs(q.y), 19.01);
        glm::dvec3 voxel(voxelFromWorld * glm::dvec4(p, 1.0)), last = glm::dvec3(kDims) - 1.0;
        if (glm::any(glm::lessThan(voxel, glm::dvec3(0.0))) || glm::any(glm::greaterThan(voxel, last))) continue;
        ++checked;
        double grey = glm::clamp((-200.0 + 20 * voxel.x + 10 * voxel.z) / 700.0, 0.0, 1.0);
        EXPECT_NEAR(sampleOf(image, {x, y}, "R") * 255, grey * 255, 1.5 / opacity) << x << ", " << y;
        EXPECT_NEAR(sampleOf(image, {x, y}, "A"), opacity, 1.01 / 255);
      }
    EXPECT_GT(checked, 800);
  }
}

TEST_F(InlaysGL, AShorterFallOffNeverShowsMore) {
  scene::Scene scene = sectionScene(0.0);
  scene.lighting.shaded = false;
  Image before;
  for (double falloff : {2.0, 4.0, 7.0, 11.0, 40.0}) {
    membrane(scene).falloff = falloff;
    Image image = draw(scene, kSize);
    double more = 0;
    for (int y = 0; y < kSize.y && before.width > 0; ++y)
      for (int x = 0; x < kSize.x; ++x) {
        double change = sampleOf(image, {x, y}, "A") - sampleOf(before, {x, y}, "A");
        EXPECT_GE(change, -1.5 / 255) << falloff << " mm at " << x << ", " << y;
        more += change;
      }
    EXPECT_TRUE(before.width == 0 || more > 1.0) << falloff;
    before = image;
  }
  membrane(scene).falloff = 11;
  Image reach = draw(scene, kSize);
  membrane(scene).falloff = 0;
  expectSame(draw(scene, kSize), reach, 0.0, "0 is the reach");
}

TEST_F(InlaysGL, SeveralAddUpAndOtherCutsTakeTheirImages) {
  scene::Scene one = sectionScene(0.9);
  lookAlong(one, {0.5, -1, 0.9}, 100);
  scene::Scene two = one, other = one;
  other.cuts[0].axis = {0, 0, 1};
  other.cuts[0].membrane->shape = domeSheet(kParticles, kFrame);
  scene::addCut(two, other.cuts[0]);
  double a = coverageOf(draw(one)), b = coverageOf(draw(other)), both = coverageOf(draw(two));
  EXPECT_GT(both, std::max(a, b) + 0.01);
  EXPECT_LE(both, a + b);
  scene::Scene cut = one;
  scene::Cut half;
  half.axis = {1, 0, 0};
  half.centre = cut.cuts[0].centre;
  cut.cuts.push_back(half);
  Image image = draw(cut, kSize, kAllLayers);
  int shown = 0;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      if (sampleOf(image, {x, y}, "A") < 0.02f) continue;
      ++shown;
      EXPECT_LE(vectorOf(image, {x, y}, "position").x, half.centre.x + 0.1);
    }
  EXPECT_GT(shown, 200);
}

TEST_F(InlaysGL, AMaximumStandsOutOfTheInlayAndAnOpaqueInlayEndsIt) {
  scene::Scene scene = sectionScene(1.0);
  scene.rayCast.mode = scene::RenderMode::Mip;
  Image both = draw(scene, kSize);
  membrane(scene).emphasis = 1;
  expectSame(draw(scene, kSize), both, 1.0, "nothing behind an opaque section");
  membrane(scene).emphasis = -1;
  Image section = draw(scene, kSize);
  double brighter = 0;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      double change = sampleOf(both, {x, y}, "R") - sampleOf(section, {x, y}, "R");
      EXPECT_GE(change, -1.5 / 255);
      brighter += change;
    }
  EXPECT_GT(brighter, 10.0);
}

TEST_F(MembranesGL, ASheetIsShownWhereItIsAndCanBePicked) {
  for (auto look : {scene::SheetLook::Surface, scene::SheetLook::Grid}) {
    scene::Scene scene = softScene();
    scene.volume.transfer.opacities = {{0, 0}, {1000, 0}};
    scene.cuts = {membraneOf(foldedSheet({40, 40}, kFrame))};
    EXPECT_EQ(coverageOf(draw(scene, kSize)), 0.0);
    scene.cuts[0].membrane->look = look;
    Cuts cuts(scene);
    Image image = draw(scene, kSize, kAllLayers);
    int shown = 0;
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x) {
        if (sampleOf(image, {x, y}, "A") < 0.02f) continue;
        ++shown;
        glm::vec3 p = vectorOf(image, {x, y}, "position");
        EXPECT_LT(std::abs(shared::cutDistance(cuts.data[0], p, cuts.sheets.view())), 0.02f) << x << ", " << y;
        render::Pick pick = renderer().pick({x, y});
        EXPECT_TRUE(pick.hit);
        EXPECT_LT(glm::length(glm::vec3(pick.world) - p), 1e-3f);
      }
    EXPECT_GT(shown, 500) << int(look);
  }
}

TEST_F(MembranesGL, SurfacesAreCutToo) {
  scene::Scene scene = softScene();
  scene.volume.visible = false;
  scene::Surface surface;
  Mesh mesh;
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 20; ++k)
      for (glm::vec2 c :
           {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
        mesh.positions.emplace_back(0.3f, 2 * (i + c.x) - 20, 2 * (k + c.y) - 20);
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) mesh.indices.push_back(i);
  surface.data = Shared<Mesh>(std::move(mesh));
  scene.surfaces = {surface};
  lookAlong(scene, {1, 0, 0}, 100);
  scene.cuts = {membraneOf(wavySheet(kParticles, kFrame))};
  Cuts cuts(scene);
  Image image = draw(scene, kSize, kAllLayers);
  int shown = 0;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      if (sampleOf(image, {x, y}, "A") < 0.5f) continue;
      ++shown;
      EXPECT_GE(shared::cutDistance(cuts.data[0], vectorOf(image, {x, y}, "position"), cuts.sheets.view()), -0.02f);
    }
  EXPECT_GT(shown, 200);
}

}  // namespace
}  // namespace velum
