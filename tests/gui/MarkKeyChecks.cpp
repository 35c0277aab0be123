// What the keys of marks do.
#include "KeysFixture.h"

namespace velum::gui {

std::map<QString, Keys::Check> Keys::markChecks() {
  std::map<QString, Check> all;
  auto takesUp = [](const char* id, std::size_t clicks, scene::MarkKind kind) {
    return [=](Keys& keys, const Key& key) {
      keys.mWindow->views().setLayout(scene::Layout::Volume);
      ASSERT_TRUE(keys.settle());
      keys.press(key);
      EXPECT_TRUE(keys.mWindow->actions().find(id)->isChecked());
      for (std::size_t i = 0; i < clicks; ++i) keys.clickMiddle();
      if (clicks > 0) {
        ASSERT_EQ(keys.scene().lettering.marks.size(), 1u);
        EXPECT_EQ(keys.scene().lettering.marks[0].kind, kind);
      }
      keys.press(key);
      EXPECT_FALSE(keys.mWindow->toolbox().active()) << "again lays it down";
    };
  };
  all["mark.distance"] = takesUp("mark.distance", 2, scene::MarkKind::Distance);
  all["mark.angle"] = takesUp("mark.angle", 3, scene::MarkKind::Angle);
  all["mark.name"] = takesUp("mark.name", 0, scene::MarkKind::Name);
  all["mark.label"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    ASSERT_TRUE(keys.mWindow->toolbox().active());
    keys.press(key);
    EXPECT_FALSE(keys.mWindow->toolbox().active()) << "again lays it down";
  };
  return all;
}

}  // namespace velum::gui
