#include "gui/rows/PictureCard.h"

#include <QIcon>
#include <QPainter>
#include <QPainterPath>

namespace velum::gui {

namespace {

constexpr int kPadding = 7, kRadius = 7;

}  // namespace

PictureCard::PictureCard(const QString& title, const QString& line, const QPixmap& picture, QWidget* parent)
    : QAbstractButton(parent), mLine(line), mPicture(picture) {
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setText(title);
  setFixedSize(sizeHint());
}

QSize PictureCard::size() { return kPicture + QSize(2 * kPadding, 3 * kPadding); }

QSize PictureCard::sizeHint() const { return size() + QSize(0, 2 * fontMetrics().height()); }

void PictureCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPalette& colors = palette();
  bool lit = underMouse() || hasFocus();
  painter.setPen(QPen(hasFocus() ? colors.color(QPalette::Link) : colors.color(QPalette::Button), hasFocus() ? 2 : 1));
  painter.setBrush(isDown() || !lit ? colors.color(QPalette::Window) : colors.color(QPalette::Button));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), kRadius, kRadius);
  QRect picture(QPoint(kPadding, kPadding), kPicture);
  QPainterPath outline;
  outline.addRoundedRect(picture, kRadius - 3, kRadius - 3);
  painter.save();
  painter.setClipPath(outline);
  if (mPicture.isNull()) {
    painter.fillRect(picture, colors.color(QPalette::Base));
    QRect middle(0, 0, 56, 56);
    middle.moveCenter(picture.center());
    QIcon(":/velum/velum.svg").paint(&painter, middle, Qt::AlignCenter, QIcon::Disabled);
  } else {
    painter.drawPixmap(picture, mPicture);
  }
  painter.restore();
  QFontMetrics metrics = fontMetrics();
  QRect line(kPadding + 2, picture.bottom() + kPadding, kPicture.width() - 4, metrics.height());
  painter.setPen(colors.color(QPalette::Text));
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, metrics.elidedText(text(), Qt::ElideMiddle, line.width()));
  line.translate(0, metrics.height());
  painter.setPen(colors.color(QPalette::PlaceholderText));
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, metrics.elidedText(mLine, Qt::ElideMiddle, line.width()));
}

}  // namespace velum::gui
