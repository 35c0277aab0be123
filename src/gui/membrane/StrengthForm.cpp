#include "gui/membrane/StrengthForm.h"

#include <QHBoxLayout>
#include <algorithm>

#include "gui/kit/Length.h"
#include "gui/kit/Widgets.h"
#include "gui/service/Job.h"
#include "gui/service/SelectedCut.h"

namespace velum::gui {

StrengthForm::StrengthForm(session::Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent), mDocument(document), mSelection(selection), mCanvas(new StrengthCanvas(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  makeHead();
  makeCanvas();
}

StrengthForm::~StrengthForm() { mJob.reset(); }

void StrengthForm::makeHead() {
  auto* head = new QWidget(this);
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  mTitle = makeTitle(tr("Protect"), head);
  mTitle->setObjectName("protectTitle");
  row->addWidget(mTitle, 1);
  mAttribute = new QComboBox(head);
  mAttribute->setObjectName("strengthBy");
  mAttribute->addItems({tr("By value"), tr("By gradient")});
  mAttribute->setAccessibleName(tr("Force by"));
  mAttribute->setToolTip(tr("Which property of the data the curve is over; forces of both add up"));
  row->addWidget(mAttribute);
  layout()->addWidget(head);
  connect(mAttribute, &QComboBox::activated, this, [this] { showCurve(); });
}

void StrengthForm::makeCanvas() {
  layout()->addWidget(mCanvas);
  mCanvas->setObjectName("strengthCanvas");
  mCanvas->setAccessibleName(tr("Force by value: above the line what the sheet protects"));
  mCanvas->setToolTip(
      tr("Force of each value, -1000 to 1000. Above the line: the sheet goes around it, and where it must cut it cuts "
         "what is weaker; below: the sheet is drawn to it, to what is stronger from farther away.\n"
         "Click: add a point. Drag: move it. Right click or Del: remove it.\nKeys: PgUp and PgDn go from one to the "
         "next, arrows move, Ins adds."));
  connect(mCanvas, &StrengthCanvas::settled, this, [this] { mDocument.endMerge(); });
  connect(mCanvas, &StrengthCanvas::edited, this, [this](const QString& label, const StrengthCurve& next, bool merge) {
    auto change = [&, gradient = byGradient()](scene::Membrane& m) {
      (gradient ? m.field.byGradient : m.field.byValue) = next;
    };
    editSelectedMembrane(mDocument, mSelection, label.toStdString(), change, merge);
  });
}

void StrengthForm::showField(const scene::ForceField& field) {
  mShown = field;
  showCurve();
}

void StrengthForm::showCurve() {
  const auto& layer = mDocument.shown().volume;
  for (QWidget* part : {static_cast<QWidget*>(mCanvas), static_cast<QWidget*>(mAttribute)})
    part->setEnabled(bool(layer.data));
  mCanvas->setCurve(byGradient() ? mShown.byGradient : mShown.byValue);
  if (!layer.data) return;
  QString unit = QString::fromStdString(layer.data->unit);
  mCanvas->setUnit(byGradient() ? unit + "/" + Length(mDocument.shown()).sceneUnit() : unit);
  // Of several channels the sheet goes by the one that is edited.
  bool hasSeveral = layer.channels.size() > 1;
  auto channel = std::size_t(std::clamp(layer.channel, 0, layer.data->channels - 1));
  mTitle->setText(hasSeveral ? tr("Protect in %1").arg(QString::fromStdString(layer.channels[channel].name))
                             : tr("Protect"));
  mTitle->setToolTip(hasSeveral ? tr("The channel that is chosen on the page Look: what the sheet goes by")
                                : QString());
  if (mCounted != std::pair(layer.data.id(), layer.channel)) countHistogram();
  session::AxisView view = byGradient() ? session::AxisView{0.0, mGradients.range.y}
                                        : session::AxisView{layer.data->range.x, layer.data->range.y};
  mCanvas->setHistogram(byGradient() ? mGradients : mValues, view);
}

void StrengthForm::countHistogram() {
  if (mJob) return;
  auto values = std::make_shared<Histogram>(), gradients = std::make_shared<Histogram>();
  Shared<Volume> volume = mDocument.shown().volume.data;
  const auto& layer = mDocument.shown().volume;
  int channel = std::clamp(layer.channel, 0, volume->channels - 1),
      timeStep = std::clamp(layer.timeStep, 0, volume->timeSteps - 1);
  mJob = std::make_unique<Job>(
      [=](Progress&) {
        *values = session::valueHistogram(*volume, channel, timeStep);
        *gradients = session::gradientHistogram(*volume, channel, timeStep);
      },
      nullptr);
  connect(mJob.get(), &Job::finished, this,
          [this, values, gradients, of = std::pair(volume.id(), layer.channel)](bool done) {
            mJob.release()->deleteLater();
            if (!done) return;
            mValues = std::move(*values);
            mGradients = std::move(*gradients);
            mCounted = of;
            showCurve();
          });
  mJob->start();
}

}  // namespace velum::gui
