// What the shaders cut away is what shaders/shared/cut.h says on the processor.
#include <fmt/format.h>

#include <random>

#include "CutsFixture.h"
#include "ProbeShaders.h"
#include "cutShapes.h"
#include "gpu/Buffer.h"
#include "gpu/Program.h"
#include "shared/bindings.h"
#include "shared/cuts.h"
#include "shared/frame.h"

namespace velum {
namespace {

constexpr glm::ivec2 kCutsSize(72, 72);

shared::CutData cutDataOf(const scene::Cut& cut) {
  shared::CutData data{};
  data.localFromScene = glm::mat4(glm::inverse(scene::worldFromCut(cut)));
  data.halfSize = glm::vec4(glm::vec3(cut.size * 0.5), cut.invert ? -1.0f : 1.0f);
  data.kind.x = static_cast<int>(cut.shape);
  return data;
}

/// Millimetres of a stretch of a ray that no cut removes, from the intervals of cut.h.
double keptLength(const std::vector<scene::Cut>& cuts, const TestRay& ray, glm::dvec2 stretch) {
  std::vector<glm::dvec2> kept{stretch};
  for (const auto& cut : cuts) {
    glm::vec2 inside = shared::cutInterval(cutDataOf(cut), glm::vec3(ray.origin), glm::vec3(ray.direction));
    std::vector<glm::dvec2> next;
    auto add = [&](double a, double b) {
      if (b > a) next.emplace_back(a, b);
    };
    for (glm::dvec2 k : kept) {
      bool isEmpty = inside.x >= inside.y;
      if (cut.invert) {
        if (!isEmpty) add(std::max(k.x, double(inside.x)), std::min(k.y, double(inside.y)));
      } else if (isEmpty) {
        next.push_back(k);
      } else {
        add(k.x, std::min(k.y, double(inside.x)));
        add(std::max(k.x, double(inside.y)), k.y);
      }
    }
    kept = next;
  }
  double length = 0;
  for (glm::dvec2 k : kept) length += k.y - k.x;
  return length;
}

scene::Cut cutOf(scene::CutShape shape, glm::dvec3 centre, glm::dvec3 axis, glm::dvec3 size, bool invert = false) {
  scene::Cut cut;
  cut.shape = shape;
  cut.centre = centre;
  cut.axis = axis;
  cut.size = size;
  cut.spinDeg = 25;
  cut.invert = invert;
  return cut;
}

class CutsGL : public CutPictures {
 protected:
  void expectAgrees(const scene::Scene& scene, const std::string& what) {
    expectShowsWhatIsKept(
        scene, kCutsSize, [&](const TestRay& ray, glm::dvec2 box) { return keptLength(scene.cuts, ray, box); },
        [&](glm::vec3 p) {
          float least = 1e9f;
          for (const auto& cut : scene.cuts) least = std::min(least, shared::cutDistance(cutDataOf(cut), p, {}));
          return least;
        },
        0.01f, what);
  }
};

const scene::Cut kShapes[] = {
    cutOf(scene::CutShape::Plane, {2, 1, 3}, {0.3, -1, 0.2}, {10, 10, 10}),
    cutOf(scene::CutShape::Box, {3, -14, 2}, {0.2, -1, 0.5}, {22, 14, 26}),
    cutOf(scene::CutShape::Sphere, {-4, -12, 5}, {0, -1, 0}, {30, 30, 30}),
    cutOf(scene::CutShape::Cylinder, {4, -6, -3}, {0.4, -1, 0.3}, {18, 1, 34}),
    cutOf(scene::CutShape::Cone, {0, 6, 0}, {0.1, -1, 0.2}, {26, 1, 40}),
};

TEST_F(CutsGL, EveryShapeRemovesWhatTheProcessorSays) {
  for (const auto& shape : kShapes)
    for (bool invert : {false, true})
      for (auto projection : {scene::Projection::Perspective, scene::Projection::Orthographic}) {
        scene::Scene scene = solidScene();
        scene.camera.projection = projection;
        scene.camera.height = 55;
        lookAlong(scene, {0.35, -1, 0.3}, 100);
        scene.cuts = {shape};
        scene.cuts[0].invert = invert;
        expectAgrees(scene, std::string(enumName(shape.shape)) + (invert ? " inverted" : "") +
                                (projection == scene::Projection::Perspective ? "" : " orthographic"));
      }
}

TEST_F(CutsGL, RaysAlongTheAxesOfTheCutAreNoException) {
  const glm::dvec3 kAxes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  for (auto shape : everyShapeButMembranes())
    for (glm::dvec3 axis : kAxes) {
      scene::Scene scene = solidScene(0.0);
      scene.camera.projection = scene::Projection::Orthographic;
      scene.camera.height = 55;
      lookAlong(scene, {0, -1, 0});
      scene.cuts = {cutOf(shape, {1, 0.5, 2}, axis, {20, 16, 24})};
      scene.cuts[0].spinDeg = 0;
      Image image = draw(scene, kCutsSize, kAllLayers);
      int shown = 0, wrong = 0;
      for (int y = 0; y < kCutsSize.y && wrong < 3; ++y)
        for (int x = 0; x < kCutsSize.x && wrong < 3; ++x) {
          // Told by points along the ray, not by intervals: nothing of the box may be left where all points are
          // removed.
          TestRay ray = rayThrough(scene.camera, kCutsSize, {x + 0.5, y + 0.5});
          glm::dvec2 t = boxInterval(*scene.volume.data, ray);
          float furthest = -1.0f;  // largest distance to what is removed
          for (double s = t.x + 0.05; s < t.y; s += 0.1)
            furthest = std::max(furthest, shared::cutDistance(cutDataOf(scene.cuts[0]), glm::vec3(ray.at(s)), {}));
          float alpha = sampleOf(image, {x, y}, "A");
          std::string where = std::string(enumName(shape)) + " axis " + std::to_string(axis.x) + " " +
                              std::to_string(axis.y) + " " + std::to_string(axis.z) + ", pixel " + std::to_string(x) +
                              ", " + std::to_string(y);
          if (t.x + 0.05 < t.y && furthest > 0.1f) {
            EXPECT_GT(alpha, 0.9f) << where;
            wrong += alpha <= 0.9f;
          } else if (furthest < -0.1f) {
            EXPECT_EQ(alpha, 0.0f) << where;
            wrong += alpha != 0.0f;
          }
          if (alpha == 0.0f) continue;
          ++shown;
          EXPECT_GE(shared::cutDistance(cutDataOf(scene.cuts[0]), vectorOf(image, {x, y}, "position"), {}), -0.01f)
              << where;
        }
      EXPECT_GT(shown, 100);
    }
}

TEST_F(CutsGL, AnEyeInsideTheVolumeOrInsideTheCutSeesTheSame) {
  for (const auto& shape : kShapes)
    for (bool invert : {false, true}) {
      scene::Scene scene = solidScene();
      scene.camera.fieldOfViewDeg = 90;
      scene.cuts = {shape};
      scene.cuts[0].invert = invert;
      // In the middle of what the shape holds, then just beside it.
      scene.camera.eye =
          shape.centre + (shape.shape == scene::CutShape::Cone ? 25.0 : 1.0) * glm::normalize(shape.axis);
      scene.camera.target = scene.camera.eye + glm::dvec3(-3, 10, 2);
      expectAgrees(scene,
                   std::string("eye in the ") + std::string(enumName(shape.shape)) + (invert ? " inverted" : ""));
    }
}

TEST_F(CutsGL, ManyCutsTogether) {
  scene::Scene scene = solidScene();
  lookAlong(scene, {0.4, -1, 0.5}, 100);
  scene.cuts.assign(std::begin(kShapes) + 1, std::end(kShapes));
  expectAgrees(scene, "four shapes");
  scene::Cut away = kShapes[2];
  away.invert = true;
  away.size = glm::dvec3(38);
  away.centre = {0, 0, 0};
  scene.cuts.push_back(away);
  expectAgrees(scene, "four shapes within a ball");
  scene.cuts.clear();
  for (int i = 0; i < 40; ++i) {
    glm::dvec3 at(hashNoise({i, 0, 0}) * 36 - 18, hashNoise({i, 1, 0}) * 20 - 22, hashNoise({i, 2, 0}) * 36 - 18);
    scene.cuts.push_back(cutOf(scene::CutShape::Sphere, at, {0, 0, 1}, glm::dvec3(9)));
  }
  expectAgrees(scene, "forty balls");
}

constexpr float kRayEnd = 3.0f;

/// The stretches of rays, added up.
constexpr const char* kProbe = R"(layout(local_size_x = 64) in;

#include "common/cuts.glsl"

layout(std430, binding = 2) readonly buffer RayBlock { vec4 rays[]; };          // origin, direction, one after the other
layout(std430, binding = 3) writeonly buffer AnswerBlock { vec4 answers[]; };  // kept length, stretches

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(answers.length())) return;
  Ray ray = Ray(rays[2u * i].xyz, rays[2u * i + 1u].xyz);
  vec4 sum = vec4(0.0);
  float t = 0.0;
  do {
    Stretch stretch = stretchFrom(ray, t, 3.0);
    if (sum.y < 200.0 && t < 3.0) sum += vec4(stretch.kept ? stretch.end - t : 0.0, 1.0, 0.0, 0.0);
    t = max(stretch.end, t + 1e-6);
  } while (t < 3.0 && sum.y < 200.0);
  answers[i] = sum;
}
)";

