// What all cuts together leave of a structure is one function, whoever asks.
#include <random>

#include "FrameSetup.h"
#include "ProbeShaders.h"
#include "RenderFixture.h"
#include "sheetShapes.h"
#include "upload/SpareTable.h"
#include "velum/render/section/KeptVoxels.h"
#include "velum/render/section/SectionImage.h"

namespace velum {
namespace {

constexpr double kTooNear = 0.01;  // floats and doubles may differ about a point on a face
constexpr int kPoints = 3000;
constexpr glm::ivec2 kParticles(14, 17);

// ---- the cuts in doubles, written anew

double distanceToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  double t = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::length(p - (a + t * (b - a)));
}

/// < 0 inside; what is removed of the plane is its inside.
double distanceOfShape(scene::CutShape shape, glm::dvec3 half, glm::dvec3 p) {
  double r = std::hypot(p.x, p.y);
  auto boxed = [](glm::dvec3 q) {
    double outside = glm::length(glm::max(q, glm::dvec3(0.0)));
    return outside > 0 ? outside : std::max(q.x, std::max(q.y, q.z));
  };
  switch (shape) {
    case scene::CutShape::Plane:
      return -p.z;
    case scene::CutShape::Sphere:
      return glm::length(p) - half.x;
    case scene::CutShape::Box:
      return boxed(glm::abs(p) - half);
    case scene::CutShape::Cylinder:
      return boxed({r - half.x, std::abs(p.z) - half.z, -1e9});
    default:
      break;
  }
  double h = 2.0 * half.z;
  double away =
      std::min(distanceToSegment({r, p.z}, {0, 0}, {half.x, h}), distanceToSegment({r, p.z}, {0, h}, {half.x, h}));
  return p.z < h && p.z > 0 && r < half.x * p.z / h ? -away : away;
}

/// How far a point is from what a cut removes, < 0 in it; and how near it is to where that may be doubtful.
struct Place {
  double distance = 0, doubt = 1e9;
};

/// Every triangle of the sheet against the line along z through the point.
Place placeOfMembrane(const scene::Cut& cut, const scene::SheetShape& sheet, glm::dvec3 p) {
  Place place;
  glm::dvec2 half = glm::dvec2(cut.size) * 0.5, toRim = half - glm::abs(glm::dvec2(p));
  bool holds = toRim.x > 0 && toRim.y > 0;
  place.doubt = std::min({std::abs(toRim.x), std::abs(toRim.y), std::abs(p.z)});
  double nearest = 1e9, toSheet = std::abs(p.z);
  int over = 0;
  glm::ivec2 n = sheet.particles;
  for (int y = 0; y + 1 < n.y; ++y)
    for (int x = 0; x + 1 < n.x; ++x) {
      auto at = [&](int i, int j) { return glm::dvec3(sheet.places[std::size_t((y + j) * n.x + x + i)]) - p; };
      glm::dvec3 corners[2][3] = {{at(0, 0), at(1, 0), at(1, 1)}, {at(0, 0), at(1, 1), at(0, 1)}};
      for (auto& [a, b, c] : corners) {
        auto cross = [](glm::dvec3 u, glm::dvec3 v) { return u.x * v.y - u.y * v.x; };
        double area = cross(b - a, c - a), u = cross(b, c) / area, v = cross(c, a) / area, w = 1.0 - u - v;
        double least = std::min(u, std::min(v, w));
        if (holds) place.doubt = std::min(place.doubt, 20.0 * std::abs(least));  // on an edge
        if (!holds || least < 0) continue;
        double z = u * a.z + v * b.z + w * c.z;
        over += z > 0;
        place.doubt = std::min(place.doubt, std::abs(z));
        if (std::abs(z) > nearest) continue;
        nearest = std::abs(z);
        glm::dvec3 normal = glm::cross(b - a, c - a);
        toSheet = nearest * std::abs(normal.z) / glm::length(normal);
      }
    }
  bool isAbove = holds ? over % 2 == 0 : p.z > 0;
  bool isInlay = cut.membrane->use == scene::MembraneUse::Inlay;
  bool removes = isInlay ? !holds || isAbove == (p.z > 0) : isAbove != cut.invert;
  double depth = isInlay ? std::min(toSheet, std::abs(p.z)) : toSheet;
  place.distance = removes ? -depth : depth;
  return place;
}

Place placeOf(const scene::Cut& cut, glm::dvec3 world) {
  glm::dvec3 p(glm::inverse(scene::worldFromCut(cut)) * glm::dvec4(world, 1.0));
  if (cut.membrane) return placeOfMembrane(cut, membrane::fitShape(cut.membrane->shape, kParticles, cut.size), p);
  double distance = distanceOfShape(cut.shape, cut.size * 0.5, p) * (cut.invert ? -1.0 : 1.0);
  return {distance, std::abs(distance)};
}

struct Naive {
  bool keeps = true, isDoubtful = false;
};

Naive naive(const scene::Scene& scene, glm::dvec3 world, int structure, double u) {
  bool isTaken = false, hasInlay = false, inInlay = false;
  Naive out;
  for (const auto& cut : scene.cuts) {
    if (!cut.enabled) continue;
    double depth = 0.0;
    for (auto spare = cut.spares.rbegin(); spare != cut.spares.rend(); ++spare)
      if (spare->structure == structure) depth = u < spare->share ? spare->distance : 0.0;
    Place place = placeOf(cut, world);
    out.isDoubtful = out.isDoubtful || place.doubt < kTooNear || std::abs(-place.distance - depth) < kTooNear;
    bool keeps = place.distance >= 0.0 || -place.distance <= depth;
    bool isInlay = cut.membrane && cut.membrane->use == scene::MembraneUse::Inlay;
    hasInlay = hasInlay || isInlay;
    inInlay = inInlay || (isInlay && keeps);
    isTaken = isTaken || (!isInlay && !keeps);
  }
  out.keeps = !isTaken && (!hasInlay || inInlay);
  return out;
}

// ---- random scenes

struct Points {
  std::vector<glm::vec4> places;  ///< w: random number
  std::vector<std::uint32_t> structures;
};

const int kStructures[] = {0, 1, 2, 300, 65535};

class Random {
 public:
  explicit Random(unsigned seed) : mEngine(seed) {}
  double number(double a, double b) { return std::uniform_real_distribution<double>(a, b)(mEngine); }
  int whole(int a, int b) { return std::uniform_int_distribution<int>(a, b)(mEngine); }
  glm::dvec3 vector(double most) { return {number(-most, most), number(-most, most), number(-most, most)}; }

