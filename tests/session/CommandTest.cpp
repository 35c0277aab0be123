// The table of commands, and their lines.
#include "session/command/Command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "core/Error.h"
#include "scene/Presets.h"
#include "session/command/CutCommands.h"
#include "session/command/DocumentCommands.h"
#include "session/command/StructureCommands.h"
#include "session/cut/CutEdit.h"
#include "session/document/Document.h"
#include "session/extrusion/Extrusion.h"

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

TEST(Commands, AStructureIsFoundAgainWhateverOthersAreCalled) {
  scene::Scene scene;
  scene.labels.structures = {{.id = 1, .name = "2"},     {.id = 2, .name = ""},   {.id = 3, .name = "twice"},
                             {.id = 4, .name = "twice"}, {.id = 5, .name = "#7"}, {.id = 6, .name = "a, b\n "},
                             {.id = 7, .name = "five"}};
  for (const auto& structure : scene.labels.structures) {
    auto names = structureNames(scene, {structure.id});
    EXPECT_EQ(structureIds(scene, names), std::vector<int>{structure.id}) << names[0];
    std::string line = Call(ShowStructures{names, false}).line();
    EXPECT_EQ(line.find('\n'), std::string::npos);
    auto again = std::any_cast<ShowStructures>(parseCall(line).arguments());
    EXPECT_EQ(structureIds(scene, again.structures), std::vector<int>{structure.id}) << line;
  }
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

/// A scene on which the examples of commands mean something. @param shape  of its only cut; everywhere: a plane and
/// another cut
scene::Scene exampleScene(scene::CutShape shape) {
  bool isAlone = shape != scene::CutShape::Everywhere;
  if (!isAlone) shape = scene::CutShape::Plane;
  scene::Scene scene;
  Volume volume;
  volume.dims = {40, 60, 90};
  volume.unit = "HU";
  volume.type = SampleType::Int16;
  volume.voxels.resize(timeStepBytes(volume));
  auto* values = reinterpret_cast<std::int16_t*>(volume.voxels.data());
  for (std::size_t i = 0; i < voxelCount(volume); ++i) values[i] = std::int16_t(i % 40 < 20 ? 500 + i % 7 : i % 5);
  volume.worldFromVoxel[3] = {0, -60, 0, 1};
  computeRange(volume);
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene::applyPreset(scene, "ct-skin");
  int id = 0;
  for (const char* name : {"aorta", "heart", "skin", "femur", "left kidney"})
    scene.labels.structures.push_back({.id = ++id, .name = name});
  scene.labels.structures.push_back({.id = 12, .name = "twelfth"});
  scene.labels.structures.push_back({.id = 13, .name = "structure 1"});
  scene::Growth step;
  step.structure = 13;
  step.low = 400, step.high = 600;
  step.distance = 5;
  step.seeds = {{3, -50, 20}};
  scene.labels.growths = {step};
  scene.lettering.captions = {{.text = "Words"}};
  scene.lettering.marks = {{.kind = scene::MarkKind::Label, .points = {{3, -50, 20}}, .text = "Here"}};
  scene.timeline.tracks = {{"camera.fieldOfViewDeg", true, {{0.0, {"20"}}, {2.5, {"30"}}}}};
  scene::Cut cut;
  cut.shape = shape;
  cut.name = "Plane 1";
  cut.axis = {0, 0, 1};
  cut.centre = {20, -30, 45};
  cut.size = {40, 60, 20};
  scene::addCut(scene, cut);
  scene::completeItems(scene);
  setSpared(scene.cuts[0], 1, false);
  setExtrusion(scene.cuts[0], 1, 6.0);
  setExtrusion(scene.cuts[0], 13, 30.0);
  if (scene.cuts[0].membrane) scene.cuts[0].membrane->field.byValue = {{400, 100}, {600, 100}};
  cut.shape = scene::CutShape::Box;
  cut.name = "Box";
  if (!isAlone) scene.cuts.insert(scene.cuts.begin(), cut);
  scene::completeItems(scene);
  return scene;
}

TEST(Commands, AChannelIsShownAloneThenAllAgainAndHasAColour) {
  Document document;
  scene::Scene scene = exampleScene(scene::CutShape::Plane);
  scene.volume.channels.resize(3);
  document.replace(scene);
  auto visible = [&] {
    std::vector<bool> all;
    for (const auto& look : document.scene().volume.channels) all.push_back(look.visible);
    return all;
  };
  edit(document, parseCall("look.channelAlone 1"));
  EXPECT_EQ(visible(), (std::vector<bool>{false, true, false}));
  edit(document, parseCall("look.channelAlone 1"));
  EXPECT_EQ(visible(), (std::vector<bool>{true, true, true}));
  edit(document, parseCall("look.channelColor 2 0.25,0.5,1"));
  EXPECT_EQ(document.scene().volume.channels[2].color, glm::vec3(0.25f, 0.5f, 1.0f));
  EXPECT_THROW(edit(document, parseCall("look.channelAlone 3")), ArgumentError);
  EXPECT_THROW(edit(document, parseCall("look.channelColor 3 1,1,1")), ArgumentError);
}

TEST(Commands, EachEditIsOneStepThatUndoTakesBackAndRedoBringsAgain) {
  const std::set<std::string_view> kOfModels{
      "look.model",          "model.show",        "model.color",    "model.paletteColor", "model.reset",
      "model.ghosts",        "model.target",      "model.leave",    "model.leaveBy",      "model.keepInView",
      "model.showUnthinned", "model.solo",        "model.protect",  "model.meetTargets",  "model.letSee",
      "model.leaveAsAbove",  "model.bringToSize", "model.setDrawn", "model.letFollow",    "model.rename",
      "model.listInLegend"};
  const std::set<std::string_view> kOfChannels{"look.channelAlone", "look.channelColor"};
  const std::set<std::string_view> kOfOtherData{"film.equalize", "film.fly", "film.time", "mark.follow"};
  int done = 0;
  for (const Command& command : commands()) {
    if (!command.change || kOfModels.count(command.name) || kOfChannels.count(command.name)) continue;
    if (kOfOtherData.count(command.name)) continue;
    if (command.name == "look.import") continue;
    std::string why;
    bool isDone = false;
    for (auto shape : {scene::CutShape::Plane, scene::CutShape::Membrane, scene::CutShape::Everywhere}) {
      Document document;
      document.replace(exampleScene(shape));
      scene::Scene before = document.scene();
      try {
        edit(document, parseCall(command.example));
      } catch (const Error& error) {
        why = error.what();
        EXPECT_TRUE(document.scene() == before) << command.name;
        continue;
      }
      if (document.scene() == before) continue;
      isDone = true;
      scene::Scene after = document.scene();
      ASSERT_EQ(document.undoLabels().size(), 1u) << command.name;
      EXPECT_EQ(document.isModified(), !command.isView) << command.name;
      std::vector<std::string> line{std::string(command.example)};
      EXPECT_TRUE(command.isView || document.lastCommandLines() == line) << command.name;
      document.undo();
      EXPECT_TRUE(document.scene() == before) << command.name;
      document.redo();
      EXPECT_TRUE(document.scene() == after) << command.name;
    }
    EXPECT_TRUE(isDone) << command.name << " changed nothing: " << why;
    ++done;
  }
  EXPECT_GT(done, 35);
}

}  // namespace
}  // namespace velum::session
