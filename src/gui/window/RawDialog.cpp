#include "gui/window/RawDialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/Error.h"
#include "gui/kit/CoreWords.h"
#include "gui/kit/Widgets.h"
#include "gui/rows/PictureList.h"
#include "scene/Scene.h"
#include "session/document/RawFile.h"

namespace velum::gui {

namespace {

constexpr int kPicture = 260;  // pixels
constexpr int kMostDim = 65535, kMostHeader = 1 << 30;

QString nameOf(SampleType type) {
  auto name = enumName(type);
  return QString::fromUtf8(name.data(), qsizetype(name.size()));
}

QString textOf(const scene::RawLayout& layout) {
  QString text = QString("%1 \u00d7 %2 \u00d7 %3, %4")
                     .arg(layout.dims.x)
                     .arg(layout.dims.y)
                     .arg(layout.dims.z)
                     .arg(nameOf(layout.type));
  if (layout.bigEndian) text += RawDialog::tr(", big endian");
  if (layout.headerBytes > 0) text += RawDialog::tr(", header of %1 bytes").arg(layout.headerBytes);
  return text;
}

QSpinBox* makeCount(QWidget* parent, const char* object, const QString& name, int least, int most) {
  auto* spin = new QSpinBox(parent);
  spin->setObjectName(object);
  spin->setAccessibleName(name);
  spin->setToolTip(name);
  spin->setRange(least, most);
  spin->setAlignment(Qt::AlignRight);
  return spin;
}

}  // namespace

RawDialog::RawDialog(const scene::Source& source, QWidget* parent) : QDialog(parent), mSource(source) {
  QFileInfo file(QString::fromStdString(source.path));
  mFileBytes = double(file.size());
  setObjectName("rawDialog");
  setWindowTitle(tr("Open %1").arg(file.fileName()));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(18, 18, 18, 14);
  layout->setSpacing(12);
  auto* why =
      new QLabel(tr("%1 has no header that says what its samples are. The picture shows how they would be read.")
                     .arg(file.fileName()),
                 this);
  why->setWordWrap(true);
  layout->addWidget(why);
  auto* halves = new QHBoxLayout;
  halves->setSpacing(20);
  halves->addWidget(makeFields(), 1);
  halves->addWidget(makePreview());
  layout->addLayout(halves);
  mFits = new QLabel(this);
  mFits->setObjectName("rawFits");
  mFits->setWordWrap(true);
  layout->addWidget(mFits);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  mOpen = new QPushButton(tr("&Open"), buttons);
  mOpen->setProperty("role", "main");
  mOpen->setDefault(true);
  buttons->addButton(mOpen, QDialogButtonBox::AcceptRole);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    mVoxel->remember();
    accept();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  show(source.raw);
  source.raw.dims.x > 0 ? changed() : guess();
}

RawDialog::~RawDialog() { mJob.reset(); }

QWidget* RawDialog::makeFields() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(8);
  auto row = [&](const QString& name, QWidget* field, int columns = 3) {
    auto* label = new QLabel(name, box);
    label->setBuddy(field);
    int at = grid->rowCount();
    grid->addWidget(label, at, 0);
    grid->addWidget(field, at, 1, 1, columns);
    return at;
  };
  mGuess = new QComboBox(box);
  mGuess->setObjectName("rawGuess");
  mGuess->setAccessibleName(tr("Guesses"));
  mGuess->setToolTip(tr("Layouts that fill the file to its last byte, the smoothest first"));
  row(tr("&Guess"), mGuess);
  const QString names[] = {tr("Voxels along x"), tr("Voxels along y"), tr("Voxels along z")};
  static constexpr const char* kObjects[] = {"rawX", "rawY", "rawZ"};
  int at = 0;
  for (int i = 0; i < 3; ++i) {
    mDims[i] = makeCount(box, kObjects[i], names[i], 1, kMostDim);
    if (i == 0)
      at = row(tr("&Voxels"), mDims[0], 1);
    else
      grid->addWidget(mDims[i], at, 1 + i);
  }
  mType = new QComboBox(box);
  mType->setObjectName("rawType");
  mType->setAccessibleName(tr("Type of a sample"));
  mType->setToolTip(tr("What one sample is: its bits, and whether it has a sign"));
  for (std::size_t i = 0; i < std::size(EnumNames<SampleType>::kNames); ++i) mType->addItem(nameOf(SampleType(i)));
  row(tr("&Type"), mType);
  mOrder = new QComboBox(box);
  mOrder->setObjectName("rawOrder");
  mOrder->setAccessibleName(tr("Byte order"));
  mOrder->addItems({tr("Little endian (PC)"), tr("Big endian")});
  mOrder->setToolTip(tr("Which byte of a sample comes first; bytes alone have none"));
  row(tr("&Byte order"), mOrder);
  mChannels = makeCount(box, "rawChannels", tr("Samples of a voxel, one after the other"), 1, 4);
  row(tr("&Samples a voxel"), mChannels, 1);
  mHeader = makeCount(box, "rawHeader", tr("Bytes before the first sample"), 0, kMostHeader);
  mHeader->setSuffix(tr(" bytes"));
  row(tr("&Header"), mHeader);
  mVoxel = new VoxelSizeForm(box);
  if (glm::all(glm::greaterThan(mSource.spacing, glm::dvec3(0.0)))) mVoxel->setValue(mSource.spacing);
  row(tr("Voxel size"), mVoxel);
  connect(mGuess, &QComboBox::activated, this, [this](int index) {
    if (std::size_t(index) < mGuesses.size()) show(mGuesses[std::size_t(index)]);
    changed();
  });
  for (QSpinBox* spin : {mDims[0], mDims[1], mDims[2], mChannels, mHeader})
    connect(spin, &QSpinBox::valueChanged, this, &RawDialog::changed);
  for (QComboBox* combo : {mType, mOrder}) connect(combo, &QComboBox::activated, this, &RawDialog::changed);
  return box;
}

