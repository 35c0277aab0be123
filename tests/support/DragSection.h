#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QTest>
#include <algorithm>
#include <thread>
#include <vector>

#include "core/Parallel.h"
#include "gui/service/Job.h"
#include "gui/window/MainWindow.h"
#include "scene/Presets.h"

/// How soon section views answer the hand: for a test with generous bounds, and for the bench's figures.
namespace velum::gui {

/// n^3 bytes at once: nested shells, so that rays go on after a thin skin.
inline Shared<Volume> makeNestedShells(int n) {
  Volume v;
  v.dims = glm::ivec3(n);
  v.voxels.resize(timeStepBytes(v));
  v.worldFromVoxel[3] = glm::dvec4(glm::dvec3(-0.5 * (n - 1)), 1.0);
  v.range = {0, 255};
  auto* out = reinterpret_cast<std::uint8_t*>(v.voxels.data());
  parallelFor(0, n, [&](int z) {
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        glm::dvec3 p = glm::dvec3(2 * x - n, 2 * y - n, 2 * z - n) / double(n);
        int r2 = int(glm::dot(p, p) * 2048);
        out[(std::size_t(z) * std::size_t(n) + std::size_t(y)) * std::size_t(n) + std::size_t(x)] =
            std::uint8_t(r2 > 1950 ? 0 : 60 + r2 * 7 % 190);
      }
  });
  return Shared<Volume>(std::move(v));
}

/// Shows a volume in four views of a window of 1440 x 900.
inline void showFourViews(MainWindow& window, const Shared<Volume>& volume) {
  window.resize(1440, 900);
  window.views().setLayout(scene::Layout::FourUp);
  scene::Scene scene;
  scene.volume.data = volume;
  scene::applyPreset(scene, scene::choosePreset(*volume));
  scene::placeSections(scene);
  window.showScene(scene, "nested shells");
}

/// A job that holds every core until it is cancelled.
inline Job::Work holdEveryCore() {
  return [](Progress& progress) {
    int cores = int(std::max(1u, std::thread::hardware_concurrency()));
    parallelFor(0, 4 * cores, [&](int) {
      volatile double x = 1.0;
      while (!progress.isCancelled()) x = x * 1.0000001 + 1e-9;
    });
    progress.throwIfCancelled();
  };
}

/// Milliseconds, ascending.
struct AnswerTimes {
  std::vector<double> ms;
  double median() const { return ms[ms.size() / 2]; }
  double worst() const { return ms.back(); }
};

/// Drags in a view as a hand does, and times each move from its event until it is answered on the screen. Every
/// fifteenth move comes after a rest, when the 3D view has taken up its work again.
/// @param counter  grows when what answers has been painted
template <class Counter>
AnswerTimes timeDrag(QWidget& view, int moves, Counter counter) {
  auto send = [&](QEvent::Type type, QPointF place) {
    auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    auto buttons = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    QCoreApplication::postEvent(&view,
                                new QMouseEvent(type, place, view.mapToGlobal(place), button, buttons, Qt::NoModifier));
  };
  AnswerTimes times;
  QPointF place(view.width() * 0.4, view.height() * 0.4);
  send(QEvent::MouseButtonPress, place);
  for (int i = 0; i < moves; ++i) {
    QTest::qWait(i % 15 == 0 ? 400 : 12);
    int before = counter();
    place += QPointF(i % 2 ? 1.5 : 0.5, 1);
    QElapsedTimer clock;
    clock.start();
    send(QEvent::MouseMove, place);
    while (counter() == before && clock.elapsed() < 5000) QCoreApplication::processEvents();
    times.ms.push_back(double(clock.nsecsElapsed()) * 1e-6);
  }
  send(QEvent::MouseButtonRelease, place);
  QCoreApplication::processEvents();
  std::sort(times.ms.begin(), times.ms.end());
  return times;
}

/// The crosshair in the axial view; the answer is the pictures of the other two.
inline AnswerTimes dragCrosshair(MainWindow& window, int moves) {
  ViewGrid& views = window.views();
  return timeDrag(views.section(scene::SectionKind::Axial), moves, [&] {
    return std::min(views.section(scene::SectionKind::Coronal).paintCount(),
                    views.section(scene::SectionKind::Sagittal).paintCount());
  });
}

/// Counts how often widgets over a view are painted.
class PaintCount : public QObject {
 public:
  explicit PaintCount(QWidget& view) {
    for (QWidget* widget : view.findChildren<QWidget*>()) widget->installEventFilter(this);
  }
  int count = 0;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    count += event->type() == QEvent::Paint &&
             static_cast<QWidget*>(watched)->testAttribute(Qt::WA_TransparentForMouseEvents);
    return false;
  }
};

/// A structure out of a cut through the middle, in the 3D view alone, grown as it is pulled; the answer is what is
/// drawn over the picture: how far it is out, and what has grown so far.
/// @param longestMs  so long it waits for the whole picture before the hand pulls
inline AnswerTimes dragStructure(MainWindow& window, int moves, int longestMs) {
  window.views().setLayout(scene::Layout::Volume);
  window.document().edit("Add cut", [](scene::Scene& s) {
    scene::Cut cut;
    cut.axis = {0, -1, 0};
    scene::addCut(s, cut);
    s.camera = scene::frameCamera(s, scene::StandardView::Oblique, 1.6);
  });
  window.actions().find("extrusion.pull")->trigger();
  Viewport& view = window.viewport();
  (void)QTest::qWaitFor([&] { return window.isSettled(); }, longestMs);
  PaintCount painted(view);
  return timeDrag(view, moves, [&] { return painted.count; });
}

/// The camera in the 3D view; the answer is its next picture.
inline AnswerTimes dragCamera(MainWindow& window, int moves) {
  Viewport& view = window.viewport();
  return timeDrag(view, moves, [&] { return view.shownCount(); });
}

}  // namespace velum::gui
