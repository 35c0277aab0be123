#pragma once
#include <QPainter>
#include <QStyleOptionViewItem>
#include <array>

#include "core/Counts.h"
#include "gui/rows/BarScale.h"

namespace velum::gui {

/// A stacked bar of a row ([VE] 7), of the parts of kCountKinds; with knobs that can be dragged at the end of what is
/// seen, and of what is left.
struct CountBar {
  QRectF box;                                     ///< of the whole ruler; empty: nothing is known of the row
  std::array<double, kCountKinds.size()> ends{};  ///< where the parts end, pixels from the box's left end
  double seen = 0.0, left = 0.0;                  ///< where those end that are seen, and those that are left

  /// The number at a place of the widget.
  double countAt(double x, const BarScale& scale, double total) const {
    return box.isEmpty() ? 0.0 : scale.count((x - box.left()) / box.width(), total);
  }
};

/// @param cell  that the bar lies in
CountBar layCountBar(QRect cell, const BarScale& scale, const Counts& counts);
/// The title of their column: "Seen, hidden, removed".
QString countTitle();
/// Where rulers of bars in cells of a column lie.
QRectF countBarBox(QRect cell);
/// @param hasSeenKnob  how much is seen can be dragged, too
void paintCountBar(QPainter& painter, const QStyleOptionViewItem& option, const CountBar& bar, bool hasSeenKnob);
/// The ruler over bars: percent from 0 to 100, or powers of ten as far as they have room.
void paintBarRuler(QPainter& painter, QRect cell, const BarScale& scale);

}  // namespace velum::gui