std::vector<glm::vec4> stretchesOnGpu(const std::vector<shared::CutData>& cuts, const std::vector<glm::vec4>& rays) {
  ProbeShaders probes;
  probes.add("stretches.comp", kProbe);
  gpu::Program program = probes.make({"stretches.comp"});
  shared::FrameParams params{};
  params.cutCount = int(cuts.size());
  params.flags = shared::kFlagCuts | shared::kFlagWalks | shared::kFlagJoined;
  gpu::UniformBuffer<shared::FrameParams> block("frame");
  block.set(params);
  block.bind(shared::kFrameBinding);
  gpu::Buffer cutBuffer("cuts", std::span<const shared::CutData>(cuts));
  gpu::Buffer rayBuffer("rays", std::span<const glm::vec4>(rays));
  std::vector<glm::vec4> answers(rays.size() / 2);
  gpu::Buffer out("answers", answers.size() * sizeof(glm::vec4));
  cutBuffer.bindStorage(shared::kCutBinding);
  rayBuffer.bindStorage(2);
  out.bindStorage(3);
  gpu::dispatch(program, {int(answers.size() + 63) / 64, 1, 1});
  gpu::barrier();
  out.read(0, out.bytes(), answers.data());
  return answers;
}

/// The same on the processor, by walks.
float keptByWalks(const std::vector<shared::CutData>& cuts, glm::vec3 origin, glm::vec3 direction) {
  float kept = 0.0f, t = 0.0f;
  for (int guard = 200; t < kRayEnd && guard > 0; --guard) {
    shared::RunFold fold = shared::emptyRuns(t);
    float e = 1e-5f * std::max(1.0f, t);
    for (std::size_t i = 0; i < cuts.size(); ++i)
      fold = shared::foldRun(fold, int(i), shared::cutPart(cuts[i]),
                             shared::cutWalk(cuts[i], origin, direction, t, e, kRayEnd), t);
    shared::Stretch stretch = shared::stretchOf(fold, kRayEnd);
    if (stretch.kept) kept += stretch.end - t;
    t = std::max(stretch.end, t + 1e-6f);
  }
  return kept;
}

