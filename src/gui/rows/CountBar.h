#pragma once
#include <QPainter>
#include <QStyleOptionViewItem>

#include "gui/rows/BarScale.h"

namespace velum::gui {

/// A stacked bar of a row ([VE] 7): what is seen, what is there but hidden, what is removed; with a knob at the end of
/// each of the first two that can be dragged.
struct CountBar {
  QRectF box;                                ///< of the whole ruler; empty: nothing is known of the row
  double seen = 0.0, left = 0.0, all = 0.0;  ///< where the parts end, pixels from the box's left end

  /// The number at a place of the widget.
  double countAt(double x, const BarScale& scale, double total) const {
    return box.isEmpty() ? 0.0 : scale.count((x - box.left()) / box.width(), total);
  }
};

/// @param cell  that the bar lies in  @param left  seen or hidden
CountBar layCountBar(QRect cell, const BarScale& scale, double seen, double left, double total);
/// Where rulers of bars in cells of a column lie.
QRectF countBarBox(QRect cell);
/// @param hasSeenKnob  how much is seen can be dragged, too
void paintCountBar(QPainter& painter, const QStyleOptionViewItem& option, const CountBar& bar, bool hasSeenKnob);
/// The ruler over bars: percent from 0 to 100, or powers of ten as far as they have room.
void paintBarRuler(QPainter& painter, QRect cell, const BarScale& scale);

}  // namespace velum::gui
