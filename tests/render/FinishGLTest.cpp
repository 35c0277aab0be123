// What the finish adds to a picture: lit spheres, strokes, paper.
#include <functional>
#include <random>

#include "ChangeFields.h"
#include "FinishFixture.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "scene/LitSpheres.h"
#include "shared/bindings.h"
#include "shared/finish.h"

namespace velum {
namespace {

using FinishGL = FinishFixture;

TEST_F(FinishGL, OffIsThePictureWithoutIt) {
  scene::Scene plain = ball(), off = ball(), on = ball();
  off.finish.contourWidth = 7.0;
  off.finish.sphere = "gold";
  off.finish.paperGrain = 1.0;
  finishAll(on);
  Image before = draw(plain, {64, 64}, kAllLayers);
  draw(on, {64, 64});
  expectIdentical(before, draw(off, {64, 64}, kAllLayers), "after one with a finish");
}

TEST_F(FinishGL, LayersAreThoseOfThePictureWithoutIt) {
  scene::Scene plain = ball(), on = ball();
  finishAll(on);
  Image before = draw(plain, {64, 64}, kAllLayers), after = draw(on, {64, 64}, kAllLayers);
  for (std::size_t i = 0; i < before.pixels.size(); ++i)
    if (i % before.channels.size() >= 4) {
      ASSERT_EQ(before.pixels[i], after.pixels[i]) << before.channels[i % before.channels.size()];
    }
}

TEST_F(FinishGL, ColoursAreMixedAsThePaperSays) {
  // rgb = ((1 - m) * ray-cast colour + m * lit sphere's) * contour intensity.
  scene::Scene scene = ball();
  scene.lighting.shaded = true;
  scene.rayCast.samplesPerPixel = 1;
  scene.finish.sphere = "muscle";
  glm::ivec2 size(96, 96);
  Image cast = draw(scene, size, kAllLayers);
  for (double m : {0.25, 0.5, 1.0}) {
    scene.finish.litSphere = m;
    scene.finish.contours = 0.0;
    Image mixed = draw(scene, size);
    scene.finish.contours = 1.0;
    scene.finish.contourWidth = 8.0;
    scene.finish.contourColor = {0.2f, 0.1f, 0.0f};
    Image lined = draw(scene, size);
    int compared = 0, dark = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        if (sampleOf(cast, {x, y}, "instance") < 0) continue;
        glm::vec3 n = vectorOf(cast, {x, y}, "normal");
        // From the front, x to the left of the patient is to the right, z is up.
        glm::vec3 sphere = scene::litSphereColor("muscle", glm::normalize(glm::vec3(n.x, n.z, -n.y)));
        glm::vec3 wanted = glm::mix(glm::vec3(colorOf(cast, {x, y})), sphere, float(m));
        glm::vec3 got(colorOf(mixed, {x, y}));
        // The rim's rows of the sphere's picture are interpolated.
        if (-n.y > 0.35f) {
          EXPECT_LT(glm::length(wanted - got), 0.02f) << x << ", " << y << ", m " << m;
        }
        ++compared;
        // One share of ink explains all three channels.
        glm::vec3 left = glm::vec3(colorOf(lined, {x, y})) / glm::max(got, glm::vec3(0.02f));
        float share = (1.0f - left.b);
        if (share < 0.3f) continue;
        ++dark;
        EXPECT_NEAR(left.r, 1.0f - share * 0.8f, 0.06f);
      }
    EXPECT_GT(compared, 1500);
    EXPECT_GT(dark, 20);
  }
}

TEST_F(FinishGL, WindowsOfAPictureFitTogether) {
  scene::Scene scene = ball();
  finishAll(scene);
  // With a dark side towards the last windows, where strokes are.
  scene.lighting.shaded = true;
  scene.lighting.keyDirection = {-1, 0.7, 0.3};
  scene.finish.hatchWidth = 6.0;
  scene.rayCast.samplesPerPixel = 2;
  Progress progress;
  render::Frame frame = frameOf(scene, {200, 180});
  ASSERT_LT(render::windowMargin(frame), 90) << "windows that begin within it are drawn from the first pixel on";
  Image whole = render::renderPicture(renderer(), frame, {}, 4096, progress);
  for (int window : {101, 160})
    expectIdentical(whole, render::renderPicture(renderer(), frame, {}, window, progress), "in windows");
}

TEST_F(FinishGL, LinesAloneGoOnFromWindowToWindow) {
  // Strokes look further around than lines do: without them windows are larger by the lines' own reach only.
  scene::Scene scene = ball();
  scene.finish.contours = 1.0;
  scene.rayCast.samplesPerPixel = 1;
  Progress progress;
  for (double width : {6.0, 40.0}) {
    scene.finish.contourWidth = width;
    render::Frame frame = frameOf(scene, {100, 90});
    Image whole = render::renderPicture(renderer(), frame, {}, 4096, progress);
    for (int window : {50, 61, 77})
      expectIdentical(whole, render::renderPicture(renderer(), frame, {}, window, progress), "in windows");
  }
}

TEST_F(FinishGL, PreviewsShowIt) {
  scene::Scene scene = ball();
  Progress progress;
  render::Frame frame = frameOf(scene, {64, 64});
  frame.isPreview = true;
  Image plain = render::renderPicture(renderer(), frame, {}, 4096, progress);
  finishAll(frame.scene);
  EXPECT_GT(differenceOf(plain, render::renderPicture(renderer(), frame, {}, 4096, progress)).mean, 5.0);
}

TEST_F(FinishGL, TransparentBackgroundsStayTransparent) {
  scene::Scene scene = ball();
  finishAll(scene);
  scene.background.transparent = true;
  Image image = draw(scene, {100, 100});
  EXPECT_EQ(colorOf(image, {3, 3}), glm::vec4(0.0f));
  EXPECT_EQ(colorOf(image, {50, 50}).a, 1.0f);
}

TEST_F(FinishGL, EveryPaperLooksItsOwnWayAndAlikeAtEachSize) {
  scene::Scene scene = ball();
  std::vector<Image> papers;
  for (auto paper : {scene::Paper::Smooth, scene::Paper::Rough, scene::Paper::Laid, scene::Paper::Canvas,
                     scene::Paper::Linen, scene::Paper::Parchment}) {
    scene.finish.paper = paper;
    scene.finish.paperGrain = 1.0;
    papers.push_back(draw(scene, {400, 400}));
    for (std::size_t i = 0; i + 1 < papers.size(); ++i)
      EXPECT_GT(differenceOf(papers[i], papers.back()).mean, 0.3) << i << " and " << papers.size() - 1;
    // Its mean colour is the paper's, whatever the size.
    for (int rows : {200, 400}) {
      Image image = draw(scene, {rows, rows});
      double mean = meanInk(image, {0, 0}, {rows, rows / 6});
      EXPECT_NEAR(mean, 1.0 - double(scene.finish.paperColor.g), 0.05) << int(paper);
    }
  }
}

/// A picture of paper, grey by its place in 0..1, of 40 x 30 pixels.
Shared<Image> paperOf(const std::function<float(glm::vec2)>& greyAt) {
  Image image{40, 30, {"R", "G", "B"}, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      float grey = greyAt((glm::vec2(float(x), float(y)) + 0.5f) / glm::vec2(40, 30));
      image.pixels.insert(image.pixels.end(), {grey, grey, grey});
    }
  return Shared<Image>(image);
}

TEST_F(FinishGL, OnesOwnPaperIsAsItIsAndHasNoSeams) {
  constexpr glm::ivec2 kWide(200, 1000);  // a pixel of the paper is one of such a picture
  scene::Scene scene = ball();
  scene.finish.paper = scene::Paper::Own;
  auto greyAt = [](const Image& image, glm::ivec2 p) { return sampleOf(image, p, "G"); };
  // What tiles is repeated.
  auto waves = [](glm::vec2 p) { return 0.5f + 0.2f * std::sin(6.2832f * p.x) + 0.1f * std::cos(6.2832f * p.y); };
  scene.finish.ownPaper.data = paperOf(waves);
  Image image = draw(scene, kWide);
  for (glm::ivec2 p : {glm::ivec2(3, 5), glm::ivec2(43, 5), glm::ivec2(3, 35), glm::ivec2(163, 95)})
    EXPECT_NEAR(greyAt(image, p), waves((glm::vec2(3, 5) + 0.5f) / glm::vec2(40, 30)), 0.01f) << p.x << ", " << p.y;
  // What does not is turned over by turns: nowhere is there a step.
  scene.finish.ownPaper.data = paperOf([](glm::vec2 p) { return 0.3f + 0.4f * p.x; });
  image = draw(scene, kWide);
  EXPECT_NEAR(greyAt(image, {2, 9}), greyAt(image, {77, 9}), 0.01f);
  EXPECT_NEAR(greyAt(image, {2, 9}), greyAt(image, {82, 9}), 0.01f);
  for (int x = 1; x < kWide.x; ++x) EXPECT_LT(std::abs(greyAt(image, {x, 9}) - greyAt(image, {x - 1, 9})), 0.02f) << x;
  // Twice as large; and in a picture half the size everything is half as large.
  scene.finish.paperScale = 2.0;
  Image large = draw(scene, kWide);
  scene.finish.paperScale = 1.0;
  Image half = draw(scene, kWide / 2);
  for (int x : {4, 21, 50}) {
    EXPECT_NEAR(greyAt(large, {2 * x, 9}), greyAt(image, {x, 9}), 0.02f) << x;
    EXPECT_NEAR(greyAt(half, {x, 4}), greyAt(image, {2 * x, 9}), 0.02f) << x;
  }
  // Without grain it is its mean colour.
  scene.finish.paperGrain = 0.0;
  EXPECT_NEAR(greyAt(draw(scene, kWide), {2, 9}), 0.5f, 0.02f);
  // One that could not be read is smooth.
  scene.finish.ownPaper.data = {};
  Image missing = draw(scene, {60, 60});
  scene.finish.paper = scene::Paper::Smooth;
  expectIdentical(missing, draw(scene, {60, 60}), "smooth instead");
}

TEST_F(FinishGL, StrokesAreDenserWhereItIsDarker) {
  scene::Scene scene = ball();
  scene.lighting.shaded = true;
  scene.lighting.keyDirection = {-1, 0.2, 0.6};
  scene.finish.hatching = 1.0;
  scene.finish.hatchWidth = 14.0;
  Image left = intensity(scene, {300, 300});
  EXPECT_GT(meanInk(left, {180, 130}, {215, 170}), 2.0 * meanInk(left, {85, 130}, {120, 170}));
}

TEST_F(FinishGL, StrokesGoRoundACylinderHoweverItLies) {
  for (double turnDeg : {0.0, 30.0, 60.0, 90.0, 120.0, 150.0}) {
    double turn = glm::radians(turnDeg);
    glm::dvec3 axis(std::cos(turn), 0.0, std::sin(turn));
    scene::Scene scene = sceneOf(makeVolume(
        kDims, SampleType::Float32,
        [&](glm::ivec3 p) {
          glm::dvec3 q = glm::dvec3(p) - 0.5 * (glm::dvec3(kDims) - 1.0);
          return 500.0 + 100.0 * (14.0 - glm::length(q - axis * glm::dot(q, axis)));
        },
        centredFrame(kDims)));
    scene.volume.transfer = ball().volume.transfer;
    scene.volume.transfer.colors = {{0, glm::vec3(0.5f)}};  // one family of strokes
    scene.background = ball().background;
    scene.lighting.shaded = true;
    scene.lighting.ambient = 1.0;
    scene.lighting.diffuse = scene.lighting.specular = scene.lighting.shadow = scene.lighting.occlusion = 0.0;
    seenFromFront(scene);
    scene.finish.hatching = 1.0;
    scene.finish.hatchWidth = 14.0;
    Image left = intensity(scene, {300, 300});
    // Which way the picture changes most, in the middle: across the strokes.
    double xx = 0, xy = 0, yy = 0;
    for (int y = 110; y < 190; ++y)
      for (int x = 110; x < 190; ++x) {
        double dx = sampleOf(left, {x + 1, y}, "G") - sampleOf(left, {x - 1, y}, "G");
        double dy = sampleOf(left, {x, y + 1}, "G") - sampleOf(left, {x, y - 1}, "G");
        xx += dx * dx, xy += dx * dy, yy += dy * dy;
      }
    EXPECT_GT(xx + yy, 50.0) << "there are strokes";
    double change = 0.5 * std::atan2(2.0 * xy, xx - yy);
    // Rows run downwards.
    double along = std::abs(std::cos(change) * std::cos(turn) - std::sin(change) * std::sin(turn));
    EXPECT_GT(along, std::cos(glm::radians(12.0))) << turnDeg << " degrees: it changes along " << -glm::degrees(change);
  }
}

TEST_F(FinishGL, StrokesComeTogetherWhicheverWayTheirDirectionsAreCounted) {
  // The same strokes: a direction turned about, and with it the phases that grow along it.
  constexpr glm::ivec2 kCells(40, 30);
  shared::FinishParams params{};
  params.strokePixels = 5.0f;
  params.cellPixels = params.strokePixels * shared::kCellPeriods;
  params.cellsX = kCells.x;
  params.cellsY = kCells.y;
  gpu::UniformBuffer<shared::FinishParams> block("finish");
  block.set(params);
  gpu::Program align({"render/stroke_align.comp"}, {{"FINISH", "1"}});
  auto aligned = [&](const std::vector<glm::vec4>& cells) {
    auto from = gpu::Texture::make2d("from", gpu::Format::Rgba32f, kCells);
    auto to = gpu::Texture::make2d("to", gpu::Format::Rgba32f, kCells);
    from.write({0, 0, 0}, {kCells, 1}, cells.data());
    block.bind(shared::kFinishBinding);
    from.bindSampler(shared::kStrokeUnit);
    to.bindImage(shared::kStrokeImage, gpu::Access::Write);
    gpu::dispatch(align, {(kCells.x + 7) / 8, (kCells.y + 7) / 8, 1});
    gpu::barrier();
    std::vector<glm::vec4> found(cells.size());
    to.read(found.data(), found.size() * sizeof(found[0]));
    return found;
  };
  std::mt19937 random(5);
  std::uniform_real_distribution<float> turn(-3.14159f, 3.14159f);
  std::vector<glm::vec4> cells, turned;
  std::vector<float> sides;
  for (int i = 0; i < kCells.x * kCells.y; ++i) {
    float along = turn(random);
    cells.emplace_back(std::cos(along), std::sin(along), turn(random), turn(random));
    sides.push_back(random() % 2 ? 1.0f : -1.0f);
    turned.push_back(sides.back() * cells.back());
  }
  std::vector<glm::vec4> wanted = aligned(cells), found = aligned(turned);
  double moved = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (int c = 0; c < 2; ++c) EXPECT_EQ(found[i][c], sides[i] * wanted[i][c]) << i;
    // Phases are the same a turn on.
    for (int c = 2; c < 4; ++c) {
      worst = std::max(worst, std::abs(std::sin(0.5 * double(found[i][c] - sides[i] * wanted[i][c]))));
      moved += std::abs(std::sin(0.5 * double(wanted[i][c] - cells[i][c])));
    }
  }
  EXPECT_GT(moved / double(cells.size()), 0.1) << "they come together";
  // Where waves nearly cancel each other, the rounding of their sum turns the phase a little.
  EXPECT_LT(worst, 0.01);
}

