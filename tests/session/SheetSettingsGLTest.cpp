// Each setting of a membrane that the window shows for a rule changes where a sheet rests, as its tip says; those that
// it does not show have no say.
#include <algorithm>
#include <functional>

#include "GlFixture.h"
#include "io/phantoms/Sample.h"
#include "makeVolume.h"
#include "membrane/sheet/Simulation.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/Membranes.h"

namespace velum::session {

namespace {

constexpr auto kSided = scene::KernelRule::Sided, kPaper = scene::KernelRule::Paper;
constexpr double kNoSay = 0.1;  ///< voxels: by so much the way to rest may show
using Setting = std::function<void(scene::Membrane&)>;

class SheetSettingsGL : public GlTest {
 protected:
  struct Rested {
    MembraneReport report;
    scene::Cut cut;
    double voxel = 1.0;
    double distance() const { return membrane::meanDistance(cut.membrane->shape) / voxel; }
    /// How much it is bent, in the mean over its particles.
    double bend() const {
      const scene::SheetShape& shape = cut.membrane->shape;
      int nx = shape.particles.x;
      double sum = 0;
      for (int y = 0; y < shape.particles.y; ++y)
        for (int x = 1; x + 1 < nx; ++x) {
          const glm::vec3* p = shape.places.data() + y * nx + x;
          sum += glm::length(p[-1] - 2.0f * p[0] + p[1]);
        }
      return sum / double(shape.places.size());
    }
  };
  static Rested rest(scene::KernelRule rule, const Setting& setting = {}) {
    return rest(io::makeSample("two-spheres", rule == kPaper ? 48 : 72, sProgress).volume, rule, setting);
  }
  static Rested rest(Volume volume, scene::KernelRule rule, const Setting& setting = {}) {
    scene::Scene scene;
    scene.volume.data = Shared<Volume>(std::move(volume));
    scene.cuts = {makeCut(scene, scene::CutShape::Membrane)};
    scene.cuts[0].axis = {0, 0, 1};
    scene.cuts[0].spinDeg = 0.0;
    scene.cuts[0].centre = centreOf(*scene.volume.data);
    protectValues(*scene.cuts[0].membrane, 500, 4000);
    setRule(*scene.cuts[0].membrane, rule);
    if (setting) setting(*scene.cuts[0].membrane);
    Rested rested;
    rested.report = settleMembranes(scene, {}, sProgress).at(0);
    rested.cut = scene.cuts[0];
    rested.voxel = glm::length(glm::dvec3(scene.volume.data->worldFromVoxel[0]));
    return rested;
  }
  /// The largest difference of two sheets' heights over the rest plane, in voxels.
  static double apart(const Rested& a, const Rested& b) {
    membrane::HeightOver first = membrane::heightOf(a.cut.membrane->shape),
                         second = membrane::heightOf(b.cut.membrane->shape);
    glm::dvec2 half(0.48 * glm::dvec2(a.cut.size));
    double most = 0;
    for (double y = -half.y; y < half.y; y += a.voxel)
      for (double x = -half.x; x < half.x; x += a.voxel)
        most = std::max(most, std::abs(first({x, y}) - second({x, y})));
    return most / a.voxel;
  }
  inline static Progress sProgress;
};

TEST_F(SheetSettingsGL, BySidesStiffnessSpansMoreAndThePullBackLess) {
  Rested usual = rest(kSided);
  Rested stiff = rest(kSided, [](auto& m) { m.cloth.stretch = 1.0; });
  Rested pulled = rest(kSided, [](auto& m) { m.cloth.restoring = 2000.0; });
  // Beside the spheres: over them it lies where they let it.
  EXPECT_GT(stiff.distance(), 1.04 * usual.distance());
  EXPECT_GT(apart(stiff, usual), 3.0 * kNoSay);
  EXPECT_LT(pulled.distance(), 0.98 * usual.distance());
  EXPECT_GT(apart(pulled, usual), 3.0 * kNoSay);
}

TEST_F(SheetSettingsGL, BySidesOneSaysWhichSideIsPassedAndHowFineTheSheetIs) {
  // A ball in the middle, round which there is a way on either side.
  auto ball = [] {
    return makeVolume(
        glm::ivec3(48), SampleType::Int16,
        [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - glm::dvec3(23.5)) < 4.0 ? 1000.0 : 0.0; },
        glm::dmat4(1.0));
  };
  Rested kept = rest(ball(), kSided);
  Rested removed = rest(ball(), kSided, [](auto& m) { m.field.side = scene::MembraneSide::Remove; });
  EXPECT_GT(membrane::heightOf(kept.cut.membrane->shape)({0, 0}), 3.0);
  EXPECT_LT(membrane::heightOf(removed.cut.membrane->shape)({0, 0}), -3.0);
  Rested usual = rest(kSided);
  Rested coarse = rest(kSided, [](auto& m) { m.cloth.finest = 30; });
  EXPECT_EQ(std::max(coarse.report.particles.x, coarse.report.particles.y), 50) << "no coarser than it moved";
  EXPECT_GT(usual.report.particles.x, 70);
}

TEST_F(SheetSettingsGL, BySidesWhatIsNotShownHasNoSay) {
  Rested usual = rest(kSided);
  const Setting settings[] = {[](auto& m) { m.field.level = 3; }, [](auto& m) { m.field.areaOfEffect = 4.0; },
                              [](auto& m) { m.cloth.bend = 0.9; }, [](auto& m) { m.cloth.particles = glm::ivec2(30); }};
  for (std::size_t i = 0; i < std::size(settings); ++i) EXPECT_LT(apart(usual, rest(kSided, settings[i])), kNoSay) << i;
}

TEST_F(SheetSettingsGL, ByThePapersRuleEachDoesWhatItSays) {
  Rested usual = rest(kPaper);
  EXPECT_GT(rest(kPaper,
                 [](auto& m) {
                   for (auto& point : m.field.byValue) point.strength *= 4.0;
                 })
                .distance(),
            1.05 * usual.distance())
      << "a stronger force pushes farther";
  Rested coarse = rest(kPaper, [](auto& m) { m.field.level = 3; });
  EXPECT_LT(coarse.report.kernels, usual.report.kernels / 8) << "a kernel for 8 voxels along an edge, not 2";
  EXPECT_GT(apart(usual, coarse), 0.5);
  EXPECT_GT(rest(kPaper, [](auto& m) { m.field.areaOfEffect = 4.0; }).distance(), 1.05 * usual.distance());
  EXPECT_LT(rest(kPaper, [](auto& m) { m.cloth.bend = 1.0; }).bend(), 0.95 * usual.bend());
  EXPECT_GT(apart(usual, rest(kPaper, [](auto& m) { m.cloth.stretch = 0.2; })), 0.3);
  EXPECT_LT(rest(kPaper, [](auto& m) { m.cloth.restoring = 200.0; }).distance(), 0.9 * usual.distance());
  EXPECT_EQ(rest(kPaper, [](auto& m) { m.cloth.particles = glm::ivec2(30); }).report.particles, glm::ivec2(30));
}

}  // namespace
}  // namespace velum::session
