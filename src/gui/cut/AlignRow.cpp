#include "gui/cut/AlignRow.h"

#include <QHBoxLayout>

#include "gui/kit/Length.h"
#include "gui/view/SideNames.h"

namespace velum::gui {

namespace {

struct AlignSide {
  const char* letter;  ///< in the name of its button
  int axis;
  bool isPlus;
};
constexpr AlignSide kAlignSides[] = {{"R", 0, false}, {"L", 0, true}, {"A", 1, false},
                                     {"P", 1, true},  {"S", 2, true}, {"I", 2, false}};

}  // namespace

AlignRow::AlignRow(QWidget* parent) : QWidget(parent), mNearest(new QPushButton(tr("Nearest"), this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(5);
  for (std::size_t i = 0; i < std::size(kAlignSides); ++i) {
    auto* button = mSides[i] = new QPushButton(this);
    button->setObjectName(QString("align") + kAlignSides[i].letter);
    button->setProperty("role", "small");
    button->setMinimumWidth(24);
    glm::dvec3 axis(0.0);
    axis[kAlignSides[i].axis] = kAlignSides[i].isPlus ? 1.0 : -1.0;
    connect(button, &QPushButton::clicked, this, [this, axis] { emit aligned(axis); });
    layout->addWidget(button, 1);
  }
  mNearest->setObjectName("alignNearest");
  mNearest->setProperty("role", "small");
  connect(mNearest, &QPushButton::clicked, this, &AlignRow::nearestAsked);
  layout->addWidget(mNearest, 2);
}

void AlignRow::nameSides(const scene::Scene& scene) {
  bool isPatient = hasPatientLetters(scene);
  QString point = isPatient ? tr("Point the axis to the patient's %1; a plane takes away what lies there")
                            : tr("Point the axis to the %1; a plane takes away what lies there");
  for (std::size_t i = 0; i < std::size(kAlignSides); ++i) {
    QString side = sideName(scene, kAlignSides[i].axis, kAlignSides[i].isPlus);
    mSides[i]->setText(sideSign(scene, kAlignSides[i].axis, kAlignSides[i].isPlus));
    mSides[i]->setToolTip(point.arg(side));
    mSides[i]->setAccessibleName(tr("Align to %1").arg(side));
  }
  mNearest->setToolTip(isPatient ? tr("Turn the axis to the patient's axis that is nearest")
                                 : tr("Turn the axis to x, y or z, whichever is nearest"));
}

}  // namespace velum::gui