  scene::Cut cut(scene::CutShape shape) {
    scene::Cut cut;
    cut.shape = shape;
    cut.invert = whole(0, 3) == 0;
    cut.enabled = whole(0, 9) != 0;
    cut.centre = vector(8);
    cut.axis = vector(1);
    cut.spinDeg = number(-180, 180);
    cut.size = {number(12, 40), number(12, 40), number(12, 40)};
    if (shape == scene::CutShape::Membrane) {
      cut.membrane.emplace();
      cut.membrane->cloth.particles = kParticles;
      cut.membrane->shape = whole(0, 1) ? wavySheet(kParticles, cut.size) : foldedSheet(kParticles, cut.size);
      if (whole(0, 2) == 0) cut.membrane->use = scene::MembraneUse::Inlay;
    }
    for (int i = whole(0, 4); i > 0; --i) {
      double distance = whole(0, 2) == 0 ? scene::Spare::kEndless : number(0, 9);
      cut.spares.push_back({kStructures[whole(0, 4)], distance, whole(0, 1) ? 1.0 : number(0, 1)});
    }
    return cut;
  }

  /// All shapes once, in any order, those that take much inverted or not; two more membranes.
  scene::Scene scene() {
    scene::Scene scene;
    std::vector<scene::CutShape> shapes{scene::CutShape::Plane,    scene::CutShape::Box,     scene::CutShape::Sphere,
                                        scene::CutShape::Cylinder, scene::CutShape::Cone,    scene::CutShape::Membrane,
                                        scene::CutShape::Membrane, scene::CutShape::Membrane};
    std::shuffle(shapes.begin(), shapes.end(), mEngine);
    shapes.resize(std::size_t(whole(1, 5)));
    for (auto shape : shapes) scene::addCut(scene, cut(shape));
    return scene;
  }

