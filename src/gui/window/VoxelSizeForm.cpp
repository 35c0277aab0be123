#include "VoxelSizeForm.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "kit/Preferences.h"
#include "velum/scene/Source.h"

namespace velum::gui {

namespace {

constexpr const char* kKey = "voxelSizeMm";

struct Unit {
  const char* name;
  double millimetres;
};
constexpr Unit kUnits[] = {{"mm", 1.0}, {"\u00b5m", 1e-3}, {"nm", 1e-6}, {"\u00c5", 1e-7}};

struct Usual {
  const char* name;
  glm::dvec3 millimetres;
};
constexpr Usual kUsual[] = {
    {QT_TRANSLATE_NOOP("VoxelSizeForm", "CT of a trunk, 0.7 \u00d7 0.7 \u00d7 1 mm"), {0.7, 0.7, 1.0}},
    {QT_TRANSLATE_NOOP("VoxelSizeForm", "MR of a head, 1 mm"), {1, 1, 1}},
    {QT_TRANSLATE_NOOP("VoxelSizeForm", "Micro-CT, 10 \u00b5m"), {0.01, 0.01, 0.01}},
    {QT_TRANSLATE_NOOP("VoxelSizeForm", "Light sheet 5\u00d7, 1.3 \u00d7 1.3 \u00d7 5 \u00b5m"),
     {0.0013, 0.0013, 0.005}},
    {QT_TRANSLATE_NOOP("VoxelSizeForm", "Confocal 20\u00d7, 0.62 \u00d7 0.62 \u00d7 2 \u00b5m"),
     {0.00062, 0.00062, 0.002}},
    {QT_TRANSLATE_NOOP("VoxelSizeForm", "Confocal 40\u00d7, 0.31 \u00d7 0.31 \u00d7 1 \u00b5m"),
     {0.00031, 0.00031, 0.001}},
    {QT_TRANSLATE_NOOP("VoxelSizeForm", "Confocal 63\u00d7, 0.2 \u00d7 0.2 \u00d7 0.5 \u00b5m"),
     {0.0002, 0.0002, 0.0005}},
    {QT_TRANSLATE_NOOP("VoxelSizeForm", "Electron microscope, 10 nm"), {1e-5, 1e-5, 1e-5}}};

/// The largest unit in which the least edge is one or more.
int unitFor(glm::dvec3 millimetres) {
  double least = std::min({millimetres.x, millimetres.y, millimetres.z});
  // Tenths of a millimetre are told in millimetres, tenths of a micrometre in micrometres.
  for (int i = 0; i < int(std::size(kUnits)); ++i)
    if (least >= 0.02 * kUnits[i].millimetres) return i;
  return int(std::size(kUnits)) - 1;
}

}  // namespace

VoxelSizeForm::VoxelSizeForm(QWidget* parent)
    : QWidget(parent), mUnit(new QComboBox(this)), mUsual(new QComboBox(this)), mSame(new QCheckBox(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  static constexpr const char* kAxes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    mEdges[i] = new NumberField(this);
    mEdges[i]->setObjectName(QString("voxelSize%1").arg(kAxes[i]));
    mEdges[i]->setAccessibleName(tr("Voxel size along %1").arg(kAxes[i]));
    mEdges[i]->setToolTip(
        tr("Edge of a voxel along %1; other units may be typed, as \u201c0.3 um\u201d").arg(kAxes[i]));
    mEdges[i]->setAlignment(Qt::AlignRight);
    mEdges[i]->setMinimumWidth(96);
    grid->addWidget(mEdges[i], 0, i);
    connect(mEdges[i], &QDoubleSpinBox::valueChanged, this, [this, i](double value) {
      if (mSame->isChecked())
        for (NumberField* other : mEdges) other->setValue(value);
      emit changed();
    });
  }
  mUnit->setObjectName("voxelUnit");
  mUnit->setAccessibleName(tr("Unit of the voxel size"));
  mUnit->setToolTip(tr("The unit of the three numbers"));
  for (const Unit& unit : kUnits) mUnit->addItem(QString::fromUtf8(unit.name));
  grid->addWidget(mUnit, 0, 3);
  mSame->setObjectName("voxelSame");
  mSame->setText(tr("The same in &all directions"));
  mSame->setToolTip(tr("Voxels are cubes"));
  mUsual->setObjectName("voxelUsual");
  mUsual->setAccessibleName(tr("Usual voxel sizes"));
  mUsual->setToolTip(tr("The last answer, and what usual scanners and microscopes give"));
  grid->addWidget(mUsual, 1, 0, 1, 4);
  grid->addWidget(mSame, 2, 0, 1, 4);
  fillUsual();
  connect(mUnit, &QComboBox::activated, this, &VoxelSizeForm::showUnit);
  connect(mUsual, &QComboBox::activated, this, [this](int index) {
    glm::dvec3 size = index == 0 ? lastAnswer() : kUsual[std::size_t(index - 1)].millimetres;
    mSame->setChecked(size.x == size.y && size.y == size.z);
    setValue(size);
    emit changed();
  });
  connect(mSame, &QCheckBox::toggled, this, [this](bool on) {
    if (on) mEdges[1]->setValue(mEdges[0]->value()), mEdges[2]->setValue(mEdges[0]->value());
  });
  setValue(lastAnswer());
}

void VoxelSizeForm::fillUsual() {
  glm::dvec3 last = lastAnswer();
  double unit = kUnits[unitFor(last)].millimetres;
  auto number = [&](double edge) { return QString::number(edge / unit, 'g', 4); };
  mUsual->addItem(tr("The last answer, %1 \u00d7 %2 \u00d7 %3 %4")
                      .arg(number(last.x), number(last.y), number(last.z), kUnits[unitFor(last)].name));
  for (const Usual& usual : kUsual) mUsual->addItem(tr(usual.name));
}

/// The lengths stay; what they are told in changes.
void VoxelSizeForm::showUnit(int index) {
  const Unit& unit = kUnits[index];
  glm::dvec3 size = value();
  for (int i = 0; i < 3; ++i) {
    const QSignalBlocker quiet(mEdges[i]);
    mEdges[i]->setUnitBeside(QString::fromUtf8(unit.name), unit.millimetres);
    mEdges[i]->setDecimals(4);
    mEdges[i]->setRange(1e-4, scene::kMostSpacing);
    mEdges[i]->setSingleStep(0.1);
    mEdges[i]->setValue(size[i] / unit.millimetres);
  }
  mUnit->setProperty("shown", index);
}

glm::dvec3 VoxelSizeForm::value() const {
  double unit = kUnits[mUnit->property("shown").toInt()].millimetres;
  return glm::dvec3(mEdges[0]->value(), mEdges[1]->value(), mEdges[2]->value()) * unit;
}

void VoxelSizeForm::setValue(glm::dvec3 millimetres) {
  int index = unitFor(millimetres);
  mUnit->setCurrentIndex(index);
  showUnit(index);
  for (int i = 0; i < 3; ++i) {
    const QSignalBlocker quiet(mEdges[i]);
    mEdges[i]->setValue(millimetres[i] / kUnits[index].millimetres);
  }
}

void VoxelSizeForm::remember() const {
  glm::dvec3 size = value();
  Preferences().setValue(kKey, QVariantList{size.x, size.y, size.z});
}

glm::dvec3 VoxelSizeForm::lastAnswer() {
  QVariantList last = Preferences().value(kKey).toList();
  glm::dvec3 size(1.0);
  for (int i = 0; i < 3 && last.size() == 3; ++i) size[i] = last[i].toDouble();
  bool isUsable = glm::all(glm::greaterThanEqual(size, glm::dvec3(scene::kLeastSpacing))) &&
                  glm::all(glm::lessThanEqual(size, glm::dvec3(scene::kMostSpacing)));
  return isUsable ? size : glm::dvec3(1.0);
}

}  // namespace velum::gui