/// Every shape can be walked by its distance, as those are that are not convex, and comes out as by its interval.
TEST_F(CutsGL, WalksComeOutAsIntervalsDo) {
  std::mt19937 random(21);
  auto number = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  auto vector = [&](double most) { return glm::dvec3(number(-most, most), number(-most, most), number(-most, most)); };
  int rays = 0, off = 0, split = 0;
  for (int round = 0; round < 30; ++round) {
    std::vector<shared::CutData> plain, walked;
    for (int i = 0; i <= round % 4; ++i) {
      scene::Cut cut = kShapes[random() % std::size(kShapes)];
      cut.centre = vector(0.3);
      cut.axis = vector(1);
      cut.size = {number(0.1, 0.7), number(0.1, 0.7), number(0.1, 0.7)};
      cut.invert = random() % 4 == 0;
      plain.push_back(cutDataOf(cut));
      if (i > 0 && random() % 2 == 0) plain.back().kind.z |= shared::kCutJoined;
      walked.push_back(plain.back());
      walked.back().kind.z |= shared::kCutWalks;
    }
    std::vector<glm::vec4> lines;
    for (int i = 0; i < 500; ++i) {
      glm::dvec3 origin = glm::normalize(vector(1)) * 1.5;
      lines.emplace_back(glm::vec3(origin), 0.0f);
      lines.emplace_back(glm::vec3(glm::normalize(vector(0.4) - origin)), 0.0f);
    }
    auto wanted = stretchesOnGpu(plain, lines), found = stretchesOnGpu(walked, lines);
    for (std::size_t i = 0; i < found.size(); ++i, ++rays) {
      float onProcessor = keptByWalks(walked, glm::vec3(lines[2 * i]), glm::vec3(lines[2 * i + 1]));
      split += found[i].y > wanted[i].y + 2.0f;
      off += std::abs(found[i].x - wanted[i].x) > 2e-4f || std::abs(found[i].x - onProcessor) > 2e-4f;
      EXPECT_NEAR(found[i].x, wanted[i].x, 5e-3f) << "round " << round << ", ray " << i;
      EXPECT_NEAR(found[i].x, onProcessor, 5e-3f) << "round " << round << ", ray " << i;
    }
  }
  EXPECT_LT(off, rays / 200) << "only rays that graze may come out otherwise";
  EXPECT_LT(split, rays / 200);
}

