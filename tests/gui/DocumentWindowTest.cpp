// What becomes of the user's work: undo of views, asking before it is lost, recovery, recent files, data that is
// missing.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <QTest>
#include <QTimer>
#include <filesystem>
#include <fstream>
#include <functional>
#include <utility>

#include "Shots.h"
#include "SmallDisk.h"
#include "TempFolder.h"
#include "gui/service/RecentFiles.h"
#include "gui/window/MainWindow.h"
#include "gui/window/RecoveryBar.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "patience.h"
#include "session/document/Folders.h"
#include "session/document/Open.h"
#include "session/document/Showcase.h"

namespace velum::gui {
namespace {

class DocumentWindow : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(session::stateFolder());
    Progress progress;
    io::writeVolume(io::makeSample("two-spheres", 16, progress).volume, mFolder / "phantom.nrrd", progress);
    mWindow = makeWindow();
  }
  void openSamples(bool isWhole);
  std::unique_ptr<MainWindow> makeWindow() {
    auto window = std::make_unique<MainWindow>();
    window->resize(760, 520);
    window->show();
    window->protectWork(mFolder / "recovery");
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window->isLookingForWork(); }, kPatience));
    return window;
  }
  QString path(const char* name) const { return QString::fromStdString((mFolder / name).string()); }
  bool open(const char* name) {
    mWindow->openPaths({path(name)});
    return waitForJob();
  }
  bool waitForJob() {
    return QTest::qWaitFor([&] { return !mWindow->isBusy(); }, kPatience);
  }
  void edit(double level) {
    mWindow->document().edit("Window", [level](scene::Scene& scene) { scene.volume.windowLevel = level; });
  }
  /// Presses a button of the next question that is asked. @return whether one was, later
  std::shared_ptr<bool> answer(const QString& button) {
    auto asked = std::make_shared<bool>(false);
    auto* timer = new QTimer(mWindow.get());
    QObject::connect(timer, &QTimer::timeout, mWindow.get(), [asked, button, timer] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box) return;
      timer->deleteLater();
      takeShot(*box, "ask-" + button.section(' ', 0, 0).toLower());
      for (auto* one : box->buttons())
        if (one->text().remove('&') == button) {
          *asked = true;
          one->click();
          return;
        }
      ADD_FAILURE() << "no button " << button.toStdString();
      box->reject();
    });
    timer->start(20);
    return asked;
  }
  QByteArray bytesOf(const char* name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  void expectRefused(const char* name, const QByteArray& before) {
    EXPECT_TRUE(mWindow->messages().isVisible());
    EXPECT_TRUE(mWindow->messages().text().contains(name)) << mWindow->messages().text().toStdString();
    EXPECT_FALSE(mWindow->messages().text().contains("Saved"));
    EXPECT_EQ(bytesOf(name), before);
    for (const auto& entry : std::filesystem::directory_iterator(mFolder.path()))
      EXPECT_FALSE(entry.path().filename().string().starts_with(".velum-")) << entry.path();
  }
  /// As a crash leaves it: the journal stays.
  void crash() { mWindow.reset(); }

  /// Newer than all other work by its file's time, whose steps are those of the kernel's clock (4 ms).
  void leaveUnreadableWork(const std::string& name) {
    auto folder = mFolder / "recovery" / name;
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "journal-1.jsonl") << "nothing";
    std::filesystem::last_write_time(folder / "journal-1.jsonl",
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(1));
  }

  RecoveryBar& bar() { return *mWindow->findChild<RecoveryBar*>(); }

  TempFolder mFolder;
  std::unique_ptr<MainWindow> mWindow;
};

TEST_F(DocumentWindow, OneUndoTakesTheViewBackAndTheNextTheEdit) {
  ASSERT_TRUE(open("phantom.nrrd"));
  EXPECT_FALSE(mWindow->document().canUndo());
  scene::Camera start = mWindow->document().scene().camera;
  edit(5);
  auto& view = mWindow->viewport();
  for (int i = 0; i < 3; ++i) {
    QTest::mousePress(&view, Qt::LeftButton, {}, {100, 100});
    QTest::mouseMove(&view, {130 + 9 * i, 100});
    QTest::mouseRelease(&view, Qt::LeftButton, {}, {130 + 9 * i, 100});
  }
  mWindow->actions().find("view.left")->trigger();
  EXPECT_TRUE(mWindow->actions().find("edit.undo")->text().contains("Move view"));
  mWindow->actions().find("edit.undo")->trigger();
  EXPECT_EQ(mWindow->document().scene().camera, start);
  EXPECT_EQ(mWindow->document().scene().volume.windowLevel, 5);
  mWindow->actions().find("edit.undo")->trigger();
  EXPECT_NE(mWindow->document().scene().volume.windowLevel, 5);
}

