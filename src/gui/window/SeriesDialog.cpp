#include "gui/window/SeriesDialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMutex>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/Error.h"
#include "gui/kit/Text.h"
#include "gui/rows/PictureList.h"

namespace velum::gui {

namespace {

constexpr int kThumbnail = 84;  // pixels

QString titleOf(const session::Series& series) {
  QString times = QString::fromUtf8(" \u00d7 ");
  QString name = series.description.empty() ? SeriesDialog::tr("(no description)") : toText(series.description);
  QString size = SeriesDialog::tr("%n image(s)", nullptr, series.imageCount);
  QString modality = series.modality.empty() ? QString() : toText(series.modality) + ", ";
  QString pixels = QString("%1%2%3").arg(series.size.x).arg(times).arg(series.size.y);
  QString text = name + "\n" + modality + SeriesDialog::tr("%1 of %2").arg(size, pixels);
  if (!series.date.empty()) text += "\n" + toText(series.date);
  if (!series.labels.empty()) text += SeriesDialog::tr("\nwith %n segmentation(s)", nullptr, int(series.labels.size()));
  return text;
}

}  // namespace

/// What the job has drawn.
struct SeriesDialog::Drawn {
  QMutex mutex;
  std::vector<QImage> pictures;
};

SeriesDialog::SeriesDialog(std::vector<session::Series> series, const QString& folder, QWidget* parent)
    : QDialog(parent),
      mSeries(std::move(series)),
      mList(new QListWidget(this)),
      mLabels(new QComboBox(this)),
      mDrawn(std::make_shared<Drawn>()) {
  setWindowTitle(tr("Open %1").arg(folder));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(18, 18, 18, 14);
  layout->setSpacing(10);
  auto* title = new QLabel(tr("%1 holds several series. Which is to be opened?").arg(folder), this);
  if (mSeries.size() == 1) title->setText(tr("%1 holds a series and segmentations of it.").arg(folder));
  title->setWordWrap(true);
  layout->addWidget(title);
  mList->setObjectName("seriesList");
  mList->setAccessibleName(tr("Series"));
  mList->setIconSize(QSize(kThumbnail, kThumbnail));
  mList->setSpacing(3);
  QPixmap empty(kThumbnail, kThumbnail);
  empty.fill(Qt::black);
  for (const auto& one : mSeries) mList->addItem(new QListWidgetItem(QIcon(empty), titleOf(one)));
  mList->setCurrentRow(0);
  mList->setMinimumSize(520, 4 * (kThumbnail + 10));
  layout->addWidget(mList, 1);
  // The segments that go with it.
  auto* row = new QHBoxLayout;
  auto* name = new QLabel(tr("&Segments"), this);
  name->setBuddy(mLabels);
  mLabels->setObjectName("seriesLabels");
  mLabels->setAccessibleName(tr("Segments that are opened with it"));
  row->addWidget(name);
  row->addWidget(mLabels, 1);
  layout->addLayout(row);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  auto* open = new QPushButton(tr("&Open"), buttons);
  open->setProperty("role", "main");
  buttons->addButton(open, QDialogButtonBox::AcceptRole);
  open->setDefault(true);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(mList, &QListWidget::itemActivated, this, &QDialog::accept);
  connect(mList, &QListWidget::currentRowChanged, this, &SeriesDialog::showLabels);
  showLabels();
  drawPictures();
}

int SeriesDialog::row() const { return std::max(0, mList->currentRow()); }

session::SeriesLabels SeriesDialog::labels() const {
  int index = mLabels->currentIndex() - 1;
  return index < 0 ? session::SeriesLabels() : series().labels[std::size_t(index)];
}

void SeriesDialog::showLabels() {
  mLabels->clear();
  mLabels->addItem(tr("None"));
  for (const auto& labels : series().labels) mLabels->addItem(toText(labels.name));
  mLabels->setCurrentIndex(series().labels.empty() ? 0 : 1);
  mLabels->setEnabled(!series().labels.empty());
}

/// One by one; one that cannot be read stays black.
void SeriesDialog::drawPictures() {
  int pixels = int(kThumbnail * devicePixelRatioF());
  mJob = new Job(
      [series = mSeries, drawn = mDrawn, pixels](Progress& progress) {
        for (std::size_t i = 0; i < series.size(); ++i) {
          QImage picture;
          try {
            picture = toQImage(session::seriesPicture(series[i], pixels, progress));
          } catch (const InputError&) {
            // Opening it will say why.
          }
          QMutexLocker lock(&drawn->mutex);
          drawn->pictures.push_back(std::move(picture));
          lock.unlock();
          progress.report(double(i + 1) / double(series.size()), "Pictures");
        }
      },
      this);
  connect(mJob, &Job::progressed, this, &SeriesDialog::showPictures);
  connect(mJob, &Job::finished, this, &SeriesDialog::showPictures);
  mJob->start();
}

void SeriesDialog::showPictures() {
  QMutexLocker lock(&mDrawn->mutex);
  for (int i = 0; i < int(mDrawn->pictures.size()); ++i) {
    const QImage& picture = mDrawn->pictures[std::size_t(i)];
    if (!picture.isNull()) mList->item(i)->setIcon(QIcon(QPixmap::fromImage(picture)));
  }
}

}  // namespace velum::gui