QWidget* RawDialog::makePreview() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  mPicture = new QLabel(box);
  mPicture->setObjectName("rawPicture");
  mPicture->setAccessibleName(tr("A plane as it would be read"));
  mPicture->setFixedSize(kPicture, kPicture);
  mPicture->setAlignment(Qt::AlignCenter);
  mPicture->setWordWrap(true);
  mPicture->setStyleSheet("background: black; color: #c8ccd2");
  column->addWidget(mPicture);
  mPlane = new QSlider(Qt::Horizontal, box);
  mPlane->setObjectName("rawPlane");
  mPlane->setAccessibleName(tr("Plane that is shown"));
  mPlane->setToolTip(tr("Which plane along z the picture shows"));
  column->addWidget(mPlane);
  column->addStretch(1);
  connect(mPlane, &QSlider::valueChanged, this, &RawDialog::drawPlane);
  return box;
}

void RawDialog::guess() {
  mGuess->addItem(tr("Looking at the file..."));
  mGuess->setEnabled(false);
  auto found = std::make_shared<std::vector<scene::RawLayout>>();
  mJob = std::make_unique<Job>(
      [found, path = mSource.path](Progress& progress) {
        try {
          *found = session::guessLayouts(path, progress);
        } catch (const InputError&) {
          // The fields stay, and opening says why.
        }
      },
      this);
  connect(mJob.get(), &Job::finished, this, [this, found] {
    mJob.release()->deleteLater();
    takeGuesses(*found);
  });
  mJob->start();
}

void RawDialog::takeGuesses(std::vector<scene::RawLayout> guesses) {
  mGuesses = std::move(guesses);
  mGuess->clear();
  for (const auto& guess : mGuesses) mGuess->addItem(textOf(guess));
  mGuess->addItem(mGuesses.empty() ? tr("None fits; give its size") : tr("Another one"));
  mGuess->setEnabled(!mGuesses.empty());
  if (!mGuesses.empty()) show(mGuesses.front());
  changed();
}

void RawDialog::show(const scene::RawLayout& layout) {
  const QSignalBlocker x(mDims[0]), y(mDims[1]), z(mDims[2]), channels(mChannels), header(mHeader);
  for (int i = 0; i < 3; ++i) mDims[i]->setValue(layout.dims[i]);
  mType->setCurrentIndex(int(layout.type));
  mOrder->setCurrentIndex(layout.bigEndian ? 1 : 0);
  mChannels->setValue(layout.channels);
  mHeader->setValue(layout.headerBytes);
}

scene::RawLayout RawDialog::layout() const {
  return {{mDims[0]->value(), mDims[1]->value(), mDims[2]->value()},
          SampleType(mType->currentIndex()),
          mChannels->value(),
          mOrder->currentIndex() == 1,
          mHeader->value()};
}

scene::Source RawDialog::source() const {
  scene::Source source = mSource;
  source.raw = layout();
  source.spacing = mVoxel->value();
  return source;
}

void RawDialog::changed() {
  scene::RawLayout now = layout();
  mOrder->setEnabled(sampleSize(now.type) > 1);
  auto same = std::find(mGuesses.begin(), mGuesses.end(), now);
  if (!mJob) mGuess->setCurrentIndex(int(same - mGuesses.begin()));
  double wanted = session::bytesOf(now);
  auto bytes = [](double count) { return QLocale().toString(qulonglong(count)); };
  bool isPacked = mSource.path.ends_with(".gz"), fits = isPacked || wanted == mFileBytes;
  mFits->setText(isPacked ? tr("The file is compressed: only opening tells whether the size is right.")
                 : fits   ? tr("This fills the file: %1 bytes.").arg(bytes(mFileBytes))
                          : tr("This needs %1 bytes, the file has %2.").arg(bytes(wanted), bytes(mFileBytes)));
  mFits->setProperty("role", fits ? "muted" : "alarm");
  mFits->style()->polish(mFits);
  mOpen->setEnabled(fits && !mJob);
  const QSignalBlocker quiet(mPlane);
  bool isNew = mPlane->maximum() != now.dims.z - 1;
  mPlane->setRange(0, now.dims.z - 1);
  if (isNew) mPlane->setValue(now.dims.z / 2);
  drawPlane();
}

void RawDialog::drawPlane() {
  scene::Source source = mSource;
  source.raw = layout();
  try {
    double ratio = devicePixelRatioF();
    QImage picture = toQImage(session::rawPicture(source, mPlane->value(), int(kPicture * ratio)));
    picture.setDevicePixelRatio(ratio);
    mPicture->setPixmap(QPixmap::fromImage(picture));
  } catch (const InputError& error) {
    mPicture->setText(inWords(error.what()).section(": ", -1));
  }
}

}  // namespace velum::gui
