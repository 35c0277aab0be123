// The form of a sheet at rest is the anatomy's: it does not show the lattice on which its least cut was found.
#include <array>
#include <random>

#include "GlFixture.h"
#include "io/phantoms/Sample.h"
#include "makeVolume.h"
#include "membrane/forces/Kernels.h"
#include "membrane/sheet/Simulation.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/Membranes.h"

namespace velum::session {

namespace {

constexpr double kSlopeVoxels = 2.0;  ///< radius of the disc over which a slope is taken

class SheetFormGL : public GlTest {
 protected:
  /// Balls that lie about anyhow: no direction is another than the next.
  static Volume balls(int size, unsigned seed) {
    std::mt19937 random(seed);
    auto uniform = [&](double low, double high) { return low + (high - low) * double(random()) / 4294967296.0; };
    std::vector<glm::dvec4> all;
    for (int i = 0; i < 90; ++i)
      all.emplace_back(uniform(0, size), uniform(0, size), uniform(0, size), uniform(0.04, 0.09) * size);
    return makeVolume(glm::ivec3(size), SampleType::Int16, [&](glm::ivec3 p) {
      for (glm::dvec4 ball : all)
        if (glm::distance(glm::dvec3(ball), glm::dvec3(p)) < ball.w) return 1000.0;
      return 0.0;
    });
  }
  static scene::Scene sceneOf(Volume volume, glm::dvec3 axis, double low) {
    scene::Scene scene;
    scene.volume.data = Shared<Volume>(std::move(volume));
    scene.cuts = {makeCut(scene, scene::CutShape::Membrane)};
    scene.cuts[0].centre = centreOf(*scene.volume.data);
    scene.cuts[0].axis = axis;
    scene.cuts[0].spinDeg = 0.0;
    protectValues(*scene.cuts[0].membrane, low, 4000);
    return scene;
  }

