#include "velum/session/Document.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace velum::session {

namespace {

auto moveCut(double y) {
  return [y](scene::Scene& scene) {
    if (scene.cuts.empty()) scene.cuts.emplace_back();
    scene.cuts[0].centreMm.y = y;
  };
}

}  // namespace

TEST(Document, HundredMergedEditsAreOneStep) {
  Document document;
  for (int i = 1; i <= 100; ++i) document.edit("Move cut", moveCut(i), true);
  EXPECT_EQ(document.scene().cuts[0].centreMm.y, 100.0);
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
  EXPECT_EQ(document.scene().cuts[0].centreMm.y, 2.0);
  EXPECT_EQ(document.undoLabel(), "Preset");
  document.undo();
  document.undo();
  EXPECT_EQ(document.scene().cuts[0].centreMm.y, 1.0);
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

TEST(Document, AmendmentOutlivesUndo) {
  Document document;
  document.edit("A", moveCut(1));
  document.amend([](scene::Scene& scene) { scene.camera.eyeMm.x = 7.0; });
  EXPECT_EQ(document.undoLabel(), "A");
  document.undo();
  EXPECT_TRUE(document.scene().cuts.empty());
  EXPECT_EQ(document.scene().camera.eyeMm.x, 7.0);
}

TEST(Document, HistoryIsBounded) {
  Document document;
  for (std::size_t i = 1; i <= Document::kMaxSteps + 50; ++i) document.edit("Move cut", moveCut(double(i)));
  std::size_t steps = 0;
  for (; document.canUndo(); ++steps) document.undo();
  EXPECT_EQ(steps, Document::kMaxSteps);
}

TEST(Document, ReplaceForgetsTheHistory) {
  Document document;
  document.edit("A", moveCut(1));
  document.replace({});
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.isModified());
}

}  // namespace velum::session
