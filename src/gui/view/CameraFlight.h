#pragma once
#include <QVariantAnimation>

#include "session/document/Document.h"

namespace velum::gui {

/// Brings the camera to another place on a short way. A hand that moves it meanwhile has it.
class CameraFlight : public QObject {
  Q_OBJECT
 public:
  CameraFlight(session::Document& document, QObject* parent);
  void start(const scene::Camera& to);
  bool isUnderWay() const { return mWay.state() == QAbstractAnimation::Running; }

 private:
  session::Document& mDocument;
  QVariantAnimation mWay;
  scene::Camera mFrom, mTo, mLast;
};

}  // namespace velum::gui
