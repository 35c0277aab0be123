// Fields set by their paths, with all that follows: whoever sets them.
#include "session/document/SetFields.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "TempFolder.h"
#include "core/Error.h"
#include "io/images/ImageFile.h"
#include "io/labels/WriteLabels.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "session/Session.h"
#include "session/command/Command.h"
#include "session/command/FilmCommands.h"
#include "session/document/Open.h"

namespace velum::session {
namespace {

class SetFields : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    sFolder = new TempFolder;
    io::Sample sample = io::makeSample("two-spheres", 32, sProgress);
    io::writeVolume(sample.volume, *sFolder / "one.nrrd", sProgress);
    io::writeLabels(sample.labels, *sFolder / "labels.seg.nrrd", sProgress);
    io::writeVolume(io::makeSample("torso", 48, sProgress).volume, *sFolder / "other.nrrd", sProgress);
    Image paper(4, 4, {"R", "G", "B"});
    paper.pixels.assign(4 * 4 * 3, 0.5f);
    io::writeImage(paper, *sFolder / "paper.png", "");
  }
  static void TearDownTestSuite() {
    delete sFolder;
    sFolder = nullptr;
  }
  void SetUp() override {
    scene::Source source;
    source.path = path("one.nrrd");
    mScene = open(source, sProgress);
    source.path = path("labels.seg.nrrd");
    addLabels(mScene, source, sProgress);
  }
  static std::string path(const char* name) { return (*sFolder / name).string(); }
  std::vector<std::string> set(const std::string& field, const std::string& value) {
    scene::Scene before = mScene;
    scene::Scene after = mScene;
    setField(after, field, value);
    mFollows = mustFollow(after, before);
    return setFields(mScene, {{field, value}}, sProgress);
  }

  static inline TempFolder* sFolder = nullptr;
  static inline Progress sProgress;
  scene::Scene mScene;
  bool mFollows = false;  ///< Of what was set last: it is work for a job.
};

TEST_F(SetFields, WhatIsOnlyAFieldIsDoneAtOnce) {
  auto data = mScene.volume.data;
  EXPECT_TRUE(set("rayCast.mode", "mip").empty());
  EXPECT_FALSE(mFollows);
  EXPECT_EQ(mScene.rayCast.mode, scene::RenderMode::Mip);
  EXPECT_EQ(mScene.volume.data, data);
  set("labels.structures.*.visible", "false");
  EXPECT_FALSE(mFollows);
}

TEST_F(SetFields, TheTableGoesAndComesBackWithItsField) {
  auto all = mScene.volume.data;
  auto notes = set("volume.bodyOnly", "true");
  EXPECT_TRUE(mFollows);
  EXPECT_TRUE(mScene.volume.given == all);
  EXPECT_FALSE(mScene.volume.data == all);
  EXPECT_EQ(notes.size(), 1u) << "what was left out is told";
  set("volume.bodyOnly", "false");
  EXPECT_TRUE(mScene.volume.data == all);
}

TEST_F(SetFields, AnotherVoxelSizeIsRead) {
  glm::dvec3 eye = mScene.camera.eye;
  set("volume.source.spacing", "2,2,2");
  EXPECT_TRUE(mFollows);
  EXPECT_EQ(spacingOf(*mScene.volume.data), glm::dvec3(2.0));
  EXPECT_FALSE(mScene.camera.eye == eye) << "the camera goes with it";
  EXPECT_EQ(mScene.labels.data->worldFromVoxel(), mScene.volume.data->worldFromVoxel);
}

TEST_F(SetFields, AnotherFileIsRead) {
  auto dims = mScene.volume.data->dims;
  set("volume.source.path", path("other.nrrd"));
  EXPECT_TRUE(mFollows);
  EXPECT_NE(mScene.volume.data->dims, dims);
  set("labels.source.path", "\"\"");
  EXPECT_FALSE(mScene.labels.data);
  set("labels.source.path", path("labels.seg.nrrd"));
  EXPECT_TRUE(mScene.labels.data);
}

TEST_F(SetFields, ShapesAreSmoothed) {
  auto file = mScene.labels.data;
  set("labels.structures.0.smoothing", "1.5");
  EXPECT_TRUE(mFollows);
  EXPECT_FALSE(mScene.labels.data == file);
  set("labels.structures.0.smoothing", "0");
  EXPECT_TRUE(mScene.labels.data == file);
}

