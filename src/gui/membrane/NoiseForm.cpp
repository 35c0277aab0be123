#include "gui/membrane/NoiseForm.h"

#include <QGridLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <algorithm>

#include "gui/service/SelectedCut.h"

namespace velum::gui {

namespace {
constexpr int kMost = 1'000'000;  ///< of what can be asked for here
constexpr int kAutomatic = 0;     ///< how the number shows -1
}  // namespace

NoiseForm::NoiseForm(session::Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mSelection(selection),
      mLeast(new QSpinBox(this)),
      mDenoise(new QCheckBox(tr("Take noise out first"), this)),
      mText(new QLabel(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(8);
  grid->setColumnStretch(1, 1);
  auto* name = new QLabel(tr("Least piece"), this);
  name->setBuddy(mLeast);
  mLeast->setObjectName("leastPiece");
  mLeast->setAccessibleName(tr("Least piece that is protected by value, voxels"));
  mLeast->setRange(kAutomatic, kMost);
  mLeast->setSpecialValueText(tr("automatic"));
  mLeast->setSuffix(tr(" voxels"));
  mLeast->setKeyboardTracking(false);
  QString tip =
      tr("What is protected by value counts in pieces of so many voxels or more, joined by their faces.\n"
         "Automatic: as many as noise does not explain. 1: everything counts.");
  mLeast->setToolTip(tip);
  name->setToolTip(tip);
  mDenoise->setObjectName("denoise");
  mDenoise->setToolTip(
      tr("The forces are by the values of the data with its noise taken out: what is thin and little brighter than its "
         "noise holds together, and what is around it is not taken for it"));
  mText->setObjectName("leftOutText");
  mText->setProperty("role", "muted");
  mText->setWordWrap(true);
  mText->hide();
  grid->addWidget(name, 0, 0);
  grid->addWidget(mLeast, 0, 1);
  grid->addWidget(mDenoise, 1, 0, 1, 2);
  grid->addWidget(mText, 2, 0, 1, 2);
  connect(mLeast, &QSpinBox::valueChanged, this, [this](int voxels) {
    editSelectedMembrane(
        mDocument, mSelection, tr("Change membrane: least piece").toStdString(),
        [&](scene::Membrane& m) { m.field.leastPiece = voxels == kAutomatic ? -1 : voxels; }, true);
  });
  connect(mLeast, &QSpinBox::editingFinished, this, [this] { mDocument.endMerge(); });
  connect(mDenoise, &QCheckBox::clicked, this, [this](bool on) {
    editSelectedMembrane(mDocument, mSelection, tr("Change membrane: take noise out").toStdString(),
                         [&](scene::Membrane& m) { m.field.denoise = on; });
  });
}

void NoiseForm::showField(const scene::ForceField& field) {
  const QSignalBlocker quiet(mLeast);
  mLeast->setValue(field.leastPiece < 0 ? kAutomatic : std::max(field.leastPiece, 1));
  mDenoise->setChecked(field.denoise);
  setEnabled(bool(mDocument.shown().volume.data));
}

void NoiseForm::showLeftOut(const membrane::LeftOut& leftOut, double voxelSize, const Length& length) {
  mText->setVisible(leftOut.pieces > 0);
  if (leftOut.pieces == 0) return;
  double percent = 100.0 * double(leftOut.voxels) / double(std::max<std::size_t>(leftOut.protectedVoxels, 1));
  mText->setText(
      tr("Leaves out %1 specks under %2 voxels, %3 % of what is protected by value.")
          .arg(QLocale().toString(qulonglong(leftOut.pieces)))
          .arg(QLocale().toString(leftOut.leastPiece), QLocale().toString(percent, 'f', percent < 9.95 ? 1 : 0)));
  mText->setToolTip(tr("%1 voxels are %L2 %3")
                        .arg(leftOut.leastPiece)
                        .arg(leftOut.leastPiece * voxelSize, 0, 'g', 3)
                        .arg(length.unit() + QChar(0x00b3)));
}

}  // namespace velum::gui
