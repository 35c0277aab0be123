// What all cuts together leave of a structure is one function, on both sides, and the one that was meant.
#include <random>

#include "NaiveCuts.h"
#include "ProbeShaders.h"
#include "RenderFixture.h"
#include "cutShapes.h"
#include "render/FrameSetup.h"
#include "render/upload/SpareTable.h"

namespace velum {
namespace {

constexpr int kPoints = 3000;

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
    cut.joined = whole(0, 2) == 0;
    cut.enabled = whole(0, 9) != 0;
    cut.centre = vector(8);
    cut.axis = vector(1);
    cut.spinDeg = number(-180, 180);
    cut.size = {number(12, 40), number(12, 40), number(12, 40)};
    if (shape == scene::CutShape::Membrane) {
      cut.membrane.emplace();
      cut.membrane->cloth.particles = kNaiveParticles;
      cut.membrane->shape = whole(0, 1) ? wavySheet(kNaiveParticles, cut.size) : foldedSheet(kNaiveParticles, cut.size);
      if (whole(0, 2) == 0) cut.membrane->use = scene::MembraneUse::Inlay;
    }
    for (int i = whole(0, 4); i > 0; --i) {
      double distance = whole(0, 2) == 0 ? scene::Spare::kEndless : number(0, 9);
      cut.spares.push_back({kStructures[whole(0, 4)], distance});
    }
    return cut;
  }

  /// All shapes once, in any order, those that take much inverted or not; two more membranes.
  scene::Scene scene() {
    scene::Scene scene;
    auto shapes = everyShapeButMembranes();
    shapes.insert(shapes.end(), 3, scene::CutShape::Membrane);
    std::shuffle(shapes.begin(), shapes.end(), mEngine);
    shapes.resize(std::size_t(whole(1, 5)));
    for (auto shape : shapes) scene::addCut(scene, cut(shape));
    return scene;
  }