TEST_F(SetFields, AListThatIsSetWholeKeepsTheDataOfItsItems) {
  set("finish.paper", path("paper.png"));
  EXPECT_EQ(mScene.finish.paper, scene::Paper::Own);
  EXPECT_TRUE(mScene.finish.ownPaper.data);
  set("finish.spheres", "[{\"name\":\"mine\",\"source\":{\"path\":\"" + path("paper.png") + "\"}}]");
  ASSERT_TRUE(mScene.finish.spheres.at(0).data);
  auto picture = mScene.finish.spheres[0].data;
  set("finish.spheres.+.name", "second");
  ASSERT_EQ(mScene.finish.spheres.size(), 2u);
  EXPECT_TRUE(mScene.finish.spheres[0].data == picture);
}

TEST_F(SetFields, SurfacesThatWereMadeInMemoryStayAsTheyAre) {
  mScene.surfaces.resize(2);
  for (auto& surface : mScene.surfaces) {
    Mesh mesh;
    mesh.positions.assign(3, glm::vec3(0.0f));
    surface.data = Shared<Mesh>(std::move(mesh));
  }
  auto second = mScene.surfaces[1].data;
  set("rayCast.mode", "mip");
  EXPECT_TRUE(mScene.surfaces[1].data == second);
}

TEST_F(SetFields, TracksOfOneFieldBecomeOneWhateverBringsThem) {
  scene::addCut(mScene, {});
  auto keys = [](const char* path, double time) {
    return fmt::format(R"({{"path": "{}", "keys": [{{"time": {}, "value": [1, 2, 3]}}]}})", path, time);
  };
  auto notes = set("timeline.tracks", "[" + keys("cuts.0.centre", 1) + "," + keys("cuts[#1].centre", 2) + "]");
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("cuts[#1].centre has two tracks"), notes[0].npos) << notes[0];
  ASSERT_EQ(mScene.timeline.tracks.size(), 1u);
  EXPECT_EQ(mScene.timeline.tracks[0].keys.size(), 2u);
  // A file, with a structure by its name.
  int id = mScene.labels.structures[0].id;
  std::string name = mScene.labels.structures[0].name;
  scene::Scene twice = mScene;
  twice.timeline.tracks.push_back({"cuts.0.centre", true, {{3.0, {"[4,5,6]"}}}});
  for (const std::string& key : {name, fmt::format("#{}", id)})
    twice.timeline.tracks.push_back({fmt::format("labels.structures[{}].opacity", key), true, {{0.0, {"0.5"}}}});
  scene::Source source;
  source.path = path("twice.json");
  saveScene(twice, source.path);
  notes.clear();
  scene::Scene opened = open(source, sProgress, {}, &notes);
  EXPECT_EQ(notes.size(), 2u);
  ASSERT_EQ(opened.timeline.tracks.size(), 2u);
  EXPECT_EQ(opened.timeline.tracks[0].keys.size(), 3u);
  EXPECT_EQ(opened.timeline.tracks[1].path, fmt::format("labels.structures[#{}].opacity", id));
  // Keys that are added.
  Session session(opened);
  for (const std::string& field : {std::string("cuts.0.centre"), "labels.structures[" + name + "].opacity"})
    run(session, SetFilmKey{field, 7.0, {}}, sProgress);
  ASSERT_EQ(session.scene().timeline.tracks.size(), 2u);
  EXPECT_EQ(session.scene().timeline.tracks[0].keys.size(), 4u);
  EXPECT_EQ(session.scene().timeline.tracks[1].keys.size(), 2u);
}

TEST_F(SetFields, WhatIsRefusedChangesNothing) {
  scene::Scene before = mScene;
  EXPECT_THROW(set("volume.source.path", path("gone.nrrd")), InputError);
  EXPECT_THROW(set("labels.source.path", path("gone.seg.nrrd")), InputError);
  EXPECT_THROW(set("finish.paper", path("gone.png")), InputError);
  EXPECT_THROW(set("finish.paper", "own"), ArgumentError);
  EXPECT_THROW(set("camera.eye", "4"), ArgumentError);
  EXPECT_THROW(setFields(mScene, {{"rayCast.mode", "mip"}, {"volume.source.path", path("gone.nrrd")}}, sProgress),
               InputError);
  EXPECT_TRUE(mScene == before);
}

TEST_F(SetFields, ASheetThatBecomesPassiveForgetsWhereAnActiveOneHadCome) {
  scene::Cut cut;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace().repositioning = scene::Repositioning::Active;
  cut.membrane->shape.particles = {2, 2};
  cut.membrane->shape.places.assign(4, glm::vec3(1.0f));
  scene::addCut(mScene, cut);
  auto shape = [this] { return mScene.cuts.back().membrane->shape; };
  set("cuts.0.membrane.look", "grid");
  EXPECT_EQ(shape().places.size(), 4u);
  set("cuts.0.membrane.repositioning", "passive");
  EXPECT_EQ(shape(), scene::SheetShape());
}

}  // namespace
}  // namespace velum::session
