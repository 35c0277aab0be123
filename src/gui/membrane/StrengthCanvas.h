#pragma once
#include <QColor>

#include "gui/kit/CurveCanvas.h"
#include "scene/Membrane.h"

namespace velum::gui {

/// The signs of forces wherever they are drawn: what the sheet keeps whole, what draws it, what it is let through.
inline const QColor kKeepColor(0xf0, 0x86, 0x5c), kDrawColor(0x6c, 0xa6, 0xe4), kAvoidColor(0x9c, 0xae, 0xc2);

using StrengthCurve = std::vector<scene::StrengthPoint>;

/// As far as forces of a membrane go, to either side of 0.
double mostStrength();

/// The signed curve from values to forces over a histogram, and the hand on its points: above the line what the sheet
/// leaves whole, below it what draws the sheet. It changes nothing itself: it says what the curve would become.
class StrengthCanvas : public CurveCanvas {
  Q_OBJECT
 public:
  explicit StrengthCanvas(QWidget* parent);

  void setCurve(const StrengthCurve& curve);
  void setHistogram(const Histogram& histogram, session::AxisView view);

  /// Where a point is, widget pixels; for tests.
  QPointF placeOf(scene::StrengthPoint point) const;
  int selected() const { return mSelected; }

 signals:
  /// @param merge  part of a drag, which ends with settled()
  void edited(const QString& label, const std::vector<velum::scene::StrengthPoint>& next, bool merge);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  bool isOwnKey(int key) const override;
  void step(int sideways, int up, bool wide) override;
  void selectNext(int by) override;
  void addBeside() override;
  void removeSelected() override;

 private:
  scene::StrengthPoint pointAt(QPointF place) const;
  int hit(QPointF place) const;
  void addAt(QPointF place);
  void moveSelected(scene::StrengthPoint to, const StrengthCurve& start, bool merge);
  void paintPlot(QPainter& painter) const;

  StrengthCurve mCurve, mStart;
  int mSelected = -1;
  bool mDragging = false;
};

}  // namespace velum::gui