TEST_F(DocumentWindow, ClosingAsksOnlyAboutEdits) {
  ASSERT_TRUE(open("phantom.nrrd"));
  mWindow->viewport().lookFrom(scene::StandardView::Left);
  EXPECT_TRUE(mWindow->close());
  mWindow = makeWindow();
  EXPECT_FALSE(bar().isVisible());
  ASSERT_TRUE(open("phantom.nrrd"));
  edit(5);
  auto asked = answer("Cancel");
  EXPECT_FALSE(mWindow->close());
  EXPECT_TRUE(*asked);
  EXPECT_TRUE(mWindow->isVisible());
  asked = answer("Don't save");
  mWindow->actions().find("file.new")->trigger();
  EXPECT_TRUE(*asked);
  EXPECT_FALSE(mWindow->document().scene().volume.data);
  EXPECT_TRUE(mWindow->close());
  mWindow = makeWindow();
  EXPECT_FALSE(bar().isVisible());
}

TEST_F(DocumentWindow, SaveInTheQuestionSaves) {
  ASSERT_TRUE(open("phantom.nrrd"));
  mWindow->saveSceneTo(path("a.json"));
  edit(7);
  auto asked = answer("Save");
  EXPECT_TRUE(mWindow->close());
  EXPECT_TRUE(*asked);
  Progress progress;
  scene::Source source;
  source.path = path("a.json").toStdString();
  EXPECT_EQ(session::open(source, progress).volume.windowLevel, 7);
}

TEST_F(DocumentWindow, WorkOfADeadWindowIsOfferedAndRestoredAsModified) {
  ASSERT_TRUE(open("phantom.nrrd"));
  edit(11);
  mWindow->viewport().lookFrom(scene::StandardView::Left);
  scene::Scene before = mWindow->document().scene();
  crash();
  mWindow = makeWindow();
  ASSERT_TRUE(bar().isVisible());
  ASSERT_TRUE(bar().current());
  EXPECT_EQ(bar().current()->title, "phantom.nrrd");
  EXPECT_EQ(bar().current()->label, "Move view");
  takeShot(*mWindow, "recovery");
  for (auto* button : bar().findChildren<QPushButton*>())
    if (button->text() == "&Restore") QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_TRUE(waitForJob());
  EXPECT_FALSE(bar().isVisible());
  scene::Scene after = mWindow->document().scene();
  EXPECT_TRUE(after.volume.data);
  after.volume.data = before.volume.data = {};
  EXPECT_EQ(after, before);
  EXPECT_TRUE(mWindow->document().isModified());
  // It is safe again, in one place.
  crash();
  EXPECT_EQ(session::findLostWork(mFolder / "recovery").size(), 1u);
}

TEST_F(DocumentWindow, WorkThatCannotBeReadIsSaidWithItsPlaceAndWhatCanBeIsRestored) {
  ASSERT_TRUE(open("phantom.nrrd"));
  edit(11);
  crash();
  leaveUnreadableWork("1-2-3");
  mWindow = makeWindow();
  ASSERT_TRUE(bar().current());
  EXPECT_FALSE(bar().current()->isReadable) << "the newest comes first";
  QString shown;
  for (auto* label : bar().findChildren<QLabel*>()) shown += label->toolTip();
  EXPECT_TRUE(shown.contains(path("recovery/1-2-3")) && shown.contains("journal-1.jsonl: it is damaged"))
      << shown.toStdString();
  takeShot(*mWindow, "recovery-unreadable");
  auto restore = [&] {
    for (auto* button : bar().findChildren<QPushButton*>())
      if (button->text() == "&Restore") return button->isVisible();
    return false;
  };
  EXPECT_FALSE(restore());
  auto asked = answer("Delete");
  emit bar().discardWanted();
  EXPECT_TRUE(*asked);
  ASSERT_TRUE(bar().current());
  EXPECT_TRUE(restore());
  EXPECT_FALSE(std::filesystem::exists(mFolder / "recovery" / "1-2-3"));
  leaveUnreadableWork("1-2-4");
  mWindow.reset();
  mWindow = makeWindow();
  ASSERT_FALSE(bar().current()->isReadable);
  EXPECT_TRUE(mWindow->restoreWork()) << "the newest that can be read";
  ASSERT_TRUE(waitForJob());
  EXPECT_EQ(mWindow->document().scene().volume.windowLevel, 11);
}