  Points points() {
    Points points;
    for (int i = 0; i < kPoints; ++i) {
      points.places.emplace_back(vector(18), whole(0, 1) ? 0.0 : number(0, 0.999));
      points.structures.push_back(std::uint32_t(whole(0, 9) == 0 ? 7 : kStructures[whole(0, 4)]));
    }
    return points;
  }

 private:
  std::mt19937 mEngine;
};

bool keepsOnProcessor(const std::vector<shared::CutData>& cuts, const render::SpareTable& spares, glm::vec4 p,
                      std::uint32_t structure, const shared::SheetRows& sheets) {
  shared::CutFold fold = shared::emptyFold();
  for (std::size_t i = 0; i < cuts.size(); ++i)
    fold = shared::foldCut(fold, cuts[i], shared::cutIsInlay(cuts[i]), shared::spareDepth(spares.of(structure, i), p.w),
                           spares.hasDepths, glm::vec3(p), sheets);
  return shared::foldKeeps(fold);
}

/// Asks the shaders' own functions about points, one by one.
constexpr const char* kProbe = R"(layout(local_size_x = 64) in;

#include "common/cuts.glsl"

layout(std430, binding = 2) readonly buffer PointBlock { vec4 points[]; };     // xyz: place, scene frame; w: random number
layout(std430, binding = 3) readonly buffer NameBlock { uint structureOf[]; };
layout(std430, binding = 4) writeonly buffer AnswerBlock { ivec2 answers[]; };  // x: cutsKeep; y: cutsGuess

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(points.length())) return;
  ivec2 answer;
  answer.x = cutsKeep(points[i].xyz, structureOf[i], points[i].w) ? 1 : 0;
#ifdef MEMBRANES
  answer.y = cutsGuess(points[i].xyz, structureOf[i]);
#else
  answer.y = answer.x == 1 ? kCutKeeps : kCutRemoves;
#endif
  answers[i] = answer;
}
)";

class SparesGL : public RenderTest {
 protected:
  /// x: cutsKeep(), y: cutsGuess() of each point.
  std::vector<glm::ivec2> onGpu(const scene::Scene& scene, const Points& points) {
    render::Frame frame = frameOf(scene, {8, 8});
    render::CutSheets sheets;
    sheets.prepare(frame);
    auto cuts = render::makeCutData(scene, glm::dvec3(0.0), sheets.plans());
    render::SpareTable spares = render::makeSpareTable(scene);
    shared::FrameParams params{};
    params.voxelsPerLength = 1.0f;
    params.cutCount = int(cuts.size());
    params.flags = shared::kFlagCuts | shared::kFlagMembranes | shared::kFlagInlays;
    if (!spares.isEmpty()) params.flags |= shared::kFlagSpares;
    if (spares.hasDepths) params.flags |= shared::kFlagSpareDepths;
    if (cuts.empty()) cuts.emplace_back();
    if (spares.isEmpty()) spares.rowOf = {0}, spares.rows = {{0.0f, 0.0f}};
    gpu::UniformBuffer<shared::FrameParams> block("frame");
    block.set(params);
    block.bind(shared::kFrameBinding);
    gpu::Buffer cutBuffer("cuts", std::span<const shared::CutData>(cuts));
    gpu::Buffer index("index", std::span<const std::uint32_t>(spares.rowOf));
    gpu::Buffer rows("spares", std::span<const shared::CutSpare>(spares.rows));
    gpu::Buffer places("places", std::span<const glm::vec4>(points.places));
    gpu::Buffer structures("structures", std::span<const std::uint32_t>(points.structures));
    std::vector<glm::ivec2> answers(points.places.size());
    gpu::Buffer out("answers", answers.size() * sizeof(glm::ivec2));
    cutBuffer.bindStorage(shared::kCutBinding);
    index.bindStorage(shared::kSpareIndexBinding);
    rows.bindStorage(shared::kSpareBinding);
    places.bindStorage(2);
    structures.bindStorage(3);
    out.bindStorage(4);
    sheets.bind();
    if (!mProgram) {
      ProbeShaders probes;
      probes.add("fold.comp", kProbe);
      mProgram = probes.make({"fold.comp"}, {{"MEMBRANES", "1"}});
    }
    gpu::dispatch(mProgram, {int(answers.size() + 63) / 64, 1, 1});
    gpu::barrier();
    out.read(0, out.bytes(), answers.data());
    return answers;
  }

