#include "gui/rows/PictureList.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyledItemDelegate>
#include <QWheelEvent>
#include <algorithm>

namespace velum::gui {

namespace {

constexpr int kNameHeight = 30, kGap = 6;

enum Role { kName = Qt::UserRole, kPicture };

class PictureDelegate : public QStyledItemDelegate {
 public:
  PictureDelegate(QListView* list, int pictureHeight)
      : QStyledItemDelegate(list), mList(list), mPictureHeight(pictureHeight) {}
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return mList->gridSize(); }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    bool isOn = option.state & QStyle::State_Enabled;
    if (!isOn) painter->setOpacity(0.4);
    QRectF frame(option.rect.x() + kGap / 2.0, option.rect.y() + 2, option.rect.width() - kGap, mPictureHeight);
    QPainterPath shape;
    shape.addRoundedRect(frame, 5, 5);
    // Not of the list, whose own ground the style sheet makes clear.
    painter->fillPath(shape, mList->parentWidget()->palette().color(QPalette::Base));
    auto picture = index.data(kPicture).value<QPixmap>();
    if (!picture.isNull()) {
      painter->setClipPath(shape);
      painter->drawPixmap(frame, picture, sourceOf(picture.size(), frame.size()));
      painter->setClipping(false);
    }
    bool isChosen = option.state & QStyle::State_Selected;
    bool isNear = option.state & (QStyle::State_MouseOver | QStyle::State_HasFocus);
    QColor edge = option.palette.color(isChosen ? QPalette::Link
                                       : isNear ? QPalette::PlaceholderText
                                                : QPalette::Button);
    painter->setPen(QPen(edge, isChosen ? 2.0 : 1.0));
    painter->drawPath(shape);
    painter->setPen(option.palette.color(isChosen ? QPalette::Text : QPalette::PlaceholderText));
    QFont small = option.font;
    small.setPointSizeF(small.pointSizeF() * 0.86);
    painter->setFont(small);
    QRectF text(option.rect.x() - 1, frame.bottom() + 2, option.rect.width() + 2, kNameHeight - 4);
    painter->drawText(text, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, index.data().toString());
    painter->restore();
  }

 private:
  /// The middle of a picture, in the shape of its frame.
  static QRectF sourceOf(QSizeF picture, QSizeF frame) {
    QSizeF part = frame.scaled(picture, Qt::KeepAspectRatio);
    return {QPointF(picture.width() - part.width(), picture.height() - part.height()) / 2.0, part};
  }
  QListView* mList;
  int mPictureHeight;
};

}  // namespace

QImage toQImage(const Image& image) {
  std::size_t channels = image.channels.size(), shown = std::min<std::size_t>(channels, 4);
  QImage out(image.width, image.height, shown == 4 ? QImage::Format_RGBA8888 : QImage::Format_RGB888);
  for (int y = 0; y < image.height; ++y) {
    uchar* row = out.scanLine(y);
    const float* in = &image.pixels[std::size_t(y) * std::size_t(image.width) * channels];
    for (int x = 0; x < image.width; ++x, in += channels, row += shown)
      for (std::size_t c = 0; c < shown; ++c) row[c] = uchar(std::lround(255.0f * std::clamp(in[c], 0.0f, 1.0f)));
  }
  return out;
}

PictureList::PictureList(int columns, int pictureHeight, QWidget* parent)
    : QListWidget(parent), mColumns(columns), mPictureHeight(pictureHeight) {
  setProperty("role", "pictures");
  setItemDelegate(new PictureDelegate(this, pictureHeight));
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setUniformItemSizes(true);
  setSpacing(0);
  setFrameShape(QFrame::NoFrame);
  setMouseTracking(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto tell = [this](QListWidgetItem* item) { emit chosen(item->data(kName).toString()); };
  connect(this, &QListWidget::itemClicked, this, tell);
  connect(this, &QListWidget::itemActivated, this, tell);
}

void PictureList::add(const QString& name, const QString& title, const QString& tip, const QPixmap& picture) {
  auto* item = new QListWidgetItem(title, this);
  item->setData(kName, name);
  item->setData(kPicture, picture);
  item->setToolTip(tip);
}

QListWidgetItem* PictureList::find(const QString& name) const {
  for (int i = 0; i < count(); ++i)
    if (item(i)->data(kName).toString() == name) return item(i);
  return nullptr;
}

void PictureList::setPicture(const QString& name, const QPixmap& picture) {
  if (QListWidgetItem* found = find(name)) found->setData(kPicture, picture);
}

QStringList PictureList::names() const {
  QStringList names;
  for (int i = 0; i < count(); ++i) names << item(i)->data(kName).toString();
  return names;
}

QList<std::pair<QString, QString>> PictureList::titles() const {
  QList<std::pair<QString, QString>> titles;
  for (int i = 0; i < count(); ++i) titles.emplaceBack(item(i)->data(kName).toString(), item(i)->text());
  return titles;
}

void PictureList::mark(const QString& name) {
  QListWidgetItem* now = find(name);
  if (now == currentItem() && (!now || now->isSelected())) return;
  setCurrentItem(now);
  if (!now) clearSelection();
}

void PictureList::fit(int width) {
  int rows = (count() + mColumns - 1) / mColumns;
  setGridSize({std::max(40, (width - 1) / mColumns), mPictureHeight + kNameHeight});
  setFixedHeight(rows * (mPictureHeight + kNameHeight) + 2);
}

QSize PictureList::pictureSize() const {
  double ratio = devicePixelRatioF();
  return {int(ratio * (gridSize().width() - kGap)), int(ratio * mPictureHeight)};
}

bool PictureList::event(QEvent* event) {
  // The window has another use for Space.
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space)
    event->accept();
  return QListWidget::event(event);
}

void PictureList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && currentItem()) {
    emit itemActivated(currentItem());
    return;
  }
  QListWidget::keyPressEvent(event);
}

void PictureList::wheelEvent(QWheelEvent* event) { event->ignore(); }  // the panel scrolls

}  // namespace velum::gui
