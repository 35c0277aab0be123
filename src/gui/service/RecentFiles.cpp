#include "gui/service/RecentFiles.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QProxyStyle>
#include <QVBoxLayout>

#include "core/Error.h"
#include "gui/service/SaveImage.h"
#include "gui/service/SayTime.h"

namespace velum::gui {

namespace {

constexpr int kMostCards = 6, kMenuRows = 12, kGap = 14;
constexpr QSize kStored{416, 260}, kMenuPicture{44, 44};

QString toText(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

QString nameOf(const session::RecentFile& file) { return QFileInfo(toText(file.path)).fileName(); }

/// The folder, with the home folder as ~.
QString placeOf(const session::RecentFile& file) {
  QString folder = QFileInfo(toText(file.path)).path(), home = QDir::homePath();
  return folder.startsWith(home) ? "~" + folder.mid(home.size()) : folder;
}

/// The middle of a picture, scaled to fill a size.
QImage cutTo(const QImage& image, QSize size) {
  QImage scaled = image.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  QPoint corner((scaled.width() - size.width()) / 2, (scaled.height() - size.height()) / 2);
  return scaled.copy(QRect(corner, size));
}

/// A menu's icons as large as its pictures; a style sheet cannot say it.
class PictureMenuStyle : public QProxyStyle {
 public:
  PictureMenuStyle() : QProxyStyle("Fusion") {}
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    return metric == PM_SmallIconSize ? kMenuPicture.width() : QProxyStyle::pixelMetric(metric, option, widget);
  }
};

}  // namespace

QPixmap recentPixmap(const std::filesystem::path& file, QSize logicalSize, double pixelRatio) {
  QImage image(toText(session::recentPicture(file)));
  if (image.isNull()) return {};
  QPixmap pixmap = QPixmap::fromImage(cutTo(image, logicalSize * pixelRatio));
  pixmap.setDevicePixelRatio(pixelRatio);
  return pixmap;
}

void saveRecentPicture(const std::filesystem::path& file, const QImage& image) {
  if (image.isNull()) return;
  QString path = toText(session::recentPicture(file));
  QDir().mkpath(QFileInfo(path).path());
  try {
    saveImage(cutTo(image.convertToFormat(QImage::Format_RGB32), kStored), path.toStdString());
  } catch (const Error&) {
    // A card without a picture is no loss.
  }
}

// A card.

RecentCard::RecentCard(const session::RecentFile& file, QWidget* parent)
    : PictureCard(nameOf(file), placeOf(file), recentPixmap(file.path, kPicture, parent->devicePixelRatioF()), parent),
      mFile(file) {
  setAccessibleName(tr("Open %1").arg(nameOf(file)));
  setToolTip(tr("Open %1\n%2").arg(toText(file.path), sayTime(file.when)));
}

// The row.

RecentRow::RecentRow(QWidget* parent) : QWidget(parent), mRow(new QWidget(this)) {
  setObjectName("recentRow");
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // what does not fit is not shown
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(24, 26, 24, 0);
  layout->setSpacing(10);
  auto* title = new QLabel(tr("Recent"), this);
  title->setProperty("role", "muted");
  layout->addWidget(title, 0, Qt::AlignHCenter);
  auto* row = new QHBoxLayout(mRow);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGap);
  row->setAlignment(Qt::AlignHCenter);
  layout->addWidget(mRow);
  hide();
}

void RecentRow::refresh() {
  qDeleteAll(mCards);
  mCards.clear();
  for (const auto& file : session::readRecent(session::recentList())) {
    if (mCards.size() == kMostCards) break;
    if (QFileInfo::exists(toText(file.path))) addCard(file);
  }
  setVisible(!mCards.isEmpty());
  placeCards();
}

void RecentRow::addCard(const session::RecentFile& file) {
  auto* card = new RecentCard(file, mRow);
  card->setContextMenuPolicy(Qt::CustomContextMenu);
  mRow->layout()->addWidget(card);
  mCards << card;
  connect(card, &RecentCard::clicked, this, [this, card] { emit chosen(toText(card->path())); });
  connect(card, &QWidget::customContextMenuRequested, this, [this, card](QPoint where) { askRemove(card, where); });
}

void RecentRow::askRemove(RecentCard* card, QPoint where) {
  QMenu menu(this);
  QAction* remove = menu.addAction(tr("Remove from this list"));
  if (menu.exec(card->mapToGlobal(where)) != remove) return;
  session::removeRecent(session::recentList(), card->path());
  QMetaObject::invokeMethod(this, &RecentRow::refresh, Qt::QueuedConnection);
}

void RecentRow::placeCards() {
  int room = (width() - 48 + kGap) / (PictureCard::size().width() + kGap);
  for (int i = 0; i < mCards.size(); ++i) mCards[i]->setVisible(i < std::max(1, room));
}

void RecentRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeCards();
}

void RecentRow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  placeCards();
}

void keepRecentMenu(QMenu* menu, std::function<void(const QString&)> open) {
  auto* style = new PictureMenuStyle;
  style->setParent(menu);
  menu->setStyle(style);
  menu->setToolTipsVisible(true);
  QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, open = std::move(open)] {
    menu->clear();
    for (const auto& file : session::readRecent(session::recentList())) {
      if (menu->actions().size() == kMenuRows) break;
      QString path = toText(file.path);
      if (!QFileInfo::exists(path)) continue;
      QAction* action = menu->addAction(nameOf(file).replace('&', "&&") + "\t" + sayTime(file.when));
      action->setIcon(QIcon(recentPixmap(file.path, kMenuPicture, menu->devicePixelRatioF())));
      action->setToolTip(path);
      QObject::connect(action, &QAction::triggered, menu, [open, path] { open(path); });
    }
    if (menu->isEmpty()) menu->addAction(RecentRow::tr("Nothing yet"))->setEnabled(false);
  });
}

}  // namespace velum::gui