  void TearDown() override {
    mProgram = {};
    RenderTest::TearDown();
  }

  gpu::Program mProgram;
};

TEST_F(SparesGL, TheCutsTogetherLeaveWhatTheyLeaveOnTheProcessorAndOneByOne) {
  int kept = 0, removed = 0, doubtful = 0, near = 0, bySpare = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    scene::Scene scene = random.scene(), hard = scene;
    for (auto& cut : hard.cuts) cut.spares.clear();
    Points points = random.points();
    auto sheets = render::makeCpuSheets(scene, {});
    auto cuts = render::makeCutData(scene, glm::dvec3(0.0), sheets.plans);
    render::SpareTable spares = render::makeSpareTable(scene);
    auto answers = onGpu(scene, points);
    int wrong = 0;
    for (std::size_t i = 0; i < answers.size() && wrong < 5; ++i) {
      glm::vec4 p = points.places[i];
      int structure = int(points.structures[i]);
      Naive wanted = naive(scene, glm::dvec3(p), structure, double(p.w));
      doubtful += wanted.isDoubtful;
      if (wanted.isDoubtful) continue;
      (wanted.keeps ? kept : removed) += 1;
      bySpare += wanted.keeps && !naive(hard, glm::dvec3(p), structure, double(p.w)).keeps;
      bool onGpu = answers[i].x == 1;
      bool onProcessor = keepsOnProcessor(cuts, spares, p, points.structures[i], sheets.view());
      bool guessFits = p.w > 0.0f || answers[i].y == shared::kCutNear || (answers[i].y == shared::kCutKeeps) == onGpu;
      near += p.w == 0.0f && answers[i].y == shared::kCutNear;
      if (onGpu == wanted.keeps && onProcessor == wanted.keeps && guessFits) continue;
      ++wrong;
      ADD_FAILURE() << "scene " << seed << ", point " << p.x << ", " << p.y << ", " << p.z << " of " << structure
                    << ", u " << p.w << ": kept " << wanted.keeps << ", processor " << onProcessor << ", GPU " << onGpu
                    << ", guess " << answers[i].y;
    }
  }
  EXPECT_GT(kept, 30000);
  EXPECT_GT(removed, 30000);
  EXPECT_GT(bySpare, 5000);
  EXPECT_LT(doubtful, 60 * kPoints / 10);
  EXPECT_LT(near, 60 * kPoints / 10) << "a guess is of use only where it mostly knows";
}

TEST_F(SparesGL, EveryStructureMayBeSparedByItself) {
  scene::Scene scene;
  for (int i = 0; i < 2; ++i) {
    scene::Cut plane;
    plane.axis = {i == 0 ? 1.0 : 0.0, i == 0 ? 0.0 : 1.0, 0};
    for (int id = 0; id < 65536; ++id) plane.spares.push_back({id, (id * 7 + i) % 10 + 0.5});
    scene::addCut(scene, plane);
  }
  Points points;
  std::vector<bool> wanted;
  for (int id = 0; id < 65536; id += 13)
    for (glm::vec4 p :
         {glm::vec4(3, -1, 0, 0), glm::vec4(-1, 7, 0, 0), glm::vec4(5, 5, 0, 0), glm::vec4(-1, -1, 0, 0)}) {
      points.places.push_back(p);
      points.structures.push_back(std::uint32_t(id));
      wanted.push_back(double(p.x) <= id * 7 % 10 + 0.5 && double(p.y) <= (id * 7 + 1) % 10 + 0.5);
    }
  auto answers = onGpu(scene, points);
  for (std::size_t i = 0; i < answers.size(); ++i)
    ASSERT_EQ(answers[i].x == 1, wanted[i]) << points.structures[i] << " at " << points.places[i].x;
}

