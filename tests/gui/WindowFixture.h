#pragma once
#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QMouseEvent>
#include <QTest>
#include <memory>

#include "TempFolder.h"
#include "gui/window/MainWindow.h"
#include "io/labels/WriteLabels.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "patience.h"
#include "scene/Project.h"

namespace velum::gui {

/// What Qt has warned of since the test began.
inline QStringList& warnings() {
  static QStringList lines;
  return lines;
}

inline QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A window with a small phantom at hand, driven by real events.
class Window : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    sFolder = new TempFolder;
    Progress progress;
    io::Sample sample = io::makeSample("two-spheres", 32, progress);
    io::writeVolume(sample.volume, *sFolder / "phantom.nrrd", progress);
    io::writeLabels(sample.labels, *sFolder / "phantom_labels.seg.nrrd", progress);
  }
  static void TearDownTestSuite() { delete sFolder; }

  void SetUp() override {
    warnings().clear();
    mWindow = std::make_unique<MainWindow>();
    mWindow->resize(760, 520);
    mWindow->views().setLayout(scene::Layout::Volume);  // also of what is opened next
    mWindow->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(mWindow.get()));
    // Without a window manager nobody else gives it the keyboard.
    mWindow->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(mWindow.get()));
  }
  void TearDown() override {
    mWindow.reset();
    EXPECT_TRUE(warnings().isEmpty()) << warnings().join("\n").toStdString();
  }

  static QString path(const char* name) { return QString::fromStdString((*sFolder / name).string()); }
  const scene::Scene& scene() { return mWindow->document().scene(); }
  Viewport& viewport() { return mWindow->viewport(); }
  glm::dvec2 size() { return {viewport().width(), viewport().height()}; }
  bool waitForJob() {
    return QTest::qWaitFor([&] { return !mWindow->isBusy(); }, kPatience);
  }
  bool settle() {
    return QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience);
  }
  void openPhantom() {
    mWindow->openPaths({path("phantom.nrrd")});
    ASSERT_TRUE(waitForJob());
    ASSERT_TRUE(scene().volume.data);
  }
  /// Pictures that are complete soon: one sample, and no grid of light, which takes seconds for each place of a sheet.
  void drawSoon() {
    mWindow->document().view([](scene::Scene& scene) {
      scene.rayCast.samplesPerPixel = 1;
      scene.lighting.shadow = scene.lighting.occlusion = 0.0;
    });
  }
  void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {}) {
    drag(viewport(), from, to, button, keys);
  }
  void drag(QWidget& view, QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
            Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(&view, button, keys, from);
    for (int i = 1; i <= 5; ++i) {
      // QTest's own moves know of no keys.
      QPointF place(from + (to - from) * i / 5);
      QMouseEvent move(QEvent::MouseMove, place, view.mapToGlobal(place), Qt::NoButton, button, keys);
      QApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, button, keys, to);
  }
  template <class T>
  T* child(const char* name) {
    return mWindow->findChild<T*>(name);
  }

  inline static TempFolder* sFolder = nullptr;
  std::unique_ptr<MainWindow> mWindow;
};

}  // namespace velum::gui
