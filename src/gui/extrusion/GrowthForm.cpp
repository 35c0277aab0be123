#include "gui/extrusion/GrowthForm.h"

#include <fmt/format.h>

#include <QLocale>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "gui/kit/Length.h"
#include "scene/SectionPlane.h"
#include "session/command/Command.h"
#include "session/command/GrowthCommands.h"
#include "session/command/StructureCommands.h"
#include "session/growth/Growths.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

namespace {

/// A text about the limits that the user has drawn for the growth.
QString limitsOf(const scene::Growth& grown) {
  auto barriers = int(grown.barriers.size()), others = int(grown.others.size());
  QStringList limits;
  if (barriers > 0)
    limits << (barriers == 1 ? GrowthForm::tr("a barrier") : GrowthForm::tr("%1 barriers").arg(barriers));
  if (others > 0)
    limits << (others == 1 ? GrowthForm::tr("a place that is not of it")
                           : GrowthForm::tr("%1 places that are not of it").arg(others));
  return limits.join(GrowthForm::tr(" and "));
}

/// A number as commands take it.
std::string textOf(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

}  // namespace

GrowthForm::GrowthForm(session::Session& session, QWidget* parent) : QWidget(parent), mSession(session) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(8);
  mLow = addNumber("growLow", tr("Smallest value that belongs to it"),
                   tr("Smallest value that belongs to the structure: it grows anew as it changes"),
                   tr("Change its smallest value"), "low",
                   [](const scene::Growth& g, double value) { return std::min(value, g.high); });
  mHigh = addNumber("growHigh", tr("Largest value that belongs to it"),
                    tr("Largest value that belongs to the structure: it grows anew as it changes"),
                    tr("Change its largest value"), "high",
                    [](const scene::Growth& g, double value) { return std::max(value, g.low); });
  mSteepest = addNumber("growSteepest", tr("Gradient at which it stops"),
                        tr("Growing stops where the values change by more than this from voxel to voxel; at 0 it does "
                           "not ask.\nOf use where two structures of like values touch"),
                        tr("Stop at edges"), "steepest", [](const scene::Growth&, double value) {
                          return value > 0.0 ? value : scene::Growth::kEndless;
                        });
  mSteepest->setSpecialValueText(tr("off"));
  mBarrier = new QPushButton(tr("Barrier"), this);
  mBarrier->setObjectName("barrierTool");
  mBarrier->setToolTip(tr("Draw a stroke that the structure does not grow through, where it would leak into another"));
  mClosing =
      addNumber("growClosing", tr("How far gaps are closed in it"),
                tr("What has grown is closed: pores and gaps that no ball of this radius gets into become part of "
                   "it, whatever lies there"),
                tr("Close gaps"), "closing", [](const scene::Growth&, double value) { return value; });
  mClosing->setSpecialValueText(tr("off"));
  mFillHoles = new QCheckBox(tr("Fill holes"), this);
  mFillHoles->setObjectName("growFillHoles");
  mFillHoles->setToolTip(tr("What the structure encloses becomes part of it, as marrow of its bone"));
  connect(mFillHoles, &QCheckBox::toggled, this, [this](bool on) {
    change(tr("Fill holes"), "fillHoles", on ? "true" : "false");
    mSession.document().endMerge();
  });
  mText = new QLabel(this);
  mText->setObjectName("growText");
  mText->setProperty("role", "muted");
  mText->setWordWrap(true);
  grid->addWidget(new QLabel(tr("Values"), this), 0, 0);
  grid->addWidget(mLow, 0, 1);
  grid->addWidget(mHigh, 0, 2);
  grid->addWidget(new QLabel(tr("Edges"), this), 1, 0);
  grid->addWidget(mSteepest, 1, 1);
  grid->addWidget(mBarrier, 1, 2);
  grid->addWidget(new QLabel(tr("Gaps"), this), 2, 0);
  grid->addWidget(mClosing, 2, 1);
  grid->addWidget(mFillHoles, 2, 2);
  grid->addWidget(mText, 3, 0, 1, 3);
}

