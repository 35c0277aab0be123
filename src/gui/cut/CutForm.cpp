#include "gui/cut/CutForm.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <memory>

#include "gui/kit/Length.h"
#include "gui/kit/Words.h"
#include "gui/rows/FieldRow.h"
#include "gui/service/SelectedCut.h"
#include "gui/view/SideNames.h"
#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/cut/CutEdit.h"
#include "session/cut/ShapeTraits.h"
#include "session/membrane/FirstPlace.h"

namespace velum::gui {

namespace {

constexpr double kFar = 1e9;

/// Says what a control is for, to eyes and ears.
void nameIt(QWidget* control, const QString& words) {
  control->setToolTip(words);
  control->setAccessibleName(words);
}

void setQuietly(NumberField* spin, double value) {
  const QSignalBlocker quiet(spin);
  spin->setValue(value);
}

QHBoxLayout* makeTight(QWidget* widget) {
  auto* layout = new QHBoxLayout(widget);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(5);
  return layout;
}

}  // namespace

CutForm::CutForm(session::Document& document, Selection& selection, JobRunner& jobs, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mSelection(selection),
      mJobs(jobs),
      mGrid(makeFieldGrid(this, 62)),
      mForm(document, this, "cuts.N.", [this] { return scene::cutPlace(mDocument.shown(), mSelection.cut()); }) {
  mForm.setGrid(mGrid);
  makePlace();
  makeDirection();
  makeAlign();
  makeSize();
  makeFace();
  mOfPlace.insert(mOfPlace.end(), {mCentreRow, mCentreLabel, mAxisRow, mAxisLabel, mAlignRow, mAlignLabel});
  showDirections();
}

QLabel* CutForm::addRow(const QString& name, QWidget* control) {
  int line = mGrid->rowCount();
  auto* label = new QLabel(name, this);
  mGrid->addWidget(label, line, 0);
  mGrid->addWidget(control, line, 1);
  return label;
}

void CutForm::editCut(const char* label, const std::function<void(scene::Cut&)>& change, bool merge) {
  scene::Cut placed = mShown;
  change(placed);
  placeCut(mDocument, placed, label, merge);
}

NumberField* CutForm::makeSpin(QWidget* parent, double min, double max, const QString& suffix) {
  auto* spin = new NumberField(parent);
  spin->setRange(min, max);
  spin->setDecimals(1);
  spin->setSuffix(suffix);
  spin->setAlignment(Qt::AlignRight);
  return spin;
}

/// Three numbers side by side. @param change  called with the place and the new value of the number that was changed
QWidget* CutForm::makeTriple(NumberField* (&spins)[3], const QString& name, std::function<void(int, double)> change) {
  auto* row = new QWidget(this);
  auto* layout = new FieldRow(row);
  for (int i = 0; i < 3; ++i) {
    spins[i] = makeSpin(row, -kFar, kFar, {});
    spins[i]->setObjectName(QString("cut%1%2").arg(name).arg(i));
    layout->addWidget(spins[i]);
    connect(spins[i], &QDoubleSpinBox::valueChanged, this, [change, i](double value) { change(i, value); });
  }
  return row;
}

void CutForm::makePlace() {
  mPosition = new NumberRow(-1, 1, 1, {}, this);
  mPosition->setObjectName("cutPosition");
  mPosition->setToolTip(tr("Distance of the plane from the middle of the data, along its normal"));
  mPosition->setName(tr("Position"));
  mPositionLabel = addRow(tr("Position"), mPosition);
  connect(mPosition, &NumberRow::changed, this, [this](double length) {
    editCut(
        "Move cut", [&](scene::Cut& cut) { cut = session::withOffset(mDocument.shown(), cut, length); }, true);
  });
  connect(mPosition, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
  QWidget* row = makeTriple(mCentre, "Centre", [this](int i, double length) {
    editCut("Move cut", [&](scene::Cut& cut) { cut.centre[i] = length; });
  });
  mCentreRow = row;
  mCentreLabel = addRow(tr("Centre"), row);
}

void CutForm::makeDirection() {
  auto* row = new QWidget(this);
  auto* layout = new FieldRow(row);
  QString degrees = QString::fromUtf8("\u00b0");
  auto add = [&](double limit, const QString& prefix, const char* name) {
    auto* spin = makeSpin(row, -limit, limit, degrees);
    spin->setPrefix(prefix);
    spin->setObjectName(name);
    layout->addWidget(spin);
    return spin;
  };
  mAzimuth = add(180, tr("az "), "cutAzimuth");
  mAzimuth->setWrapping(true);
  mElevation = add(90, tr("el "), "cutElevation");
  mSpin = add(360, tr("turn "), "cutSpin");
  nameIt(mSpin, tr("Turn of the box about its axis, degrees"));
  mAxisRow = row;
  mAxisLabel = addRow(tr("Axis"), row);
  mAxisLabel->setToolTip(tr("Where the plane's normal or the shape's axis points"));
  auto turn = [this] {
    session::AxisAngles angles{mAzimuth->value(), mElevation->value()};
    editCut("Turn cut", [&](scene::Cut& cut) { cut.axis = session::axisFromAngles(angles); });
  };
  connect(mAzimuth, &QDoubleSpinBox::valueChanged, this, turn);
  connect(mElevation, &QDoubleSpinBox::valueChanged, this, turn);
  connect(mSpin, &QDoubleSpinBox::valueChanged, this,
          [this](double deg) { editCut("Turn cut", [&](scene::Cut& cut) { cut.spinDeg = deg; }); });
}

void CutForm::makeAlign() {
  mAlignRow = new AlignRow(this);
  mAlignLabel = addRow(tr("Align to"), mAlignRow);
  connect(mAlignRow, &AlignRow::aligned, this, &CutForm::align);
  connect(mAlignRow, &AlignRow::nearestAsked, this, [this] {
    glm::dvec3 axis = mShown.axis * (mShown.shape == scene::CutShape::Plane && mShown.invert ? -1.0 : 1.0);
    align(session::nearestAxis(axis));
  });
}

void CutForm::align(glm::dvec3 axis) {
  auto aligned = [&](const scene::Cut& cut) { return session::alignedCut(mDocument.shown(), cut, axis); };
  const scene::Cut* cut = scene::findCut(mDocument.shown(), mSelection.cut());
  if (!cut) return;
  if (!scene::isMembrane(*cut)) return editCut("Align cut", [&](scene::Cut& one) { one = aligned(one); });
  auto placed = std::make_shared<scene::Cut>(aligned(*cut));
  mJobs.startShort(
      tr("Looking for where the membrane keeps what it protects"),
      [placed, scene = mDocument.shown()](Progress& progress) {
        *placed = session::placedToKeep(scene, *placed, progress).value_or(*placed);
      },
      // A cut that the user has changed meanwhile stays as it is.
      [this, placed, before = *cut] {
        const scene::Cut* now = scene::findCut(mDocument.shown(), before.id);
        if (!now || *now != before) return;
        placeCut(mDocument, *placed, "Align cut");
      });
}

void CutForm::makeSize() {
  mSizeRow = makeTriple(mSize, "Size", [this](int i, double length) {
    editCut("Resize cut", [&](scene::Cut& cut) { cut.size[i] = length; });
  });
  mSizeLabel = addRow(tr("Size"), mSizeRow);
}

void CutForm::makeFace() {
  auto* row = new QWidget(this);
  auto* layout = makeTight(row);
  auto* face = mForm.make(row, "face", tr("Face"),
                          {.object = "cutFace",
                           .tip = tr("How the cut surface looks: lit material, or the data's grey values as on a "
                                     "section"),
                           .step = tr("Change cut face"),
                           .choices = {tr("Shaded"), tr("Section (grey values)")}});
  mFlip = new QPushButton(tr("Flip"), row);
  mFlip->setObjectName("cutFlip");
  mFlip->setCheckable(true);
  layout->addWidget(face, 1);
  layout->addWidget(mFlip);
  mOfPlace.insert(mOfPlace.end(), {row, addRow(tr("Face"), row)});
  mForm.add("faceOpacity", tr("Opacity"),
            {.object = "cutFaceOpacity",
             .tip = tr("Opacity of the grey section on the cut's face, %"),
             .name = tr("Opacity of the face"),
             .step = tr("Change face opacity"),
             .isShown = [this] {
               return mShown.face == scene::CutFace::Section && mShown.shape != scene::CutShape::Everywhere;
             }});
  auto* joined = mForm.make(
      this, "joined", tr("Only with the cut above"),
      {.object = "cutJoined",
       .tip = tr("Removes only what the cut before it in the list removes, too: two planes open "
                 "a wedge, a sphere and a plane a bowl"),
       .step = tr("Join cuts"),
       .stepOff = tr("Part cuts"),
       .isEnabled = [this] { return scene::cutPlace(mDocument.shown(), mShown.id) > 0 && !scene::isInlay(mShown); }});
  addRow(tr("Joined"), joined);
  connect(mFlip, &QPushButton::clicked, this,
          [this] { session::edit(mDocument, session::FlipCut{session::cutKey(mDocument.shown(), mShown.id)}); });
}

void CutForm::showDirections() {
  const QString positive[] = {tr("L"), tr("P"), tr("S")}, negative[] = {tr("R"), tr("A"), tr("I")},
                axes[] = {"x ", "y ", "z "};
  bool known = hasPatientLetters(mDocument.shown());
  for (int i = 0; i < 3; ++i) {
    mCentre[i]->setDirections(known ? positive[i] : QString(), known ? negative[i] : QString());
    mCentre[i]->setPrefix(known ? QString() : axes[i]);
  }
  if (mNamesPatient == known) return;
  mNamesPatient = known;
  nameSides();
}

/// Words of the clinic stand where there is a patient; all else has a front and a top.
void CutForm::nameSides() {
  const scene::Scene& scene = mDocument.shown();
  bool isPatient = *mNamesPatient;
  auto side = [&](int axis, bool isPlus) { return sideName(scene, axis, isPlus); };
  for (int i = 0; i < 3; ++i) {
    QString where = !isPatient ? tr("the %1").arg(side(i, true)) : i == 0 ? tr("the patient's left") : side(i, true);
    nameIt(mCentre[i], tr("Centre: towards %1").arg(where));
  }
  mCentreLabel->setToolTip(isPatient ? tr("In the patient's axes") : tr("Along x, y and z"));
  nameIt(mAzimuth, tr("Azimuth of the axis, degrees: 0 %1, 90 %2, -90 %3, 180 %4")
                       .arg(side(1, false), side(0, true), side(0, false), side(1, true)));
  nameIt(mElevation, tr("Elevation of the axis, degrees: 90 %1, -90 %2").arg(side(2, true), side(2, false)));
  mAlignRow->nameSides(scene);
}

/// The numbers that the shape has, with names that fit.
void CutForm::showSize(const scene::Cut& cut) {
  const auto& sizes = session::traitsOf(cut.shape).sizes;
  bool any = false;
  for (int i = 0; i < 3; ++i) {
    bool used = sizes[std::size_t(i)].tip;
    QString tip = used ? wordsOf(sizes[std::size_t(i)].tip) : QString();
    any = any || used;
    mSize[i]->setVisible(used);
    mSize[i]->setPrefix(wordsOf(sizes[std::size_t(i)].prefix));
    mSize[i]->setToolTip(tip);
    mSize[i]->setAccessibleName(tip);
    setQuietly(mSize[i], cut.size[i]);
  }
  mSizeRow->setVisible(any);
  mSizeLabel->setVisible(any);
}

void CutForm::showCut(const scene::Cut& cut) {
  mShown = cut;
  Length length(mDocument.shown());
  showDirections();
  for (auto* spin : mCentre) spin->setFreeLength(length, false, false);
  for (auto* spin : mSize) spin->setFreeLength(length, true, false);
  mPosition->setLength(length);
  mCentreLabel->setText(tr("Centre, %1").arg(length.unit()));
  mSizeLabel->setText(tr("Size, %1").arg(length.unit()));
  // A cut of the shape Everywhere has neither place nor face.
  bool isPlaced = cut.shape != scene::CutShape::Everywhere;
  for (QWidget* part : mOfPlace) part->setVisible(isPlaced);
  bool isPlane = cut.shape == scene::CutShape::Plane,
       isBall = session::traitsOf(cut.shape).girth == session::Girth::Ball;
  auto [offset, reach] = session::cutPosition(mDocument.shown(), cut);
  mPosition->setVisible(isPlane);
  mPositionLabel->setVisible(isPlane);
  mPosition->setRange(std::min(-reach, offset), std::max(reach, offset));
  mPosition->setValue(offset);
  for (int i = 0; i < 3; ++i) setQuietly(mCentre[i], cut.centre[i]);
  session::AxisAngles angles = session::anglesFromAxis(cut.axis);
  setQuietly(mAzimuth, angles.azimuthDeg);
  setQuietly(mElevation, angles.elevationDeg);
  setQuietly(mSpin, cut.spinDeg);
  mSpin->setVisible(session::hasSides(cut.shape));
  for (QWidget* spin : {static_cast<QWidget*>(mAzimuth), static_cast<QWidget*>(mElevation)}) spin->setEnabled(!isBall);
  showSize(cut);
  mForm.refresh();
  mFlip->setChecked(cut.invert);
  mFlip->setToolTip(isPlane ? tr("Take away the other side (X)")
                            : tr("Keep what is inside and take away all that is outside (X)"));
}

}  // namespace velum::gui
