// How soon the window's section views answer while it computes. In a child: a window wants an application of its own.
// Before Qt, whose word `emit` it would stumble over.

#include <QApplication>
#include <QStandardPaths>
#include <QSurfaceFormat>

#include "Child.h"
#include "DragSection.h"
#include "gui/kit/Theme.h"

namespace velum::bench {

namespace {

nlohmann::json figuresOf(const gui::AnswerTimes& times) {
  return {{"medianMs", times.median()}, {"most90Ms", times.ms[times.ms.size() * 9 / 10]}, {"worstMs", times.worst()}};
}

}  // namespace

nlohmann::json childAnswers(int size) {
  QStandardPaths::setTestModeEnabled(true);
  QSurfaceFormat format;
  format.setVersion(4, 5);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QSurfaceFormat::setDefaultFormat(format);
  int count = 1;
  char name[] = "velum-bench", *words[] = {name, nullptr};
  QApplication application(count, words);
  gui::applyTheme(application);
  gui::MainWindow window;
  window.show();
  gui::showFourViews(window, gui::makeNestedShells(size));
  constexpr int kMoves = 90;
  nlohmann::json figures;
  figures["while the volume goes to the driver"] = figuresOf(gui::dragCrosshair(window, kMoves));
  (void)QTest::qWaitFor([&] { return window.viewport().stats().samples > 0; }, 120000);
  figures["while the 3D view refines"] = figuresOf(gui::dragCrosshair(window, kMoves));
  figures["the 3D view itself, turned while it refines"] = figuresOf(gui::dragCamera(window, kMoves));
  {
    gui::Job job(gui::holdEveryCore(), nullptr);
    job.start();
    figures["and a job holds every core"] = figuresOf(gui::dragCrosshair(window, kMoves));
  }
  (void)QTest::qWaitFor([&] { return window.isSettled(); }, 120000);
  figures["at rest"] = figuresOf(gui::dragCrosshair(window, kMoves));
  figures["a structure pulled out of a cut, grown as it comes"] = figuresOf(gui::dragStructure(window, kMoves, 120000));
  return figures;
}

}  // namespace velum::bench
