// The dialog that asks for a picture, the command finder and the guide: without the main window.
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QProcess>
#include <QTest>
#include <QTextBlock>
#include <future>

#include "RunBatch.h"
#include "Shots.h"
#include "TempFolder.h"
#include "gui/window/CommandFinder.h"
#include "gui/window/HelpWindow.h"
#include "gui/window/SavePictureDialog.h"
#include "patience.h"
#include "session/Session.h"
#include "session/document/Open.h"

namespace velum::gui {
namespace {

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

class PictureDialog : public testing::Test {
 protected:
  void SetUp() override {
    Progress progress;
    mScene = session::openSample("two-spheres", 32, mFolder.path(), progress);
  }
  template <class T>
  T* child(SavePictureDialog& dialog, const char* name) {
    return dialog.findChild<T*>(name);
  }
  TempFolder mFolder;
  scene::Scene mScene;
};

TEST_F(PictureDialog, CentimetresAtADpiArePixels) {
  SavePictureDialog dialog({800, 400}, {800, 400}, mScene, nullptr);
  child<QComboBox>(dialog, "pictureUnit")->setCurrentIndex(1);
  child<QSpinBox>(dialog, "pictureDpi")->setValue(254);
  child<QDoubleSpinBox>(dialog, "pictureWidth")->setValue(10.0);
  EXPECT_EQ(dialog.options().size, glm::ivec2(1000, 500));
  EXPECT_EQ(dialog.options().dpi, 254);
  child<QSpinBox>(dialog, "pictureDpi")->setValue(508);  // the same paper, twice the pixels
  EXPECT_EQ(dialog.options().size, glm::ivec2(2000, 1000));
  child<QComboBox>(dialog, "pictureUnit")->setCurrentIndex(0);
  EXPECT_EQ(child<QDoubleSpinBox>(dialog, "pictureWidth")->value(), 2000);
}

TEST_F(PictureDialog, ShowsThePictureSmallBeforeItIsMade) {
  SavePictureDialog dialog({800, 600}, {800, 600}, mScene, nullptr);
  dialog.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.hasPreview(); }, kPatience));
  QImage preview = dialog.grab().toImage();
  EXPECT_NE(preview.pixelColor(190, 170), preview.pixelColor(30, 60)) << "the preview shows nothing";
  takeShot(dialog, "save-picture");
}

TEST_F(PictureDialog, TheCopiedCommandMakesTheSamePicture) {
  SavePictureDialog dialog({160, 120}, {160, 120}, mScene, nullptr);
  child<QComboBox>(dialog, "pictureBackground")->setCurrentIndex(2);
  child<QSpinBox>(dialog, "pictureSamples")->setValue(2);
  QStringList words = QProcess::splitCommand(dialog.command());
  ASSERT_GT(words.size(), 3);
  EXPECT_EQ(words.takeFirst(), "velum-batch");
  QString made = QString::fromStdString((mFolder.path() / "command.png").string());
  words[words.indexOf("picture.png")] = made;
  runBatch(words);
  Progress progress;
  auto saved = mFolder.path() / "window.png";
  // Where no window's context is current, as in the program.
  std::async(std::launch::async, [&] {
    session::Session(dialog.pictureScene()).savePicture(dialog.options(), {}, saved, progress);
  }).get();
  auto pixels = [](const QString& path) { return QImage(path).convertToFormat(QImage::Format_RGBA8888); };
  ASSERT_FALSE(bytesOf(made).isEmpty());
  EXPECT_EQ(pixels(made), pixels(QString::fromStdString(saved.string())));
}

TEST_F(PictureDialog, RemembersWhatWasChosenForThePictureBefore) {
  scene::Cut cut;
  cut.axis = {0, -1, 0};
  cut.spares = {{1, 12.0}};
  scene::addCut(mScene, cut);
  {
    SavePictureDialog dialog({800, 400}, {800, 400}, mScene, nullptr);
    child<QComboBox>(dialog, "pictureUnit")->setCurrentIndex(1);
    child<QSpinBox>(dialog, "pictureDpi")->setValue(254);
    child<QDoubleSpinBox>(dialog, "pictureWidth")->setValue(12.0);
    child<QCheckBox>(dialog, "pictureLayers")->setChecked(true);
    dialog.remember();
  }
  SavePictureDialog again({800, 400}, {1200, 600}, mScene, nullptr);
  again.recall();
  EXPECT_EQ(child<QComboBox>(again, "pictureUnit")->currentText(), "cm");
  EXPECT_EQ(child<QDoubleSpinBox>(again, "pictureWidth")->value(), 12.0);
  EXPECT_EQ(again.options().size, glm::ivec2(1200, 600));
  EXPECT_EQ(again.options().dpi, 254);
  EXPECT_TRUE(again.options().layers);
  SavePictureDialog({800, 400}, {1920, 1080}, mScene, nullptr).remember();
}

TEST(CommandFinder, BeginningsOfWordsComeFirst) {
  EXPECT_GT(CommandFinder::score("ap", "Cut > Add plane"), CommandFinder::score("ap", "File > Snapshot"));
  EXPECT_GT(CommandFinder::score("undo", "Edit > Undo"), CommandFinder::score("undo", "Unload odd things"));
  EXPECT_EQ(CommandFinder::score("xyz", "Edit > Undo"), 0);
}

TEST(CommandFinder, EnterDoesTheCommandThatIsOnTop) {
  QWidget window;
  ActionTable actions(&window);
  QMenu menu("Cut", &window);
  int planes = 0, others = 0;
  actions.add(&menu, "test.other", "Flip", "Turn it round", [&] { ++others; });
  actions.add(&menu, "test.plane", "Add plane", "Cut away a half", [&] { ++planes; });
  CommandFinder finder(findCommands(actions), &window);
  finder.show();
  QTest::keyClicks(finder.findChild<QLineEdit*>(), "adpl");
  takeShot(finder, "find-command");
  QTest::keyClick(finder.findChild<QLineEdit*>(), Qt::Key_Return);
  EXPECT_EQ(planes, 1);
  EXPECT_EQ(others, 0);
}

TEST(Help, TheGuideRidesInTheProgramWithItsPictures) {
  HelpWindow help(nullptr);
  help.show();
  EXPECT_TRUE(help.page().toPlainText().contains("User guide"));
  takeShot(help, "guide");
  // Each picture of the guide is there.
  for (auto block = help.page().document()->begin(); block.isValid(); block = block.next())
    for (auto it = block.begin(); !it.atEnd(); ++it) {
      QTextImageFormat format = it.fragment().charFormat().toImageFormat();
      if (format.isValid() && !format.name().isEmpty()) {
        EXPECT_FALSE(QImage(":/guide/" + format.name()).isNull()) << format.name().toStdString();
      }
    }
}

}  // namespace
}  // namespace velum::gui
