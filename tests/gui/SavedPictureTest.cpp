// What is proposed for a picture, and what is remembered of a file.
#include "WindowFixture.h"

#include <QDateTime>
#include <QFileInfo>
#include <QTimer>

#include "gui/kit/Preferences.h"
#include "gui/service/RecentFiles.h"
#include "gui/service/Thumbnail.h"
#include "gui/window/SavePictureDialog.h"
#include "session/document/Recent.h"

namespace velum::gui {
namespace {

class SavedPicture : public Window {
 protected:
  /// The size with which the dialog comes up. @param accepted  the picture is then made: 0: of this size
  glm::ivec2 proposedSize() {
    glm::ivec2 size{0};
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
      auto* dialog = qobject_cast<SavePictureDialog*>(QApplication::activeModalWidget());
      if (!dialog) return;
      size = dialog->options().size;
      dialog->reject();
    });
    timer.start(20);
    mWindow->actions().find("file.savePicture")->trigger();
    return size;
  }
};

TEST_F(SavedPicture, IsAsLargeAsASlideOrAsTheLastOne) {
  openPhantom();
  Preferences().setValue("picture/size", {});
  EXPECT_EQ(proposedSize(), glm::ivec2(1920, 1080));
  Preferences().setValue("picture/size", QSize(900, 1200));
  EXPECT_EQ(proposedSize(), glm::ivec2(900, 1200));
  Preferences().setValue("picture/size", {});
}

TEST_F(SavedPicture, OfARecentFileShowsTheFileAndNoCutsThatWereNeverSaved) {
  openPhantom();
  drawSoon();
  ASSERT_TRUE(settle());
  std::string file = path("phantom.nrrd").toStdString();
  auto pictureOf = [&] { return bytesOf(QString::fromStdString(session::recentPicture(file).string())); };
  QByteArray before = pictureOf();
  ASSERT_FALSE(before.isEmpty());
  mWindow->actions().find("cut.addPlane")->trigger();
  ASSERT_TRUE(settle());
  mWindow->newScene();
  EXPECT_EQ(pictureOf(), before);
}

TEST_F(SavedPicture, OfASceneIsWhereFileManagersLookForIt) {
  openPhantom();
  ASSERT_TRUE(settle());
  QString scene = path("a scene \u00e4.json");
  for (int i = 0; i < 2; ++i) {  // also when it is saved again
    mWindow->saveSceneTo(scene);
    for (int size : {128, 256}) {
      QString file = QString::fromStdString(thumbnailOf(scene.toStdString(), size).string());
      QImage picture(file);
      ASSERT_EQ(std::max(picture.width(), picture.height()), size) << file.toStdString();
      EXPECT_TRUE(picture.text("Thumb::URI").startsWith("file:///")) << picture.text("Thumb::URI").toStdString();
      EXPECT_TRUE(picture.text("Thumb::URI").endsWith("/a%20scene%20%C3%A4.json"));
      EXPECT_EQ(picture.text("Thumb::MTime").toLongLong(), QFileInfo(scene).lastModified().toSecsSinceEpoch());
      EXPECT_EQ(QFile::permissions(file) & (QFile::ReadGroup | QFile::ReadOther), QFile::Permissions());
    }
    QTest::qWait(1100);
  }
  QString phantom = QString::fromStdString(thumbnailOf(path("phantom.nrrd").toStdString(), 256).string());
  EXPECT_FALSE(QFileInfo::exists(phantom));
}

}  // namespace
}  // namespace velum::gui