TEST_F(CutsGL, ACutThatIsOffRemovesNothing) {
  scene::Scene scene = solidScene();
  Image whole = draw(scene);
  for (const auto& shape : kShapes) {
    scene.cuts.push_back(shape);
    scene.cuts.back().enabled = false;
  }
  Image off = draw(scene);
  EXPECT_EQ(off.pixels, whole.pixels);
}

TEST_F(CutsGL, TheFaceOfAPlaneHasItsNormal) {
  scene::Scene scene = solidScene(0.0);
  scene.lighting.shaded = true;
  scene.lighting.shadow = scene.lighting.occlusion = 0;
  for (glm::dvec3 axis : {glm::dvec3(0, -1, 0), glm::dvec3(0.4, -1, 0.3), glm::dvec3(-0.7, -1, -0.2)}) {
    scene.cuts = {cutOf(scene::CutShape::Plane, {0, -4, 0}, axis, {1, 1, 1})};
    Image image = draw(scene, kCutsSize, kAllLayers);
    glm::dvec3 unit = glm::normalize(axis);
    int onFace = 0;
    for (int y = 0; y < kCutsSize.y; ++y)
      for (int x = 0; x < kCutsSize.x; ++x) {
        if (sampleOf(image, {x, y}, "A") == 0.0f) continue;
        glm::dvec3 p(vectorOf(image, {x, y}, "position"));
        // The layers are those of the first sample, up to half a step behind the face.
        if (std::abs(glm::dot(p - scene.cuts[0].centre, unit)) > 0.3) continue;
        // At the sides of the box it is the box that is seen.
        glm::dvec3 inside = 0.5 * glm::dvec3(kDims) * glm::dvec3(1, 1.1, 0.9) - glm::abs(p);
        if (std::min(inside.x, std::min(inside.y, inside.z)) < 1.0) continue;
        ++onFace;
        EXPECT_GT(glm::dot(glm::dvec3(vectorOf(image, {x, y}, "normal")), unit), 0.999) << x << ", " << y;
      }
    EXPECT_GT(onFace, 400);
  }
}