TEST_F(DocumentWindow, AFolderOfWorkThatCannotBeReadIsSaid) {
  mWindow.reset();
  std::filesystem::remove_all(mFolder / "recovery");
  std::ofstream(mFolder / "recovery") << "a file";
  mWindow = makeWindow();
  EXPECT_TRUE(mWindow->messages().isVisible());
  EXPECT_TRUE(mWindow->messages().text().contains(path("recovery"))) << mWindow->messages().text().toStdString();
}

TEST_F(DocumentWindow, ADiskThatIsFullIsSaidAndAgainWhenItIsNot) {
  ASSERT_TRUE(open("phantom.nrrd"));
  edit(1);
  {
    SmallDisk disk(100);
    edit(2);
    ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->messages().text().contains("not protected"); }, kPatience));
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->messages().text().contains("is protected"); }, kPatience));
  crash();
  mWindow = makeWindow();
  ASSERT_TRUE(bar().current());
  ASSERT_TRUE(mWindow->restoreWork());
  ASSERT_TRUE(waitForJob());
  EXPECT_EQ(mWindow->document().scene().volume.windowLevel, 2);
}

// Saving.

TEST_F(DocumentWindow, ASceneThatCannotBeSavedIsSaidStaysModifiedAndTheOldFileWhole) {
  ASSERT_TRUE(open("phantom.nrrd"));
  mWindow->saveSceneTo(path("a.json"));
  QByteArray before = bytesOf("a.json");
  edit(2);
  {
    SmallDisk disk(100);
    mWindow->saveSceneTo(path("a.json"));
    // In the question, too: what is open stays open.
    auto asked = answer("Save");
    EXPECT_FALSE(mWindow->close());
    EXPECT_TRUE(*asked);
  }
  EXPECT_TRUE(mWindow->isVisible());
  expectRefused("a.json", before);
  EXPECT_TRUE(mWindow->document().isModified());
  // A name that no file system takes.
  mWindow->saveSceneTo(path(std::string(300, 'x').c_str()) + ".json");
  EXPECT_TRUE(mWindow->messages().text().contains("xxx"));
  EXPECT_TRUE(mWindow->document().isModified());
  mWindow->saveSceneTo(path("a.json"));
  EXPECT_FALSE(mWindow->document().isModified());
  EXPECT_NE(bytesOf("a.json"), before);
}

TEST_F(DocumentWindow, WhatCannotBeExportedIsSaidAndTheOldFileWhole) {
  ASSERT_TRUE(open("phantom.nrrd"));
  mWindow->actions().find("cut.addMembrane")->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !mWindow->isBusy(); }, kPatience));
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience));
  session::PictureOptions options;
  options.size = {64, 48};
  options.samples = 1;
  auto picture = [&](const QString& to) { mWindow->exports().savePictureTo(to, options, mWindow->document().scene()); };
  auto sheet = [&](const QString& to) { mWindow->exports().exportSheetTo(to); };
  auto clipped = [&](const QString& to) { mWindow->exports().exportClippedTo(to); };
  auto look = [&](const QString& to) { mWindow->look().exportTo(to); };
  const std::pair<const char*, std::function<void(const QString&)>> writers[] = {{"a.png", picture},
                                                                                 {"a.exr", picture},
                                                                                 {"a.tif", picture},
                                                                                 {"sheet.ply", sheet},
                                                                                 {"sheet.obj", sheet},
                                                                                 {"sheet.vtp", sheet},
                                                                                 {"sheet.stl", sheet},
                                                                                 {"clipped.nrrd", clipped},
                                                                                 {"clipped.nii", clipped},
                                                                                 {"clipped.nii.gz", clipped},
                                                                                 {"clipped.vti", clipped},
                                                                                 {"clipped.vdb", clipped},
                                                                                 {"a.velum-transfer.json", look},
                                                                                 {"a.vp.json", look},
                                                                                 {"a.vp", look}};
  for (const auto& [name, write] : writers) {
    SCOPED_TRACE(name);
    std::ofstream(mFolder / name) << "the old file";
    {
      SmallDisk disk(100);
      write(path(name));
      ASSERT_TRUE(waitForJob());
    }
    expectRefused(name, "the old file");
    write(path(name));
    ASSERT_TRUE(waitForJob());
    EXPECT_TRUE(mWindow->messages().text().contains("Saved")) << mWindow->messages().text().toStdString();
    EXPECT_NE(bytesOf(name), "the old file");
  }
}

