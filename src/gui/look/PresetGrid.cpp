#include "PresetGrid.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

#include "kit/CallLater.h"
#include "kit/Widgets.h"
#include "velum/scene/Presets.h"
#include "velum/session/picture/PresetPictures.h"

namespace velum::gui {

namespace {

constexpr int kColumns = 3, kPictureHeight = 64, kNameHeight = 30, kGap = 6;
constexpr int kPatienceMs = 4000;  // a view that is busy for longer does not keep the pictures away

enum Role { kName = Qt::UserRole, kPicture };

/// Without the modality in front, which the group says already.
QString titleOf(const scene::Preset& preset, bool withModality) {
  QString text = QString::fromUtf8(preset.title.data(), int(preset.title.size()));
  int colon = text.indexOf(": ");
  if (colon < 0) return text;
  if (withModality) return text.replace(": ", " ");
  text = text.mid(colon + 2);
  return text.left(1).toUpper() + text.mid(1);
}

class PresetDelegate : public QStyledItemDelegate {
 public:
  explicit PresetDelegate(QListView* list) : QStyledItemDelegate(list), mList(list) {}
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return mList->gridSize(); }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    bool isOn = option.state & QStyle::State_Enabled;
    if (!isOn) painter->setOpacity(0.4);
    QRectF frame(option.rect.x() + kGap / 2.0, option.rect.y() + 2, option.rect.width() - kGap, kPictureHeight);
    QPainterPath shape;
    shape.addRoundedRect(frame, 5, 5);
    // Not of the list, whose own ground the style sheet makes clear.
    painter->fillPath(shape, mList->parentWidget()->palette().color(QPalette::Base));
    auto picture = index.data(kPicture).value<QPixmap>();
    if (!picture.isNull()) {
      painter->setClipPath(shape);
      painter->drawPixmap(frame, picture, QRectF(picture.rect()));
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
    QRectF text(option.rect.x() + 1, frame.bottom() + 2, option.rect.width() - 2, kNameHeight - 4);
    painter->drawText(text, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, index.data().toString());
    painter->restore();
  }

 private:
  QListView* mList;
};

/// Chooses by Enter and Space as by a click.
class PresetList : public QListWidget {
 public:
  using QListWidget::QListWidget;

 protected:
  bool event(QEvent* event) override {
    // The window has another use for Space.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space)
      event->accept();
    return QListWidget::event(event);
  }
  void keyPressEvent(QKeyEvent* event) override {
    if (event->key() == Qt::Key_Space && currentItem()) {
      emit itemActivated(currentItem());
      return;
    }
    QListWidget::keyPressEvent(event);
  }
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }  // the panel scrolls
};

/// What the data seems to be where the file does not say.
Modality kindOf(const Volume& volume) {
  if (volume.modality != Modality::Unknown) return volume.modality;
  std::string_view fitting = scene::choosePreset(volume);
  for (const auto& preset : scene::presets())
    if (preset.name == fitting) return preset.modality;
  return Modality::Unknown;
}

QImage toQImage(const Image& image) {
  QImage out(image.width, image.height, QImage::Format_RGB888);
  std::size_t channels = image.channels.size();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float* p = &image.pixels[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * channels];
      out.setPixel(x, y, qRgb(int(p[0] * 255 + 0.5f), int(p[1] * 255 + 0.5f), int(p[2] * 255 + 0.5f)));
    }
  return out;
}

}  // namespace

