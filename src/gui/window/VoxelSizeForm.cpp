#include "gui/window/VoxelSizeForm.h"

#include <QLocale>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "gui/kit/Preferences.h"
#include "gui/kit/Words.h"
#include "scene/Scene.h"
#include "scene/Source.h"

namespace velum::gui {

namespace {

constexpr const char* kKey = "voxelSizeMm";
constexpr int kDecimals = 7;  ///< so that tenths of a nanometre can be typed where millimetres are shown

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
    {QT_TRANSLATE_NOOP("Words", "CT of a trunk, 0.7 \u00d7 0.7 \u00d7 1 mm"), {0.7, 0.7, 1.0}},
    {QT_TRANSLATE_NOOP("Words", "MR of a head, 1 mm"), {1, 1, 1}},
    {QT_TRANSLATE_NOOP("Words", "Micro-CT, 10 \u00b5m"), {0.01, 0.01, 0.01}},
    {QT_TRANSLATE_NOOP("Words", "Light sheet 5\u00d7, 1.3 \u00d7 1.3 \u00d7 5 \u00b5m"), {0.0013, 0.0013, 0.005}},
    {QT_TRANSLATE_NOOP("Words", "Confocal 20\u00d7, 0.62 \u00d7 0.62 \u00d7 2 \u00b5m"), {0.00062, 0.00062, 0.002}},
    {QT_TRANSLATE_NOOP("Words", "Confocal 40\u00d7, 0.31 \u00d7 0.31 \u00d7 1 \u00b5m"), {0.00031, 0.00031, 0.001}},
    {QT_TRANSLATE_NOOP("Words", "Confocal 63\u00d7, 0.2 \u00d7 0.2 \u00d7 0.5 \u00b5m"), {0.0002, 0.0002, 0.0005}},
    {QT_TRANSLATE_NOOP("Words", "Electron microscope, 10 nm"), {1e-5, 1e-5, 1e-5}}};

/// The largest unit in which the least edge is one or more.
int unitFor(glm::dvec3 millimetres) {
  double least = std::min({millimetres.x, millimetres.y, millimetres.z});
  // Tenths of a millimetre are told in millimetres, tenths of a micrometre in micrometres.
  for (int i = 0; i < int(std::size(kUnits)); ++i)
    if (least >= 0.02 * kUnits[i].millimetres) return i;
  return int(std::size(kUnits)) - 1;
}

/// An edge of a voxel: as many digits as were given, no zeros behind them.
class EdgeField : public NumberField {
 public:
  using NumberField::NumberField;
  QString textFromValue(double value) const override {
    QString text = NumberField::textFromValue(value);
    while (text.contains(locale().decimalPoint()) && text.endsWith('0')) text.chop(1);
    return text.endsWith(locale().decimalPoint()) ? text.chopped(locale().decimalPoint().size()) : text;
  }
};

QVariant toVariant(glm::dvec3 size) { return QVariantList{size.x, size.y, size.z}; }

bool isUsable(glm::dvec3 size) {
  return glm::all(glm::greaterThanEqual(size, glm::dvec3(scene::kLeastSpacing))) &&
         glm::all(glm::lessThanEqual(size, glm::dvec3(scene::kMostSpacing)));
}

std::optional<glm::dvec3> fromVariant(const QVariant& variant) {
  QVariantList list = variant.toList();
  if (list.size() != 3) return std::nullopt;
  glm::dvec3 size(list[0].toDouble(), list[1].toDouble(), list[2].toDouble());
  return isUsable(size) ? std::optional(size) : std::nullopt;
}

}  // namespace

VoxelSizeForm::VoxelSizeForm(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  // In the order in which Tab goes through them.
  addEdges(*grid);
  mUnit = new QComboBox(this);
  mUnit->setObjectName("voxelUnit");
  mUnit->setAccessibleName(tr("Unit of the voxel size"));
  mUnit->setToolTip(tr("The unit of the three numbers"));
  mUnit->setFocusPolicy(Qt::StrongFocus);
  for (const Unit& unit : kUnits) mUnit->addItem(QString::fromUtf8(unit.name));
  grid->addWidget(mUnit, 0, 3);
  addUsual();
  grid->addWidget(mUsual, 1, 0, 1, 4);
  mSame = new QCheckBox(tr("The same in &all directions"), this);
  mSame->setObjectName("voxelSame");
  mSame->setToolTip(tr("Voxels are cubes"));
  grid->addWidget(mSame, 2, 0, 1, 4);
  connect(mUnit, &QComboBox::activated, this, &VoxelSizeForm::chooseUnit);
  connect(mSame, &QCheckBox::toggled, this, [this](bool on) {
    if (on) mEdges[1]->setValue(mEdges[0]->value()), mEdges[2]->setValue(mEdges[0]->value());
  });
  setGuess(firstGuess(false));
}

