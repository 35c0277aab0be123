// A picture of paper that a user brings.
#include "session/document/PaperFile.h"

#include <gtest/gtest.h>

#include <fstream>

#include "TempFolder.h"
#include "core/Error.h"
#include "io/images/ImageFile.h"
#include "scene/Finishes.h"
#include "scene/LitSpheres.h"
#include "scene/json/Json.h"
#include "session/document/Open.h"

namespace velum::session {
namespace {

TEST(PaperFile, ItIsSavedByItsPlaceAndReadAgain) {
  TempFolder folder;
  io::writeImage(scene::makeLitSphere("gold"), folder / "mine.png");
  scene::Scene scene;
  takePaper(scene, folder / "mine.png");
  EXPECT_EQ(scene.finish.paper, scene::Paper::Own);
  std::string text = sceneTextFor(scene, folder / "scene.json");
  EXPECT_NE(text.find("\"mine.png\""), std::string::npos) << "beside the scene it is named by its name alone";
  scene::Scene again = scene::fromJson(text);
  EXPECT_FALSE(loadPaper(again, folder.path()));
  ASSERT_TRUE(again.finish.ownPaper.data);
  EXPECT_EQ(again.finish.ownPaper.data->pixels, scene.finish.ownPaper.data->pixels);
  EXPECT_EQ(again.finish.ownPaper.source, scene.finish.ownPaper.source);
}

TEST(PaperFile, AFinishByNameLeavesIt) {
  TempFolder folder;
  io::writeImage(scene::makeLitSphere("gold"), folder / "mine.png");
  scene::Scene scene;
  takePaper(scene, folder / "mine.png");
  scene::applyFinish(scene, "pencil");
  EXPECT_EQ(scene::finishName(scene), "pencil");
  EXPECT_TRUE(scene.finish.ownPaper.data) << "to be chosen again";
}

TEST(PaperFile, WhatIsMissingOrBadIsOneLine) {
  TempFolder folder;
  std::ofstream(folder / "bad.png") << "no picture";
  scene::Scene scene;
  EXPECT_THROW(takePaper(scene, folder / "bad.png"), InputError);
  EXPECT_THROW(takePaper(scene, folder / "gone.png"), InputError);
  EXPECT_EQ(scene, scene::Scene()) << "nothing has changed";
  EXPECT_FALSE(loadPaper(scene, folder.path())) << "none is named";
  for (const char* name : {"bad.png", "gone.png", ""}) {
    scene.finish.paper = scene::Paper::Own;
    scene.finish.ownPaper.source.path = name;
    auto note = loadPaper(scene, folder.path());
    ASSERT_TRUE(note) << name;
    EXPECT_EQ(note->find('\n'), std::string::npos) << *note;
    EXPECT_FALSE(scene.finish.ownPaper.data);
  }
}

}  // namespace
}  // namespace velum::session
