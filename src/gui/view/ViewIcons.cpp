#include "ViewIcons.h"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>

namespace velum::gui {

namespace {

class ViewIconEngine : public QIconEngine {
 public:
  ViewIconEngine(ViewIcon icon, const QColor& color) : mIcon(icon), mColor(color) {}

  QIconEngine* clone() const override { return new ViewIconEngine(*this); }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return pixmap;
  }
  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    QColor color = mColor.isValid() ? mColor
                                    : QApplication::palette().color(group, state == QIcon::On && mode != QIcon::Disabled
                                                                               ? QPalette::HighlightedText
                                                                               : QPalette::ButtonText);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.topLeft());
    painter->scale(rect.width() / 16.0, rect.height() / 16.0);
    painter->setPen(QPen(color, 1.3));
    draw(*painter, color);
    painter->restore();
  }

 private:
  void draw(QPainter& p, const QColor& color) const {
    QRectF frame(1.5, 2.5, 13, 11);
    QColor soft = color;
    soft.setAlpha(90);
    auto line = [&](double x0, double y0, double x1, double y1) { p.drawLine(QPointF(x0, y0), QPointF(x1, y1)); };
    switch (mIcon) {
      case ViewIcon::FourUp:
        p.fillRect(QRectF(8, 2.5, 6.5, 5.5), soft);
        p.drawRect(frame);
        line(8, 2.5, 8, 13.5);
        line(1.5, 8, 14.5, 8);
        break;
      case ViewIcon::Volume:
        p.fillRect(frame, soft);
        p.drawRect(frame);
        break;
      case ViewIcon::VolumeAndSection:
        p.fillRect(QRectF(1.5, 2.5, 7.5, 11), soft);
        p.drawRect(frame);
        line(9, 2.5, 9, 13.5);
        break;
      case ViewIcon::Section:
        p.drawRect(frame);
        line(8, 4.5, 8, 11.5);
        line(4, 8, 12, 8);
        break;
      case ViewIcon::Maximise:
        p.drawPolyline(QPolygonF({{3, 6.5}, {3, 3}, {6.5, 3}}));
        p.drawPolyline(QPolygonF({{13, 9.5}, {13, 13}, {9.5, 13}}));
        line(3, 3, 6.8, 6.8);
        line(13, 13, 9.2, 9.2);
        break;
      case ViewIcon::Restore:
        p.drawPolyline(QPolygonF({{7, 3.5}, {7, 7}, {3.5, 7}}));
        p.drawPolyline(QPolygonF({{9, 12.5}, {9, 9}, {12.5, 9}}));
        line(7, 7, 3, 3);
        line(9, 9, 13, 13);
        break;
      case ViewIcon::Menu:
        p.setBrush(color);
        p.setPen(Qt::NoPen);
        for (double y : {3.5, 8.0, 12.5}) p.drawEllipse(QPointF(8, y), 1.4, 1.4);
        break;
    }
  }

  ViewIcon mIcon;
  QColor mColor;
};

}  // namespace

QIcon makeViewIcon(ViewIcon icon, const QColor& color) { return QIcon(new ViewIconEngine(icon, color)); }

}  // namespace velum::gui
