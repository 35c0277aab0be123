// The table of commands, their lines, and the journal of them that can be run again.
#include "velum/session/command/Command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <set>

#include "TempFolder.h"
#include "velum/core/Error.h"
#include "velum/io/labels/WriteLabels.h"
#include "velum/io/phantoms/Sample.h"
#include "velum/io/volumes/WriteVolume.h"
#include "velum/scene/json/Json.h"
#include "velum/session/Session.h"
#include "velum/session/command/CutCommands.h"
#include "velum/session/command/DocumentCommands.h"
#include "velum/session/command/ExtrusionCommands.h"
#include "velum/session/command/LookCommands.h"
#include "velum/session/command/StructureCommands.h"

namespace velum::session {
namespace {

TEST(Commands, EachHasANameAMeaningAndAnExampleThatIsALine) {
  std::set<std::string_view> names;
  for (const Command& command : commands()) {
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    EXPECT_TRUE(command.doc.ends_with('.')) << command.name;
    EXPECT_NE(bool(command.act), bool(command.change)) << command.name;
    EXPECT_EQ(bool(command.step), bool(command.change)) << command.name;
    for (const auto& row : command.arguments())
      EXPECT_TRUE(row.doc.ends_with('.') || row.doc.ends_with("...") || row.doc.ends_with("none"))
          << command.name << ": " << row.doc;
    Call call = parseCall(command.example);
    EXPECT_EQ(call.command().name, command.name);
    EXPECT_EQ(call.line(), command.example);
  }
}

TEST(Commands, ALineIsTheCallAgain) {
  ShowStructures show{{"left kidney", "12", "a,b"}, false};
  MakePicture picture{"12x8cm", "/tmp/a picture=x.png", 4, true, false, 300};
  OpenFile open;
  open.path = "/data/my head.raw";
  open.spacing = {1, 1, 2.5};
  open.raw.dims = {64, 64, 32};
  RenameCut rename{"Plane 1", "42"};
  for (const Call& call :
       {Call(show), Call(picture), Call(open), Call(rename), Call(SetField{"cuts.0.name", "a = \"b\""}),
        Call(AddCut{scene::CutShape::Box, ""}), Call(FlipCut{}), Call(SpareStructures{{"aorta"}, true, "cut 2"})}) {
    std::string line = call.line();
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(parseCall(line).line(), line);
  }
  auto again = std::any_cast<ShowStructures>(parseCall(Call(show).line()).arguments());
  EXPECT_EQ(again.structures, show.structures);
  EXPECT_FALSE(again.visible);
  auto openAgain = std::any_cast<OpenFile>(parseCall(Call(open).line()).arguments());
  EXPECT_EQ(openAgain, open);
  EXPECT_EQ(std::any_cast<RenameCut>(parseCall(Call(rename).line()).arguments()).name, "42");
}

TEST(Commands, WhatIsNoLineIsRefusedByName) {
  const std::pair<const char*, const char*> kRows[] = {{"structure.shwo a", "structure.show"},
                                                       {"structure.show a visible=7", "visible"},
                                                       {"structure.show a true more", "too many"},
                                                       {"structure.opacity a 7", "outside"},
                                                       {"cut.add cube", "not one of"},
                                                       {"structure.show \"a", "not closed"}};
  for (auto [line, word] : kRows) try {
      parseCall(line);
      ADD_FAILURE() << line;
    } catch (const ArgumentError& error) {
      EXPECT_NE(std::string_view(error.what()).find(word), std::string_view::npos) << error.what();
      EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
    }
}

TEST(Commands, TheTableInTheDocsIsThisOne) {
  std::filesystem::path path = std::filesystem::path(VELUM_SOURCE_DIR) / "docs" / "COMMANDS.md";
  std::ifstream in(path, std::ios::binary);
  std::string known((std::istreambuf_iterator<char>(in)), {});
  const std::string begin = "<!-- commands -->\n";
  std::size_t first = known.find(begin);
  ASSERT_NE(first, std::string::npos) << path << " has no line " << begin;
  std::string now = known.substr(0, first + begin.size()) + commandTable();
  if (known == now) return;
  std::string beside = path.string() + ".new";
  std::ofstream(beside, std::ios::binary) << now;
  FAIL() << "commands have changed; look at the difference, then accept it with\n  mv " << beside << " "
         << path.string();
}

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
