// The four targets of the user study of [ACS] 5.2, and the same on a real scan: from the opened file to the picture
// with clicks, drags and keys in the real window, at most one drag a structure.
#include <cstdlib>
#include <map>
#include <set>

#include "PullFixture.h"

namespace velum::gui {

class PullStudy : public PullFixture {
 protected:
  /// A structure by the name that the phantom's truth has for it, out of which plane, and how far.
  struct Target {
    std::string name;
    int plane;
    double distance;
  };
  using Targets = std::vector<Target>;

  static void SetUpTestSuite() {
    Window::SetUpTestSuite();
    for (const char* name : {"hand", "foot"}) {
      Progress progress;
      io::Sample sample = io::makeSample(name, 144, progress);
      io::writeVolume(sample.volume, *sFolder / (name + std::string(".nrrd")), progress);
      io::writeLabels(sample.labels, *sFolder / (name + std::string(".seg.nrrd")), progress);
      sTruth[name] = std::move(sample.labels);
    }
  }
  static void TearDownTestSuite() {
    sTruth.clear();
    Window::TearDownTestSuite();
  }

  void openPhantom(const std::string& name, bool withLabels) {
    QStringList files{path((name + ".nrrd").c_str())};
    if (withLabels) files << path((name + ".seg.nrrd").c_str());
    open(files);
    ASSERT_EQ(bool(scene().labels.data), withLabels);
    mHasLabels = withLabels;
    mTruth = &sTruth[name];
  }
  /// Looks from a side and cuts there; then looks obliquely.
  void makePlane(const char* side, int notches) {
    press(side);
    ASSERT_TRUE(settle());
    takeUp();
    ASSERT_EQ(scene().cuts.size(), 1u) << "the tool brings one";
    turnWheel(notches);
    press("0");
    ASSERT_TRUE(settle());
  }
  void makeSecondPlane(int notches) {
    press("Shift+U");
    ASSERT_EQ(scene().cuts.size(), 2u);
    turnWheel(notches);
    ASSERT_TRUE(settle());
  }

  int idOf(const std::string& name) {
    for (const auto& info : mTruth->table)
      if (info.name == name) return info.id;
    ADD_FAILURE() << "no " << name;
    return 0;
  }
  int truthAt(glm::dvec3 world) {
    glm::dvec3 voxel(glm::inverse(mTruth->worldFromVoxel()) * glm::dvec4(world, 1.0));
    return int(mTruth->at(glm::clamp(glm::ivec3(glm::round(voxel)), glm::ivec3(0), mTruth->dims() - 1)));
  }
  /// What is the truth of it: a sample lies at the border of what is seen, to either side.
  std::set<int> truthsAround(const render::Pick& pick) {
    std::set<int> ids;
    for (double off : {-1.0, 0.0, 0.6})
      ids.insert(truthAt(pick.world - off * scene::sectionStep(scene()) * glm::dvec3(pick.normal)));
    return ids;
  }
  /// Well inside of what is wanted, among what is seen on the face of a plane.
  std::optional<Seen> placeOn(const scene::Cut& plane, const std::function<bool(const Seen&)>& isWanted) {
    std::map<std::pair<int, int>, Seen> candidates;
    for (const Seen& seen : look(4))
      if (isOnFace(seen, plane) && isWanted(seen)) candidates[{seen.pixel.x(), seen.pixel.y()}] = seen;
    std::optional<Seen> best;
    int most = -1;
    for (const auto& [place, seen] : candidates) {
      int around = 0;
      for (int x = -12; x <= 12; x += 4)
        for (int y = -12; y <= 12; y += 4) around += int(candidates.count({place.first + x, place.second + y}));
      if (around > most) most = around, best = seen;
    }
    return best;
  }
  /// One press, one drag.
  void pullOut(const Target& target) {
    SCOPED_TRACE(target.name);
    int id = idOf(target.name);
    const scene::Cut plane = cut(target.plane);
    auto place = placeOn(plane, [&](const Seen& seen) {
      bool isLabelled = mHasLabels && seen.pick.structure != 0;
      return isLabelled ? seen.pick.structure == id : truthAt(seen.pick.world) == id;
    });
    ASSERT_TRUE(place) << "it is not seen on the face";
    pull(place->pixel, place->pick.world, plane, target.distance);
    ++mDrags;
    ASSERT_TRUE(settle());
  }