TEST_F(CutsGL, TheFaceOfJoinedPlanesIsThatOfThePlaneThatAPlaceLiesOn) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int onFirst = 0, onOthers = 0;
  for (int round = 0; round < 8; ++round) {
    scene::Scene scene = solidScene(0.0);
    scene.lighting.shaded = true;
    scene.lighting.shadow = scene.lighting.occlusion = 0;
    for (int i = 0, count = 2 + round % 2; i < count; ++i) {
      glm::dvec3 axis(0.8 * unit(random), -1.0, 0.8 * unit(random));
      scene::Cut plane = cutOf(scene::CutShape::Plane, {6 * unit(random), -2, 6 * unit(random)}, axis, {1, 1, 1});
      plane.joined = i > 0;
      // The first has its voxels' grey on it, the others the material's colour.
      plane.face = i == 0 ? scene::CutFace::Section : scene::CutFace::Shaded;
      scene::addCut(scene, plane);
    }
    Image image = draw(scene, kCutsSize, kAllLayers);
    eachShown(image, [&](glm::ivec2 pixel, glm::vec3 position) {
      glm::dvec3 p(position), inside = 0.5 * glm::dvec3(kDims) * glm::dvec3(1, 1.1, 0.9) - glm::abs(p);
      if (std::min(inside.x, std::min(inside.y, inside.z)) < 1.0) return;
      std::vector<double> off;
      for (const auto& cut : scene.cuts) off.push_back(std::abs(glm::dot(p - cut.centre, glm::normalize(cut.axis))));
      auto nearest = std::min_element(off.begin(), off.end());
      // Where two planes meet it may be either's.
      if (std::count_if(off.begin(), off.end(), [&](double d) { return d < *nearest + 1.0; }) > 1) return;
      ASSERT_LT(*nearest, 0.3) << "what is seen within the block is a face";
      auto at = std::size_t(nearest - off.begin());
      glm::dvec3 normal(vectorOf(image, pixel, "normal"));
      EXPECT_GT(glm::dot(normal, glm::normalize(scene.cuts[at].axis)), 0.999) << "round " << round << ", plane " << at;
      glm::vec4 color = colorOf(image, pixel);
      EXPECT_EQ(std::abs(color.r - color.b) < 0.02f, at == 0) << "round " << round << ", plane " << at;
      ++(at == 0 ? onFirst : onOthers);
    });
  }
  EXPECT_GT(onFirst, 800);
  EXPECT_GT(onOthers, 800);
}

TEST_F(CutsGL, ASectionFaceShowsTheGreyOfItsVoxels) {
  // Values that change along x and z only, so that the section's depth does not matter.
  Volume v = makeVolume(
      kDims, SampleType::Int16, [](glm::ivec3 p) { return -200.0 + 20 * p.x + 10 * p.z; }, centredFrame(kDims));
  glm::dmat4 voxelFromWorld = glm::inverse(v.worldFromVoxel);
  scene::Scene scene = sceneOf(std::move(v));
  scene.volume.transfer.colors = {{0, {1, 0, 0}}};
  scene.volume.transfer.opacities = {{-200, 0}, {2000, 0}};
  scene.volume.windowLevel = 350;
  scene.volume.windowWidth = 700;
  scene.cuts = {cutOf(scene::CutShape::Plane, {0, -3, 0}, {0.1, -1, 0}, {1, 1, 1})};
  scene.cuts[0].face = scene::CutFace::Section;
  for (double opacity : {1.0, 0.5}) {
    scene.cuts[0].faceOpacity = opacity;
    Image image = draw(scene, kCutsSize, kAllLayers);
    int checked = 0;
    for (int y = 0; y < kCutsSize.y; ++y)
      for (int x = 0; x < kCutsSize.x; ++x) {
        if (sampleOf(image, {x, y}, "A") == 0.0f) continue;
        glm::dvec3 p(vectorOf(image, {x, y}, "position"));
        EXPECT_LT(std::abs(glm::dot(p - scene.cuts[0].centre, glm::normalize(scene.cuts[0].axis))), 1e-3);
        glm::dvec3 voxel(voxelFromWorld * glm::dvec4(p, 1.0));
        glm::dvec3 last = glm::dvec3(kDims) - 1.0;
        if (glm::any(glm::lessThan(voxel, glm::dvec3(0.0))) || glm::any(glm::greaterThan(voxel, last))) continue;
        double grey = glm::clamp((-200.0 + 20 * voxel.x + 10 * voxel.z) / 700.0, 0.0, 1.0);
        ++checked;
        EXPECT_NEAR(sampleOf(image, {x, y}, "R") * 255, grey * 255, 1.5 / opacity) << x << ", " << y;
        EXPECT_NEAR(sampleOf(image, {x, y}, "A"), opacity, 1.01 / 255);
      }
    EXPECT_GT(checked, 800);
  }
}