TEST_F(DocumentWindow, DiscardedWorkIsAskedAboutAndGone) {
  ASSERT_TRUE(open("phantom.nrrd"));
  edit(11);
  crash();
  mWindow = makeWindow();
  auto asked = answer("Delete");
  emit bar().discardWanted();
  EXPECT_TRUE(*asked);
  EXPECT_FALSE(bar().isVisible());
  EXPECT_TRUE(session::findLostWork(mFolder / "recovery").empty());
}

TEST_F(DocumentWindow, SavedWorkIsNotOffered) {
  ASSERT_TRUE(open("phantom.nrrd"));
  edit(3);
  mWindow->saveSceneTo(path("b.json"));
  EXPECT_FALSE(mWindow->document().isModified());
  crash();
  mWindow = makeWindow();
  EXPECT_FALSE(bar().isVisible());
}

TEST_F(DocumentWindow, RecentFilesHavePicturesAndOpenByAClick) {
  ASSERT_TRUE(open("phantom.nrrd"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience));
  mWindow->saveSceneTo(path("c.json"));
  mWindow->actions().find("file.new")->trigger();
  auto cards = mWindow->findChildren<RecentCard*>();
  ASSERT_EQ(cards.size(), 2);
  EXPECT_EQ(QString::fromStdString(cards[0]->path().string()), path("c.json"));
  for (auto* card : cards) EXPECT_FALSE(recentPixmap(card->path(), RecentCard::kPicture, 1).isNull());
  QMenu* menu = nullptr;
  for (auto* one : mWindow->findChildren<QMenu*>())
    if (one->title() == "Open &recent") menu = one;
  ASSERT_TRUE(menu);
  emit menu->aboutToShow();
  ASSERT_EQ(menu->actions().size(), 2);
  EXPECT_TRUE(menu->actions()[0]->text().startsWith("c.json"));
  EXPECT_FALSE(menu->actions()[0]->icon().isNull());
  takeShot(*menu, "recent-menu");
  takeShot(*mWindow, "recent");
  QTest::mouseClick(cards[0], Qt::LeftButton);
  ASSERT_TRUE(waitForJob());
  EXPECT_TRUE(mWindow->document().scene().volume.data);
}

/// Each of the three systems, in one click, without anything that would have to be fetched.
/// Opens each by its card in the empty window. @param isWhole  waits for the whole picture, and keeps it
void DocumentWindow::openSamples(bool isWhole) {
  for (const session::Showcase& sample : session::showcases()) {
    std::string name(sample.name);
    std::filesystem::path cache(QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString());
    std::filesystem::remove_all(cache / "samples");
    mWindow->actions().find("file.new")->trigger();
    auto* card = mWindow->findChild<QAbstractButton*>(QString::fromStdString("sample." + name));
    ASSERT_TRUE(card) << name;
    QElapsedTimer clock;
    clock.start();
    QTest::mouseClick(card, Qt::LeftButton);
    ASSERT_TRUE(waitForJob()) << name;
    RecordProperty(name + ", ms", std::to_string(clock.elapsed()));
    const auto& scene = mWindow->document().scene();
    EXPECT_TRUE(scene.volume.data || scene.model.data) << name;
    EXPECT_FALSE(mWindow->document().isModified()) << name;
    EXPECT_FALSE(scene.cuts.empty()) << name;
    if (!isWhole) continue;
    ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience)) << name;
    RecordProperty(name + ", until the picture is whole, ms", std::to_string(clock.elapsed()));
    takeShot(*mWindow, ("sample-" + name).c_str());
  }
}

TEST_F(DocumentWindow, ASampleOpensByAClick) { openSamples(false); }

/// What they look like: a study.
class Samples : public DocumentWindow {};
TEST_F(Samples, HaveAWholePictureSoon) { openSamples(true); }

