// Pictures of lit spheres that users bring.
#include "session/document/LitSphereFiles.h"

#include <gtest/gtest.h>

#include <fstream>

#include "TempFolder.h"
#include "core/Error.h"
#include "io/images/ImageFile.h"
#include "scene/LitSpheres.h"
#include "scene/json/Json.h"
#include "session/document/Open.h"

namespace velum::session {
namespace {

TEST(LitSphereFiles, OnesOwnIsSavedByItsPlaceAndReadAgain) {
  TempFolder folder;
  io::writeImage(scene::makeLitSphere("gold"), folder / "mine.png");
  scene::Scene scene;
  EXPECT_EQ(addLitSphere(scene, folder / "mine.png"), "mine");
  EXPECT_EQ(addLitSphere(scene, folder / "mine.png"), "mine") << "the same again";
  ASSERT_EQ(scene.finish.spheres.size(), 1u);
  scene.finish.sphere = "mine";
  std::string text = sceneTextFor(scene, folder / "scene.json");
  EXPECT_NE(text.find("\"mine.png\""), std::string::npos) << "beside the scene it is named by its name alone";
  scene::Scene again = scene::fromJson(text);
  EXPECT_TRUE(loadLitSpheres(again, folder.path()).empty());
  ASSERT_TRUE(again.finish.spheres[0].data);
  EXPECT_EQ(again.finish.spheres[0].data->pixels, scene.finish.spheres[0].data->pixels);
}

TEST(LitSphereFiles, NamesDoNotRepeat) {
  TempFolder folder;
  io::writeImage(scene::makeLitSphere("gold"), folder / "bone.png");
  scene::Scene scene;
  EXPECT_EQ(addLitSphere(scene, folder / "bone.png"), "bone 2") << "there is one of ours";
}

TEST(LitSphereFiles, WhatIsMissingOrBadIsOneLine) {
  TempFolder folder;
  std::ofstream(folder / "bad.png") << "no picture";
  scene::Scene scene;
  scene.finish.spheres.resize(2);
  scene.finish.spheres[0].name = "bad";
  scene.finish.spheres[0].source.path = "bad.png";
  scene.finish.spheres[1].name = "gone";
  scene.finish.spheres[1].source.path = "gone.png";
  scene.finish.sphere = "crayon";
  auto notes = loadLitSpheres(scene, folder.path());
  ASSERT_EQ(notes.size(), 3u);
  for (const auto& note : notes) EXPECT_EQ(note.find('\n'), std::string::npos) << note;
  EXPECT_FALSE(scene.finish.spheres[0].data);
  EXPECT_THROW(addLitSphere(scene, folder / "bad.png"), InputError);
  EXPECT_THROW(addLitSphere(scene, folder / "gone.png"), InputError);
}

}  // namespace
}  // namespace velum::session
