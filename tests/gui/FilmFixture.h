#pragma once
#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTimer>

#include "ModelFixture.h"
#include "Shots.h"
#include "gui/kit/Preferences.h"
#include "gui/kit/Theme.h"
#include "gui/window/FilmCommands.h"
#include "gui/window/ReadyFilmDialog.h"
#include "gui/window/SaveFilmDialog.h"

namespace velum::gui {

inline bool hasFfmpeg() { return !QStandardPaths::findExecutable("ffmpeg").isEmpty(); }

/// A window whose dialogs of films are driven by real events.
class FilmFixture : public ModelWindow {
 protected:
  void SetUp() override {
    Preferences known;
    for (const char* key : {"film/format", "film/blur", "film/sixteenBits", "film/layers"}) known.setValue(key, 0);
    known.setValue("film/quality", 75);
    known.setValue("film/size", QSize());
    known.setValue("film/folder", QString());
    ModelWindow::SetUp();
  }
  void TearDown() override {
    applyTheme(*qApp);
    ModelWindow::TearDown();
  }
  session::Document& document() { return mWindow->document(); }
  QAction* action(const char* id) { return mWindow->actions().find(id); }
  /// A command as a line of a script.
  void run(const char* line) {
    Progress progress;
    session::run(mWindow->session(), session::parseCall(line), progress);
  }
  /// The phantom with its labels, a plane from which a structure stands out, and a membrane.
  void openCutPhantom() {
    mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
    ASSERT_TRUE(waitForJob());
    drawSoon();
    run("cut.add plane Front");
    run("set cuts.0.axis 0,-1,0");
    run("set cuts.0.spares [{\"structure\":1,\"distance\":60}]");
    ASSERT_TRUE(settle());
  }
  /// Triggers a command and calls use(dialog) with each dialog of the type that comes up.
  template <class Dialog, class Use>
  int inDialog(const char* id, Use use) {
    int dialogs = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
      auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
      if (!dialog || dialogs > 0) return;
      ++dialogs;
      use(*dialog);
    });
    timer.start(20);
    action(id)->trigger();
    return dialogs;
  }
  static bool isDrawn(FilmPreview& preview) {
    return QTest::qWaitFor([&] { return preview.isDone(); }, kPatience);
  }
  template <class T>
  static T* in(QDialog& dialog, const char* name) {
    T* found = dialog.findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  /// A film of few small frames.
  session::FilmOutput smallOutput(const QString& path) {
    session::FilmOutput output;
    output.path = path.toStdString();
    output.picture.size = {96, 64};
    output.picture.samples = 1;
    return output;
  }
};

}  // namespace velum::gui