void VoxelSizeForm::addEdges(QGridLayout& grid) {
  static constexpr const char* kAxes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    mEdges[i] = new EdgeField(this);
    mEdges[i]->setObjectName(QString("voxelSize%1").arg(kAxes[i]));
    mEdges[i]->setAccessibleName(tr("Voxel size along %1").arg(kAxes[i]));
    mEdges[i]->setToolTip(tr("Edge of a voxel along %1; other units may be typed, as \u201c"
                             "0.3 um\u201d")
                              .arg(kAxes[i]));
    mEdges[i]->setAlignment(Qt::AlignRight);
    mEdges[i]->setMinimumWidth(96);
    grid.addWidget(mEdges[i], 0, i);
    connect(mEdges[i], &QDoubleSpinBox::valueChanged, this, [this](double value) {
      mIsKnown = false;
      if (mSame->isChecked())
        for (NumberField* other : mEdges) other->setValue(value);
      emit changed();
    });
  }
}

/// Nothing is chosen of them at first.
void VoxelSizeForm::addUsual() {
  mUsual = new QComboBox(this);
  mUsual->setObjectName("voxelUsual");
  mUsual->setAccessibleName(tr("Usual voxel sizes"));
  mUsual->setPlaceholderText(tr("Usual sizes..."));
  mUsual->setToolTip(tr("What usual scanners and microscopes give, and what was answered last"));
  mUsual->setFocusPolicy(Qt::StrongFocus);
  if (auto last = lastAnswer()) {
    const Unit& unit = kUnits[unitFor(*last)];
    auto number = [&](double edge) { return QLocale().toString(edge / unit.millimetres, 'g', 4); };
    mUsual->addItem(tr("The last answer, %1 \u00d7 %2 \u00d7 %3 %4")
                        .arg(number(last->x), number(last->y), number(last->z), QString::fromUtf8(unit.name)),
                    toVariant(*last));
  }
  for (const Usual& usual : kUsual) mUsual->addItem(wordsOf(usual.name), toVariant(usual.millimetres));
  mUsual->setCurrentIndex(-1);
  connect(mUsual, &QComboBox::activated, this, [this](int index) {
    glm::dvec3 size = fromVariant(mUsual->itemData(index)).value_or(glm::dvec3(1.0));
    mSame->setChecked(size.x == size.y && size.y == size.z);
    setValue(size);
    emit changed();
  });
}

void VoxelSizeForm::chooseUnit(int index) {
  showIn(index, mIsKnown ? value() / kUnits[index].millimetres : numbers());
  emit changed();
}

void VoxelSizeForm::showIn(int index, glm::dvec3 numbers) {
  const Unit& unit = kUnits[index];
  for (int i = 0; i < 3; ++i) {
    const QSignalBlocker quiet(mEdges[i]);
    mEdges[i]->setUnitBeside(QString::fromUtf8(unit.name), unit.millimetres);
    mEdges[i]->setDecimals(kDecimals);
    mEdges[i]->setRange(std::pow(10.0, -kDecimals), scene::kMostSpacing);
    mEdges[i]->setSingleStep(0.1);
    mEdges[i]->setValue(numbers[i]);
  }
  mShownUnit = index;
  mUnit->setCurrentIndex(index);
}

glm::dvec3 VoxelSizeForm::numbers() const { return {mEdges[0]->value(), mEdges[1]->value(), mEdges[2]->value()}; }

glm::dvec3 VoxelSizeForm::value() const { return numbers() * kUnits[mShownUnit].millimetres; }

void VoxelSizeForm::setValue(glm::dvec3 millimetres) {
  setGuess(millimetres);
  mIsKnown = true;
}

void VoxelSizeForm::setGuess(glm::dvec3 millimetres) {
  int unit = unitFor(millimetres);
  showIn(unit, millimetres / kUnits[unit].millimetres);
  mIsKnown = false;
}

void VoxelSizeForm::startTyping() {
  mEdges[0]->setFocus();
  mEdges[0]->selectAll();
}

void VoxelSizeForm::remember() const { Preferences().setValue(kKey, toVariant(value())); }

std::optional<glm::dvec3> VoxelSizeForm::lastAnswer() { return fromVariant(Preferences().value(kKey)); }

glm::dvec3 VoxelSizeForm::firstGuess(bool isMicroscope) {
  auto last = lastAnswer();
  bool isOfKind = last && (!isMicroscope || unitFor(*last) > 0);
  return isOfKind ? *last : glm::dvec3(isMicroscope ? 1e-3 : 1.0);
}

}  // namespace velum::gui
