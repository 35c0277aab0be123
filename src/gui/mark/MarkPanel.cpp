#include "gui/mark/MarkPanel.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Icons.h"
#include "gui/kit/Text.h"
#include "gui/kit/Words.h"
#include "gui/mark/MarkKinds.h"
#include "gui/rows/ListParts.h"
#include "scene/Scene.h"
#include "session/command/DocumentCommands.h"
#include "session/mark/MarkHands.h"
#include "session/mark/MarkWords.h"

namespace velum::gui {

namespace {

constexpr int kMostMarkRows = 8, kToolsInRow = 4, kMarkLabels = 72;

}  // namespace

MarkPanel::MarkPanel(session::Document& document, Selection& selection, MarkMenu& menu, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mSelection(selection),
      mMenu(menu),
      mList(new EyeList("markList", kMostMarkRows, this)),
      mEmpty(new QLabel(tr("Nothing is marked. Take up a tool and click two points for a distance (D), three for an "
                           "angle (A), in the picture or on sections."),
                        this)),
      mForm(document, this, "lettering.marks.N.", [this] { return place(); }),
      mLettering(new LetteringForm(document, this)) {
  QVBoxLayout* layout = makeColumn(this, 14);
  QVBoxLayout* top = makeColumn(new QWidget(this), 8);
  layout->addWidget(top->parentWidget());
  top->addWidget(makeTitle(tr("Marks"), this));
  top->addWidget(makeTools());
  mEmpty->setWordWrap(true);
  mEmpty->setProperty("role", "muted");
  top->addWidget(mEmpty);
  mList->setAccessibleName(tr("Marks"));
  mList->setToolTip(
      tr("The eye shows and hides a mark; F2 or a double click types its words; Del removes it; Ctrl+C "
         "copies its value"));
  mList->setContextMenuPolicy(Qt::CustomContextMenu);
  mList->installEventFilter(this);
  top->addWidget(mList);
  top->addWidget(mButtons = makeButtons());
  top->addWidget(mFields = makeFields());
  layout->addWidget(makeLine(this));
  layout->addWidget(mLettering);
  connect(mList, &QListWidget::currentRowChanged, this, [this](int row) { mSelection.setMark(mList->idAt(row)); });
  connect(&mSelection, &Selection::markChanged, this, &MarkPanel::refresh);
  connect(mList, &EyeList::toggled, &mMenu, &MarkMenu::setVisible);
  connect(mList, &EyeList::renamed, &mMenu, &MarkMenu::setWords);
  connect(mList, &QWidget::customContextMenuRequested, this, [this](QPoint at) {
    QMenu entries(this);
    mMenu.fill(entries, mSelection.mark());
    if (!entries.isEmpty()) entries.exec(mList->viewport()->mapToGlobal(at));
  });
  refresh();
}

QWidget* MarkPanel::makeTools() {
  auto* tools = new QWidget(this);
  auto* grid = new QGridLayout(tools);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  for (const MarkKindRow& row : markKinds()) {
    if (!row.id) continue;
    auto* button = new QToolButton(tools);
    QString title = wordsOf(row.menu).remove('&');
    button->setObjectName(QString(row.id) + "Tool");
    button->setText(title);
    button->setIcon(makeIcon(row.id));
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setAccessibleName(title);
    button->setToolTip(wordsOf(row.tip));
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // all of one width
    int count = int(mTools.size());
    grid->addWidget(button, count / kToolsInRow, count % kToolsInRow);
    mTools.insert(int(row.kind), button);
  }
  return tools;
}

/// What is done to the selected mark.
QWidget* MarkPanel::makeButtons() {
  auto* buttons = new QWidget(this);
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  auto add = [&](const QString& text, const char* name, const QString& tip, void (MarkMenu::*act)(int)) {
    QPushButton* button = makeQuiet(text, name, tip, buttons);
    button->setAccessibleName(text + " " + tr("mark"));
    connect(button, &QPushButton::clicked, this, [this, act] { (mMenu.*act)(mSelection.mark()); });
    row->addWidget(button);
  };
  add(tr("Go there"), "markGo", tr("Bring the crosshair to the selected mark"), &MarkMenu::goTo);
  add(tr("Duplicate"), "markDuplicate", tr("Add a copy of the selected mark"), &MarkMenu::duplicate);
  row->addStretch(1);
  add(tr("Remove"), "markRemove", tr("Remove the selected mark (Del)"), &MarkMenu::remove);
  return buttons;
}

QWidget* MarkPanel::makeFields() {
  auto* fields = new QWidget(this);
  QVBoxLayout* layout = makeColumn(fields, 8);
  QGridLayout* rows = makeFieldGrid(nullptr, kMarkLabels);
  layout->addLayout(rows);
  mForm.setGrid(rows);
  mForm.add("alongSurface", tr("Along the surface"),
            {.object = "markAlongSurface",
             .tip = tr("The way is measured along the surface that is seen, not through the air"),
             .step = tr("Measure along the surface"),
             .stepOff = tr("Measure through the air"),
             .isShown = [this] {
               if (place() < 0) return false;
               scene::MarkKind kind = marks()[std::size_t(place())].kind;
               return kind == scene::MarkKind::Distance || kind == scene::MarkKind::Path;
             }});
  mForm.addWidget(mShownAt = makeShownAt(fields), tr("Shown at"));
  mShownAtLabel = rows->itemAtPosition(rows->rowCount() - 1, 0)->widget();
  mForm.add("opacity", tr("Opacity"),
            {.object = "markOpacity",
             .tip = tr("How much it covers, %"),
             .name = tr("Opacity of the mark"),
             .step = tr("Change opacity of mark")});
  auto color = [this] { return place() < 0 ? std::nullopt : marks()[std::size_t(place())].color; };
  mOwnColor = new OwnColor(mForm, tr("mark"), "markOwnColor", "markColor", color, fields);
  connect(mOwnColor, &OwnColor::asked, this, [this](const std::string& value) {
    if (place() < 0) return;
    session::edit(mDocument, session::SetField{"lettering.marks." + std::to_string(place()) + ".color", value}, false,
                  tr("Change colour of mark").toStdString());
  });
  mForm.addWidget(mOwnColor);
  return fields;
}

QComboBox* MarkPanel::makeShownAt(QWidget* parent) {
  auto* steps = new QComboBox(parent);
  steps->setObjectName("markShownAt");
  steps->setAccessibleName(tr("Time steps at which the mark is shown"));
  steps->setToolTip(tr("A mark is shown and listed at all time steps of a series, or drawn at one of them alone"));
  connect(steps, &QComboBox::activated, this, [this, steps](int row) {
    if (place() < 0) return;
    session::edit(mDocument,
                  session::SetField{"lettering.marks." + std::to_string(place()) + ".timeStep",
                                    std::to_string(steps->itemData(row).toInt())},
                  false, tr("Change time step of mark").toStdString());
  });
  return steps;
}

/// All time steps, the one that is shown, and that of the mark where it is another. Nothing where there is only one.
void MarkPanel::refreshShownAt() {
  const auto& volume = mDocument.shown().volume;
  int own = place() < 0 ? -1 : marks()[std::size_t(place())].timeStep;
  bool hasChoice = own >= 0 || (volume.data && volume.data->timeSteps > 1);
  mShownAt->setVisible(hasChoice);
  mShownAtLabel->setVisible(hasChoice);
  if (!hasChoice) return;
  mShownAt->clear();
  mShownAt->addItem(tr("All time steps"), -1);
  mShownAt->addItem(tr("This time step (%1)").arg(volume.timeStep + 1), volume.timeStep);
  if (own >= 0 && own != volume.timeStep) mShownAt->addItem(tr("Time step %1").arg(own + 1), own);
  mShownAt->setCurrentIndex(mShownAt->findData(own));
}

/// Of the selected mark in the scene's list; -1: none is selected.
int MarkPanel::place() const {
  auto found = std::ranges::find(marks(), mSelection.mark(), &scene::Mark::id);
  return found == marks().end() ? -1 : int(found - marks().begin());
}

void MarkPanel::setMeasured(std::map<int, session::Measured> measured) {
  mMeasured = std::move(measured);
  showList();
}

void MarkPanel::setHidden(std::set<int> marks) {
  if (mHidden == marks) return;
  mHidden = std::move(marks);
  showList();
}

/// In one line; of what is still being measured three dots.
QString MarkPanel::valueOf(const scene::Mark& mark) const {
  if (session::isMeasuredAtOnce(mark)) return localNumber(session::markValue(mDocument.shown(), mark));
  auto found = mMeasured.find(mark.id);
  if (found == mMeasured.end()) return QString::fromUtf8("\u2026");
  const session::Measured& measured = found->second;
  return (measured.text.empty() ? inWords(measured.problem) : localNumber(measured.text)).section('\n', 0, 0);
}

void MarkPanel::showList() {
  const scene::Scene& scene = mDocument.shown();
  std::vector<EyeList::Row> rows;
  auto nameOf = [&](const scene::Mark& mark) {
    std::string name = session::markName(scene, mark);
    const char* title = rowOf(mark.kind).menu;
    bool isKinds = mark.text.empty() && title && name == session::markTitle(mark.kind);
    return isKinds ? wordsOf(title).remove('&') : toText(name).replace('\n', ' ');
  };
  for (const scene::Mark& mark : marks())
    rows.push_back({.id = mark.id,
                    .icon = rowOf(mark.kind).sign,
                    .name = nameOf(mark),
                    .value = valueOf(mark),
                    .isOn = mark.visible,
                    .isDim = mHidden.contains(mark.id),
                    .tip = mHidden.contains(mark.id) ? tr("Hidden here: the picture shows nothing of what it points at")
                                                     : QString()});
  mList->setRows(rows, place());
}

void MarkPanel::refresh() {
  showList();
  bool isAny = !marks().empty(), isSelected = place() >= 0;
  mEmpty->setVisible(!isAny);
  mList->setVisible(isAny);
  mButtons->setVisible(isAny);
  mButtons->setEnabled(isSelected);
  mFields->setVisible(isSelected);
  for (QToolButton* tool : std::as_const(mTools)) tool->setEnabled(marks().size() < scene::kMostMarks);
  mOwnColor->refresh();
  refreshShownAt();
  mForm.refresh();
  mLettering->refresh();
}

void MarkPanel::startRenaming(int mark) {
  mSelection.setMark(mark);
  if (place() < 0) return;
  mList->setFocus(Qt::OtherFocusReason);
  mList->editItem(mList->item(place()));
}

/// Del comes before the command that has the same key.
bool MarkPanel::eventFilter(QObject* watched, QEvent* event) {
  bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (!isKey || watched != mList || place() < 0) return QWidget::eventFilter(watched, event);
  auto* key = static_cast<QKeyEvent*>(event);
  bool isDelete = key->key() == Qt::Key_Delete, isCopy = key->matches(QKeySequence::Copy);
  if (!isDelete && !isCopy) return QWidget::eventFilter(watched, event);
  event->accept();
  if (event->type() == QEvent::KeyPress) isDelete ? mMenu.remove(mSelection.mark()) : mMenu.copy(mSelection.mark());
  return true;
}

}  // namespace velum::gui