/// A ray goes stretch by stretch as its points go one by one, spares left out.
TEST(Spares, TheStretchesOfARayAreWhatTheCutsLeaveOfItsPoints) {
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    // Removed parts of made-up cuts along a line: the fold of runs knows nothing else of them.
    struct Part {
      float from, to;
      bool isInlay;
    };
    std::vector<Part> parts;
    for (int n = random.whole(0, 5); n > 0; --n) {
      auto from = float(random.number(-2, 9));
      parts.push_back({from, from + float(random.number(0.1, 6)), random.whole(0, 2) == 0});
    }
    auto keepsAt = [&](float t) {
      shared::CutFold fold = shared::emptyFold();
      for (const auto& part : parts)
        fold = shared::foldAnswer(fold, part.isInlay,
                                  t >= part.from && t < part.to ? shared::kCutRemoves : shared::kCutKeeps);
      return shared::foldKeeps(fold);
    };
    for (float t = 0.0f; t < 10.0f;) {
      shared::RunFold fold = shared::emptyRuns(t);
      for (std::size_t c = 0; c < parts.size(); ++c) {
        bool holds = t >= parts[c].from && t < parts[c].to;
        shared::CutRun run{holds ? parts[c].to : t, t < parts[c].from ? parts[c].from : shared::kCutFar, -1};
        fold = shared::foldRun(fold, int(c), parts[c].isInlay, run, t);
      }
      shared::Stretch stretch = shared::stretchOf(fold, 10.0f);
      ASSERT_GT(stretch.end, t);
      for (double share : {0.001, 0.3, 0.7, 0.999}) {
        float at = t + float(share) * (stretch.end - t);
        ASSERT_EQ(keepsAt(at), stretch.kept) << at << " of " << t << " to " << stretch.end;
      }
      t = stretch.end;
    }
  }
}

// ---- the same everywhere

constexpr glm::ivec3 kDims(40, 36, 44);
constexpr glm::ivec2 kSize(72, 72);

/// A block with a ball of structure 4 in it; the plane takes all before y = 4, towards the eye.
class SparedScene : public SparesGL {
 protected:
  void SetUp() override {
    SparesGL::SetUp();
    mScene = sceneOf(makeVolume(
        kDims, SampleType::UInt8, [](glm::ivec3) { return 100; }, centredFrame(kDims)));
    makeSolid(mScene);
    auto inBall = [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - glm::dvec3(20, 10, 22)) < 7; };
    mScene.labels.data = Shared<LabelVolume>(makeLabels(
        kDims, [&](glm::ivec3 p) { return inBall(p) ? 4 : 0; }, mScene.volume.data->worldFromVoxel));
    scene::completeStructures(mScene.labels);
    scene::Cut plane;
    plane.centre = {0, 4, 0};
    plane.axis = {0, -1, 0};
    scene::addCut(mScene, plane);
  }

  int structureAt(glm::dvec3 world) const {
    glm::dvec3 voxel(glm::inverse(mScene.volume.data->worldFromVoxel) * glm::dvec4(world, 1.0));
    return mScene.labels.visible
               ? mScene.labels.data->at(glm::clamp(glm::ivec3(glm::floor(voxel + 0.5)), glm::ivec3(0), kDims - 1))
               : 0;
  }

  /// Picture, sections, kept voxels (which exports write) and picking say the same as the naive fold.
  void expectSameEverywhere(const std::string& what) {
    SCOPED_TRACE(what);
    Progress progress;
    auto kept = render::keptVoxels(mScene, kDims, mScene.volume.data->worldFromVoxel, progress);
    std::size_t i = 0;
    int keptCount = 0;
    for (int z = 0; z < kDims.z; ++z)
      for (int y = 0; y < kDims.y; ++y)
        for (int x = 0; x < kDims.x; ++x, ++i) {
          glm::dvec3 world(mScene.volume.data->worldFromVoxel * glm::dvec4(x, y, z, 1.0));
          Naive wanted = naive(mScene, world, structureAt(world), 0.0);
          keptCount += kept[i];
          if (wanted.isDoubtful) continue;
          ASSERT_EQ(kept[i] != 0, wanted.keeps) << x << ", " << y << ", " << z;
        }
    expectSection();
    expectPicture(keptCount > 0);
  }

 private:
  void expectSection() {
    scene::Scene bare = mScene;
    bare.cuts.clear();
    auto view = scene::makeSectionPlane(mScene, scene::SectionKind::Axial, glm::dvec2(kSize));
    auto image = render::drawSection(mScene, view), whole = render::drawSection(bare, view);
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x) {
        glm::dvec3 world = scene::worldFromSectionPixel(view, {x + 0.5, y + 0.5});
        glm::dvec3 voxel(glm::inverse(mScene.volume.data->worldFromVoxel) * glm::dvec4(world, 1.0));
        if (glm::any(glm::lessThan(voxel, glm::dvec3(0.5))) ||
            glm::any(glm::greaterThan(voxel, glm::dvec3(kDims) - 1.5)))
          continue;
        glm::dvec3 off = glm::abs(glm::fract(voxel + 0.5) - 0.5);
        Naive wanted = naive(mScene, world, structureAt(world), 0.0);
        if (wanted.isDoubtful || std::max(off.x, std::max(off.y, off.z)) > 0.45) continue;  // on a label's border
        auto at = std::size_t(y * kSize.x + x);
        ASSERT_EQ(image.pixels[at] == whole.pixels[at], wanted.keeps) << "section at " << x << ", " << y;
      }
  }

  /// Along each ray of an orthographic picture the first place that is kept is what shows.
  void expectPicture(bool showsAny) {
    mScene.camera.projection = scene::Projection::Orthographic;
    mScene.camera.height = 60;
    lookAlong(mScene, {0, -1, 0});
    Image image = draw(mScene, kSize, kAllLayers);
    int shown = 0, rays = 0, slivers = 0;
    for (int y = 2; y + 2 < kSize.y; y += 3)
      for (int x = 2; x + 2 < kSize.x; x += 3) {
        TestRay ray = rayThrough(mScene.camera, kSize, glm::dvec2(x, y) + 0.5);
        glm::dvec2 box = boxInterval(*mScene.volume.data, ray);
        // Segments are half a voxel, and what is spared is asked in their middles: thinner slivers may be stepped over.
        double found = -1, since = -1;
        bool hasSliver = false;
        for (double t = box.x + 0.02; t < box.y && found < 0; t += 0.05) {
          bool keeps = naive(mScene, ray.at(t), structureAt(ray.at(t)), 0.0).keeps;
          hasSliver = hasSliver || (since >= 0 && !keeps);
          since = !keeps ? -1 : since < 0 ? t : since;
          if (since >= 0 && t - since > 0.6) found = since;
        }
        ++(hasSliver ? slivers : rays);
        if (hasSliver) continue;
        bool isShown = sampleOf(image, {x, y}, "A") > 0.5f;
        ASSERT_EQ(isShown, found >= 0) << "picture at " << x << ", " << y;
        if (!isShown) continue;
        ++shown;
        glm::dvec3 wanted = ray.at(found), is(vectorOf(image, {x, y}, "position"));
        ASSERT_LT(glm::length(wanted - is), 0.6) << "picture at " << x << ", " << y;
      }
    EXPECT_LT(slivers, rays / 10);
    EXPECT_EQ(shown > 0, showsAny);
  }

 protected:
  scene::Scene mScene;
};

