#include "gui/view/CameraFlight.h"

#include "scene/Navigate.h"

namespace velum::gui {

namespace {
constexpr int kFlightMs = 320;
}  // namespace

CameraFlight::CameraFlight(session::Document& document, QObject* parent) : QObject(parent), mDocument(document) {
  mWay.setDuration(kFlightMs);
  mWay.setStartValue(0.0);
  mWay.setEndValue(1.0);
  mWay.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&mWay, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
    if (!(mDocument.shown().camera == mLast)) return mWay.stop();
    scene::Camera camera = mLast = scene::between(mFrom, mTo, value.toDouble());
    mDocument.view([camera](scene::Scene& scene) { scene.camera = camera; });
  });
}

void CameraFlight::start(const scene::Camera& to) {
  mWay.stop();
  mFrom = mLast = mDocument.shown().camera;
  mTo = to;
  mWay.start();
}

}  // namespace velum::gui
