#pragma once
#include <QPolygonF>
#include <QWidget>
#include <optional>
#include <vector>

#include "gui/view/CameraFlight.h"
#include "session/document/Document.h"

namespace velum::gui {

/// A cube in the corner of the 3D view that turns with the camera: it shows from where the camera looks, and a click on
/// a face, an edge or a corner flies the camera there. A drag turns the camera. The cube is not part of saved pictures.
class ViewCube : public QWidget {
  Q_OBJECT
 public:
  /// @param view  the 3D view in whose corner the cube stands
  ViewCube(session::Document& document, QWidget& view);

  /// To be called after every change of the document.
  void refresh();
  void setShown(bool shown);
  /// The face, edge or corner of the cube under a place: 1, 0 or -1 along each axis; nothing beside the cube.
  std::optional<glm::ivec3> partAt(QPointF place) const;
  /// The name of a side: "anterior, left"; of a model "front, left"; of a scan whose file does not
  /// say how it lay "-y, +x".
  QString nameOf(glm::ivec3 side) const;

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  /// A cell of a face, as it is seen on the screen; an edge or corner has cells on several faces.
  struct Cell {
    glm::ivec3 side;
    QPolygonF outline;
  };
  std::vector<Cell> cellsOf(glm::ivec3 face) const;
  std::vector<glm::ivec3> facesSeen() const;
  QPointF pointOf(glm::dvec3 place) const;
  void paintFace(QPainter& painter, glm::ivec3 face) const;
  void paintName(QPainter& painter, glm::ivec3 face) const;
  void setHover(std::optional<glm::ivec3> side);
  void place();
  bool hasWords() const;

  session::Document& mDocument;
  QWidget& mView;
  CameraFlight mFlight;
  scene::Camera mCamera;  ///< the camera for which the cube is painted
  QString mFront;         ///< what its front was called then
  bool mIsShown = true;
  std::optional<glm::ivec3> mHover, mPressed;
  QPointF mFrom, mLast;
  bool mIsDragged = false;
};

}  // namespace velum::gui
