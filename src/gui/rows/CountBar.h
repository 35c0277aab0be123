#pragma once
#include <QPainter>
#include <QStyleOptionViewItem>
#include <array>

#include "core/Counts.h"
#include "gui/rows/BarScale.h"

namespace velum::gui {

/// A stacked bar of a row ([VE] 7), of the parts of kCountKinds; with knobs that can be dragged, at the end of the part
/// that is seen and at the end of the parts that cuts leave.
struct CountBar {
  QRectF box;                                     ///< of the whole ruler; empty: nothing is known of the row
  std::array<double, kCountKinds.size()> ends{};  ///< where the parts end, pixels from the box's left end
  double seen = 0.0, left = 0.0;                  ///< where the parts that are seen end, and those that cuts leave

  /// The number at a place of the widget.
  double countAt(double x, const BarScale& scale, double total) const {
    return box.isEmpty() ? 0.0 : scale.count((x - box.left()) / box.width(), total);
  }
};

/// @param cell  that the bar lies in
CountBar layCountBar(QRect cell, const BarScale& scale, const Counts& counts);
/// The title of a column of such bars: "Seen, hidden, removed".
QString countTitle();
/// The colour of a kind's part of a bar, in both themes.
QColor countColor(CountOf kind);
/// Where the box of a bar lies in its cell.
QRectF countBarBox(QRect cell);
/// @param hasSeenKnob  the bar has a second knob, by which the number that is seen is dragged
void paintCountBar(QPainter& painter, const QStyleOptionViewItem& option, const CountBar& bar, bool hasSeenKnob);
/// The ruler over bars: percent from 0 to 100, or powers of ten as far as they have room.
void paintBarRuler(QPainter& painter, QRect cell, const BarScale& scale);

}  // namespace velum::gui