TEST_F(FinishGL, StructuresHaveTheirOwnSpheres) {
  scene::Scene scene = halves();
  scene.finish.litSphere = 1.0;
  scene.labels.structures[0].litSphere = "gold";
  Image image = draw(scene, {64, 64});
  auto front = [](const char* name) { return scene::litSphereColor(name, {0, 0, 1}); };
  EXPECT_LT(glm::length(glm::vec3(colorOf(image, {16, 32})) - front("gold")), 0.02f);
  EXPECT_LT(glm::length(glm::vec3(colorOf(image, {48, 32})) - front("porcelain")), 0.02f);
  scene::LitSphere own;
  own.name = "mine";
  Image blue{128, 128, {"R", "G", "B"}, {}};
  for (int i = 0; i < 128 * 128; ++i) blue.pixels.insert(blue.pixels.end(), {0.0f, 0.0f, 1.0f});
  own.data = Shared<Image>(blue);
  scene.finish.spheres = {own};
  scene.labels.structures[1].litSphere = "mine";
  EXPECT_LT(glm::length(glm::vec3(colorOf(draw(scene, {64, 64}), {48, 32})) - glm::vec3(0, 0, 1)), 0.02f);
  scene.finish.structureSpheres = false;
  EXPECT_LT(glm::length(glm::vec3(colorOf(draw(scene, {64, 64}), {48, 32})) - front("porcelain")), 0.02f);
  scene.finish.structureSpheres = true;
  // Nobody's is the plain one.
  scene.labels.structures[1].litSphere = "nobody";
  EXPECT_LT(glm::length(glm::vec3(colorOf(draw(scene, {64, 64}), {48, 32})) - front("porcelain")), 0.02f);
}

TEST_F(FinishGL, EveryFieldMatters) {
  scene::Scene scene = ball();
  scene.lighting.shaded = true;
  // Two structures, and a notch for creases and steps.
  scene.labels = halves().labels;
  scene.labels.structures[0].litSphere = "bone";
  scene::Cut box;
  box.id = 1;
  box.shape = scene::CutShape::Box;
  box.size = {12, 14, 12};
  box.centre = {4, -14, 3};
  scene.cuts = {box};
  finishAll(scene);
  Image before = draw(scene, {96, 96});
  int fields = 0;
  for (int n = 0;; ++n) {
    scene::Scene other = scene;
    std::string path;
    int left = n;  // is counted down
    scene::changeNthField(other, left, "", path);
    if (path.empty()) break;
    if (!path.starts_with("finish.") || path.starts_with("finish.spheres")) continue;
    if (path.starts_with("finish.ownPaper")) continue;  // there is none
    ++fields;
    EXPECT_GT(differenceOf(before, draw(other, {96, 96})).largest, 0.0) << path;
  }
  EXPECT_GE(fields, 12);
}

}  // namespace
}  // namespace velum
