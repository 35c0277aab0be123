#include "session/picture/Picture.h"

#include <gtest/gtest.h>

#include "TempFolder.h"
#include "core/Error.h"
#include "io/images/ImageFile.h"
#include "makeVolume.h"
#include "session/document/Open.h"

namespace velum::session {
namespace {

TEST(PictureSize, IsPixelsOrPaperAtAResolution) {
  EXPECT_EQ(parsePictureSize("1280x720", 0), glm::ivec2(1280, 720));
  EXPECT_EQ(parsePictureSize("1280x720px", 72), glm::ivec2(1280, 720));
  EXPECT_EQ(parsePictureSize("2.54x5.08cm", 100), glm::ivec2(100, 200));
  EXPECT_EQ(parsePictureSize("25.4x50.8mm", 100), glm::ivec2(100, 200));
  EXPECT_EQ(parsePictureSize("2x1in", 0), glm::ivec2(600, 300));
}

TEST(PictureSize, WhatIsNoneIsRefused) {
  for (const char* text :
       {"", "12", "12x", "12x8km", "0x8", "-1x5", "1280.5x720", "1e9x1", "nanx5", "12x8cmm", "99999x9", "12x8cm extra"})
    EXPECT_THROW(parsePictureSize(text, 300), ArgumentError) << text;
}

TEST(PictureCommand, QuotesWhatAShellWouldTakeApart) {
  PictureOptions options{{100, 50}, 4, true, false, 300};
  EXPECT_EQ(
      pictureCommand("/data/my scene's.json", options, "out.png"),
      "velum-batch render '/data/my scene'\\''s.json' -o out.png --size 100x50 --samples 4 --dpi 300 --transparent");
}

TEST(Picture, EveryFormatOpensAsItsScene) {
  TempFolder folder;
  Progress progress;
  scene::Scene scene = openSample("two-spheres", 16, folder.path(), progress);
  scene.cuts.emplace_back().name = "the cut";
  Image image{2, 2, {"R", "G", "B", "A"}, std::vector<float>(16, 0.5f)};
  for (const char* name : {"a.png", "a.exr", "a.tif"}) {
    savePicture(image, scene, {{2, 2}, 1, false, false, 300}, folder / name);
    scene::Source source;
    source.path = (folder / name).string();
    scene::Scene back = open(source, progress);
    ASSERT_EQ(back.cuts.size(), 1u) << name;
    EXPECT_EQ(back.cuts[0].name, "the cut") << name;
    EXPECT_TRUE(back.volume.data) << name;
  }
}

TEST(Picture, OfASectionHasTheColoursOfItsStructures) {
  Progress progress;
  scene::Scene scene;
  glm::ivec3 dims(12);
  scene.volume.data = Shared<Volume>(makeVolume(dims, SampleType::UInt8, [](glm::ivec3) { return 100.0; }));
  scene.labels.data = Shared<LabelVolume>(makeLabels(dims, [](glm::ivec3) { return 1; }));
  scene.sections.labelOpacity = 1.0;
  for (glm::vec3 color : {glm::vec3(1.0f, 0.5f, 0.0f), glm::vec3(0.0f, 0.25f, 1.0f)}) {
    scene.labels.structures = {{1, "all"}};
    scene.labels.structures[0].color = color;
    Image image = drawSectionPicture(scene, scene::SectionKind::Axial, {{40, 40}, 1, false, false, 300}, progress);
    ASSERT_EQ(image.channels, (std::vector<std::string>{"R", "G", "B", "A"}));
    const float* middle = &image.pixels[(20 * 40 + 20) * 4];
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(middle[c], color[c], 0.02f) << c;
    EXPECT_EQ(middle[3], 1.0f);
  }
}

TEST(Picture, ATiffWithoutASceneIsAVolume) {
  TempFolder folder;
  Progress progress;
  Image image{4, 4, {"R", "G", "B"}, std::vector<float>(48, 0.5f)};
  image.pixels[0] = 1.0f;
  io::writeImage(image, folder / "plain.tif");
  scene::Source source;
  source.path = (folder / "plain.tif").string();
  EXPECT_TRUE(open(source, progress).volume.data);
}

}  // namespace
}  // namespace velum::session