  /// A sheet at rest over the places of its rest plane, and where it is free.
  struct Sheet {
    explicit Sheet(scene::Scene scene) {
      settleMembranes(scene, {}, sProgress);
      cut = scene.cuts[0];
      worldFromLocal = worldFromCut(cut);
      height = membrane::heightOf(cut.membrane->shape);
      membrane::Potential potential(scene);
      voxels = potential.computeProtected(cut.membrane->field, {glm::ivec3(0), potential.dims()}, sProgress);
      spacing = glm::length(glm::dvec3(voxels.worldFromVoxel[0]));
    }
    /// Slope of the sheet in its own frame: of the plane that fits it best over a disc. (Differences along the axes
    /// would find slopes along the axes wherever it is steep.)
    glm::dvec2 slopeAt(glm::dvec2 at) const {
      constexpr int kSteps = 4;
      glm::dvec2 sum(0.0);
      double squares = 0.0, step = kSlopeVoxels * spacing / kSteps;
      for (int y = -kSteps; y <= kSteps; ++y)
        for (int x = -kSteps; x <= kSteps; ++x) {
          if (x * x + y * y > kSteps * kSteps) continue;
          glm::dvec2 away = step * glm::dvec2(x, y);
          sum += away * height(at + away);
          squares += away.x * away.x;
        }
      return sum / squares;
    }
    /// Nothing protected in the voxel there and in those around it.
    bool isFreeAt(glm::dvec2 at) const {
      glm::dvec3 world(worldFromLocal * glm::dvec4(at, height(at), 1.0));
      glm::ivec3 middle = glm::round(glm::dvec3(glm::inverse(voxels.worldFromVoxel) * glm::dvec4(world, 1.0)));
      glm::ivec3 n = voxels.box.end, low = glm::max(middle - 1, 0), high = glm::min(middle + 1, n - 1);
      for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
          for (int x = low.x; x <= high.x; ++x)
            if (voxels.mask[(std::size_t(z) * std::size_t(n.y) + std::size_t(y)) * std::size_t(n.x) + std::size_t(x)])
              return false;
      return true;
    }
    scene::Cut cut;
    glm::dmat4 worldFromLocal{1.0};
    membrane::HeightOver height;
    membrane::ProtectedVoxels voxels;
    double spacing = 1.0;
  };
  static Sheet turned(scene::Scene scene, double spinDeg) {
    scene.cuts[0].spinDeg = spinDeg;
    return Sheet(scene);
  }
  /// Places of a disc within the rest planes of both frames, local to the first one.
  template <class Visit>
  static void forEachPlace(const Sheet& sheet, Visit visit) {
    double radius = 0.44 * std::min(sheet.cut.size.x, sheet.cut.size.y), pitch = sheet.spacing;
    for (double y = -radius; y <= radius; y += pitch)
      for (double x = -radius; x <= radius; x += pitch)
        if (x * x + y * y < radius * radius) visit(glm::dvec2(x, y));
  }
  inline static Progress sProgress;
};

}  // namespace

TEST_F(SheetFormGL, ItsAreaIsThatOfASheetInATurnedFrame) {
  struct Case {
    Volume volume;
    glm::dvec3 axis;
    double low;
  };
  std::vector<Case> cases;
  cases.push_back({balls(96, 1), {0, 0, 1}, 500});
  cases.push_back({balls(96, 2), {1, 0.4, 0.3}, 500});
  cases.push_back({io::makeSample("vessels", 96, sProgress).volume, {0, 0, 1}, 700});
  cases.push_back({io::makeSample("skull", 112, sProgress).volume, {1, 0, 0}, 300});
  for (std::size_t i = 0; i < cases.size(); ++i) {
    scene::Scene scene = sceneOf(cases[i].volume, cases[i].axis, cases[i].low);
    Sheet straight = turned(scene, 0.0), turn = turned(scene, 30.0);
    double areas[2] = {}, flat = 0.0, all = 0.0;
    forEachPlace(straight, [&](glm::dvec2 at) {
      glm::dvec4 world = straight.worldFromLocal * glm::dvec4(at, 0.0, 1.0);
      glm::dvec2 there(glm::inverse(turn.worldFromLocal) * world);
      all += 1.0;
      if (!straight.isFreeAt(at) || !turn.isFreeAt(there)) return;
      glm::dvec2 a = straight.slopeAt(at), b = turn.slopeAt(there);
      areas[0] += std::sqrt(1.0 + glm::dot(a, a));
      areas[1] += std::sqrt(1.0 + glm::dot(b, b));
      flat += 1.0;
    });
    EXPECT_GT(flat, 0.2 * all) << i;
    EXPECT_NEAR(areas[0] / areas[1], 1.0, 0.03) << i;
  }
}

TEST_F(SheetFormGL, ItsSlopesHaveNoPeaksAtTheAxes) {
  constexpr int kSectors = 12;  // of 15 degrees each, over half a turn
  for (double spin : {0.0, 30.0}) {
    std::array<double, kSectors> sectors{};
    double all = 0.0;
    for (unsigned seed = 1; seed <= 10; ++seed) {
      Sheet sheet = turned(sceneOf(balls(72, seed), {0, 0, 1}, 500), spin);
      forEachPlace(sheet, [&](glm::dvec2 at) {
        glm::dvec2 slope = sheet.slopeAt(at);
        double steep = glm::length(slope);
        if (steep < 0.1 || !sheet.isFreeAt(at)) return;
        double turns = std::atan2(slope.y, slope.x) / glm::radians(180.0) + 1.0;
        sectors[std::size_t(std::floor(turns * kSectors + 0.5)) % kSectors] += 1.0;
        all += 1.0;
      });
    }
    EXPECT_GT(all, 1000.0);
    // The mean is one; the first sector lies about the x axis, the seventh about y.
    EXPECT_LT((sectors[0] + sectors[6]) / all, 1.25 * 2.0 / kSectors) << spin;
  }
}

}  // namespace velum::session
