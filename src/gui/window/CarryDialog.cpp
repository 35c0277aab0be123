#include "gui/window/CarryDialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "core/Error.h"
#include "gui/kit/CoreWords.h"
#include "gui/kit/Text.h"
#include "gui/kit/Widgets.h"
#include "gui/rows/FieldForm.h"
#include "gui/service/SavePath.h"
#include "session/film/Retarget.h"

namespace velum::gui {

namespace {

constexpr int kCarryNameWidth = 70, kPathWidth = 300, kTypingMs = 400;

}  // namespace

CarryDialog::CarryDialog(const scene::Scene& scene, const QString& folder, QWidget* parent)
    : QDialog(parent), mLabels(scene.labels), mFolder(folder), mReading(kTypingMs, this) {
  setWindowTitle(tr("Carry over to other data"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(18, 18, 18, 14);
  layout->setSpacing(12);
  auto* what = new QLabel(tr("The look, the cuts and the film of this scene go to other data: another patient, another "
                             "specimen. Undo brings this data back, and saving asks for a file of its own."),
                          this);
  what->setWordWrap(true);
  layout->addWidget(what);
  auto* grid = makeFieldGrid(nullptr, kCarryNameWidth);
  mVolume =
      addPath(grid, tr("Volume"), "carryVolume", tr("The other volume: a file, or a folder of DICOM images"), true);
  mOther = addPath(grid, tr("Labels"), "carryLabels", tr("Labels of the other volume, where there are some"), false);
  mStructure = new QComboBox(this);
  mStructure->setObjectName("carryStructure");
  mStructure->setAccessibleName(tr("Places by"));
  mStructure->setToolTip(
      tr("By what camera, cuts and marks are found again: the box of the data, or a structure of both"));
  grid->addWidget(new QLabel(tr("Places by"), this), grid->rowCount(), 0);
  grid->addWidget(mStructure, grid->rowCount() - 1, 1);
  layout->addLayout(grid);
  mSaid = new QLabel(this);
  mSaid->setObjectName("carrySaid");
  mSaid->setWordWrap(true);
  layout->addWidget(mSaid);
  layout->addStretch(1);
  addButtons(layout);
  offer({});
  connect(mVolume, &QLineEdit::textChanged, this, &CarryDialog::tell);
  connect(mOther, &QLineEdit::textChanged, this, &CarryDialog::readLabels);
  tell();
}

QLineEdit* CarryDialog::addPath(QGridLayout* grid, const QString& title, const char* name, const QString& tip,
                                bool mayBeFolder) {
  auto* line = new QLineEdit(this);
  line->setObjectName(name);
  line->setToolTip(tip);
  line->setAccessibleName(title);
  line->setMinimumWidth(kPathWidth);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(line, 1);
  auto addButton = [&](const QString& text, const QString& spoken, bool folder) {
    auto* button = new QPushButton(text, this);
    button->setAutoDefault(false);
    button->setToolTip(spoken);
    button->setAccessibleName(spoken);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, line, folder] { browse(*line, folder); });
  };
  addButton(tr("File..."), tr("Choose a file: %1").arg(title), false);
  if (mayBeFolder) addButton(tr("Folder..."), tr("Choose a folder: %1").arg(title), true);
  int at = grid->rowCount();
  grid->addWidget(new QLabel(title, this), at, 0);
  grid->addLayout(row, at, 1);
  return line;
}

void CarryDialog::browse(QLineEdit& line, bool folder) {
  QString start = line.text().isEmpty() ? mFolder : QFileInfo(line.text()).path(), title = line.accessibleName();
  QString path = folder ? QFileDialog::getExistingDirectory(this, title, start)
                        : QFileDialog::getOpenFileName(this, title, start, volumeFilters(title));
  if (path.isEmpty()) return;
  mFolder = QFileInfo(path).path();
  line.setText(path);
}

void CarryDialog::addButtons(QLayout* layout) {
  auto* buttons = new QDialogButtonBox(this);
  mCarry = new QPushButton(tr("Carry over"), buttons);
  mCarry->setProperty("role", "main");  // before the box shows it: the style is chosen then
  mCarry->setObjectName("carry");
  mCarry->setToolTip(tr("Read the other data, and show it as this scene shows its own"));
  buttons->addButton(mCarry, QDialogButtonBox::AcceptRole);
  mCarry->setDefault(true);
  buttons->addButton(QDialogButtonBox::Cancel);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void CarryDialog::offer(const std::vector<std::string>& structures) {
  mStructure->clear();
  mStructure->addItem(tr("The box of the data"), QString());
  for (const std::string& name : structures) mStructure->addItem(readableText(name), toText(name));
  mStructure->setEnabled(mStructure->count() > 1);
}

/// Looks what the labels that are named have in common with those of the scene.
void CarryDialog::readLabels() {
  QString path = mOther->text().trimmed();
  if (path == mRead) return tell();
  mRead = path;
  mWhyNotRead.clear();
  mReading.stop();
  offer({});
  if (mLabels.data && QFileInfo::exists(path)) {
    struct Found {
      std::vector<std::string> names;
      std::string error;
    };
    auto found = std::make_shared<Found>();
    auto work = [found, labels = mLabels, path = path.toStdString()](Progress& progress) {
      try {
        found->names = session::sharedStructures(labels, path, progress);
      } catch (const Error& error) {
        found->error = error.what();
      }
    };
    mReading.want([work] { return work; },
                  [this, found] {
                    mWhyNotRead = found->error;
                    offer(found->names);
                    tell();
                  });
  }
  tell();
}

void CarryDialog::tell() {
  QString volume = mVolume->text().trimmed(), labels = mOther->text().trimmed(), why;
  auto expectThere = [&](const QString& path) {
    if (!path.isEmpty() && !QFileInfo::exists(path)) why = tr("There is no %1").arg(path);
  };
  expectThere(volume);
  expectThere(labels);
  if (!mWhyNotRead.empty()) why = inWords(mWhyNotRead);
  mCarry->setEnabled(why.isEmpty() && !volume.isEmpty());
  QString hint;
  if (isReading())
    hint = tr("Looking for structures that both have ...");
  else if (mLabels.data && labels.isEmpty())
    hint = tr("With labels, structures are found again by their names; without, they are left out.");
  else if (mStructure->count() > 1)
    hint = tr("%n structures are in both.", nullptr, mStructure->count() - 1);
  else if (mLabels.data)
    hint = tr("No structure is in both by its name.");
  sayIn(*mSaid, why.isEmpty() ? hint : why, !why.isEmpty());
}

session::CarryScene CarryDialog::call() const {
  auto whole = [](const QLineEdit& line) {
    QString path = line.text().trimmed();
    return path.isEmpty() ? std::string() : QFileInfo(path).absoluteFilePath().toStdString();
  };
  return {whole(*mVolume), whole(*mOther), mStructure->currentData().toString().toStdString()};
}

}  // namespace velum::gui