PresetGrid::PresetGrid(session::Document& document, QWidget* parent)
    : QWidget(parent), mDocument(document), mList(new PresetList(this)), mMore(new QPushButton(tr("More"), this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto* header = new QHBoxLayout;
  header->addWidget(makeTitle(tr("Preset"), this), 1);
  header->addWidget(mMore);
  layout->addLayout(header);
  layout->addWidget(mList);
  mList->setObjectName("preset");
  mList->setAccessibleName(tr("Preset"));
  mList->setToolTip(tr("Colours, opacity and light made for a kind of data"));
  mList->setItemDelegate(new PresetDelegate(mList));
  mList->setViewMode(QListView::IconMode);
  mList->setMovement(QListView::Static);
  mList->setResizeMode(QListView::Adjust);
  mList->setUniformItemSizes(true);
  mList->setSpacing(0);
  mList->setFrameShape(QFrame::NoFrame);
  mList->setMouseTracking(true);
  mList->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  mList->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  mMore->setObjectName("morePresets");
  mMore->setProperty("role", "quiet");
  mMore->setCheckable(true);
  mMore->setToolTip(tr("Presets made for other kinds of data"));
  mPatience.setSingleShot(true);
  mPatience.setInterval(kPatienceMs);
  auto chosen = [this](QListWidgetItem* item) { choose(item->data(kName).toString()); };
  connect(mList, &QListWidget::itemClicked, this, chosen);
  connect(mList, &QListWidget::itemActivated, this, chosen);
  connect(&mPatience, &QTimer::timeout, this, &PresetGrid::drawPictures);
  connect(mMore, &QPushButton::toggled, this, [this](bool on) {
    mMore->setText(on ? tr("Fewer") : tr("More"));
    fill();
    refresh();
    drawPictures();
  });
  fill();
}

PresetGrid::~PresetGrid() { mJob.reset(); }

void PresetGrid::choose(const QString& name) {
  mDocument.edit("Choose preset", [&](scene::Scene& scene) { scene::applyPreset(scene, name.toStdString()); });
}

/// The presets for this kind of data and the one that is chosen; where they are wanted, all others.
void PresetGrid::fill() {
  bool mixes = scene::mixesChannels(mDocument.scene().volume);
  Modality first = mixes ? Modality::Microscopy : mVolume ? kindOf(*mVolume) : Modality::Unknown;
  // A patient's scan of which nothing is known is an MR more often than anything else.
  bool isPatient = mVolume && mVolume->isOrientationKnown;
  Modality second = first == Modality::Unknown && isPatient ? Modality::MR : first;
  std::string current = scene::currentTransfer(mDocument.scene().volume).preset;
  mList->clear();
  for (bool others : {false, true})
    for (const auto& preset : scene::presets()) {
      bool isFirst = preset.modality == first || preset.modality == second || preset.name == current;
      if (isFirst == others || (others && !mMore->isChecked())) continue;
      auto* item = new QListWidgetItem(titleOf(preset, preset.modality != first), mList);
      QString name = QString::fromUtf8(preset.name.data(), int(preset.name.size()));
      item->setData(kName, name);
      item->setData(kPicture, mPictures.value(name));
      item->setToolTip(titleOf(preset, true));
    }
  fitHeight();
}

/// The panel scrolls, not the list in it.
void PresetGrid::fitHeight() {
  int rows = (mList->count() + kColumns - 1) / kColumns;
  mList->setGridSize({std::max(60, (width() - 1) / kColumns), kPictureHeight + kNameHeight});
  mList->setFixedHeight(rows * (kPictureHeight + kNameHeight) + 2);
}

void PresetGrid::resizeEvent(QResizeEvent*) { fitHeight(); }

void PresetGrid::refresh() {
  const scene::VolumeLayer& layer = mDocument.scene().volume;
  setEnabled(bool(layer.data));
  int channel = layer.data ? std::clamp(layer.channel, 0, layer.data->channels - 1) : -1;
  if (!(mVolume == layer.data) || mChannel != channel) {
    if (mJob) mJob->cancel();
    mVolume = layer.data;
    mChannel = channel;
    mPictures.clear();
    fill();
    if (layer.data) mPatience.start();
  }
  QString current = QString::fromStdString(scene::currentTransfer(layer).preset);
  QListWidgetItem* now = nullptr;
  for (int i = 0; i < mList->count(); ++i)
    if (mList->item(i)->data(kName).toString() == current) now = mList->item(i);
  if (now == mList->currentItem() && (!now || now->isSelected())) return;
  mList->setCurrentItem(now);
  if (!now) mList->clearSelection();
}

QStringList PresetGrid::missing() const {
  QStringList names;
  for (int i = 0; i < mList->count(); ++i) {
    QString name = mList->item(i)->data(kName).toString();
    if (!mPictures.contains(name)) names << name;
  }
  return names;
}

bool PresetGrid::isComplete() const { return !mVolume || (!mJob && missing().isEmpty()); }

void PresetGrid::drawPictures() {
  QStringList names = missing();
  if (mJob || !mVolume || names.isEmpty()) return;
  mPatience.stop();
  std::vector<std::string> wanted;
  for (const QString& name : names) wanted.push_back(name.toStdString());
  double ratio = devicePixelRatioF();
  glm::ivec2 size(int(ratio * (mList->gridSize().width() - kGap)), int(ratio * kPictureHeight));
  auto key = std::make_pair(mVolume.id(), mChannel);
  auto work = [this, scene = mDocument.scene(), wanted, size, key](Progress& progress) {
    session::drawPresetPictures(
        scene, wanted, size,
        [&](const std::string& name, const Image& image) {
          callLater(this, [this, key, name = QString::fromStdString(name), picture = toQImage(image)] {
            if (key == std::make_pair(mVolume.id(), mChannel)) takePicture(name, picture);
          });
        },
        progress);
  };
  mJob = std::make_unique<Job>(work, nullptr);
  // Without a driver for pictures in the background the names alone must do: the error has no place in the window.
  connect(mJob.get(), &Job::finished, this, [this, key](bool done) {
    mJob.release()->deleteLater();
    if (done || key != std::make_pair(mVolume.id(), mChannel)) drawPictures();
  });
  mJob->start();
}

void PresetGrid::takePicture(const QString& name, const QImage& picture) {
  QPixmap pixmap = QPixmap::fromImage(picture);
  mPictures.insert(name, pixmap);
  for (int i = 0; i < mList->count(); ++i)
    if (mList->item(i)->data(kName).toString() == name) mList->item(i)->setData(kPicture, pixmap);
}

}  // namespace velum::gui