  /// How far a structure reaches out of a plane, where the planes open it: by the truth.
  double reachOf(int id, const scene::Cut& plane) {
    double reach = 0.0;
    glm::ivec3 dims = mTruth->dims();
    glm::dmat4 worldFromVoxel = mTruth->worldFromVoxel();
    for (glm::ivec3 v(0); v.z < dims.z; ++v.z)
      for (v.y = 0; v.y < dims.y; ++v.y)
        for (v.x = 0; v.x < dims.x; ++v.x) {
          if (mTruth->at(v) != id) continue;
          glm::dvec3 world(worldFromVoxel * glm::dvec4(v, 1.0));
          if (depthOf(world) > 0.0) reach = std::max(reach, session::depthInCut(plane, world));
        }
    return reach;
  }
  /// Each wanted structure stands out as far as it was pulled, or as it reaches.
  void expectStandOut(const Targets& targets, const std::vector<Seen>& seen) {
    for (const Target& target : targets) {
      int id = idOf(target.name);
      const scene::Cut& plane = cut(target.plane);
      double wanted = std::min(target.distance, reachOf(id, plane)), most = 0.0;
      for (const auto& one : seen)
        if (depthOf(one.pick.world) > slack() && truthsAround(one.pick).count(id))
          most = std::max(most, session::depthInCut(plane, one.pick.world));
      std::printf("%s: pulled %.1f mm out, reaches %.1f, stands out %.1f\n", target.name.c_str(), target.distance,
                  reachOf(id, plane), most);
      EXPECT_NEAR(most, wanted, 4.0) << target.name;
    }
  }
  void expectPicture(const Targets& targets) {
    std::vector<Seen> seen = look(4);
    expectStandOut(targets, seen);
    std::set<int> wanted;
    for (const Target& target : targets) wanted.insert(idOf(target.name));
    for (const auto& [pixel, pick] : seen) {
      if (depthOf(pick.world) <= slack()) continue;
      EXPECT_TRUE(wanted.count(pick.structure))
          << "structure " << pick.structure << " stands out at " << pixel.x() << " " << pixel.y();
    }
    auto out = session::extrusionsOf(scene());
    ASSERT_EQ(out.size(), targets.size());
    for (const Target& target : targets) {
      int id = idOf(target.name);
      double far = std::min(target.distance, reachOf(id, cut(target.plane)));  // not beyond its end
      EXPECT_NEAR(session::extrusionOf(cut(target.plane), id), far, 2.0) << target.name;
    }
    EXPECT_LE(mDrags, int(targets.size()));
  }
  /// The tool is laid down, and the picture is what it leaves.
  void finish(const char* name) {
    takeShot(*mWindow, QString(name) + "-tool");
    press("U");
    EXPECT_FALSE(tool());
    mWindow->selection().setCut(0);
    ASSERT_TRUE(settle());
    takeShot(*mWindow, name);
  }

  /// The whole way with labels.
  void study(const char* phantom, const char* side, int notches, std::optional<int> second, const Targets& targets,
             const char* picture) {
    openPhantom(phantom, true);
    makePlane(side, notches);
    if (second) makeSecondPlane(*second);
    for (const Target& target : targets) pullOut(target);
    if (HasFatalFailure()) return;
    finish(picture);
    expectPicture(targets);
  }

  /// Without labels one drag brings the bone, with what hangs together with it by its values.
  void studyGrown(const char* phantom, const char* side, int notches, std::optional<int> second, const Targets& targets,
                  const char* picture) {
    openPhantom(phantom, false);
    makePlane(side, notches);
    if (second) makeSecondPlane(*second);
    for (const Target& target : targets) pullOut(target);
    if (HasFatalFailure()) return;
    finish(picture);
    EXPECT_EQ(mDrags, int(targets.size()));
    ASSERT_EQ(session::extrusionsOf(scene()).size(), targets.size());
    std::set<int> structures;
    for (const auto& step : scene().labels.growths) structures.insert(step.structure);
    std::vector<Seen> seen = look(4);
    expectStandOut(targets, seen);
    int all = 0, bright = 0;
    for (const auto& [pixel, pick] : seen) {
      if (depthOf(pick.world) <= slack()) continue;
      EXPECT_TRUE(structures.count(pick.structure)) << pixel.x() << " " << pixel.y();
      ++all;
      // Arteries full of contrast, then bones, follow all soft parts in the tables of both phantoms.
      bright += *truthsAround(pick).rbegin() >= idOf("artery");
    }
    std::printf("%zu structures; %d of %d places that stand out are bone or vessel\n", structures.size(), bright, all);
    EXPECT_GT(bright, 0.8 * all) << "the rest is their blurred border";
  }

