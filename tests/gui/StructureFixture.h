#pragma once
#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>
#include <functional>
#include <memory>
#include <optional>

#include "TempFolder.h"
#include "gui/structure/StructurePanel.h"
#include "gui/window/MainWindow.h"
#include "io/labels/WriteLabels.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "patience.h"

namespace velum::gui {

/// The real window with a small phantom and its labels, driven by real events.
class StructureWindow : public testing::Test {
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
    mWindow = std::make_unique<MainWindow>();
    mWindow->resize(900, 700);
    mWindow->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(mWindow.get()));
    mWindow->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(mWindow.get()));
  }

  static QString path(const char* name) { return QString::fromStdString((*sFolder / name).string()); }
  session::Document& document() { return mWindow->document(); }
  const scene::Scene& scene() { return document().scene(); }
  const std::vector<scene::Structure>& structures() { return scene().labels.structures; }
  Viewport& viewport() { return mWindow->viewport(); }
  StructureList& list() { return *child<StructureList>("structureList"); }
  template <class T>
  T* child(const char* name) {
    return mWindow->findChild<T*>(name);
  }
  bool wait(const std::function<bool()>& until) { return QTest::qWaitFor(until, kPatience); }

  void openWithLabels() {
    mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
    ASSERT_TRUE(wait([&] { return !mWindow->isBusy(); }));
    ASSERT_GE(structures().size(), 2u);
    document().view([](scene::Scene& scene) { scene.rayCast.samplesPerPixel = 1; });  // enough to pick from
    mWindow->actions().find("structure.list")->trigger();
    ASSERT_TRUE(wait([&] { return list().isVisible(); }));
  }
  /// As many structures as one likes, without a file.
  void openMany(int count) {
    openWithLabels();
    document().edit("Many", [&](scene::Scene& scene) {
      scene.labels.structures.clear();
      for (int i = 1; i <= count; ++i)
        scene.labels.structures.push_back({i, "region " + std::to_string(i), {0.3f, 0.5f, 0.7f}});
    });
  }
  void clickCell(int id, StructureModel::Column column, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(list().viewport(), Qt::LeftButton, keys, list().cellOf(id, column).center());
  }
  bool settle() {
    return wait([&] { return mWindow->isSettled(); });
  }
  /// A place of the picture where a structure is seen.
  std::optional<QPoint> placeOf(int id) {
    for (int y = 10; y < viewport().height(); y += 12)
      for (int x = 10; x < viewport().width(); x += 12)
        if (auto pick = viewport().pickAt(QPointF(x, y)); pick && pick->hit && pick->structure == id)
          return QPoint(x, y);
    return std::nullopt;
  }

  inline static TempFolder* sFolder = nullptr;
  std::unique_ptr<MainWindow> mWindow;
};

}  // namespace velum::gui
