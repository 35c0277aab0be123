#include "gui/timeline/CameraPath.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/kit/Theme.h"
#include "gui/tool/HandlePaint.h"
#include "scene/Navigate.h"
#include "scene/Project.h"
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"
#include "session/command/Command.h"

namespace velum::gui {

namespace {

constexpr int kPathPoints = 240;
constexpr double kKnobReach = 10.0;  ///< pixels
constexpr const char* kCameraPath = "camera";

bool movesEye(const scene::Track& track) {
  bool isCamera = track.path == kCameraPath || track.path.starts_with("camera.");
  return track.enabled && !track.keys.empty() && (isCamera || track.path == scene::kOrbitPath);
}

/// A scene with nothing but what moves the eye: asking it for a time costs little.
scene::Scene eyeAlone(const scene::Scene& scene) {
  scene::Scene alone;
  alone.camera = scene.camera;
  alone.timeline = scene.timeline;
  std::erase_if(alone.timeline.tracks, [](const scene::Track& track) { return !movesEye(track); });
  return alone;
}

/// Lines through what is before the eye.
QPainterPath seenPath(const session::ViewSpace& space, const std::vector<glm::dvec3>& places) {
  QPainterPath path;
  bool isDown = false;
  for (glm::dvec3 place : places) {
    auto pixel = space.pixelFromWorld(place);
    if (pixel) isDown ? path.lineTo(pixel->x, pixel->y) : path.moveTo(pixel->x, pixel->y);
    isDown = pixel.has_value();
  }
  return path;
}

}  // namespace

CameraPath::CameraPath(session::Document& document, Toolbox& toolbox, std::function<bool()> isOpen)
    : mDocument(document), mToolbox(toolbox), mIsOpen(std::move(isOpen)) {}

void CameraPath::refresh() {
  scene::Scene alone = eyeAlone(mDocument.scene());
  bool hasPath = mIsOpen() && !alone.timeline.tracks.empty();
  auto playhead = mDocument.playhead();
  bool wasShown = mIsShown;
  mIsShown = hasPath && (!playhead || !(scene::sceneAt(alone, *playhead).camera == mDocument.shown().camera));
  if (mIsShown || wasShown) mToolbox.repaint();
  if (!mIsShown) return;
  if (mTracks == alone.timeline.tracks && mCamera == alone.camera && mDuration == alone.timeline.duration) return;
  mTracks = alone.timeline.tracks;
  mCamera = alone.camera;
  mDuration = alone.timeline.duration;
  mStops.clear();
  mKnobs.clear();
  for (int i = 0; i <= kPathPoints; ++i) {
    double time = mDuration * i / kPathPoints;
    mStops.push_back({time, scene::sceneAt(alone, time).camera, false});
  }
  for (const scene::Track& track : mTracks)
    for (const scene::Key& key : track.keys)
      mKnobs.push_back({key.time, scene::sceneAt(alone, key.time).camera, track.path == kCameraPath});
  std::ranges::stable_sort(mKnobs, {}, &Stop::time);
}

std::vector<glm::dvec3> CameraPath::keyEyes() const {
  std::vector<glm::dvec3> eyes;
  for (const Stop& knob : mKnobs)
    if (knob.isKey) eyes.push_back(knob.camera.eye);
  return eyes;
}

int CameraPath::knobUnder(const ViewPoint& at) const {
  if (!mIsShown || at.isOnSection()) return -1;
  int best = -1;
  double reach = kKnobReach;
  for (std::size_t i = 0; i < mKnobs.size(); ++i) {
    auto pixel = at.space().pixelFromWorld(mKnobs[i].camera.eye);
    if (!mKnobs[i].isKey || !pixel) continue;
    if (double off = glm::length(*pixel - at.pixel()); off < reach) reach = off, best = int(i);
  }
  return best;
}

void CameraPath::setHover(int knob) {
  if (std::exchange(mHover, knob) != knob) mToolbox.repaint();
}

std::optional<Qt::CursorShape> CameraPath::hover(const ViewPoint& at) {
  setHover(knobUnder(at));
  return mHover >= 0 ? std::optional(Qt::SizeAllCursor) : std::nullopt;
}

void CameraPath::leave() { setHover(-1); }

bool CameraPath::press(const PointerEvent& event) {
  int knob = event.button == Qt::LeftButton ? knobUnder(event.at) : -1;
  if (knob < 0) return false;
  mHeld = mHover = knob;
  mStart = mKnobs[std::size_t(knob)].camera;
  mSpace = event.at.space();
  mFrom = event.at.pixel();
  return true;
}

/// The view stays where it is, although the film is another then.
void CameraPath::drag(const PointerEvent& event) {
  if (mHeld < 0) return;
  glm::dvec2 by = (event.at.pixel() - mFrom) * mSpace.lengthPerPixel(mStart.eye);
  scene::CameraBasis basis = scene::cameraBasis(mSpace.camera());
  double time = mKnobs[std::size_t(mHeld)].time;
  scene::Scene valued = mDocument.scene();
  valued.camera = mStart;
  valued.camera.eye += basis.right * by.x - basis.up * by.y;
  if (double orbit = scene::orbitAt(mDocument.scene(), time); orbit != 0.0)
    valued.camera = scene::turntable(valued.camera, -glm::radians(orbit));
  AnyValue value = scene::valueAt(valued, kCameraPath);
  auto set = [&](scene::Scene& scene) { scene::setKey(scene.timeline, kCameraPath, time, value); };
  scene::Camera from = mDocument.shown().camera;
  session::editByHand(mDocument, "Move key of camera", set, true);
  if (mDocument.playhead()) mDocument.view([from](scene::Scene& scene) { scene.camera = from; });
}

void CameraPath::release(const PointerEvent&) {
  if (std::exchange(mHeld, -1) >= 0) mDocument.endMerge();
}

void CameraPath::paint(ViewPainter& over) const {
  if (!mIsShown || over.space.section()) return;
  std::vector<glm::dvec3> eyes, targets;
  for (const Stop& stop : mStops) eyes.push_back(stop.camera.eye), targets.push_back(stop.camera.target);
  over.painter.save();
  over.painter.setOpacity(0.45);
  strokeTwice(over.painter, seenPath(over.space, targets), kAccent, 1.2);
  over.painter.setOpacity(1.0);
  strokeTwice(over.painter, seenPath(over.space, eyes), kHandle, 1.6);
  if (auto playhead = mDocument.playhead()) {
    scene::Camera now = scene::sceneAt(eyeAlone(mDocument.scene()), *playhead).camera;
    over.painter.setOpacity(0.7);
    strokeTwice(over.painter, seenPath(over.space, {now.eye, now.target}), kOverPicture, 1.0);
    over.painter.setOpacity(1.0);
  }
  for (std::size_t i = 0; i < mKnobs.size(); ++i) {
    auto pixel = over.space.pixelFromWorld(mKnobs[i].camera.eye);
    if (!pixel) continue;
    if (mKnobs[i].isKey) {
      drawKnob(over.painter, {pixel->x, pixel->y}, int(i) == mHover || int(i) == mHeld);
    } else {
      over.painter.setPen(QPen(QColor(0, 0, 0, 150), 1.0));
      over.painter.setBrush(kHandle);
      over.painter.drawEllipse(QPointF(pixel->x, pixel->y), 3.0, 3.0);
    }
  }
  over.painter.restore();
}

}  // namespace velum::gui