/// Each pixel whose ray meets a plane in the middle of the data is opaque, each whose ray passes by is empty.
/// @return how many are on the face
int expectWholeFace(const Image& image, const scene::Scene& scene, const std::string& what) {
  const scene::Cut& cut = scene.cuts[0];
  glm::dvec3 axis = glm::normalize(cut.axis);
  int onFace = 0, holes = 0, strays = 0;
  for (int y = 0; y < kCutsSize.y; ++y)
    for (int x = 0; x < kCutsSize.x; ++x) {
      TestRay ray = rayThrough(scene.camera, kCutsSize, glm::dvec2(x + 0.5, y + 0.5));
      glm::dvec2 box = boxInterval(*scene.volume.data, ray);
      double t = glm::dot(cut.centre - ray.origin, axis) / glm::dot(ray.direction, axis);
      bool isOnFace = t > box.x + 0.1 && t < box.y - 0.1, isBeside = t < box.x - 0.1 || t > box.y + 0.1;
      float alpha = sampleOf(image, {x, y}, "A");
      onFace += isOnFace;
      holes += isOnFace && alpha != 1.0f;
      // What lies behind the plane has values of its own in a projection.
      bool showsValues = scene.rayCast.mode == scene::RenderMode::Mip && box.y > std::max(box.x, t);
      strays += isBeside && !showsValues && alpha != 0.0f;
    }
  EXPECT_EQ(holes, 0) << what << ", of " << onFace << " pixels of the face";
  EXPECT_EQ(strays, 0) << what;
  return onFace;
}

TEST_F(CutsGL, ASectionFaceIsWholeWhateverTheValues) {
  std::mt19937 dice(7);
  auto noise = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(dice); };
  // Of all grey values most are black: air with noise about zero, low tissue, a few bright voxels.
  auto valueOf = [&](glm::ivec3 p) { return p.x < 14 ? noise(-30, 30) : p.x < 28 ? -500.0 : noise(-900, 600); };
  glm::dmat4 frame = centredFrame(kDims, {1, 1.1, 0.9}, 0.3);
  Volume grey = makeVolume(kDims, SampleType::Int16, valueOf, frame);
  Volume colors = makeVolume(
      {kDims.x * 3, kDims.y, kDims.z}, SampleType::UInt8, [&](glm::ivec3 p) { return p.x < 60 ? 0.0 : noise(0, 255); },
      frame);
  colors.dims.x = kDims.x, colors.channels = 3, colors.isColor = true;
  for (bool isColor : {false, true})
    for (auto mode : {scene::RenderMode::Volume, scene::RenderMode::Mip, scene::RenderMode::Iso})
      for (bool isSpared : {false, true}) {
        scene::Scene scene = sceneOf(isColor ? colors : grey);
        scene.volume.transfer.opacities = {{-2000, 0}, {2000, 0}};
        scene.volume.windowLevel = 350, scene.volume.windowWidth = 700;
        scene.rayCast.mode = mode;
        scene.rayCast.isoValue = 900;
        scene.cuts = {cutOf(scene::CutShape::Plane, {0, -6, 4}, {0.5, -1, 0.4}, {1, 1, 1})};
        scene.cuts[0].face = scene::CutFace::Section;
        if (isSpared) scene.cuts[0].spares = {{9}};  // of which there is nothing
        int onFace = expectWholeFace(
            draw(scene, kCutsSize), scene,
            fmt::format("{}{}{}", enumName(mode), isColor ? ", colours" : "", isSpared ? ", spares" : ""));
        EXPECT_GT(onFace, 900);
      }
}

TEST_F(CutsGL, WhatACutSparesStaysWhole) {
  scene::Scene scene = solidScene(0.0);
  auto inBall = [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - glm::dvec3(20, 10, 22)) < 7; };
  LabelVolume labels = makeLabels(
      kDims, [&](glm::ivec3 p) { return inBall(p) ? 4 : 0; }, scene.volume.data->worldFromVoxel);
  scene.labels.data = Shared<LabelVolume>(std::move(labels));
  scene::completeStructures(scene.labels);
  scene.cuts = {cutOf(scene::CutShape::Plane, {0, 4, 0}, {0, -1, 0}, {1, 1, 1})};
  scene.cuts[0].spares = {{4}};
  Image image = draw(scene, kCutsSize, kAllLayers);
  int spared = 0, removedShown = 0;
  for (int y = 0; y < kCutsSize.y; ++y)
    for (int x = 0; x < kCutsSize.x; ++x) {
      if (sampleOf(image, {x, y}, "A") == 0.0f) continue;
      bool inFront = vectorOf(image, {x, y}, "position").y < 3.9f;
      bool isBall = std::lround(sampleOf(image, {x, y}, "id")) == 4;
      spared += inFront && isBall;
      removedShown += inFront && !isBall;
    }
  EXPECT_GT(spared, 150);
  EXPECT_EQ(removedShown, 0);
}

}  // namespace
}  // namespace velum
