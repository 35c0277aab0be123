#include "session/document/Document.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

namespace velum::session {

namespace {

auto moveCut(double y) {
  return [y](scene::Scene& scene) {
    if (scene.cuts.empty()) scene.cuts.emplace_back();
    scene.cuts[0].centre.y = y;
  };
}

auto moveEye(double x) {
  return [x](scene::Scene& scene) { scene.camera.eye.x = x; };
}

}  // namespace

TEST(Document, HundredMergedEditsAreOneStep) {
  Document document;
  for (int i = 1; i <= 100; ++i) document.edit("Move cut", moveCut(i), true);
  EXPECT_EQ(document.scene().cuts[0].centre.y, 100.0);
  document.undo();
  EXPECT_EQ(document.scene(), scene::Scene());
  EXPECT_FALSE(document.canUndo());
}

TEST(Document, MergingStopsAtTheEndOfADragAndAtAnotherEdit) {
  Document document;
  document.edit("Move cut", moveCut(1), true);
  document.endMerge();
  document.edit("Move cut", moveCut(2), true);
  document.edit("Preset", [](scene::Scene& scene) { scene.volume.transfer.preset = "ct-bone"; });
  document.edit("Move cut", moveCut(3), true);
  document.undo();
  EXPECT_EQ(document.scene().cuts[0].centre.y, 2.0);
  EXPECT_EQ(document.undoLabel(), "Preset");
  document.undo();
  document.undo();
  EXPECT_EQ(document.scene().cuts[0].centre.y, 1.0);
}

TEST(Document, ADragThatComesBackLeavesNoStepAndIsNoModification) {
  Document document;
  document.edit("Move cut", moveCut(1));
  document.markSaved();
  for (double place : {2.0, 3.0, 1.0}) document.edit("Drag cut", moveCut(place), true);
  EXPECT_EQ(document.undoLabels(), std::vector<std::string>{"Move cut"});
  EXPECT_FALSE(document.isModified());
  document.edit("Drag cut", moveCut(5), true);
  EXPECT_EQ(document.undoLabel(), "Drag cut") << "and goes on as a step";
  EXPECT_TRUE(document.isModified());
}

TEST(Document, MergingEditsOfDifferentLabelsAreStepsOfTheirOwn) {
  // Two sliders that are dragged one after the other, nobody having said that the first has been let go.
  Document document;
  auto setLevel = [](double level) { return [level](scene::Scene& scene) { scene.volume.windowLevel = level; }; };
  document.edit("Move cut", moveCut(1), true);
  document.edit("Move cut", moveCut(2), true);
  document.edit("Change window", setLevel(10), true);
  document.edit("Change window", setLevel(20), true);
  document.edit("Move cut", moveCut(3), true);
  ASSERT_EQ(document.undoLabels(), (std::vector<std::string>{"Move cut", "Change window", "Move cut"}));
  document.undo();
  EXPECT_EQ(document.scene().cuts[0].centre.y, 2.0);
  EXPECT_EQ(document.scene().volume.windowLevel, 20.0);
  document.undo();
  EXPECT_EQ(document.scene().volume.windowLevel, 0.0);
  EXPECT_EQ(document.scene().cuts[0].centre.y, 2.0);
  document.redo();
  EXPECT_EQ(document.scene().volume.windowLevel, 20.0);
}

TEST(Document, AMergingEditJoinsNeitherOneThatDoesNotMergeNorAView) {
  Document document;
  document.edit("Move cut", moveCut(1));
  document.edit("Move cut", moveCut(2), true);
  ASSERT_EQ(document.undoLabels().size(), 2u) << "the first was whole";
  document.view(moveEye(5));
  document.edit("Move cut", moveCut(3), true);
  ASSERT_EQ(document.undoLabels(), (std::vector<std::string>{"Move cut", "Move view", "Move cut", "Move cut"}));
  document.undo();
  document.edit("Move cut", moveCut(4), true);
  document.undo();
  EXPECT_EQ(document.scene().cuts[0].centre.y, 2.0) << "after an undo a drag begins anew";
  document.edit("Move cut", moveCut(5), true);
  double eye = document.scene().camera.eye.x;
  document.view(moveEye(eye + 1));
  document.view(moveEye(eye));
  document.edit("Move cut", moveCut(6), true);
  document.undo();
  EXPECT_EQ(document.scene().cuts[0].centre.y, 5.0) << "after a look around, too";
}

TEST(Document, FailingEditLeavesTheSceneUnchanged) {
  Document document;
  document.edit("Move cut", moveCut(1));
  scene::Scene before = document.scene();
  EXPECT_THROW(document.edit("Fail",
                             [](scene::Scene& scene) {
                               scene.cuts.clear();
                               throw std::runtime_error("no");
                             }),
               std::runtime_error);
  EXPECT_EQ(document.scene(), before);
  EXPECT_EQ(document.undoLabel(), "Move cut");
}

TEST(Document, EqualEditAddsNothing) {
  Document document;
  int calls = 0;
  document.setListener([&] { ++calls; });
  document.edit("Nothing", [](scene::Scene&) {});
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(calls, 0);
}

TEST(Document, EditClearsRedo) {
  Document document;
  document.edit("A", moveCut(1));
  document.undo();
  EXPECT_EQ(document.redoLabel(), "A");
  document.edit("B", moveCut(2));
  EXPECT_FALSE(document.canRedo());
}

TEST(Document, RedoRestoresWhatUndoTook) {
  Document document;
  document.edit("A", moveCut(1));
  document.edit("B", moveCut(2));
  scene::Scene after = document.scene();
  document.undo();
  document.undo();
  document.redo();
  document.redo();
  EXPECT_EQ(document.scene(), after);
  EXPECT_EQ(document.undoLabel(), "B");
}

TEST(Document, ViewMovesAreOneStepHoweverManyDrags) {
  Document document;
  document.edit("Add cut", moveCut(1));
  scene::Camera before = document.scene().camera;
  for (int i = 1; i <= 50; ++i) {
    document.view(moveEye(i));
    document.endMerge();
  }
  document.view([](scene::Scene& scene) { scene.sections.crosshair.z = 3; });
  EXPECT_EQ(document.undoLabels(), (std::vector<std::string>{"Move view", "Add cut"}));
  document.undo();
  EXPECT_EQ(document.scene().camera, before);
  EXPECT_EQ(document.scene().sections.crosshair.z, 0);
  EXPECT_EQ(document.scene().cuts.size(), 1u);
  document.undo();
  EXPECT_TRUE(document.scene().cuts.empty());
  document.redo();
  document.redo();
  EXPECT_EQ(document.scene().camera.eye.x, 50.0);
}

TEST(Document, UndoOfAnEditKeepsTheViewBeforeIt) {
  Document document;
  document.view(moveEye(1));
  document.edit("A", moveCut(1));
  document.view(moveEye(2));
  document.edit("B", moveCut(2));
  EXPECT_EQ(document.undoLabels(), (std::vector<std::string>{"B", "Move view", "A", "Move view"}));
  document.undo();
  EXPECT_EQ(document.scene().camera.eye.x, 2.0);
  EXPECT_EQ(document.scene().cuts[0].centre.y, 1.0);
}

TEST(Document, AViewThatComesBackLeavesNoStep) {
  Document document;
  double start = document.scene().camera.eye.x;
  document.view(moveEye(7));
  document.view(moveEye(start));
  EXPECT_FALSE(document.canUndo());
}

TEST(Document, LookingAroundKeepsWhatCanBeRedone) {
  Document document;
  document.edit("A", moveCut(1));
  document.edit("B", moveCut(2));
  document.undo();
  document.undo();
  document.view(moveEye(9));
  EXPECT_EQ(document.redoLabels(), (std::vector<std::string>{"A", "B"}));
  document.redo();
  document.redo();
  EXPECT_EQ(document.scene().cuts[0].centre.y, 2.0);
  EXPECT_EQ(document.scene().camera.eye.x, 9.0);
  for (int i = 0; i < 3; ++i) document.undo();
  EXPECT_EQ(document.scene(), scene::Scene());
}

TEST(Document, AnotherViewReplacesTheOneThatWasTakenBack) {
  Document document;
  document.view(moveEye(1));
  document.edit("A", moveCut(1));
  document.undo();
  document.undo();
  document.view(moveEye(5));
  EXPECT_EQ(document.redoLabels(), std::vector<std::string>{"A"});
  document.redo();
  EXPECT_EQ(document.scene().camera.eye.x, 5.0);
}

TEST(Document, OnlyEditsCountAsModified) {
  Document document;
  document.view(moveEye(1));
  EXPECT_FALSE(document.isModified());
  document.undo();
  EXPECT_FALSE(document.isModified());
  document.edit("A", moveCut(1));
  EXPECT_TRUE(document.isModified());
  document.markSaved();
  document.view(moveEye(2));
  EXPECT_FALSE(document.isModified());
  document.undo();
  document.undo();
  EXPECT_TRUE(document.isModified());
  document.redo();
  EXPECT_FALSE(document.isModified());
  document.markModified();
  EXPECT_TRUE(document.isModified());
}

TEST(Document, WhatIsSavedAfterUndoIsWhatIsSaved) {
  Document document;
  document.edit("A", moveCut(1));
  document.edit("B", moveCut(2));
  document.undo();
  document.markSaved();
  EXPECT_FALSE(document.isModified());
  document.redo();
  EXPECT_TRUE(document.isModified());
  document.undo();
  EXPECT_FALSE(document.isModified());
}

TEST(Document, WhatWasSavedInTheMiddleOfADragCanBeComeBackTo) {
  Document document;
  document.edit("Move cut", moveCut(1), true);
  document.markSaved();
  document.edit("Move cut", moveCut(2), true);
  EXPECT_TRUE(document.isModified());
  document.undo();
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(document.scene().cuts[0].centre.y, 1.0);
}

TEST(Document, EveryChangeHasAnotherNumber) {
  Document document;
  std::uint64_t last = document.changeCount();
  auto hasMoved = [&] { return std::exchange(last, document.changeCount()) != document.changeCount(); };
  document.edit("A", moveCut(1));
  EXPECT_TRUE(hasMoved());
  document.view(moveEye(1));
  EXPECT_TRUE(hasMoved());
  document.undo();
  EXPECT_TRUE(hasMoved());
  document.edit("Nothing", [](scene::Scene&) {});
  EXPECT_FALSE(hasMoved());
}

TEST(Document, HistoryIsBounded) {
  Document document;
  for (std::size_t i = 1; i <= Document::kMaxSteps + 50; ++i) document.edit("Move cut", moveCut(double(i)));
  EXPECT_EQ(document.undoLabels().size(), Document::kMaxSteps);
}

TEST(Document, ReplaceForgetsTheHistory) {
  Document document;
  document.edit("A", moveCut(1));
  document.replace({});
  EXPECT_FALSE(document.canUndo() || document.isModified());
}

TEST(Document, RestoreBringsBackAFullHistory) {
  Document document;
  for (std::size_t i = 0; i <= Document::kMaxSteps; ++i) document.edit("Move cut", moveCut(double(i)));
  document.undo();
  Document before = document;
  document.replace({});
  document.restore(before);
  EXPECT_EQ(document.commandLines(), before.commandLines());
  EXPECT_EQ(document.redoLabels(), before.redoLabels());
  EXPECT_NE(document.changeCount(), before.changeCount());
}

}  // namespace velum::session
