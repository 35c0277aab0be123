#include "gui/window/Script.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QFile>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTest>
#include <filesystem>

#include "RunBatch.h"
#include "WindowFixture.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "scene/json/Json.h"

namespace velum::gui {
namespace {

class ScriptTest : public testing::Test {
 protected:
  void SetUp() override {
    Progress progress;
    io::writeVolume(io::makeSample("two-spheres", 16, progress).volume, mFolder / "phantom.nrrd", progress);
    mWindow.resize(600, 420);
    mWindow.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&mWindow));
  }
  QString path(const char* name) const { return QString::fromStdString((mFolder / name).string()); }
  /// @return the error; empty when all lines were done
  QString run(const QString& text) {
    bool done = false;
    QString said;
    Script script(mWindow, "test", text);
    QObject::connect(&script, &Script::finished, [&] { done = true; });
    QObject::connect(&script, &Script::failed, [&](const QString& error, int code) {
      done = true;
      said = QString("%1 (%2)").arg(error).arg(code);
    });
    QObject::connect(&script, &Script::interrupted, [&] {
      done = true;
      said = "interrupted: " + mWindow.messages().text();
    });
    script.start();
    EXPECT_TRUE(QTest::qWaitFor([&] { return done; }, kPatience)) << text.toStdString();
    return said;
  }
  const scene::Scene& scene() { return mWindow.document().scene(); }
  /// A program that was copied, run by Python, draws the window's bytes. @param parts  that it holds
  void expectPythonDrawsTheSame(std::initializer_list<const char*> parts) {
    QString program = QGuiApplication::clipboard()->text();
    for (const char* part : parts) EXPECT_TRUE(program.contains(part)) << part << " in\n" << program.toStdString();
    ASSERT_EQ(run("picture samples=1 96x72 " + path("window.png")), "");
    QFile file(path("again.py"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write((program + QString("s.picture(\"96x72\", \"%1\", samples=1)\n").arg(path("python.png"))).toUtf8());
    file.close();
    runProgram({VELUM_PYTHON, path("again.py")}, "PYTHONPATH=" VELUM_PYTHON_PACKAGE);
    QByteArray byWindow = bytesOf(path("window.png"));
    EXPECT_FALSE(byWindow.isEmpty());
    EXPECT_TRUE(bytesOf(path("python.png")) == byWindow) << program.toStdString();
  }

  TempFolder mFolder;
  MainWindow mWindow;
};

TEST_F(ScriptTest, DoesWhatEachLineSays) {
  QString said = run(QString("# a comment\n\nopen %1\nset volume.windowLevel 17\ndo cut.addPlane\nundo\nredo\nwait 10\n"
                             "settle\nsave %2\nscreenshot %3\n")
                         .arg(path("phantom.nrrd"), path("a.json"), path("a.png")));
  EXPECT_EQ(said, "");
  EXPECT_EQ(scene().volume.windowLevel, 17);
  EXPECT_EQ(scene().cuts.size(), 1u);
  EXPECT_EQ(mWindow.document().undoLabel(), "Add cut");
  EXPECT_TRUE(QFile::exists(path("a.json")));
  EXPECT_TRUE(QFile::exists(path("a.png")));
  EXPECT_FALSE(mWindow.document().isModified());
}

TEST_F(ScriptTest, ErrorsNameTheLineAndTheKind) {
  struct Row {
    QString text, part;
    int code;
  };
  QString open = "open " + path("phantom.nrrd") + "\n";
  for (const Row& row :
       {Row{"\nsing", "test:2: 'sing' is no command", 1}, Row{"open /nowhere/a.nrrd", "/nowhere/a.nrrd", 2},
        Row{"open", "a path is missing", 1}, Row{"set camera", "a field and a value", 1},
        Row{"set camera.eye 4", "eye", 1}, Row{"set camera.fieldOfViewDeg 900", "outside", 1},
        Row{"do sing.loud", "sing.loud", 1}, Row{"do cut.addPlane", "cannot be done now", 2},
        Row{"undo", "nothing to undo", 2},
        Row{"cut.add plane axis=0,0,1", "'axis' is no argument here; these are shape, name", 1},
        Row{"page of gold", "no page", 1}, Row{"wait long", "whole number", 1}, Row{"wait -5", "whole number", 1},
        Row{"recover", "no unsaved work", 2}, Row{"screenshot /nowhere/a.png", "/nowhere/a.png", 2},
        Row{open + "save /nowhere/a.json", "test:2: /nowhere/a.json", 2}}) {
    QString said = run(row.text);
    EXPECT_TRUE(said.contains(row.part)) << row.text.toStdString() << " gives " << said.toStdString();
    EXPECT_TRUE(said.endsWith(QString("(%1)").arg(row.code))) << said.toStdString();
    EXPECT_FALSE(said.contains('\n')) << said.toStdString();
  }
}

TEST_F(ScriptTest, AFilmOfWhichFramesFailEndsIt) {
  ASSERT_TRUE(std::filesystem::create_directories(mFolder / "out/frame-00001.png/in the way"));
  QString open = QString("open %1\nset timeline.framesPerSecond 4\nfilm.turn 1\n").arg(path("phantom.nrrd"));
  QString lost = R"(set timeline.tracks.+ {"path":"cuts[#9].centre","keys":[{"time":0,"value":[0,0,0]}]})";
  EXPECT_EQ(run(QString("%1%2\nfilm.save \"%3/\" 48x36 samples=1\n").arg(open, lost, path("whole"))), "");
  QString told = mWindow.messages().text();
  EXPECT_TRUE(told.startsWith("Saved ") && told.contains("timeline: ")) << told.toStdString();
  QString said = run(QString("\nfilm.save \"%1/\" 48x36 samples=1\nundo\n").arg(path("out")));
  EXPECT_TRUE(said.startsWith("test:2: ") && said.contains("1 of 4 frames could not be drawn: 1 ("))
      << said.toStdString();
  EXPECT_TRUE(said.endsWith("(2)")) << said.toStdString();
  EXPECT_TRUE(QFile::exists(path("out/frame-00002.png"))) << "the others are there";
  EXPECT_FALSE(scene().timeline.tracks.empty()) << "nothing is done after that";
}

TEST_F(ScriptTest, WhoStopsALineStopsItAll) {
  QMetaObject::Connection once = QObject::connect(&mWindow.jobs(), &JobRunner::busyChanged, [this](bool busy) {
    if (busy && scene().timeline.framesPerSecond == 4) QTimer::singleShot(50, &mWindow.jobs(), &JobRunner::cancel);
  });
  QString said =
      run(QString("open %1\nset timeline.framesPerSecond 4\nfilm.turn 100\nfilm.save \"%2/\" 400x300 samples=8\n"
                  "set volume.windowLevel 17\n")
              .arg(path("phantom.nrrd"), path("film")));
  QObject::disconnect(once);
  EXPECT_TRUE(said.startsWith("interrupted: Stopped: ") && said.endsWith("; line 4 of the script was the last."))
      << said.toStdString();
  EXPECT_NE(scene().volume.windowLevel, 17);
  EXPECT_EQ(run("set volume.windowLevel 17\n"), "") << "the next script is another one";
}

TEST_F(ScriptTest, NamesAndValuesMayHoldBlanks) {
  EXPECT_EQ(run(QString("open %1\ndo cut.addPlane\nset cuts.0.name  my 2nd cut\nset cuts[my 2nd cut].faceOpacity 0.25\n"
                        "set cuts[my 2nd cut].centre [1, 2, 3]\n")
                    .arg(path("phantom.nrrd"))),
            "");
  ASSERT_EQ(scene().cuts.size(), 1u);
  EXPECT_EQ(scene().cuts[0].name, "my 2nd cut");
  EXPECT_EQ(scene().cuts[0].faceOpacity, 0.25);
  EXPECT_EQ(scene().cuts[0].centre, glm::dvec3(1, 2, 3));
  EXPECT_TRUE(run("set cuts[no such cut].faceOpacity 0.5").contains("no such cut"));
}

TEST_F(ScriptTest, WhatFollowsFromAFieldIsDone) {
  ASSERT_EQ(run("open " + path("phantom.nrrd")), "");
  auto all = scene().volume.data;
  EXPECT_EQ(run("set volume.bodyOnly true\nlook.mode mip\nset volume.source.spacing 2,2,2"), "");
  EXPECT_TRUE(scene().volume.given);
  EXPECT_FALSE(scene().volume.data == all);
  EXPECT_EQ(spacingOf(*scene().volume.data), glm::dvec3(2.0));
  EXPECT_EQ(scene().rayCast.mode, scene::RenderMode::Mip);
  EXPECT_TRUE(run("structure.show nobody").endsWith("(1)"));
  EXPECT_TRUE(run("set volume.source.path /nowhere/a.nrrd").endsWith("(2)"));
}

TEST_F(ScriptTest, TheCommandsSoFarAreShownTypedAndRunAgain) {
  ASSERT_EQ(run(QString("open %1\ndo cut.addPlane\ndo edit.commands").arg(path("phantom.nrrd"))), "");
  auto* window = mWindow.findChild<QWidget*>("commandsWindow");
  ASSERT_TRUE(window && window->isVisible());
  auto* typed = window->findChild<QLineEdit*>("commandTyped");
  typed->setText("cut.flip");
  QTest::keyClick(typed, Qt::Key_Return);
  EXPECT_TRUE(scene().cuts.at(0).invert);
  EXPECT_TRUE(typed->text().isEmpty());
  typed->setText("cut.flop");
  QTest::keyClick(typed, Qt::Key_Return);
  EXPECT_EQ(typed->text(), "cut.flop") << "it can be mended";
  typed->setText("cut.remove nobody");
  QTest::keyClick(typed, Qt::Key_Return);
  EXPECT_EQ(typed->text(), "cut.remove nobody");
  typed->setText("look.mode mip");
  QTest::keyClick(typed, Qt::Key_Return);
  EXPECT_TRUE(typed->text().isEmpty()) << "what went wrong before is forgotten";
  auto* lines = window->findChild<QPlainTextEdit*>("commandLines");
  ASSERT_TRUE(QTest::qWaitFor([&] { return lines->toPlainText().endsWith("look.mode mip\n"); }, kPatience));
  std::string before = scene::toJson(scene());
  QString text = lines->toPlainText();
  EXPECT_EQ(run(text), "");
  EXPECT_EQ(scene::toJson(scene()), before);
  window->close();
}

TEST_F(ScriptTest, WhatWasDoneIsCopiedAsPythonAndDrawsTheSameBytes) {
  if (std::string_view(VELUM_PYTHON_PACKAGE).empty()) GTEST_SKIP() << "the Python module is not built";
  ASSERT_EQ(run(QString("open %1\ndo cut.addPlane\nset cuts.0.face section\nset cuts.0.name [1,2]\nlook.background "
                        "1,1,1 0.2,0.4,0.6\n"
                        "set lighting.shadow 0\nset lighting.occlusion 0\nview.from left\ndo edit.copyPython\n")
                    .arg(path("phantom.nrrd"))),
            "");
  expectPythonDrawsTheSame({"\ns.cut.add("});
}

/// A membrane, a region that grows, what stands out, marks, a film, and what a mouse has dragged.
TEST_F(ScriptTest, WhatAHandHasDoneIsCopiedAsPythonToo) {
  if (std::string_view(VELUM_PYTHON_PACKAGE).empty()) GTEST_SKIP() << "the Python module is not built";
  ASSERT_EQ(
      run(QString("open %1\nset lighting.shadow 0\nset lighting.occlusion 0\ncut.add plane\nset cuts.0.axis [0,-1,0]\n"
                  "growth.pullAt -29,0,14 12\nmembrane.hang 500,1100 axis=0,0,1 position=0.7\nsettle\n"
                  "mark.add distance [[-10,0,0],[10,0,5]]\nfilm.turn 1\nview.from oblique\nsettle\n")
              .arg(path("phantom.nrrd"))),
      "");
  ASSERT_EQ(scene().cuts.size(), 2u);
  scene::Camera before = scene().camera;
  QTest::mousePress(&mWindow.viewport(), Qt::LeftButton, {}, {20, 20});
  for (int i = 1; i <= 4; ++i) QTest::mouseMove(&mWindow.viewport(), QPoint(20 + 6 * i, 20 + 3 * i));
  QTest::mouseRelease(&mWindow.viewport(), Qt::LeftButton, {}, {44, 32});
  EXPECT_NE(scene().camera.eye, before.eye);
  ASSERT_EQ(run("settle\ndo edit.copyPython\n"), "");
  expectPythonDrawsTheSame({"s.membrane.hang(", "s.growth.pullAt(", "s.mark.add(", "s.film.turn(", "camera.eye"});
}

TEST_F(ScriptTest, MissingDataIsAnErrorAndAsksNothing) {
  ASSERT_EQ(run(QString("open %1\nsave %2").arg(path("phantom.nrrd"), path("b.json"))), "");
  QFile::remove(path("phantom.nrrd"));
  QString said = run("open " + path("b.json"));
  EXPECT_TRUE(said.contains("phantom.nrrd") && said.endsWith("(2)")) << said.toStdString();
}

TEST_F(ScriptTest, UnsavedChangesAreNotAskedAboutWhileItRuns) {
  QString open = "open " + path("phantom.nrrd") + "\n";
  EXPECT_EQ(run(open + "set volume.windowLevel 4\ndo file.new\n" + open), "");
  EXPECT_FALSE(mWindow.document().isModified());
}

}  // namespace
}  // namespace velum::gui
