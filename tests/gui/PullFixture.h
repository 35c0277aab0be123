#pragma once
#include <QImage>
#include <QListWidget>
#include <QPushButton>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <vector>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/extrusion/PullTool.h"
#include "scene/SectionPlane.h"
#include "session/extrusion/Extrusion.h"
#include "session/growth/Growths.h"

namespace velum::gui {

/// Values by a function of the voxel and the time step; voxels of 1 mm.
template <class Value>
void writeSeries(const std::filesystem::path& path, int edge, int timeSteps, Value&& valueAt) {
  Volume volume;
  volume.dims = glm::ivec3(edge);
  volume.timeSteps = timeSteps;
  volume.type = SampleType::UInt8;
  volume.voxels.resize(timeStepBytes(volume) * std::size_t(timeSteps));
  auto* values = volume.voxels.data();
  for (int t = 0; t < timeSteps; ++t)
    for (int z = 0; z < edge; ++z)
      for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) *values++ = std::byte(valueAt(x, y, z, t));
  Progress progress;
  io::writeVolume(volume, path, progress);
}

template <class Value>
void writeVoxels(const std::filesystem::path& path, int edge, Value&& valueAt) {
  writeSeries(path, edge, 1, [&](int x, int y, int z, int) { return valueAt(x, y, z); });
}

/// The pull tool in the real window, driven by real events.
class PullFixture : public Window {
 protected:
  /// A place of the picture, and what is seen there.
  struct Seen {
    QPoint pixel;
    render::Pick pick;
  };

  void SetUp() override {
    Window::SetUp();
    mWindow->resize(900, 640);
  }
  session::Document& document() { return mWindow->document(); }
  const session::GrowthWorker& growth() { return mWindow->session().growth(); }
  const scene::Cut& cut(int place = 0) { return scene().cuts[std::size_t(place)]; }
  /// Nothing when it is not up.
  PullTool* tool() { return dynamic_cast<PullTool*>(mWindow->toolbox().active()); }

  void open(const QStringList& files) {
    mWindow->openPaths(files);
    ASSERT_TRUE(waitForJob());
    ASSERT_TRUE(scene().volume.data);
    drawSoon();
  }
  void press(const char* key) {
    viewport().setFocus();
    QTest::keySequence(&viewport(), QKeySequence(QString(key), QKeySequence::PortableText));
  }
  void takeUp() {
    press("U");
    ASSERT_TRUE(tool());
    ASSERT_TRUE(settle());
  }
  /// Bright material with a plane that removes what lies before it, seen obliquely, and the tool up.
  void openCut(const QString& file, glm::dvec3 centre) {
    open({file});
    document().edit("Look", [&](scene::Scene& s) {
      s.volume.transfer.opacities = {{60, 0}, {80, 1}, {255, 1}};
      scene::Cut cut;
      cut.axis = {0, -1, 0};
      cut.centre = centre;
      scene::addCut(s, cut);
      s.camera = scene::frameCamera(s, scene::StandardView::Oblique, 1.0);
    });
    takeUp();
  }
  void clickButton(const char* name) {
    auto* button = child<QPushButton>(name);
    ASSERT_TRUE(button && button->isVisible());
    QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_TRUE(settle());
  }
  /// Alt and the wheel, a notch at a time.
  void turnWheel(int notches, Qt::KeyboardModifiers keys = Qt::AltModifier) {
    QPointF middle = viewport().rect().center();
    for (int i = 0; i < std::abs(notches); ++i) {
      int turn = notches > 0 ? 120 : -120;  // with Alt, Qt takes it for a sideways one
      QPoint angle = keys & Qt::AltModifier ? QPoint(turn, 0) : QPoint(0, turn);
      QWheelEvent event(middle, viewport().mapToGlobal(middle), {}, angle, Qt::NoButton, keys, Qt::NoScrollPhase,
                        false);
      QApplication::sendEvent(&viewport(), &event);
    }
  }
  QPoint pixelOf(glm::dvec3 world) {
    auto pixel = scene::pixelFromWorld(scene().camera, size(), world);
    return pixel ? QPoint(int(std::lround(pixel->x)), int(std::lround(pixel->y))) : QPoint();
  }
  /// QTest's own moves come when the display sends them.
  void hover(QPoint pixel) {
    QMouseEvent move(QEvent::MouseMove, QPointF(pixel), viewport().mapToGlobal(QPointF(pixel)), Qt::NoButton,
                     Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&viewport(), &move);
  }
  /// From a place so far out of a cut.
  void pull(QPoint pixel, glm::dvec3 world, const scene::Cut& from, double distance) {
    drag(pixel, pixel + pixelOf(world + distance * session::pullDirection(from, world)) - pixelOf(world));
  }
  /// What hits are on a grid over the whole picture.
  std::vector<Seen> look(int step = 6) {
    std::vector<Seen> seen;
    for (int y = step / 2; y < viewport().height(); y += step)
      for (int x = step / 2; x < viewport().width(); x += step)
        if (auto pick = viewport().pickAt(QPointF(x, y)); pick && pick->hit) seen.push_back({{x, y}, *pick});
    return seen;
  }
  /// A sample lies so far off a face at most.
  double slack() { return 1.5 * scene::sectionStep(scene()); }
  /// How deep a place lies in what planes that are joined remove.
  double depthOf(glm::dvec3 world) {
    double depth = 1e30;
    for (const auto& one : scene().cuts) depth = std::min(depth, session::depthInCut(one, world));
    return depth;
  }
  /// Cut there, not only near it, and well away from other planes' faces.
  bool isOnFace(const Seen& seen, const scene::Cut& of) {
    glm::dvec3 place = seen.pick.world;
    bool isCut = glm::dot(glm::dvec3(seen.pick.normal), session::pullDirection(of, place)) > 0.98;
    return isCut && std::abs(session::depthInCut(of, place)) <= 0.25 * scene::sectionStep(scene()) &&
           std::all_of(scene().cuts.begin(), scene().cuts.end(), [&](const scene::Cut& other) {
             return other.id == of.id || session::depthInCut(other, place) > 2.0 * slack();
           });
  }
  /// As it is on the screen, with all that is painted over it.
  QImage shot() { return viewport().grab().toImage().convertToFormat(QImage::Format_RGB32); }
  std::size_t voxelsOf(int structure, const std::function<bool(glm::dvec3)>& where = {}) {
    const auto& labels = scene().labels.data;
    std::size_t count = 0;
    if (!labels) return 0;
    glm::ivec3 dims = labels->dims();
    glm::dmat4 worldFromVoxel = labels->worldFromVoxel();
    for (glm::ivec3 v(0); v.z < dims.z; ++v.z)
      for (v.y = 0; v.y < dims.y; ++v.y)
        for (v.x = 0; v.x < dims.x; ++v.x)
          if (labels->at(v) == structure) count += !where || where(glm::dvec3(worldFromVoxel * glm::dvec4(v, 1.0)));
    return count;
  }
};

}  // namespace velum::gui
