// Tracks of films from outside.
#include "scene/timeline/Tracks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/Scene.h"

namespace velum::scene {
namespace {

TEST(Tracks, TracksOfOneFieldBecomeOneWithTheKeysOfBoth) {
  Scene scene;
  addCut(scene, {});
  scene.cuts[0].name = "Front";
  auto key = [](double time, double x) { return Key{time, {fmt::format("[{},0,0]", x)}, Ease::Linear}; };
  // One field by three names.
  scene.timeline.tracks = {{"cuts.0.centre", true, {key(0, 1), key(4, 5)}},
                           {"camera.fieldOfViewDeg", true, {{0.0, {"20"}}}},
                           {"cuts[#1].centre", false, {key(2, 9), key(4, 7)}},
                           {"cuts[Front].centre", true, {key(4, 5), key(6, 6)}}};
  Scene back = scene;
  std::vector<std::string> notes = joinTracks(back);
  ASSERT_EQ(back.timeline.tracks.size(), 2u);
  const Track& track = back.timeline.tracks[0];
  EXPECT_EQ(track.path, "cuts[#1].centre");
  EXPECT_TRUE(track.enabled);
  EXPECT_EQ(track.keys, (std::vector<Key>{key(0, 1), key(2, 9), key(4, 5), key(6, 6)}));
  ASSERT_EQ(notes.size(), 2u) << "a line for each that was joined";
  EXPECT_NE(notes[0].find("cuts[#1].centre has two tracks"), notes[0].npos) << notes[0];
  EXPECT_NE(notes[0].find("left out: 1"), notes[0].npos) << notes[0];
  EXPECT_EQ(notes[1].find("left out"), notes[1].npos) << "the keys at 4 s are alike: " << notes[1];
  Scene again = back;
  EXPECT_TRUE(joinTracks(again).empty()) << "what was joined is one from then on";
  EXPECT_EQ(again, back);
}

}  // namespace
}  // namespace velum::scene
