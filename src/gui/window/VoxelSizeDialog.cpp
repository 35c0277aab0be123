#include "gui/window/VoxelSizeDialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace velum::gui {

VoxelSizeDialog::VoxelSizeDialog(const QString& text, QWidget* parent)
    : QDialog(parent), mForm(new VoxelSizeForm(this)) {
  setObjectName("voxelSizeDialog");
  setWindowTitle(tr("Voxel size"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(18, 18, 18, 14);
  layout->setSpacing(12);
  auto* why = new QLabel(text, this);
  why->setWordWrap(true);
  why->setMinimumWidth(420);
  layout->addWidget(why);
  layout->addWidget(mForm);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  auto* take = new QPushButton(tr("&Set size"), buttons);
  take->setProperty("role", "main");
  take->setDefault(true);
  buttons->addButton(take, QDialogButtonBox::AcceptRole);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    mForm->remember();
    accept();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  mForm->startTyping();
}

}  // namespace velum::gui
