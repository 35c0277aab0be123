#include "CameraFlight.h"

#include <cmath>

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
    if (!(mDocument.scene().camera == mLast)) return mWay.stop();
    double t = value.toDouble();
    scene::Camera camera = t >= 1.0 ? mTo : mFrom;
    if (t < 1.0) {
      camera.target = glm::mix(mFrom.target, mTo.target, t);
      camera.eye = glm::mix(mFrom.eye, mTo.eye, t);
      camera.height = std::exp(glm::mix(std::log(mFrom.height), std::log(mTo.height), t));
    }
    mLast = camera;
    mDocument.view([camera](scene::Scene& scene) { scene.camera = camera; });
  });
}

void CameraFlight::start(const scene::Camera& to) {
  mWay.stop();
  mFrom = mLast = mDocument.scene().camera;
  mTo = to;
  mWay.start();
}

}  // namespace velum::gui
