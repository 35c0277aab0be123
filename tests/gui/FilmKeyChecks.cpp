// What the keys of films do.
#include "KeysFixture.h"
#include "scene/timeline/Tracks.h"
#include "session/command/FilmCommands.h"

namespace velum::gui {

std::map<QString, Keys::Check> Keys::filmChecks() {
  std::map<QString, Check> all;
  auto goes = [](double from, double to) {
    return [from, to](Keys& keys, const Key& key) {
      for (double time : {1.0, 4.0})
        session::editKey(keys.document(), session::SetFilmKey{"lighting.specular", time, "1"});
      keys.mWindow->timeline().setShown(true);
      keys.document().setPlayhead(from);
      keys.press(key);
      EXPECT_EQ(keys.document().playhead(), to);
    };
  };
  all["film.start"] = goes(3.0, 0.0);
  all["film.previousKey"] = goes(3.0, 1.0);
  all["film.nextKey"] = goes(3.0, 4.0);
  all["film.timeline"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    EXPECT_TRUE(keys.mWindow->timeline().isShown());
    keys.press(key);
    EXPECT_FALSE(keys.mWindow->timeline().isShown());
  };
  all["film.record"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    EXPECT_TRUE(keys.document().isRecording());
    keys.press(key);
    EXPECT_FALSE(keys.document().isRecording());
  };
  all["film.keyCamera"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    const scene::Track* track = scene::findTrack(keys.scene().timeline, "camera");
    ASSERT_TRUE(track);
    EXPECT_EQ(track->keys.size(), 1u);
  };
  return all;
}

}  // namespace velum::gui
