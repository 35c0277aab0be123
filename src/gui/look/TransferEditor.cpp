#include "gui/look/TransferEditor.h"
#include "gui/kit/Length.h"
#include "scene/Shown.h"
#include "session/command/Command.h"

#include <QColorDialog>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace velum::gui {

namespace {

constexpr std::size_t kMostCached = 64;  // a few megabytes of counts

NumberField* makeSpin(QWidget* parent, const QString& name, const QString& tip) {
  auto* spin = new NumberField(parent);
  spin->setAlignment(Qt::AlignRight);
  spin->setAccessibleName(name);
  spin->setToolTip(tip);
  return spin;
}

/// Decimals that are needed to show a tenth of a pixel of an axis.
int decimalsFor(session::AxisView view) {
  return std::clamp(int(std::ceil(3.5 - std::log10(std::max(view.high - view.low, 1e-9)))), 0, 6);
}

}  // namespace

TransferEditor::TransferEditor(session::Document& document, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mCanvas(new TransferCanvas(TransferCanvas::Kind::Values, this)),
      mGradients(new TransferCanvas(TransferCanvas::Kind::Gradients, this)),
      mUsesGradients(new QCheckBox(tr("Opacity by gradient"), this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  layout->addWidget(makeHeader());
  layout->addWidget(mCanvas);
  layout->addWidget(mUsesGradients);
  layout->addWidget(mGradients);
  layout->addWidget(makeNumbers());
  mCanvas->setObjectName("transferCanvas");
  mCanvas->setAccessibleName(tr("Opacity and colour by value"));
  mCanvas->setToolTip(
      tr("Click the line: add a point. Drag a point: move it. Drag between points: move all, or scale "
         "all opacities.\nShift+drag: move all. Alt+drag: stretch. Right or double click a point, or "
         "Del: remove it.\nIn the colours: click adds, double click changes, right click removes. "
         "Wheel: zoom. Double click the axis: whole range.\nKeys: PgUp and PgDn go from one to the next, Ins adds, "
         "arrows move, Enter changes a colour, + and - zoom."));
  mGradients->setObjectName("gradientCanvas");
  mGradients->setAccessibleName(tr("Opacity by gradient"));
  mGradients->setToolTip(
      tr("Factor on the opacity by how steeply the value changes, per length: low on the left keeps "
         "even material back and shows borders"));
  mUsesGradients->setObjectName("usesGradients");
  mUsesGradients->setToolTip(tr("Make opacity depend on how steeply the value changes, too"));
  connectCanvas(mCanvas);
  connectCanvas(mGradients);
  connect(mUsesGradients, &QCheckBox::clicked, this, &TransferEditor::useGradients);
}

TransferEditor::~TransferEditor() { mJob.reset(); }

QWidget* TransferEditor::makeHeader() {
  auto* header = new QWidget(this);
  auto* row = new QHBoxLayout(header);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  row->addWidget(makeTitle(tr("Colour and opacity"), header), 1);
  auto quiet = [&](const QString& text, const QString& tip) {
    auto* button = new QPushButton(text, header);
    button->setProperty("role", "quiet");
    button->setToolTip(tip);
    row->addWidget(button);
    return button;
  };
  mFit = quiet(tr("Fit"), tr("Show the values that occur"));
  mLogarithmic = quiet(tr("Log"), tr("Heights of the histogram by their logarithm, so that rare values are seen"));
  mLogarithmic->setObjectName("logarithmic");
  mLogarithmic->setCheckable(true);
  mLogarithmic->setChecked(true);
  connect(mLogarithmic, &QPushButton::toggled, this, [this](bool on) {
    mCanvas->setLogarithmic(on);
    mGradients->setLogarithmic(on);
  });
  connect(mFit, &QPushButton::clicked, this, [this] {
    mIsFitted = true;
    mShown = {0, -1, -1};
    refresh();
  });
  return header;
}

QWidget* TransferEditor::makeNumbers() {
  mNumbers = new QStackedWidget(this);
  mNumbers->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* hint = new QLabel(tr("Click the line to add a point, drag to move it"), mNumbers);
  hint->setProperty("role", "muted");
  mNumbers->addWidget(hint);
  auto* numbers = new QWidget(mNumbers);
  mNumbers->addWidget(numbers);
  auto* row = new QHBoxLayout(numbers);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  mValue = makeSpin(numbers, tr("Value"), tr("Value of the selected point or colour"));
  mValue->setObjectName("pointValue");
  mOpacity = makeSpin(numbers, tr("Opacity"), tr("Opacity of the selected point, %"));
  mOpacity->setObjectName("pointOpacity");
  mOpacity->setDecimals(2);
  mOpacity->setRange(0, 100);
  mOpacity->setSuffix(" %");
  mColor = new ColorButton(tr("Colour"), numbers);
  mColor->setObjectName("stopColor");
  mSecond = new QStackedWidget(numbers);
  mSecond->addWidget(mOpacity);
  mSecond->addWidget(mColor);
  mSecond->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  mRemove = new QPushButton(tr("Remove"), numbers);
  mRemove->setObjectName("removePoint");
  mRemove->setProperty("role", "quiet");
  mRemove->setToolTip(tr("Remove the selected point or colour (Del)"));
  row->addWidget(mValue, 3);
  row->addWidget(mSecond, 2);
  row->addWidget(mRemove);
  auto move = [this] {
    selected()->moveSelected(mValue->value(), mOpacity->value() / 100.0);
    mDocument.endMerge();
  };
  connect(mValue, &QDoubleSpinBox::valueChanged, this, move);
  connect(mOpacity, &QDoubleSpinBox::valueChanged, this, move);
  connect(mColor, &ColorButton::picked, this, [this](glm::vec3 color) { selected()->colorSelected(color); });
  connect(mRemove, &QPushButton::clicked, this, [this] { selected()->removeSelected(); });
  return mNumbers;
}

void TransferEditor::connectCanvas(TransferCanvas* canvas) {
  connect(canvas, &TransferCanvas::edited, this, &TransferEditor::edit);
  connect(canvas, &TransferCanvas::settled, this, [this] { mDocument.endMerge(); });
  connect(canvas, &TransferCanvas::viewChanged, this, [this] { mIsFitted = false; });
  connect(canvas, &TransferCanvas::colorWanted, mColor, &QPushButton::click);
  connect(canvas, &TransferCanvas::selectionChanged, this, [this, canvas] {
    if (canvas->selection().part != TransferCanvas::Selection::Part::None) {
      mGradientsActive = canvas == mGradients;
      (mGradientsActive ? mCanvas : mGradients)->select({});
    }
    showNumbers();
  });
}

TransferCanvas* TransferEditor::selected() const { return mGradientsActive ? mGradients : mCanvas; }

void TransferEditor::edit(const QString& label, const scene::TransferFunction& next, bool merge) {
  session::editByHand(
      mDocument, label.toStdString(), [&](scene::Scene& scene) { scene::currentTransfer(scene.volume) = next; }, merge);
}

/// Turns the curve by gradient on or off; a new curve changes nothing at first.
void TransferEditor::useGradients(bool use) {
  double steep = mGradients->view().high;
  session::editByHand(mDocument, use ? "Use gradient opacity" : "Stop gradient opacity", [&](scene::Scene& scene) {
    auto& curve = scene::currentTransfer(scene.volume).gradientOpacities;
    curve.clear();
    if (use) curve = {{0.0, 1.0}, {0.15 * steep, 1.0}, {steep, 1.0}};
  });
}

TransferEditor::Key TransferEditor::shownKey() const {
  const auto& layer = mDocument.shown().volume;
  if (!layer.data) return {0, 0, 0};
  return {layer.data.id(), scene::shownChannel(layer), scene::shownTimeStep(layer)};
}

void TransferEditor::refresh() {
  const scene::VolumeLayer& layer = mDocument.shown().volume;
  setEnabled(bool(layer.data));
  const scene::TransferFunction& transfer = scene::currentTransfer(layer);
  mCanvas->setTransfer(transfer);
  mGradients->setTransfer(transfer);
  bool mixes = scene::mixesChannels(layer);
  mUsesGradients->setVisible(!mixes);  // mixed channels have one gradient, that of their sum
  mUsesGradients->setChecked(!transfer.gradientOpacities.empty());
  mGradients->setVisible(!mixes && !transfer.gradientOpacities.empty());
  if (layer.data) mCanvas->setWhole(wholeAxis());
  if (!layer.data || shownKey() == mShown) return;
  auto found = mCache.find(shownKey());
  if (found != mCache.end()) return showHistograms(found->second);
  countHistograms();
}

/// The data's range, widened to points that lie beyond it, so that they can be reached.
session::AxisView TransferEditor::wholeAxis() const {
  const scene::VolumeLayer& layer = mDocument.shown().volume;
  session::AxisView whole{layer.data->range.x, layer.data->range.y};
  for (const auto& point : scene::currentTransfer(layer).opacities) {
    whole.low = std::min(whole.low, point.value);
    whole.high = std::max(whole.high, point.value);
  }
  return whole;
}

void TransferEditor::countHistograms() {
  if (mJob) return;  // what is wanted then is looked up when this one ends
  Key key = shownKey();
  auto counted = std::make_shared<Histograms>();
  Shared<Volume> volume = mDocument.shown().volume.data;
  mJob = std::make_unique<Job>(
      [counted, volume, key](Progress& progress) {
        counted->values = session::valueHistogram(*volume, std::get<1>(key), std::get<2>(key));
        progress.throwIfCancelled();
        counted->gradients = session::gradientHistogram(*volume, std::get<1>(key), std::get<2>(key));
      },
      nullptr);
  connect(mJob.get(), &Job::finished, this, [this, counted, key](bool done) {
    mJob.release()->deleteLater();
    if (mCache.size() >= kMostCached) mCache.clear();
    if (done) mCache[key] = std::move(*counted);
    if (done || key != shownKey()) refresh();
  });
  mJob->start();
}

void TransferEditor::showHistograms(const Histograms& histograms) {
  const scene::VolumeLayer& layer = mDocument.shown().volume;
  const scene::TransferFunction& transfer = scene::currentTransfer(layer);
  bool isOtherData = std::get<0>(mShown) != std::get<0>(shownKey());
  session::AxisView before = mCanvas->view(), gradientsBefore = mGradients->view();
  mShown = shownKey();
  mCanvas->setHistogram(histograms.values);
  mGradients->setHistogram(histograms.gradients);
  mGradients->setWhole({0.0, 2.0 * histograms.gradients.range.y});
  if (isOtherData || mIsFitted) {
    mCanvas->setView(session::defaultView(histograms.values, transfer));
    mGradients->setView({0.0, histograms.gradients.range.y});
    mIsFitted = true;
  } else {
    mCanvas->setView(before);
    mGradients->setView(gradientsBefore);
  }
  QString unit = QString::fromStdString(layer.data->unit);
  mCanvas->setUnit(unit);
  mGradients->setUnit((unit.isEmpty() ? QString() : unit) + "/" + Length(mDocument.shown()).sceneUnit());
  showNumbers();
}

/// Shows the numbers of the selected point or stop; when none is selected, what can be done.
void TransferEditor::showNumbers() {
  using Part = TransferCanvas::Selection::Part;
  TransferCanvas* canvas = selected();
  auto [part, index] = canvas->selection();
  const scene::TransferFunction& transfer = canvas->transfer();
  const QSignalBlocker quietValue(mValue), quietOpacity(mOpacity);
  mNumbers->setCurrentIndex(part == Part::None ? 0 : 1);
  mValue->setRange(-1e300, 1e300);
  mValue->setDecimals(decimalsFor(canvas->view()));
  mValue->setSingleStep(std::pow(10.0, -decimalsFor(canvas->view())));
  QString unit = QString::fromStdString(mDocument.shown().volume.data ? mDocument.shown().volume.data->unit : "");
  if (mGradientsActive) unit += "/" + Length(mDocument.shown()).sceneUnit();
  mValue->setSuffix(unit.isEmpty() ? QString() : " " + unit);
  mSecond->setCurrentIndex(part == Part::Stop ? 1 : 0);
  if (part == Part::Stop) {
    const auto& stop = transfer.colors[std::size_t(index)];
    mValue->setValue(stop.value);
    mColor->setColor(stop.color);
  } else if (part == Part::Point) {
    const auto& curve = mGradientsActive ? transfer.gradientOpacities : transfer.opacities;
    mValue->setValue(curve[std::size_t(index)].value);
    mOpacity->setValue(100.0 * curve[std::size_t(index)].opacity);
  }
}

}  // namespace velum::gui
