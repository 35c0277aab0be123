// Titles as keys of a caption's opacity.
#include <gtest/gtest.h>

#include "core/Error.h"
#include "scene/Scene.h"
#include "scene/timeline/SceneAt.h"
#include "session/film/ReadyFilms.h"

namespace velum::session {
namespace {

TEST(ReadyTitle, ATitleComesAndGoesInItsTime) {
  scene::Scene scene;
  addTitle(scene, {2.0, 4.0}, "The heart", 1.0, scene::CaptionPlace::Top);
  EXPECT_EQ(scene.timeline.duration, 6.0);
  auto opacityAt = [&](double time) { return scene::sceneAt(scene, time).lettering.captions.at(0).opacity; };
  for (double time : {0.0, 2.0, 6.0, 9.0}) EXPECT_EQ(opacityAt(time), 0.0) << time;
  for (double time : {3.0, 4.0, 5.0}) EXPECT_EQ(opacityAt(time), 1.0) << time;
  for (double time : {2.5, 5.5}) EXPECT_NEAR(opacityAt(time), 0.5, 1e-9) << time;
  // One that does not fade is there at once; one that fades longer than it lasts is whole in its middle.
  addTitle(scene, {6.0, 2.0}, "At once", 0.0, scene::CaptionPlace::Top);
  addTitle(scene, {8.0, 2.0}, "Short", 5.0, scene::CaptionPlace::Top);
  auto captionAt = [&](double time, std::size_t i) {
    return scene::sceneAt(scene, time).lettering.captions.at(i).opacity;
  };
  EXPECT_EQ(captionAt(5.99, 1), 0.0);
  EXPECT_EQ(captionAt(6.0, 1), 1.0);
  EXPECT_EQ(captionAt(7.99, 1), 1.0);
  EXPECT_EQ(captionAt(8.0, 1), 0.0);
  EXPECT_EQ(captionAt(9.0, 2), 1.0);
  EXPECT_TRUE(scene::tracksThatDoNotFit(scene).empty());
  EXPECT_THROW(addTitle(scene, {}, " ", 0.5, scene::CaptionPlace::Top), ArgumentError);
}

}  // namespace
}  // namespace velum::session
