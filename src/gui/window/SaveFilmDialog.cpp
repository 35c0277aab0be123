#include "gui/window/SaveFilmDialog.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

#include "gui/kit/Preferences.h"
#include "gui/kit/Words.h"
#include "gui/rows/FieldForm.h"

namespace velum::gui {

namespace {

/// By SaveFilmDialog::Format.
constexpr const char* kFormats[] = {QT_TRANSLATE_NOOP("Words", "MP4 video (H.264)"),
                                    QT_TRANSLATE_NOOP("Words", "WebM video (VP9)"), QT_TRANSLATE_NOOP("Words", "GIF"),
                                    QT_TRANSLATE_NOOP("Words", "PNG frames"), QT_TRANSLATE_NOOP("Words", "EXR frames")};
constexpr int kMostFilmPixels = 16384, kFilmNameWidth = 96;
constexpr const char *kFormatKey = "film/format", *kSizeKey = "film/size", *kBlurKey = "film/blur",
                     *kVideoQualityKey = "film/quality", *kSixteenBitsKey = "film/sixteenBits",
                     *kFilmLayersKey = "film/layers", *kFolderKey = "film/folder";

QString sizeText(glm::ivec2 size) { return QString::fromUtf8("%1 \u00d7 %2").arg(size.x).arg(size.y); }

/// A row of a grid: a name, and a control.
void addTo(QGridLayout* grid, const QString& title, QWidget* control) {
  int line = grid->rowCount();
  if (!title.isEmpty()) grid->addWidget(new QLabel(title, control->parentWidget()), line, 0);
  grid->addWidget(control, line, 1);
  if (control->accessibleName().isEmpty() && !title.isEmpty()) control->setAccessibleName(title);
}

template <class T>
T* named(T* control, const char* name, const QString& tip) {
  control->setObjectName(name);
  control->setToolTip(tip);
  return control;
}

QSpinBox* makeNumber(const char* name, int least, int most, const QString& tip, QWidget* parent) {
  auto* number = named(new QSpinBox(parent), name, tip);
  number->setRange(least, most);
  number->setAlignment(Qt::AlignRight);
  return number;
}

}  // namespace

SaveFilmDialog::SaveFilmDialog(glm::ivec2 viewSize, const scene::Scene& scene, const QString& name, QWidget* parent)
    : FilmDialog(tr("Save film"), 162, parent), mScene(scene) {
  auto* columns = new QHBoxLayout;
  columns->setSpacing(24);
  QGridLayout *left = makeFile(name), *right = makeQuality();
  makeSize(left, viewSize);
  makeRate(left);
  left->setRowStretch(left->rowCount(), 1);
  right->setRowStretch(right->rowCount(), 1);
  columns->addLayout(left, 1);
  columns->addLayout(right, 1);
  mColumn->addLayout(columns);
  mFacts = new QLabel(this);
  mFacts->setProperty("role", "muted");
  mFacts->setObjectName("filmFacts");
  mNote = new QLabel(this);
  mNote->setObjectName("filmNote");
  for (QLabel* label : {mFacts, mNote}) {
    label->setWordWrap(true);
    mColumn->addWidget(label);
  }
  addButtons({tr("Save"), "saveFilm", tr("Draw the film in the background, and write it")},
             {tr("Copy as command"), "copyCommand",
              tr("Copy the command line that makes this film without a window: the same bytes, for scripts")});
  connect(mOther, &QPushButton::clicked, this, &SaveFilmDialog::copyCommand);
  connect(mPreview, &FilmPreview::measured, this, [this](DrawingTime time) {
    mTime = time;
    updateText();
  });
  takeFormat();
  setSize({1920, 1080});
}

QGridLayout* SaveFilmDialog::makeFile(const QString& name) {
  auto* grid = makeFieldGrid(nullptr, kFilmNameWidth);
  QString movies = QStandardPaths::writableLocation(QStandardPaths::MoviesLocation);
  QString folder = Preferences().value(kFolderKey).toString();
  if (folder.isEmpty() || !QFileInfo(folder).isDir()) folder = QFileInfo(movies).isDir() ? movies : QDir::homePath();
  mPath = named(new QLineEdit(folder + "/" + name + ".mp4", this), "filmPath", tr("Where the film goes"));
  mPath->setMinimumWidth(240);
  auto* browsing = new QPushButton(tr("Browse..."), this);
  browsing->setToolTip(tr("Choose where the film goes"));
  browsing->setAutoDefault(false);
  auto* file = new QWidget(this);
  auto* row = new QHBoxLayout(file);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(mPath, 1);
  row->addWidget(browsing);
  mFormat = named(new QComboBox(this), "filmFormat", tr("A video, or a picture for each frame"));
  for (const char* format : kFormats) mFormat->addItem(wordsOf(format));
  addTo(grid, tr("Format"), mFormat);
  addTo(grid, tr("File"), file);
  mPath->setAccessibleName(tr("File"));
  connect(mFormat, &QComboBox::currentIndexChanged, this, &SaveFilmDialog::takeFormat);
  connect(mPath, &QLineEdit::editingFinished, this, &SaveFilmDialog::takePath);
  connect(browsing, &QPushButton::clicked, this, &SaveFilmDialog::browse);
  return grid;
}

void SaveFilmDialog::makeSize(QGridLayout* grid, glm::ivec2 viewSize) {
  mSizes = named(new QComboBox(this), "filmSizes", tr("Size of the frames, pixels"));
  auto offer = [this](const QString& title, glm::ivec2 size) {
    mSizes->addItem(title.arg(sizeText(size)), QSize(size.x, size.y));
  };
  for (glm::ivec2 size : {glm::ivec2(1920, 1080), {1280, 720}, {3840, 2160}}) offer("%1", size);
  offer(tr("Square, %1"), {1080, 1080});
  offer(tr("As the view, %1"), viewSize);
  mSizes->addItem(tr("Own size:"));
  mWidth = makeNumber("filmWidth", 1, kMostFilmPixels, tr("Width of the frames, pixels"), this);
  mHeight = makeNumber("filmHeight", 1, kMostFilmPixels, tr("Height of the frames, pixels"), this);
  mWidth->setAccessibleName(tr("Width"));
  mHeight->setAccessibleName(tr("Height"));
  auto* own = new QWidget(this);
  auto* row = new QHBoxLayout(own);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(mWidth, 1);
  row->addWidget(new QLabel(QString::fromUtf8("\u00d7"), own));
  row->addWidget(mHeight, 1);
  row->addWidget(new QLabel(tr("px"), own));
  addTo(grid, tr("Size"), mSizes);
  grid->addWidget(own, grid->rowCount(), 1);
  connect(mSizes, &QComboBox::activated, this, [this] {
    QSize size = mSizes->currentData().toSize();
    if (!size.isEmpty()) setSize({size.width(), size.height()});
  });
  for (QSpinBox* side : {mWidth, mHeight}) connect(side, &QSpinBox::valueChanged, this, &SaveFilmDialog::showSize);
}

void SaveFilmDialog::makeRate(QGridLayout* grid) {
  const scene::Timeline& film = mScene.timeline;
  mRate = named(new NumberField(this), "filmRate", tr("Frames a second, 0.01 to 1000"));
  mRate->setRange(0.01, 1000.0);
  mRate->setDecimals(2);
  mRate->setAlignment(Qt::AlignRight);
  mRate->setValue(film.framesPerSecond);
  mRange = named(new QComboBox(this), "filmRange", tr("The whole film, or the part of it that is played"));
  mRange->addItem(tr("Whole film"));
  bool hasPart = !film.tracks.empty() && (film.rangeStart > 0.0 || film.rangeEnd > 0.0);
  double end = film.rangeEnd > 0.0 ? film.rangeEnd : film.duration;
  if (hasPart) mRange->addItem(tr("From %L1 s to %L2 s").arg(film.rangeStart, 0, 'f', 1).arg(end, 0, 'f', 1));
  mRange->setCurrentIndex(hasPart ? 1 : 0);
  mRange->setEnabled(hasPart);
  addTo(grid, tr("Frames a second"), mRate);
  addTo(grid, tr("Range"), mRange);
  connect(mRate, &NumberField::valueChanged, this, &SaveFilmDialog::showFilm);
  connect(mRange, &QComboBox::currentIndexChanged, this, &SaveFilmDialog::showFilm);
}

QGridLayout* SaveFilmDialog::makeQuality() {
  auto* grid = makeFieldGrid(nullptr, kFilmNameWidth);
  mSamples = new SamplesRow("film", this);
  mSamples->setSamples(std::max(4, mScene.rayCast.samplesPerPixel));
  mBlur = makeNumber("filmBlur", 1, 256,
                     tr("How many pictures are averaged in a frame while things move; each is work"), this);
  mBlur->setSpecialValueText(tr("None"));
  mBlur->setSuffix(tr(" pictures a frame"));
  mVideoQuality = makeNumber("filmQuality", 0, 100, tr("How much of the pictures a video keeps, 0 to 100"), this);
  mVideoQuality->setValue(session::FilmOutput().quality);
  mTransparent = named(new QCheckBox(tr("Transparent background"), this), "filmTransparent",
                       tr("No background, with alpha: not in MP4"));
  mTransparent->setChecked(mScene.background.transparent);
  mSixteenBits = named(new QCheckBox(tr("16 bits a colour"), this), "filmSixteenBits",
                       tr("More levels of colour: of frames alone"));
  mLayers = named(new QCheckBox(tr("Layers: depth, normal, structure, position"), this), "filmLayers",
                  tr("In each EXR frame, or as pictures beside each PNG frame"));
  addTo(grid, tr("Quality"), mSamples);
  addTo(grid, tr("Motion blur"), mBlur);
  addTo(grid, tr("Video quality"), mVideoQuality);
  for (QCheckBox* box : {mTransparent, mSixteenBits, mLayers}) {
    addTo(grid, {}, box);
    connect(box, &QCheckBox::toggled, this, &SaveFilmDialog::updateText);
  }
  connect(mSamples, &SamplesRow::changed, this, &SaveFilmDialog::updateText);
  connect(mBlur, &QSpinBox::valueChanged, this, &SaveFilmDialog::updateText);
  return grid;
}

// What was chosen before.

void SaveFilmDialog::recall() {
  Preferences known;
  mFormat->setCurrentIndex(std::clamp(known.value(kFormatKey, 0).toInt(), 0, mFormat->count() - 1));
  QSize size = known.value(kSizeKey).toSize();
  if (!size.isEmpty()) setSize({size.width(), size.height()});
  mBlur->setValue(known.value(kBlurKey, mBlur->value()).toInt());
  mVideoQuality->setValue(known.value(kVideoQualityKey, mVideoQuality->value()).toInt());
  mSixteenBits->setChecked(known.value(kSixteenBitsKey, false).toBool());
  mLayers->setChecked(known.value(kFilmLayersKey, false).toBool());
}

void SaveFilmDialog::remember() const {
  Preferences known;
  known.setValue(kFormatKey, mFormat->currentIndex());
  known.setValue(kSizeKey, QSize(mWidth->value(), mHeight->value()));
  known.setValue(kBlurKey, mBlur->value());
  known.setValue(kVideoQualityKey, mVideoQuality->value());
  known.setValue(kSixteenBitsKey, mSixteenBits->isChecked());
  known.setValue(kFilmLayersKey, mLayers->isChecked());
  known.setValue(kFolderKey, QFileInfo(mPath->text()).absolutePath());
}

}  // namespace velum::gui