  inline static std::map<std::string, LabelVolume> sTruth;
  const LabelVolume* mTruth = nullptr;
  bool mHasLabels = false;  ///< of the file's own, not grown
  int mDrags = 0;
};

TEST_F(PullStudy, AHandWithOnePlane) {
  study("hand", "1", -11, {},
        {{"proximal phalanx of index finger", 0, 9.0},
         {"proximal phalanx of middle finger", 0, 20.0},
         {"hamate", 0, 12.0},
         {"scaphoid", 0, 8.0}},
        "study-hand-one");
}

TEST_F(PullStudy, AHandWithTwoPlanes) {
  study("hand", "1", -11, -5,
        {{"radius", 0, 8.0},
         {"proximal phalanx of index finger", 0, 10.0},
         {"proximal phalanx of middle finger", 1, 6.0},
         {"middle phalanx of middle finger", 1, 6.0}},
        "study-hand-two");
}

TEST_F(PullStudy, AFootWithOnePlane) {
  study("foot", "Shift+3", 0, {},
        {{"calcaneus", 0, 14.0}, {"tibia", 0, 9.0}, {"cuboid", 0, 18.0}, {"lateral cuneiform", 0, 6.0}},
        "study-foot-one");
}

TEST_F(PullStudy, AFootWithTwoPlanes) {
  study("foot", "Shift+3", 0, -33,
        {{"cuboid", 0, 18.0}, {"third metatarsal", 0, 5.0}, {"talus", 1, 10.0}, {"calcaneus", 1, 20.0}},
        "study-foot-two");
}

TEST_F(PullStudy, AHandThatNobodyHasLabelled) {
  studyGrown("hand", "1", -11, {}, {{"proximal phalanx of index finger", 0, 25.0}}, "study-hand-grown");
}

TEST_F(PullStudy, AFootThatNobodyHasLabelled) {
  studyGrown("foot", "Shift+3", 0, {}, {{"calcaneus", 0, 14.0}}, "study-foot-grown");
}

TEST_F(PullStudy, AHandThatNobodyHasLabelledWithTwoPlanes) {
  studyGrown("hand", "1", -11, -5,
             {{"proximal phalanx of index finger", 0, 10.0}, {"middle phalanx of middle finger", 1, 6.0}},
             "study-hand-grown-two");
}

TEST_F(PullStudy, AFootThatNobodyHasLabelledWithTwoPlanes) {
  // In this order: all bones hang together, and 18 mm of them out of the first plane hide the talus on the second.
  studyGrown("foot", "Shift+3", 0, -33, {{"talus", 1, 10.0}, {"cuboid", 0, 18.0}}, "study-foot-grown-two");
}

TEST_F(PullStudy, ARealScanGivesSpineAndRib) {
  const char* folder = std::getenv("VELUM_TEST_DATA");
  if (!folder) GTEST_SKIP() << "set VELUM_TEST_DATA to the folder of test volumes";
  open({QString(folder) + "/volumes/ct_torso_contrast_lidc2.mha"});
  document().edit("Look", [](scene::Scene& s) { s.volume.transfer.opacities = {{120, 0}, {150, 0.5}, {190, 0.95}}; });
  makePlane("1", -60);
  glm::dvec3 middle = cut().centre;
  auto aside = [middle](glm::dvec3 place) { return std::abs(place.x - middle.x); };
  struct Bone {
    const char* name;
    double from, to, distance;  ///< so far from the middle it is; so far it is pulled out
    int structure = 0;
  };
  std::vector<Bone> bones{{"spine", 0.0, 25.0, 25.0}, {"rib", 65.0, 115.0, 40.0}};
  for (Bone& bone : bones) {
    SCOPED_TRACE(bone.name);
    auto place = placeOn(cut(), [&](const Seen& seen) {
      double away = aside(seen.pick.world);
      return seen.pick.structure == 0 && seen.pick.value > 150.0 && seen.pick.value < 220.0 && away >= bone.from &&
             away <= bone.to && std::abs(seen.pick.world.z - middle.z) < 60.0;  // in bone, not on a grain of its shell
    });
    ASSERT_TRUE(place);
    pull(place->pixel, place->pick.world, cut(), bone.distance);
    ++mDrags;
    ASSERT_TRUE(settle());
    const scene::Growth& step = scene().labels.growths.back();
    bone.structure = step.structure;
    std::printf("%s: at value %.0f, range %.0f to %.0f\n", bone.name, place->pick.value, step.low, step.high);
  }
  finish("study-thorax");
  EXPECT_EQ(mDrags, 2);
  EXPECT_FALSE(growth().status().leak);
  ASSERT_EQ(session::extrusionsOf(scene()).size(), 2u);
  std::vector<Seen> seen = look(4);
  for (const Bone& bone : bones) {
    double most = 0.0;
    for (const auto& one : seen)
      if (one.pick.structure == bone.structure) most = std::max(most, depthOf(one.pick.world));
    std::size_t all = voxelsOf(bone.structure);
    std::size_t near = voxelsOf(bone.structure,
                                [&](glm::dvec3 p) { return aside(p) > bone.from - 40.0 && aside(p) < bone.to + 40.0; });
    std::printf("%s: pulled %.1f mm out, stands out %.1f, %zu voxels\n", bone.name, bone.distance, most, all);
    EXPECT_NEAR(most, bone.distance, 4.0) << bone.name;
    EXPECT_GT(all, 100u) << bone.name;
    EXPECT_GT(near, 0.98 * all) << bone.name << " alone";
  }
  for (const auto& [pixel, pick] : seen) {
    if (depthOf(pick.world) <= slack()) continue;
    EXPECT_TRUE(pick.structure == bones[0].structure || pick.structure == bones[1].structure)
        << pixel.x() << " " << pixel.y();
  }
}

}  // namespace velum::gui
