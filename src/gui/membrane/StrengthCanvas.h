#pragma once
#include <QColor>

#include "gui/kit/CurveCanvas.h"
#include "scene/Membrane.h"

namespace velum::gui {

/// The colours of forces wherever they are drawn: of tissue that the sheet keeps whole, of tissue that draws the sheet,
/// and of tissue that the sheet may pass through.
inline const QColor kKeepColor(0xf0, 0x86, 0x5c), kDrawColor(0x6c, 0xa6, 0xe4), kAvoidColor(0x9c, 0xae, 0xc2);

using StrengthCurve = std::vector<scene::StrengthPoint>;

/// The largest force of a membrane; forces go from minus that to plus that.
double mostStrength();

/// Shows the signed curve from values to forces over a histogram and lets the user edit its points: values above the
/// line of no force are kept whole by the sheet, values below that line draw the sheet. The canvas changes no data
/// itself: it tells by signals what the curve would become.
class StrengthCanvas : public CurveCanvas {
  Q_OBJECT
 public:
  explicit StrengthCanvas(QWidget* parent);

  void setCurve(const StrengthCurve& curve);
  void setHistogram(const Histogram& histogram, session::AxisView view);

  /// Where a point is, in widget pixels; for tests.
  QPointF placeOf(scene::StrengthPoint point) const;
  int selected() const { return mSelected; }

 signals:
  /// The user has edited the curve, which becomes `next`. @param merge  the edit is part of a drag, which ends with
  /// settled()
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
