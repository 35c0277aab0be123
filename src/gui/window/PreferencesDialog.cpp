#include "PreferencesDialog.h"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>

#include "kit/Preferences.h"

namespace velum::gui {

namespace {

QLabel* makePath(const QString& path, QWidget* parent) {
  auto* label = new QLabel(path, parent);
  label->setProperty("role", "muted");
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

}  // namespace

PreferencesDialog::PreferencesDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Preferences"));
  auto* form = new QFormLayout(this);
  form->setContentsMargins(20, 18, 20, 16);
  form->setHorizontalSpacing(16);
  form->setVerticalSpacing(12);
  auto* theme = new QComboBox(this);
  theme->setObjectName("theme");
  theme->addItems({tr("Dark"), tr("Light")});
  theme->setToolTip(tr("Dark lets the picture glow; light is easier in a bright room"));
  theme->setCurrentIndex(Preferences().theme() == ThemeKind::Light ? 1 : 0);
  connect(theme, &QComboBox::currentIndexChanged, this, [](int index) {
    ThemeKind kind = index == 1 ? ThemeKind::Light : ThemeKind::Dark;
    Preferences().setTheme(kind);
    applyTheme(*qApp, kind);
  });
  form->addRow(tr("&Appearance"), theme);
  form->addRow(tr("Preferences"), makePath(Preferences().path(), this));
  auto* keys = makePath(Preferences::folder() + "/keys.json", this);
  keys->setToolTip(
      tr("Write your own shortcuts there, as in {\"cut.addPlane\": [\"P\"]}; the user guide lists the commands"));
  form->addRow(tr("Your keys"), keys);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

}  // namespace velum::gui
