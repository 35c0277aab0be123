// The journal of what was done, as a script that can be run again.
#include <gtest/gtest.h>

#include "TempFolder.h"
#include "core/Error.h"
#include "io/labels/WriteLabels.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "scene/json/Json.h"
#include "session/Session.h"
#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/command/DocumentCommands.h"
#include "session/command/ExtrusionCommands.h"
#include "session/command/GrowthCommands.h"
#include "session/command/LookCommands.h"
#include "session/command/PythonLines.h"
#include "session/command/StructureCommands.h"
#include "session/growth/Growths.h"

namespace velum::session {
namespace {

class CommandLines : public testing::Test {
 protected:
  void SetUp() override {
    io::Sample sample = io::makeSample("two-spheres", 32, mProgress);
    io::writeVolume(sample.volume, mFolder / "a volume.nrrd", mProgress);
    io::writeLabels(sample.labels, mFolder / "labels.seg.nrrd", mProgress);
    does(OpenFile{.path = (mFolder / "a volume.nrrd").string()});
    does(AddFile{(mFolder / "labels.seg.nrrd").string()});
    mFirst = mSession.scene().labels.structures.at(0).name;
  }
  void does(const Call& call) {
    run(mSession, call, mProgress);
    mSession.settle(mProgress);
  }
  /// An edit that is no command: what a hand drags.
  void drags(const char* label, const Document::Change& change, bool merge = false) {
    mSession.document().edit(label, change, merge);
    mSession.settle(mProgress);
  }
  /// Of a session in which all lines have been run.
  std::string again(const std::vector<std::string>& lines) {
    Session other;
    std::string text;
    for (const auto& line : lines) text += line + "\n";
    runScript(other, text, "lines", mProgress, [](const Call&, const std::string&) {});
    return scene::toJson(other.scene());
  }
  void expectSameAgain() { EXPECT_EQ(again(mSession.document().commandLines()), scene::toJson(mSession.scene())); }

  TempFolder mFolder;
  Progress mProgress;
  Session mSession;
  std::string mFirst;
};

TEST_F(CommandLines, RunAgainTheyLeadToTheSameScene) {
  expectSameAgain();
  does(AddCut{scene::CutShape::Plane, "my = cut"});
  does(AddCut{scene::CutShape::Box, {}});
  does(DuplicateCut{"my = cut"});
  does(SpareStructures{{mFirst}, true, "my = cut"});
  does(PullStructure{mFirst, 4.5, "my = cut copy"});
  does(ColorStructures{{mFirst}, {0.5f, 0.1f, 0.7f}});
  does(ChooseMode{scene::RenderMode::Mip});
  does(SetField{"volume.bodyOnly", "true"});
  expectSameAgain();
  drags("Move cut", [](scene::Scene& scene) { scene.cuts[0].centre.x += 3.25; });
  drags("Look", [](scene::Scene& scene) { scene.volume.transfer.opacities = {{0, 0}, {10, 0.1}, {500, 0.9}}; });
  drags("Remove", [](scene::Scene& scene) { scene.cuts.pop_back(); });
  mSession.document().view([](scene::Scene& scene) { scene.camera.eye += glm::dvec3(1, 2, 3); });
  expectSameAgain();
}

TEST_F(CommandLines, WhatHasGrownGrowsAgain) {
  does(OpenFile{.path = (mFolder / "a volume.nrrd").string()});
  does(AddCut{});
  const scene::Scene& scene = mSession.scene();
  // A place on the plane with the brightest value.
  const Volume& volume = *scene.volume.data;
  glm::dvec3 best(0.0);
  double most = -1e9;
  for (int z = 1; z + 1 < volume.dims.z; ++z)
    for (int y = 1; y + 1 < volume.dims.y; ++y)
      for (int x = 1; x + 1 < volume.dims.x; ++x) {
        glm::dvec3 world(volume.worldFromVoxel * glm::dvec4(x, y, z, 1.0));
        double off = std::abs(glm::dot(world - scene.cuts[0].centre, scene.cuts[0].axis)) / spacingOf(volume).x;
        double value = valueAt(volume, {x, y, z}, 0, 0);
        if (off < 0.6 && value > most) most = value, best = world;
      }
  does(PullAt{best, 8.0, {}});
  ASSERT_EQ(scene.labels.growths.size(), 1u);
  EXPECT_TRUE(isGrown(scene));
  EXPECT_FALSE(scene.labels.data->idsInUse().empty());
  int structure = scene.labels.growths[0].structure;
  does(PullStructure{structureNames(scene, {structure})[0], 3.0, {}});
  expectSameAgain();
  does(ForgetGrown{structureNames(scene, {structure})[0]});
  EXPECT_TRUE(scene.labels.growths.empty());
  expectSameAgain();
}

TEST_F(CommandLines, WhatWasUndoneIsNotAmongThem) {
  does(AddCut{});
  auto lines = mSession.document().commandLines();
  does(FlipCut{});
  EXPECT_EQ(mSession.document().lastCommandLines(), std::vector<std::string>{"cut.flip"});
  does(Undo{});
  EXPECT_EQ(mSession.document().commandLines(), lines);
  does(Redo{});
  EXPECT_EQ(mSession.document().commandLines().back(), "cut.flip");
  expectSameAgain();
}

TEST_F(CommandLines, ADragIsOneLineThatSaysWhereItEnds) {
  for (double opacity : {0.9, 0.5, 0.25}) run(mSession, SetStructureOpacity{{mFirst}, opacity}, mProgress, true);
  auto lines = mSession.document().lastCommandLines();
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].ends_with(" 0.25")) << lines[0];
  expectSameAgain();
}

