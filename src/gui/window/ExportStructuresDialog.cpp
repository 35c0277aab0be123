#include "gui/window/ExportStructuresDialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "scene/Scene.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

ExportStructuresDialog::ExportStructuresDialog(const scene::Scene& scene, std::vector<int> selected, QWidget* parent)
    : QDialog(parent), mSelected(std::move(selected)) {
  setWindowTitle(tr("Export structures"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(18, 18, 18, 14);
  layout->setSpacing(10);
  addChoice(layout, scene);
  layout->addSpacing(6);
  addShape(layout);
  layout->addSpacing(6);
  auto* buttons = new QDialogButtonBox(this);
  auto* save = new QPushButton(tr("Choose file..."), buttons);
  save->setProperty("role", "main");  // before the box shows it: the style is chosen then
  save->setToolTip(tr("Choose where they go and in which format"));
  buttons->addButton(save, QDialogButtonBox::AcceptRole);
  save->setDefault(true);
  buttons->addButton(QDialogButtonBox::Cancel);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ExportStructuresDialog::addChoice(QLayout* layout, const scene::Scene& scene) {
  mAll = new QRadioButton(tr("&All structures"), this);
  mAll->setToolTip(tr("Every structure that has voxels, hidden ones, too"));
  QString name = mSelected.size() == 1 ? QString::fromStdString(session::structureName(scene, mSelected[0]))
                                       : tr("%n selected", nullptr, int(mSelected.size()));
  mOnly = new QRadioButton(mSelected.empty() ? tr("&Selected ones") : tr("&Only %1").arg(name), this);
  mOnly->setToolTip(tr("Those that are selected in the list of structures"));
  mOnly->setEnabled(!mSelected.empty());
  (mSelected.empty() ? mAll : mOnly)->setChecked(true);
  mAll->setObjectName("exportAll");
  mOnly->setObjectName("exportSelected");
  layout->addWidget(mAll);
  layout->addWidget(mOnly);
}

void ExportStructuresDialog::addShape(QLayout* layout) {
  mApart = new QCheckBox(tr("A &file for each"), this);
  mApart->setObjectName("exportApart");
  mApart->setToolTip(tr("Write a file for each structure, with its name behind the one that you choose"));
  auto* title = new QLabel(tr("Smoothing of surfaces"), this);
  mSmooth = new NumberRow(0, 100, 0, " %", this);
  mSmooth->setObjectName("exportSmooth");
  mSmooth->setName(tr("Smoothing of surfaces"));
  mSmooth->setToolTip(tr("How far surfaces are rounded off: 0 as the picture shows them. Their volume stays"));
  mSmooth->setValue(session::StructureExport().smoothness * 100.0);
  layout->addWidget(mApart);
  layout->addWidget(title);
  layout->addWidget(mSmooth);
}

session::StructureExport ExportStructuresDialog::options() const {
  session::StructureExport options;
  if (mOnly->isChecked()) options.structures = mSelected;
  options.smoothness = mSmooth->value() / 100.0;
  options.apart = mApart->isChecked();
  return options;
}

}  // namespace velum::gui
