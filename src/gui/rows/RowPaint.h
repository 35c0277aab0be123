#pragma once
#include <QPainter>
#include <QStyledItemDelegate>
#include <QToolButton>

namespace velum::gui {

/// Small signs in the rows of lists, drawn rather than loaded: sharp at any scale, in the palette's colours.

/// An eye; closed, a line.
void paintEye(QPainter& painter, const QRectF& box, const QColor& color, bool open);
/// Lines, as a path of SVG with a blank between its parts: M x y, L x y, C x y x y x y, Z; O x y w h is an ellipse
/// about x, y of half sizes w, h; U x y w h its lower half. From the middle of the box, y down.
void paintIcon(QPainter& painter, const QRectF& box, const QColor& color, const char* lines);
void paintSwatch(QPainter& painter, const QRectF& box, const QColor& color, const QColor& line);
/// The ground of a row: selected, under the pointer, or nothing.
void paintRowGround(QPainter& painter, const QStyleOptionViewItem& option, bool isFirst, bool isLast);

/// A checkable button that is an eye.
class EyeButton : public QToolButton {
  Q_OBJECT
 public:
  explicit EyeButton(QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// Text colour of a row. @param isStrong  false: what is hidden or of less weight
QColor rowTextColor(const QStyleOptionViewItem& option, bool isStrong);

}  // namespace velum::gui