TEST_F(CommandLines, AreThereOfStepsThatCannotBeUndoneAnyMore) {
  for (int i = 0; i < int(Document::kMaxSteps) + 30; ++i)
    drags("Window", [i](scene::Scene& scene) { scene.volume.windowLevel = i + 0.5; });
  expectSameAgain();
}

TEST_F(CommandLines, WhatIsRefusedChangesNothingAndIsNotAmongThem) {
  scene::Scene before = mSession.scene();
  auto lines = mSession.document().commandLines();
  const Call kCalls[] = {Call(RemoveCut{}), Call(ShowStructures{{"nobody"}, false}), Call(SetField{"camera.eye", "4"}),
                         Call(SetField{"volume.source.path", "/nowhere/a.nrrd"}), Call(ChoosePreset{"loud"})};
  for (const Call& call : kCalls) EXPECT_THROW(run(mSession, call, mProgress), Error) << call.line();
  EXPECT_TRUE(mSession.scene() == before);
  EXPECT_EQ(mSession.document().commandLines(), lines);
}

/// That they do the same is a law of python/tests/again_test.py.
TEST(PythonLines, CommandsAreMethodsAndFieldsAreItems) {
  const std::pair<const char*, const char*> kRows[] = {
      {"# Drag", "# Drag"},
      {"open my head.nrrd", R"(s.open("my head.nrrd"))"},
      {"open spacing=1,1,2 a.raw", R"(s.open("a.raw", spacing=(1.0, 1.0, 2.0)))"},
      {"cut.add plane", "s.cut.add()"},
      {"cut.add box", R"(s.cut.add("box"))"},
      {"cut.add box \"a \\\"b\\\"\"", R"(s.cut.add("box", name="a \"b\""))"},
      {"view.from left", R"(s.view.from_("left"))"},
      {"look.import a.vp", R"(s.look.import_("a.vp"))"},
      {"structure.show \"aorta,left kidney\" false", R"(s.structure.show(["aorta", "left kidney"], visible=False))"},
      {"growth.grow [[12.0,-40.0,80.0]] 200,3000", "s.growth.grow([(12.0, -40.0, 80.0)], range=(200.0, 3000.0))"},
      {"set rayCast.mode mip", R"(s["rayCast.mode"] = "mip")"},
      {"set camera.eye 1,2.5,-3", R"(s["camera.eye"] = (1, 2.5, -3))"},
      {"set volume.bodyOnly true", R"(s["volume.bodyOnly"] = True)"},
      {"set cuts.0.membrane null", R"(s["cuts.0.membrane"] = None)"},
      {"set cuts.0.name \"42\"", R"(s["cuts.0.name"] = 42)"},
      {"set cuts.0.name 1e3", R"(s.set("cuts.0.name", "1e3"))"},
      {"set cuts [{\"id\":1}]", R"(s["cuts"] = [{"id": 1}])"},
      {"settle", "s.settle()"}};
  for (auto [line, python] : kRows)
    EXPECT_EQ(pythonProgram({line}), std::string("import velum\n\ns = velum.Session()\n") + python + "\n") << line;
  EXPECT_THROW(pythonProgram({"cut.ad"}), ArgumentError);
}

TEST(RenamedArguments, AreTakenByTheirOldNamesToo) {
  EXPECT_EQ(parseCall("growth.grow range=200,3000 seeds=[[1,2,3]]").line(), "growth.grow [[1.0,2.0,3.0]] 200,3000");
  EXPECT_EQ(parseCall("growth.grow seeds.0=1,2,3").line(), parseCall("growth.grow seed=1,2,3").line());
  EXPECT_THROW(parseCall("growth.grow grains=1,2,3"), ArgumentError);
}

TEST_F(CommandLines, AnErrorNamesTheLine) {
  Session other;
  try {
    runScript(other, "# first\n\nopen " + (mFolder / "a volume.nrrd").string() + "\ncut.remove\n", "script", mProgress,
              [](const Call&, const std::string&) {});
    ADD_FAILURE();
  } catch (const ArgumentError& error) {
    EXPECT_TRUE(std::string_view(error.what()).starts_with("script:4: there is no cut")) << error.what();
  }
}

}  // namespace
}  // namespace velum::session