NumberField* GrowthForm::addNumber(const char* name, const QString& spoken, const QString& tip, const QString& step,
                                   const char* field,
                                   const std::function<double(const scene::Growth&, double)>& allowed) {
  auto* spin = new NumberField(this);
  spin->setObjectName(name);
  spin->setAccessibleName(spoken);
  spin->setToolTip(tip);
  connect(spin, &QDoubleSpinBox::valueChanged, this, [this, step, field, allowed](double value) {
    if (const scene::Growth* grown = growth()) change(step, field, textOf(allowed(*grown, value)));
  });
  connect(spin, &QDoubleSpinBox::editingFinished, this, [this] { mSession.document().endMerge(); });
  return spin;
}

void GrowthForm::change(const QString& step, const char* field, const std::string& value) {
  session::Document& document = mSession.document();
  if (!session::findStructure(document.shown(), mStructure)) return;
  std::string name = session::structureNames(document.shown(), {mStructure})[0];
  session::edit(document, session::ChangeGrowth{name, field, value}, true, step.toStdString());
}

const scene::Growth* GrowthForm::growth() const {
  return mStructure > 0 ? session::lastGrowth(mSession.document().shown(), mStructure) : nullptr;
}

void GrowthForm::showStructure(int structure) {
  mStructure = structure;
  const auto& volume = mSession.document().shown().volume.data;
  const scene::Growth* grown = growth();
  setVisible(grown && volume);
  if (!grown || !volume) return;
  showNumbers(*volume, *grown);
  showProgress();
}

void GrowthForm::showNumbers(const Volume& volume, const scene::Growth& grown) {
  double range = double(volume.range.y) - double(volume.range.x);
  bool isWhole = volume.type != SampleType::Float32 && volume.scale == 1.0;
  int decimals = std::max(0, 3 - int(std::floor(std::log10(std::max(range, 1e-12)))));
  QString unit = volume.unit.empty() ? QString() : " " + QString::fromStdString(volume.unit);
  auto show = [range](NumberField* spin, double low, double high, int digits, const QString& suffix, double value) {
    const QSignalBlocker quiet(spin);
    spin->setDecimals(digits);
    spin->setRange(low, high);
    spin->setSingleStep(range / 200.0);
    spin->setSuffix(suffix);
    spin->setValue(value);
  };
  show(mLow, volume.range.x, volume.range.y, isWhole ? 0 : decimals, unit, grown.low);
  show(mHigh, volume.range.x, volume.range.y, isWhole ? 0 : decimals, unit, grown.high);
  show(mSteepest, 0.0, 1e6, decimals, unit + "/" + Length(mSession.document().shown()).sceneUnit(),
       std::isfinite(grown.steepest) ? grown.steepest : 0.0);
  const QSignalBlocker quietClosing(mClosing), quietHoles(mFillHoles);
  mClosing->setFreeLength(Length(mSession.document().shown()), false);
  mClosing->setMinimum(0.0);
  mClosing->setSingleStep(scene::sectionStep(mSession.document().shown()));
  mClosing->setValue(grown.closing);
  mFillHoles->setChecked(grown.fillHoles);
}

void GrowthForm::showProgress() {
  const scene::Growth* grown = growth();
  if (!grown) return;
  session::GrowthStatus status = mSession.growth().status();
  bool isGrowing = status.isGrowing && status.structure == mStructure;
  if (isGrowing) {
    mText->setText(tr("Growing: %1 voxels so far. Esc stops it.").arg(QLocale().toString(qlonglong(status.voxels))));
    return;
  }
  QString text = tr("Grown from its values.");
  if (!grown->barriers.empty() || !grown->others.empty())
    text = tr("Grown from its values, with %1.").arg(limitsOf(*grown));
  mText->setText(text);
}

}  // namespace velum::gui
