#pragma once
#include <QPainter>
#include <QStyledItemDelegate>
#include <QToolButton>

namespace velum::gui {

/// Small signs in the rows of lists. They are drawn rather than loaded, so that they are sharp at any scale and have
/// the palette's colours.

/// Paints an eye; where it is not open, a line.
void paintEye(QPainter& painter, const QRectF& box, const QColor& color, bool open);
/// Lines, as a path of SVG with a blank between its parts: M x y, L x y, C x y x y x y, Z; O x y w h is an ellipse
/// about x, y of half sizes w, h; U x y w h the lower half of such an ellipse. Coordinates count from the middle of the
/// box, y down.
void paintIcon(QPainter& painter, const QRectF& box, const QColor& color, const char* lines);
void paintSwatch(QPainter& painter, const QRectF& box, const QColor& color, const QColor& line);
/// Paints the ground of a row that is selected or under the pointer; nothing for other rows.
void paintRowGround(QPainter& painter, const QStyleOptionViewItem& option, bool isFirst, bool isLast);

/// A checkable button that is an eye.
class EyeButton : public QToolButton {
  Q_OBJECT
 public:
  explicit EyeButton(QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// Text colour of a row. @param isStrong  false: the row is hidden or of less weight
QColor rowTextColor(const QStyleOptionViewItem& option, bool isStrong);

}  // namespace velum::gui
