#include "gui/window/SavePictureDialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QGuiApplication>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <cmath>
#include <exception>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Preferences.h"
#include "gui/rows/PictureList.h"
#include "gui/service/KeepScene.h"
#include "session/Session.h"

namespace velum::gui {

namespace {

constexpr int kPreviewWidth = 420, kPreviewHeight = 320;
constexpr int kMostPixels = 65536;
constexpr int kNameWidth = 82;     // of what stands before the fields, in both parts
constexpr int kDrawDelayMs = 250;  // while numbers are being typed
enum Unit { Pixels, Centimetres, Inches };

constexpr const char *kShapeKey = "picture/keepShape", *kDpiKey = "picture/dpi", *kUnitKey = "picture/unit",
                     *kLayersKey = "picture/layers";

double pixelsPerUnit(int unit, int dpi) { return unit == Pixels ? 1.0 : unit == Centimetres ? dpi / 2.54 : dpi; }

/// Squares behind what is transparent.
QPixmap onSquares(const QImage& image) {
  QPixmap out(image.size());
  QPainter painter(&out);
  constexpr int kSquare = 10;
  for (int y = 0; y < out.height(); y += kSquare)
    for (int x = 0; x < out.width(); x += kSquare)
      painter.fillRect(x, y, kSquare, kSquare,
                       (x + y) / kSquare % 2 ? QColor(0xa8, 0xa8, 0xa8) : QColor(0x88, 0x88, 0x88));
  painter.drawImage(0, 0, image);
  return out;
}

}  // namespace

SavePictureDialog::SavePictureDialog(glm::ivec2 viewSize, glm::ivec2 size, const scene::Scene& scene, QWidget* parent)
    : QDialog(parent), mScene(scene), mAspect(double(size.x) / std::max(1, size.y)) {
  setWindowTitle(tr("Save picture"));
  auto* outer = new QHBoxLayout;
  mPreview = new QLabel(this);
  mPreview->setFixedSize(kPreviewWidth, kPreviewHeight);
  mPreview->setAlignment(Qt::AlignCenter);
  mPreview->setText(tr("Drawing a preview..."));
  mPreview->setObjectName("picturePreview");
  outer->addWidget(mPreview);
  auto* column = new QVBoxLayout;
  column->setSpacing(12);
  column->addWidget(makeSize(viewSize));
  column->addWidget(makeQuality());
  column->addStretch(1);
  mFacts = new QLabel(this);
  mFacts->setProperty("role", "muted");
  mFacts->setWordWrap(true);
  column->addWidget(mFacts);
  outer->addSpacing(18);
  outer->addLayout(column, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(18, 18, 18, 14);
  layout->setSpacing(14);
  layout->addLayout(outer);
  auto* buttons = new QDialogButtonBox(this);
  auto* save = new QPushButton(tr("Choose file..."), buttons);
  save->setProperty("role", "main");  // before the box shows it: the style is chosen then
  save->setToolTip(tr("Choose where the picture goes, and draw it"));
  buttons->addButton(save, QDialogButtonBox::AcceptRole);
  save->setDefault(true);
  auto* copy = buttons->addButton(tr("Copy as command"), QDialogButtonBox::ActionRole);
  copy->setObjectName("copyCommand");
  copy->setToolTip(tr("Copy the command line that draws this picture without a window: the same bytes, for scripts"));
  buttons->addButton(QDialogButtonBox::Cancel);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(copy, &QPushButton::clicked, this, &SavePictureDialog::copyCommand);
  mDrawTimer.setSingleShot(true);
  mDrawTimer.setInterval(kDrawDelayMs);
  connect(&mDrawTimer, &QTimer::timeout, this, &SavePictureDialog::drawPreview);
  setPixels(size);
}

SavePictureDialog::~SavePictureDialog() = default;

void SavePictureDialog::recall() {
  Preferences known;
  mKeepShape->setChecked(known.value(kShapeKey, mKeepShape->isChecked()).toBool());
  mDpi->setValue(known.value(kDpiKey, mDpi->value()).toInt());
  mUnit->setCurrentIndex(std::clamp(known.value(kUnitKey, 0).toInt(), 0, mUnit->count() - 1));
  mLayers->setChecked(known.value(kLayersKey, mLayers->isChecked()).toBool());
  if (mScene.lettering.pageWidth <= 0.0) return;
  mUnit->setCurrentIndex(Centimetres);
  mWidth->setValue(0.1 * mScene.lettering.pageWidth);
}

void SavePictureDialog::remember() const {
  Preferences known;
  known.setValue(kPictureSizeKey, QSize(mPixels.x, mPixels.y));
  known.setValue(kShapeKey, mKeepShape->isChecked());
  known.setValue(kDpiKey, mDpi->value());
  known.setValue(kUnitKey, mUnit->currentIndex());
  known.setValue(kLayersKey, mLayers->isChecked());
}

QWidget* SavePictureDialog::makeSize(glm::ivec2 viewSize) {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(10);
  grid->setColumnMinimumWidth(0, kNameWidth);
  // The controls.
  mWidth = new NumberField(box);
  mWidth->setObjectName("pictureWidth");
  mWidth->setAccessibleName(tr("Width"));
  mWidth->setToolTip(tr("Width of the picture, in the unit beside"));
  mHeight = new NumberField(box);
  mHeight->setObjectName("pictureHeight");
  mHeight->setAccessibleName(tr("Height"));
  mHeight->setToolTip(tr("Height of the picture, in the unit beside"));
  for (auto* spin : {mWidth, mHeight}) {
    spin->setAlignment(Qt::AlignRight);
    spin->setMinimumWidth(96);
  }
  mUnit = new QComboBox(box);
  mUnit->setObjectName("pictureUnit");
  mUnit->setAccessibleName(tr("Unit"));
  mUnit->addItems({tr("px"), tr("cm"), tr("in")});
  mUnit->setToolTip(tr("Pixels, or a size on paper at the resolution below"));
  mDpi = new QSpinBox(box);
  mDpi->setObjectName("pictureDpi");
  mDpi->setAccessibleName(tr("Resolution"));
  mDpi->setRange(1, 10000);
  mDpi->setValue(300);
  mDpi->setSuffix(tr(" dpi"));
  mDpi->setAlignment(Qt::AlignRight);
  mDpi->setToolTip(tr("Pixels an inch in print; the file says it to programs that lay pages out"));
  mKeepShape = new QCheckBox(tr("Keep the shape"), box);
  mKeepShape->setChecked(true);
  mKeepShape->setToolTip(tr("Width and height change together"));
  // Their places: width, height and unit in one row,
  auto* size = new QHBoxLayout;
  size->setSpacing(8);
  size->addWidget(mWidth);
  size->addWidget(new QLabel(QString::fromUtf8("\u00d7"), box));
  size->addWidget(mHeight);
  size->addWidget(mUnit);
  grid->addWidget(new QLabel(tr("Size"), box), 0, 0);
  grid->addLayout(size, 0, 1);
  // sizes that are ready under it,
  auto* ready = new QHBoxLayout;
  for (int factor : {1, 2, 4}) {
    auto* button = new QPushButton(factor == 1 ? tr("As the view") : tr("%1 times").arg(factor), box);
    button->setProperty("role", "quiet");
    button->setAutoDefault(false);
    button->setToolTip(tr("%1 x %2 pixels").arg(viewSize.x * factor).arg(viewSize.y * factor));
    connect(button, &QPushButton::clicked, this, [this, viewSize, factor] {
      mAspect = double(viewSize.x) / viewSize.y;
      setPixels(viewSize * factor);
    });
    ready->addWidget(button);
  }
  ready->addStretch(1);
  grid->addLayout(ready, 1, 1);
  // then shape and resolution.
  grid->addWidget(mKeepShape, 2, 1);
  grid->addWidget(new QLabel(tr("Resolution"), box), 3, 0);
  grid->addWidget(mDpi, 3, 1, Qt::AlignLeft);
  // A resolution changes pixels where the size is one on paper, and nothing but words where it is in pixels.
  connect(mUnit, &QComboBox::currentIndexChanged, this, &SavePictureDialog::showSize);
  connect(mDpi, &QSpinBox::valueChanged, this,
          [this] { mUnit->currentIndex() == Pixels ? updateText() : takeWidth(); });
  connect(mWidth, &QDoubleSpinBox::valueChanged, this, &SavePictureDialog::takeWidth);
  connect(mHeight, &QDoubleSpinBox::valueChanged, this, &SavePictureDialog::takeHeight);
  return box;
}

QWidget* SavePictureDialog::makeQuality() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(10);
  grid->setColumnMinimumWidth(0, kNameWidth);
  // The controls.
  mBackground = new QComboBox(box);
  mBackground->setObjectName("pictureBackground");
  mBackground->setAccessibleName(tr("Background"));
  mBackground->addItems({tr("As in the view"), tr("Transparent"), tr("White"), tr("Black")});
  mBackground->setToolTip(tr("Transparent pictures have an alpha channel: for layouts"));
  if (mScene.background.transparent) mBackground->setCurrentIndex(1);
  mSamples = new SamplesRow("picture", box);
  mSamples->setSamples(std::max(4, mScene.rayCast.samplesPerPixel));
  mLayers = new QCheckBox(tr("Layers: depth, normal, structure, position"), box);
  mLayers->setObjectName("pictureLayers");
  mLayers->setToolTip(
      tr("Inside an .exr file; as pictures beside a .png or .tif file.\nOf an inlay also what stands before "
         "it, its image, and what lies behind it, to be put together."));
  grid->addWidget(new QLabel(tr("Background"), box), 0, 0);
  grid->addWidget(mBackground, 0, 1);
  grid->addWidget(new QLabel(tr("Quality"), box), 1, 0);
  grid->addWidget(mSamples, 1, 1);
  grid->addWidget(mLayers, 2, 1);
  grid->setColumnStretch(1, 1);
  connect(mSamples, &SamplesRow::changed, this, &SavePictureDialog::updateText);
  connect(mBackground, &QComboBox::currentIndexChanged, this, [this] {
    updateText();
    mDrawTimer.start();
  });
  connect(mLayers, &QCheckBox::toggled, this, &SavePictureDialog::updateText);
  updateText();
  return box;
}

void SavePictureDialog::setPixels(glm::ivec2 size) {
  bool sameShape = mPixels.x * size.y == mPixels.y * size.x && (mHasPreview || mJob);
  mPixels = glm::clamp(size, 1, kMostPixels);
  showSize();
  if (!sameShape) mDrawTimer.start();
}

/// The pixels in the unit that is chosen.
void SavePictureDialog::showSize() {
  int unit = mUnit->currentIndex();
  const QSignalBlocker quietWidth(mWidth), quietHeight(mHeight);
  double factor = 1.0 / pixelsPerUnit(unit, mDpi->value());
  for (auto* spin : {mWidth, mHeight}) {
    spin->setUnitBeside(mUnit->currentText(), unit == Pixels ? 0.0 : unit == Centimetres ? 10.0 : 25.4);
    spin->setDecimals(unit == Pixels ? 0 : 2);
    spin->setRange(unit == Pixels ? 1 : 0.01, kMostPixels * factor);
  }
  mWidth->setValue(mPixels.x * factor);
  mHeight->setValue(mPixels.y * factor);
  updateText();
}

void SavePictureDialog::takeWidth() {
  double factor = pixelsPerUnit(mUnit->currentIndex(), mDpi->value());
  int width = int(std::lround(mWidth->value() * factor));
  int height =
      mKeepShape->isChecked() ? int(std::lround(width / mAspect)) : int(std::lround(mHeight->value() * factor));
  setPixels({width, height});
}

void SavePictureDialog::takeHeight() {
  double factor = pixelsPerUnit(mUnit->currentIndex(), mDpi->value());
  int height = int(std::lround(mHeight->value() * factor));
  int width = mKeepShape->isChecked() ? int(std::lround(height * mAspect)) : int(std::lround(mWidth->value() * factor));
  setPixels({width, height});
}

void SavePictureDialog::updateText() {
  if (!mFacts || !mSamples) return;
  double megapixels = double(mPixels.x) * mPixels.y / 1e6;
  QString paper = tr("%L1 x %L2 cm at %3 dpi")
                      .arg(mPixels.x * 2.54 / mDpi->value(), 0, 'f', 1)
                      .arg(mPixels.y * 2.54 / mDpi->value(), 0, 'f', 1)
                      .arg(mDpi->value());
  mFacts->setText(tr("%1 x %2 pixels (%L3 megapixels), %4.\nThe picture carries the scene: drop it on the "
                     "window to go on with it.")
                      .arg(mPixels.x)
                      .arg(mPixels.y)
                      .arg(megapixels, 0, 'f', 1)
                      .arg(paper));
}

session::PictureOptions SavePictureDialog::options() const {
  return {mPixels, mSamples->samples(), mBackground->currentIndex() == 1, mLayers->isChecked(), double(mDpi->value())};
}

scene::Scene SavePictureDialog::pictureScene() const {
  scene::Scene scene = mScene;
  int index = mBackground->currentIndex();
  scene.background.transparent = index == 1;
  if (index >= 2) scene.background.top = scene.background.bottom = glm::vec3(index == 2 ? 1.0f : 0.0f);
  return scene;
}

void SavePictureDialog::drawPreview() {
  mJob.reset();  // one that is still drawing is cancelled
  session::PictureOptions small = options();
  double scale = std::min(double(kPreviewWidth) / mPixels.x, double(kPreviewHeight) / mPixels.y);
  small.size = glm::max(glm::ivec2(glm::round(glm::dvec2(mPixels) * scale)), glm::ivec2(1));
  small.samples = 2;
  small.layers = false;
  auto image = std::make_shared<Image>();
  mJob = std::make_unique<Job>([image, small, scene = pictureScene()](
                                   Progress& progress) { *image = session::Session(scene).picture(small, progress); },
                               nullptr);
  connect(mJob.get(), &Job::finished, this, [this, image](bool done, const QString& error) {
    if (!error.isEmpty()) mPreview->setText(error);
    if (!done) return;
    mPreview->setPixmap(onSquares(toQImage(*image)));
    mHasPreview = true;
  });
  mJob->start();
}

QString SavePictureDialog::command() const {
  return QString::fromStdString(session::pictureCommand(keepScene(pictureScene()), options(), "picture.png"));
}

void SavePictureDialog::copyCommand() {
  try {
    QString text = command();
    QGuiApplication::clipboard()->setText(text);
    mFacts->setText(tr("Copied: %1").arg(text));
  } catch (const std::exception& error) {
    mFacts->setText(inWords(error.what()));
  }
}

}  // namespace velum::gui
