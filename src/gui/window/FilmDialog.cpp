#include "gui/window/FilmDialog.h"

#include <QDialogButtonBox>
#include <utility>

namespace velum::gui {

FilmDialog::FilmDialog(const QString& title, int pictureWidth, QWidget* parent)
    : QDialog(parent), mColumn(new QVBoxLayout(this)), mPreview(new FilmPreview(pictureWidth, this)) {
  setWindowTitle(title);
  mColumn->setContentsMargins(18, 18, 18, 14);
  mColumn->setSpacing(14);
  mColumn->addWidget(mPreview);
  connect(mPreview, &FilmPreview::told, this, &FilmDialog::tell);
}

void FilmDialog::addButtons(const Act& main, const Act& other) {
  auto* buttons = new QDialogButtonBox(this);
  mMain = new QPushButton(main.text, buttons);
  mMain->setProperty("role", "main");  // before the box shows it: the style is chosen then
  buttons->addButton(mMain, QDialogButtonBox::AcceptRole);
  mMain->setDefault(true);
  mOther = buttons->addButton(other.text, QDialogButtonBox::ActionRole);
  buttons->addButton(QDialogButtonBox::Cancel);
  for (auto [button, act] : {std::pair{mMain, &main}, std::pair{mOther, &other}}) {
    button->setObjectName(act->name);
    button->setToolTip(act->tip);
  }
  mColumn->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

}  // namespace velum::gui
