#include "session/picture/PresetPictures.h"

#include <gtest/gtest.h>

#include <map>

#include "makeVolume.h"
#include "scene/Scene.h"

namespace velum::session {
namespace {

scene::Scene ball() {
  glm::ivec3 dims(40);
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(
      dims, SampleType::Int16, [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - 19.5) < 14 ? 800.0 : -1000.0; },
      centredFrame(dims)));
  return scene;
}

TEST(PresetPicturesGL, EachShowsTheDataInItsOwnColours) {
  std::map<std::string, Image> pictures;
  Progress progress;
  drawPresetPictures(
      ball(), {"ct-bone", "ct-skin"}, {48, 32},
      [&](const std::string& name, const Image& image) { pictures[name] = image; }, progress);
  ASSERT_EQ(pictures.size(), 2u);
  for (const auto& [name, image] : pictures) {
    EXPECT_EQ(image.width, 48);
    EXPECT_EQ(image.height, 32);
    const float* middle = &image.pixels[(16 * 48 + 24) * image.channels.size()];
    const float* corner = image.pixels.data();
    EXPECT_GT(middle[0] + middle[1] + middle[2], corner[0] + corner[1] + corner[2] + 0.5f) << name;
  }
  EXPECT_NE(pictures["ct-bone"].pixels, pictures["ct-skin"].pixels);
}

TEST(PresetPicturesGL, CanBeStopped) {
  Progress progress;
  int drawn = 0;
  EXPECT_THROW(drawPresetPictures(
                   ball(), {"ct-bone", "ct-skin"}, {48, 32},
                   [&](const std::string&, const Image&) {
                     ++drawn;
                     progress.cancel();
                   },
                   progress),
               Cancelled);
  EXPECT_EQ(drawn, 1);
}

}  // namespace
}  // namespace velum::session
