#pragma once
#include <QWidget>
#include <optional>

#include "velum/scene/Membrane.h"

namespace velum::gui {

class SketchTool;
class SliceView;
class Viewport;

/// Strokes over a view: on a slice, the part of each that lies in its plane; in the 3D view, faintly, all of it. And
/// the brush under the pointer. Lies over its view, whose size it follows, and takes no events.
class SketchOverlay : public QWidget {
 public:
  SketchOverlay(const SketchTool& tool, SliceView& view);
  SketchOverlay(const SketchTool& tool, Viewport& view);
  /// Where the brush is; nothing: away.
  void setPointer(std::optional<QPointF> place);

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// A disc of the stroke as the view shows it.
  struct Dab {
    QPointF place;
    double radius = 0;   ///< pixels
    bool joins = false;  ///< to the one before
  };
  SketchOverlay(const SketchTool& tool, QWidget& view, SliceView* slice);
  std::vector<Dab> dabsOf(const scene::Stroke& stroke) const;
  std::optional<Dab> dabAt(glm::dvec3 worldMm, double radiusMm) const;
  void paintStroke(QPainter& painter, const scene::Stroke& stroke, bool isMarked) const;
  double brushRadius() const;

  const SketchTool& mTool;
  SliceView* mSlice = nullptr;  ///< null: over the 3D view
  std::optional<QPointF> mPointer;
};

}  // namespace velum::gui