TEST_F(DocumentWindow, HistoryGoesToAnyStep) {
  ASSERT_TRUE(open("phantom.nrrd"));
  for (int i = 1; i <= 4; ++i) edit(i);
  QMenu* menu = nullptr;
  for (auto* one : mWindow->findChildren<QMenu*>())
    if (one->title() == "&History") menu = one;
  ASSERT_TRUE(menu);
  emit menu->aboutToShow();
  ASSERT_EQ(menu->actions().size(), 4);
  menu->actions()[2]->trigger();
  EXPECT_EQ(mWindow->document().scene().volume.windowLevel, 1);
  emit menu->aboutToShow();
  menu->actions()[0]->trigger();
  EXPECT_EQ(mWindow->document().scene().volume.windowLevel, 4);
}

TEST_F(DocumentWindow, SkippedDataLeavesTheSceneAndSaysSo) {
  ASSERT_TRUE(open("phantom.nrrd"));
  edit(9);
  mWindow->saveSceneTo(path("d.json"));
  QFile::remove(path("phantom.nrrd"));
  auto asked = answer("Skip");
  ASSERT_TRUE(open("d.json"));
  EXPECT_TRUE(*asked);
  EXPECT_FALSE(mWindow->document().scene().volume.data);
  EXPECT_EQ(mWindow->document().scene().volume.windowLevel, 9);
  EXPECT_TRUE(mWindow->messages().text().contains("opened without its volume"))
      << mWindow->messages().text().toStdString();
  // What is saved then still names the data.
  mWindow->saveSceneTo(path("e.json"));
  QFile saved(path("e.json"));
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
  EXPECT_TRUE(saved.readAll().contains("\"path\": \"phantom.nrrd\""));
}

TEST_F(DocumentWindow, ARenamedFileIsFoundAndSaid) {
  ASSERT_TRUE(open("phantom.nrrd"));
  mWindow->saveSceneTo(path("f.json"));
  QFile::rename(path("phantom.nrrd"), path("other.nrrd"));
  ASSERT_TRUE(open("f.json"));
  EXPECT_TRUE(mWindow->document().scene().volume.data);
  EXPECT_TRUE(mWindow->messages().text().contains("other.nrrd")) << mWindow->messages().text().toStdString();
}

/// Types a name into the next dialog that asks for one, and presses Enter.
void typeName(const QString& name) {
  QTimer::singleShot(0, [name] {
    QLineEdit* edit = nullptr;
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          auto* dialog = QApplication::activeModalWidget();
          edit = dialog ? dialog->findChild<QLineEdit*>("fileNameEdit") : nullptr;
          return edit != nullptr;
        },
        10000));
    // What is selected in the list of files follows what is typed, not what is set.
    edit->window()->activateWindow();
    edit->setFocus();
    ASSERT_TRUE(QTest::qWaitFor([&] { return edit->hasFocus(); }, kPatience));
    edit->setText(name);
    QTest::keyClick(edit, Qt::Key_Return);
  });
}

TEST_F(DocumentWindow, AFileIsWrittenUnderTheNameThatIsTyped) {
  ASSERT_TRUE(open("phantom.nrrd"));
  std::filesystem::path other = mFolder / "elsewhere";
  std::filesystem::create_directories(other);
  for (const char* name : {"a \"quoted\" name.json", "\"all\".json", "Sch\u00e4del gr\u00f6\u00dfe.json",
                           "\u982d\u84cb.json", "it's 5 o'clock.json", "two  blanks.json"}) {
    SCOPED_TRACE(name);
    // Where it is, and with the way to it.
    typeName(QString::fromUtf8(name));
    mWindow->actions().find("file.saveSceneAs")->trigger();
    EXPECT_TRUE(std::filesystem::exists(mFolder / name));
    typeName(QString::fromStdString((other / name).string()));
    mWindow->actions().find("file.saveSceneAs")->trigger();
    EXPECT_TRUE(std::filesystem::exists(other / name));
    EXPECT_EQ(mWindow->session().file().scenePath(), (other / name).string());
    mWindow->session().file().save((mFolder / "back.json").string());
  }
  typeName("Fig. 3");
  mWindow->actions().find("file.saveSceneAs")->trigger();
  EXPECT_TRUE(std::filesystem::exists(mFolder / "Fig. 3.json")) << "a number is no kind of file";
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(other)) files += entry.is_regular_file();
  EXPECT_EQ(files, 6u) << "and no other";
}

}  // namespace
}  // namespace velum::gui
