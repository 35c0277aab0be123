#include "gui/window/PreferencesDialog.h"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "core/Memory.h"
#include "gui/kit/Language.h"
#include "gui/kit/Preferences.h"
#include "gui/window/KeysPage.h"

namespace velum::gui {

namespace {

constexpr int kMostMemory = 1 << 20;  // MiB
constexpr double kBytesOfUnit = 1 << 20;
constexpr int kMostLevel = 7;  // that can be chosen for all volumes

QLabel* makeQuiet(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", "muted");
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QFormLayout* makeForm(QWidget* page) {
  auto* form = new QFormLayout(page);
  form->setContentsMargins(16, 16, 16, 12);
  form->setHorizontalSpacing(16);
  form->setVerticalSpacing(12);
  return form;
}

QComboBox* makeChoice(QWidget* page, const char* object, const QStringList& texts, int now, const QString& tip) {
  auto* choice = new QComboBox(page);
  choice->setObjectName(object);
  choice->addItems(texts);
  choice->setCurrentIndex(now);
  choice->setToolTip(tip);
  return choice;
}

void changeHabits(const std::function<void(Habits&)>& change) {
  Habits habits = Preferences::habits();
  change(habits);
  Preferences().setHabits(habits);
}

}  // namespace

PreferencesDialog::PreferencesDialog(ActionTable& actions, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Preferences"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 14, 14, 12);
  auto* pages = new QTabWidget(this);
  pages->setObjectName("preferencePages");
  pages->addTab(makeGeneral(), tr("&General"));
  pages->addTab(makeHand(), tr("&Mouse and wheel"));
  pages->addTab(new KeysPage(actions, this), tr("&Keys"));
  pages->addTab(makeMemory(), tr("M&emory"));
  layout->addWidget(pages, 1);
  layout->addWidget(makeQuiet(tr("Kept in %1").arg(Preferences::folder()), this));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(buttons);
  resize(620, 460);
}

QWidget* PreferencesDialog::makeGeneral() {
  auto* page = new QWidget(this);
  QFormLayout* form = makeForm(page);
  auto* theme = makeChoice(page, "theme", {tr("Dark"), tr("Light")}, Preferences().theme() == ThemeKind::Light ? 1 : 0,
                           tr("Dark lets the picture glow; light is easier in a bright room"));
  connect(theme, &QComboBox::activated, this, [](int index) {
    ThemeKind kind = index == 1 ? ThemeKind::Light : ThemeKind::Dark;
    Preferences().setTheme(kind);
    applyTheme(*qApp, kind);
  });
  form->addRow(tr("&Appearance"), theme);
  QStringList codes = {""}, names = {tr("As the system's")};
  for (const Language& language : languages()) {
    codes << language.code;
    names << language.name;
  }
  auto* spoken = makeChoice(page, "language", names, std::max(0, int(codes.indexOf(Preferences().language()))),
                            tr("Of the window, from the next start on; files and scripts stay as they are"));
  connect(spoken, &QComboBox::activated, this, [codes](int index) { Preferences().setLanguage(codes[index]); });
  form->addRow(tr("Language"), spoken);
  // The names are scene::Layout's.
  static const QStringList kLayouts = {"", "four-up", "volume", "volume-and-section", "section"};
  auto* first =
      makeChoice(page, "firstLayout",
                 {tr("As it was last"), tr("Four views"), tr("3D only"), tr("3D and one section"), tr("One section")},
                 std::max(0, int(kLayouts.indexOf(Preferences().firstLayout()))), tr("The views in which data opens"));
  connect(first, &QComboBox::activated, this, [](int index) { Preferences().setFirstLayout(kLayouts[index]); });
  form->addRow(tr("&Views of new data"), first);
  static const QStringList kUnits = {"", "mm", QString::fromUtf8("\u00b5m"), "nm", QString::fromUtf8("\u00c5")};
  auto* unit = makeChoice(page, "lengthUnit", QStringList{tr("What suits the data")} + kUnits.mid(1),
                          std::max(0, int(kUnits.indexOf(Preferences::habits().lengthUnit))),
                          tr("In which lengths are shown; any unit can be typed"));
  connect(unit, &QComboBox::activated, this, [this](int index) {
    changeHabits([index](Habits& habits) { habits.lengthUnit = kUnits[index]; });
    emit changed();
  });
  form->addRow(tr("Unit of lengt&hs"), unit);
  return page;
}

QWidget* PreferencesDialog::makeHand() {
  auto* page = new QWidget(this);
  QFormLayout* form = makeForm(page);
  const Habits& now = Preferences::habits();
  auto add = [&](const char* object, const QString& name, const QStringList& texts, bool Habits::*field,
                 const QString& tip) {
    auto* choice = makeChoice(page, object, texts, now.*field ? 0 : 1, tip);
    connect(choice, &QComboBox::activated, this,
            [field](int index) { changeHabits([&](Habits& habits) { habits.*field = index == 0; }); });
    form->addRow(name, choice);
  };
  add("mouseLeft", tr("&Left button in 3D"), {tr("Turns; the middle one moves"), tr("Moves; the middle one turns")},
      &Habits::leftTurns, tr("What dragging does in the 3D view; with Shift the left button does the other"));
  add("wheelVolume", tr("&Wheel forward in 3D"), {tr("Comes nearer"), tr("Goes away")},
      &Habits::wheelForwardComesNearer, tr("Which way the wheel moves the eye"));
  add("wheelSection", tr("Wheel in &sections"),
      {tr("Goes through the planes; with Ctrl nearer"), tr("Comes nearer; with Ctrl through the planes")},
      &Habits::wheelGoesThroughPlanes, tr("What the wheel does over a section"));
  form->addRow(makeQuiet(tr("The right button comes nearer in 3D, and sets the grey window in sections."), page));
  return page;
}

QWidget* PreferencesDialog::makeMemory() {
  auto* page = new QWidget(this);
  QFormLayout* form = makeForm(page);
  auto* most = new QSpinBox(page);
  most->setObjectName("graphicsMemory");
  most->setRange(0, kMostMemory);
  most->setSingleStep(256);
  most->setSuffix(tr(" MiB"));
  most->setSpecialValueText(tr("What the card has"));
  most->setValue(Preferences().graphicsMemory());
  most->setToolTip(tr("Most of the graphics card's memory that is used; larger volumes are shown reduced"));
  connect(most, &QSpinBox::valueChanged, this, [](int value) { Preferences().setGraphicsMemory(value); });
  form->addRow(tr("&Graphics memory at most"), most);
  form->addRow(makeQuiet(tr("Counts when Velum starts next. The variable VELUM_GPU_MEMORY_MB goes before it. Where a "
                            "volume does not fit it is shown reduced, which the status line says."),
                         page));
  addVolumes(*page, *form);
  return page;
}

/// Volumes of any size: what they take, and how fine they open.
void PreferencesDialog::addVolumes(QWidget& page, QFormLayout& form) {
  auto add = [&](const char* object, const QString& name, double MemoryBudget::*field, int least, const QString& usual,
                 const QString& tip) {
    auto* size = new QSpinBox(&page);
    size->setObjectName(object);
    size->setRange(least, kMostMemory);
    size->setSingleStep(256);
    size->setSuffix(tr(" MiB"));
    if (!usual.isEmpty()) size->setSpecialValueText(usual);
    size->setValue(int(Preferences().memory().*field / kBytesOfUnit));
    size->setToolTip(tip);
    connect(size, &QSpinBox::valueChanged, this, [this, field](int value) {
      MemoryBudget budget = Preferences().memory();
      budget.*field = value * kBytesOfUnit;
      Preferences().setMemory(budget);
      emit changed();
    });
    form.addRow(name, size);
  };
  add("brickMemory", tr("Memory for &bricks"), &MemoryBudget::brickBytes, 0,
      tr("An eighth of the machine's (%1 MiB)").arg(qint64(machineBytes() / 8 / kBytesOfUnit)),
      tr("Most of the machine's memory that keeps bricks of a streamed volume; 64 MiB at least, half of "
         "it at most. Counts at once"));
  add("gpuBrickMemory", tr("Graphics memory for b&ricks"), &MemoryBudget::gpuBrickBytes, 0,
      tr("A quarter of the card's, 2048 MiB at most"),
      tr("Most of the graphics card's memory for a streamed volume: where less is there than is seen, all is shown "
         "coarser. Counts at once, and the picture begins anew"));
  add("wholeSize", tr("Read whole up &to"), &MemoryBudget::wholeBytes, 1, {},
      tr("Volumes with levels of detail up to this size are read whole, larger ones are streamed. Counts for what is "
         "opened next"));
  QStringList levels{tr("As the screen shows it"), tr("0, the finest")};
  for (int i = 1; i <= kMostLevel; ++i) levels << tr("%1, coarser").arg(i);
  auto* level =
      makeChoice(&page, "volumeLevel", levels, std::clamp(Preferences().level(), -1, kMostLevel) + 1,
                 tr("The level of detail at which volumes open. A level that is chosen here is read whole, or "
                    "the next that fits into half of the memory. Counts for what is opened next"));
  connect(level, &QComboBox::activated, this, [](int index) { Preferences().setLevel(index - 1); });
  form.addRow(tr("Level of &detail"), level);
}

}  // namespace velum::gui