  Points points() {
    Points points;
    for (int i = 0; i < kPoints; ++i) {
      points.places.emplace_back(vector(18), 0.0);
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
    fold = shared::foldCut(fold, cuts[i], shared::cutPart(cuts[i]), spares.depthOf(structure, i), spares.hasDepths,
                           glm::vec3(p), sheets);
  return shared::foldKeeps(fold);
}

/// Asks the shaders' own functions about points, one by one.
constexpr const char* kSparesProbe = R"(layout(local_size_x = 64) in;

#include "common/cuts.glsl"

layout(std430, binding = 2) readonly buffer PointBlock { vec4 points[]; };     // xyz: place, scene frame
layout(std430, binding = 3) readonly buffer NameBlock { uint structureOf[]; };
layout(std430, binding = 4) writeonly buffer AnswerBlock { ivec2 answers[]; };  // x: cutsKeep; y: cutsGuess

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(points.length())) return;
  ivec2 answer;
  answer.x = cutsKeep(points[i].xyz, structureOf[i]) ? 1 : 0;
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
    params.flags = shared::kFlagCuts | shared::kFlagMembranes | shared::kFlagInlays | shared::kFlagJoined;
    if (!spares.isEmpty()) params.flags |= shared::kFlagSpares;
    if (spares.hasDepths) params.flags |= shared::kFlagSpareDepths;
    if (cuts.empty()) cuts.emplace_back();
    gpu::UniformBuffer<shared::FrameParams> block("frame");
    block.set(params);
    block.bind(shared::kFrameBinding);
    gpu::Buffer cutBuffer("cuts", std::span<const shared::CutData>(cuts));
    std::vector<std::uint32_t> spareValues = render::spareTexels(spares);
    gpu::Buffer rows("spares", std::span<const std::uint32_t>(spareValues));
    gpu::Buffer places("places", std::span<const glm::vec4>(points.places));
    gpu::Buffer structures("structures", std::span<const std::uint32_t>(points.structures));
    std::vector<glm::ivec2> answers(points.places.size());
    gpu::Buffer out("answers", answers.size() * sizeof(glm::ivec2));
    cutBuffer.bindStorage(shared::kCutBinding);
    auto rowTexels = gpu::Texture::makeOfBuffer("spares", gpu::Format::R32ui, rows);
    rowTexels.bindSampler(shared::kSpareUnit);
    places.bindStorage(2);
    structures.bindStorage(3);
    out.bindStorage(4);
    sheets.bind();
    if (!mProgram) {
      ProbeShaders probes;
      probes.add("fold.comp", kSparesProbe);
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
      Naive wanted = naive(scene, glm::dvec3(p), structure);
      doubtful += wanted.isDoubtful;
      if (wanted.isDoubtful) continue;
      (wanted.keeps ? kept : removed) += 1;
      bySpare += wanted.keeps && !naive(hard, glm::dvec3(p), structure).keeps;
      bool onGpu = answers[i].x == 1;
      bool onProcessor = keepsOnProcessor(cuts, spares, p, points.structures[i], sheets.view());
      bool guessFits = answers[i].y == shared::kCutNear || (answers[i].y == shared::kCutKeeps) == onGpu;
      near += answers[i].y == shared::kCutNear;
      if (onGpu == wanted.keeps && onProcessor == wanted.keeps && guessFits) continue;
      ++wrong;
      ADD_FAILURE() << "scene " << seed << ", point " << p.x << ", " << p.y << ", " << p.z << " of " << structure
                    << ": kept " << wanted.keeps << ", processor " << onProcessor << ", GPU " << onGpu << ", guess "
                    << answers[i].y;
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
      int part;
    };
    const int kinds[] = {shared::kFoldAlone, shared::kFoldInlay, shared::kFoldJoined};
    std::vector<Part> parts;
    for (int n = random.whole(0, 5); n > 0; --n) {
      auto from = float(random.number(-2, 9));
      int kind = kinds[random.whole(0, 2)];
      // Nothing is joined to the first, or to an inlay.
      if (kind == shared::kFoldJoined && (parts.empty() || parts.back().part == shared::kFoldInlay))
        kind = shared::kFoldAlone;
      parts.push_back({from, from + float(random.number(0.1, 6)), kind});
    }
    // By the definition: joined ones take what all of them take.
    auto isTaken = [&](float t) {
      bool taken = false, group = false;
      for (const auto& part : parts) {
        bool holds = t >= part.from && t < part.to;
        if (part.part == shared::kFoldInlay) continue;
        taken = taken || (part.part == shared::kFoldAlone && group);
        group = part.part == shared::kFoldAlone ? holds : group && holds;
      }
      return taken || group;
    };
    auto foldAt = [&](float t) {
      shared::CutFold fold = shared::emptyFold();
      for (const auto& part : parts)
        fold = shared::foldAnswer(fold, part.part,
                                  t >= part.from && t < part.to ? shared::kCutRemoves : shared::kCutKeeps);
      return fold;
    };
    auto keepsAt = [&](float t) { return shared::foldKeeps(foldAt(t)); };
    for (float t = 0.0f; t < 10.0f;) {
      shared::RunFold fold = shared::emptyRuns(t);
      for (std::size_t c = 0; c < parts.size(); ++c) {
        bool holds = t >= parts[c].from && t < parts[c].to;
        shared::CutRun run{holds ? parts[c].to : t, t < parts[c].from ? parts[c].from : shared::kCutFar, -1};
        fold = shared::foldRun(fold, int(c), parts[c].part, run, t);
      }
      shared::Stretch stretch = shared::stretchOf(fold, 10.0f);
      ASSERT_GT(stretch.end, t);
      for (double share : {0.001, 0.3, 0.7, 0.999}) {
        float at = t + float(share) * (stretch.end - t);
        ASSERT_EQ(shared::foldRemoves(foldAt(at)), isTaken(at));
        ASSERT_EQ(keepsAt(at), stretch.kept) << at << " of " << t << " to " << stretch.end;
      }
      t = stretch.end;
    }
  }
}

}  // namespace
}  // namespace velum
