#pragma once
#include <QVariantAnimation>

#include "session/document/Document.h"

namespace velum::gui {

/// Moves the camera to another place in a short animation. If the user moves the camera meanwhile the flight ends.
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