TEST_F(SparedScene, AStructureIsSparedWholeOrSoDeep) {
  mScene.cuts[0].spares = {{4}};
  expectSameEverywhere("whole");
  mScene.cuts[0].spares = {{4, 5.2}};
  expectSameEverywhere("so deep");
  mScene.cuts[0].spares = {{4, scene::Spare::kEndless, 0.0}};
  expectSameEverywhere("none of its instances");
}

TEST_F(SparedScene, WhatHasNoLabelIsSparedAlikeEverywhere) {
  mScene.cuts[0].spares = {{0}};
  expectSameEverywhere("whole");
  mScene.cuts[0].spares = {{0, 3.3}};
  expectSameEverywhere("so deep");
}

TEST_F(SparedScene, WithoutLabelsNothingHasOne) {
  mScene.cuts[0].spares = {{0, 6.7}, {4}};
  mScene.labels.visible = false;
  expectSameEverywhere("labels that are not shown");
  mScene.labels = {};
  mScene.labels.visible = false;
  expectSameEverywhere("no labels");
}

TEST_F(SparedScene, SeveralCutsSpareEachForItself) {
  scene::Cut ball;
  ball.shape = scene::CutShape::Sphere;
  ball.centre = {4, 3, 2};
  ball.size = glm::dvec3(24);
  ball.spares = {{0, 2.4}, {4, 4.1}};
  scene::addCut(mScene, ball);
  mScene.cuts[0].spares = {{4, 9.3}, {0, 1.7}};
  expectSameEverywhere("plane and ball");
  mScene.cuts[1].invert = true;
  expectSameEverywhere("plane and all around a ball");
}

}  // namespace
}  // namespace velum
