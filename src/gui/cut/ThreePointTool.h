#pragma once
#include <QWidget>
#include <glm/glm.hpp>
#include <vector>

#include "velum/render/Renderer.h"
#include "velum/session/document/Document.h"

namespace velum::gui {

class Viewport;

/// Three clicks on what is seen make a plane. Lies over the 3D view, where it draws what was clicked; a drag still
/// turns the view; Esc gives up.
class ThreePointTool : public QWidget {
  Q_OBJECT
 public:
  ThreePointTool(session::Document& document, Viewport& view);

  bool isActive() const { return mActive; }
  const std::vector<glm::dvec3>& points() const { return mPoints; }

 public slots:
  void start();
  void cancel();

 signals:
  /// The plane is there. The tool has ended.
  void made(const velum::scene::Cut& cut);
  void ended();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void takePick(const render::Pick& pick);
  void say(const QString& text);

  session::Document& mDocument;
  Viewport& mView;
  std::vector<glm::dvec3> mPoints;
  QString mText;
  bool mActive = false;
};

}  // namespace velum::gui
