#include "gui/structure/StructurePanel.h"

#include <QGridLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/kit/Length.h"
#include "gui/service/EditField.h"
#include "session/command/Command.h"
#include "session/command/StructureCommands.h"
#include "session/document/StructureShapes.h"

namespace velum::gui {

namespace {

constexpr int kNamePixels = 170;  // what eye and button leave of the panel

}  // namespace

StructurePanel::StructurePanel(StructureCommands& commands, AreaMeter& areas, Selection& selection, QWidget* parent)
    : QWidget(parent), mCommands(commands), mAreas(areas), mDocument(commands.document()), mSelection(selection) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  auto* layout = makeColumn(this, 0);
  mEmpty = makeEmpty();
  mFull = new QWidget(this);
  auto* full = makeColumn(mFull, 12);
  full->addWidget(makeHead());
  full->addWidget(makeLine(mFull));
  auto* list = new QWidget(mFull);
  auto* rows = makeColumn(list, 6);
  mList = new StructureList(commands, areas, list);
  rows->addWidget(makeSearch());
  rows->addWidget(mKey = new CountKey(CountKey::Of::Pixels, list));
  mKey->hide();
  rows->addWidget(mList, 1);
  rows->addWidget(makeFoot());
  full->addWidget(list, 1);
  full->addWidget(makeDetail());
  layout->addWidget(mEmpty);
  layout->addWidget(mFull, 1);
  connect(mList, &StructureList::picked, &mSelection, &Selection::setStructure);
  connect(mList->selectionModel(), &QItemSelectionModel::selectionChanged, this, &StructurePanel::showSelected);
  connect(&mSelection, &Selection::structureChanged, this, [this](int id) {
    // What was clicked in a view is shown, even if the search would hide it.
    int row = mList->rows().rowOf(id);
    if (row >= 0 && !mList->order().mapFromSource(mList->rows().index(row, 0)).isValid()) mSearch->clear();
    mList->selectId(id);
  });
  connect(&mCommands, &StructureCommands::renameAsked, this, [this](int id) {
    mList->setFocus();
    mList->editName(id);
  });
  connect(&mCommands.meter(), &StructureMeter::valuesMeasured, this, [this] {
    mList->rows().valuesChanged();
    mList->order().invalidate();
  });
  connect(&mCommands.meter(), &StructureMeter::measured, this, [this] {
    mList->rows().sizesChanged();
    mList->order().invalidate();
    showCount();
  });
  refresh();
}

QWidget* StructurePanel::makeEmpty() {
  auto* empty = new QWidget(this);
  auto* layout = makeColumn(empty, 10);
  layout->addWidget(makeTitle(tr("No structures yet"), empty));
  auto* text =
      new QLabel(tr("Open a label volume beside the scan: a segmentation in NIfTI, NRRD, MetaImage or DICOM SEG. "
                    "Each structure can then be coloured, hidden, and left whole by a cut."),
                 empty);
  text->setWordWrap(true);
  text->setProperty("role", "muted");
  layout->addWidget(text);
  auto* open = new QPushButton(tr("Open labels beside..."), empty);
  open->setProperty("role", "main");
  open->setToolTip(tr("Choose a file of labels for what is open"));
  layout->addWidget(open, 0, Qt::AlignLeft);
  connect(open, &QPushButton::clicked, this, &StructurePanel::openLabelsAsked);
  layout->addStretch(1);
  return empty;
}

QWidget* StructurePanel::makeHead() {
  auto* head = new QWidget(mFull);
  auto* layout = makeColumn(head, 8);
  ListHead title =
      makeListHead("labelsShown", tr("Labels shown"), tr("Whether the labels change anything at all"), head);
  mName = title.name, mShown = title.shown;
  auto* open = makeQuiet(tr("Open others..."), "", tr("Open labels beside what is open, in place of these"), head);
  title.row->addWidget(open);
  layout->addLayout(title.row);
  layout->addLayout(makeShares(head));
  connect(open, &QPushButton::clicked, this, &StructurePanel::openLabelsAsked);
  connect(mShown, &EyeButton::clicked, this, [this](bool on) { session::edit(mDocument, session::ShowLabels{on}); });
  return head;
}

QGridLayout* StructurePanel::makeShares(QWidget* head) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(8);
  grid->setColumnMinimumWidth(0, 72);
  grid->setColumnStretch(1, 1);
  auto add = [&](const QString& name, const QString& objectName, const QString& tip) {
    auto* number = new NumberRow(0, 100, 0, " %", head);
    number->setObjectName(objectName);
    number->setToolTip(tip);
    number->setName(name);
    int line = grid->rowCount();
    grid->addWidget(new QLabel(name, head), line, 0);
    grid->addWidget(number, line, 1);
    return number;
  };
  mTint = add(tr("Tint"), "labelTint", tr("How far structures take their own colour rather than the volume's, %"));
  mUnlabelled = add(tr("Unlabelled"), "labelUnlabelled", tr("Opacity of all that belongs to no structure, %"));
  mOnSections = add(tr("On sections"), "labelOnSections", tr("Opacity of the structures' colours on the sections, %"));
  driveShare(mTint, "Change tint", "labels.tint");
  driveShare(mUnlabelled, "Fade what has no label", "labels.unlabelled");
  driveShare(mOnSections, "Labels on sections", "sections.labelOpacity");
  return grid;
}

void StructurePanel::driveShare(NumberRow* row, const char* step, const char* field) {
  connect(row, &NumberRow::changed, this, [this, step, field](double percent) {
    setField(mDocument, field, QString::number(percent / 100.0, 'g', 17).toStdString(), step, true);
  });
  connect(row, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
}

QWidget* StructurePanel::makeSearch() {
  auto* bar = new QWidget(mFull);
  ListSearch search = makeListSearch("structure", bar);
  mSearch = search.field;
  mSearch->setPlaceholderText(tr("Search name or number"));
  mSearch->setToolTip(tr("Lists the structures whose name holds these words, or that have this number (Ctrl+F)"));
  mSearch->setAccessibleName(tr("Search structures"));
  search.sort->setToolTip(tr("The order of the list"));
  auto* group = new QActionGroup(search.menu);
  using Key = StructureOrder::Key;
  for (auto [name, key] : {std::pair(tr("By number"), Key::Number),
                           {tr("By name"), Key::Name},
                           {tr("By size"), Key::Size},
                           {tr("By mean value"), Key::Mean},
                           {tr("By largest value"), Key::Most}}) {
    QAction* action = search.addChoice(group, name, key == Key::Number);
    connect(action, &QAction::triggered, this, [this, key = key] {
      mList->order().setKey(key);
      measureValues();
    });
  }
  search.menu->addSeparator();
  QAction* absent = search.menu->addAction(tr("List those without voxels, too"));
  absent->setObjectName("structureAbsent");
  absent->setCheckable(true);
  connect(absent, &QAction::toggled, this, [this](bool on) {
    mList->order().setAbsentShown(on);
    showCount();
  });
  auto addSwitch = [&](const char* objectName, const QString& text, const QString& tip) {
    QToolButton* button = search.addSwitch(objectName, text, tip);
    connect(button, &QToolButton::toggled, this, &StructurePanel::showColumns);
    return button;
  };
  mValues = addSwitch("structureValues", tr("Values"),
                      tr("The mean and the largest of the scan's values in each structure: HU of a CT, SUV of a PET"));
  mBars = addSwitch("structureBars", tr("Bars"),
                    tr("How much of each structure is seen, hidden and removed in the picture; drag a bar to pull the "
                       "structure out of the cuts"));
  connect(mSearch, &QLineEdit::textChanged, this, &StructurePanel::setSearch);
  connect(mSearch, &QLineEdit::returnPressed, this, [this] { mList->setFocus(); });
  return bar;
}

QWidget* StructurePanel::makeFoot() {
  auto* foot = new QWidget(mFull);
  auto* all = makeQuiet(tr("Show all"), "showAll", tr("Show all that are listed"), foot);
  auto* none = makeQuiet(tr("Hide all"), "hideAll", tr("Hide all that are listed"), foot);
  auto* invert = makeQuiet(tr("Invert"), "invertShown",
                           tr("Show what is hidden and hide what is shown, of all that are listed"), foot);
  mCount = makeListFoot({all, none, invert}, tr("Structures that are shown, of those that are listed"), foot);
  connect(all, &QPushButton::clicked, this, [this] { mCommands.setVisible(mList->listedIds(), true); });
  connect(none, &QPushButton::clicked, this, [this] { mCommands.setVisible(mList->listedIds(), false); });
  connect(invert, &QPushButton::clicked, this, [this] { mCommands.invertVisible(mList->listedIds()); });
  return foot;
}

QWidget* StructurePanel::makeDetail() {
  mDetail = new QWidget(mFull);
  auto* layout = makeColumn(mDetail, 8);
  layout->addWidget(makeLine(mDetail));
  mDetailName = makeTitle({}, mDetail);
  mDetailName->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  layout->addWidget(mDetailName);
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  mColor = new ColorButton(tr("Colour of the structure"), mDetail);
  mColor->setObjectName("structureColor");
  mColor->setFixedSize(40, 26);
  mOpacity = new NumberRow(0, 100, 0, " %", mDetail);
  mOpacity->setObjectName("structureOpacity");
  mOpacity->setToolTip(tr("Opacity of the selected structures, %"));
  mOpacity->setName(tr("Opacity"));
  row->addWidget(mColor);
  row->addWidget(mOpacity, 1);
  layout->addLayout(row);
  auto* shape = new QHBoxLayout;
  shape->setSpacing(10);
  auto* name = new QLabel(tr("Smoothing"), mDetail);
  name->setMinimumWidth(72);
  mSmoothing = new NumberRow(0, 1, 1, " mm", mDetail);
  mSmoothing->setObjectName("structureSmoothing");
  mSmoothing->setName(tr("Smoothing"));
  shape->addWidget(name);
  shape->addWidget(mSmoothing, 1);
  layout->addLayout(shape);
  connect(mSmoothing, &NumberRow::settled, this, [this] {
    emit smoothingAsked(mList->selectedIds(), mSmoothing->value());
    showSelected();  // what is so, until it is done
  });
  connect(mColor, &ColorButton::picked, this,
          [this](glm::vec3 color) { mCommands.setColor(mList->selectedIds(), color); });
  connect(mOpacity, &NumberRow::changed, this,
          [this](double percent) { mCommands.dragOpacity(mList->selectedIds(), percent / 100.0); });
  connect(mOpacity, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
  return mDetail;
}

/// Values or bars: there is no room for both.
void StructurePanel::showColumns(bool on) {
  QToolButton* other = sender() == mBars ? mValues : mBars;
  if (const QSignalBlocker quiet(other); on) other->setChecked(false);
  using Shown = StructureList::Shown;
  mList->setShown(mBars->isChecked() ? Shown::Bars : mValues->isChecked() ? Shown::Values : Shown::Opacity);
  mKey->setVisible(mBars->isChecked());
  mAreas.setOn(mBars->isChecked());
  measureValues();
}

/// Measures the scan's values, only while they are shown.
void StructurePanel::measureValues() {
  using Key = StructureOrder::Key;
  bool isOrder = mList->order().key() == Key::Mean || mList->order().key() == Key::Most;
  if ((mValues->isChecked() || isOrder) && isVisible()) mCommands.meter().measureValues(mDocument.shown());
}

/// Bars and values were not counted while nobody saw them.
void StructurePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  mAreas.refresh();
  measureValues();
}

void StructurePanel::startSearch() {
  mSearch->setFocus(Qt::ShortcutFocusReason);
  mSearch->selectAll();
}

void StructurePanel::setSearch(const QString& text) {
  mList->order().setSearch(text);
  mList->selectId(mSelection.structure());
  showCount();
}

void StructurePanel::showCount() {
  std::size_t shown = 0;
  auto ids = mList->listedIds();
  std::sort(ids.begin(), ids.end());
  for (const auto& structure : mDocument.shown().labels.structures)
    shown += structure.visible && std::binary_search(ids.begin(), ids.end(), structure.id);
  mCount->setText(tr("%1 of %2").arg(shown).arg(ids.size()));
}

void StructurePanel::showSelected() {
  auto ids = mList->selectedIds();
  const scene::Scene& scene = mDocument.shown();
  const scene::Structure* first = ids.empty() ? nullptr : session::findStructure(scene, ids[0]);
  mDetail->setEnabled(first);
  QString name = tr("Select a structure");
  if (first && ids.size() > 1) name = tr("%n structures", nullptr, int(ids.size()));
  if (first && ids.size() == 1) name = QString::fromStdString(session::structureName(scene, ids[0]));
  mDetailName->setText(mDetailName->fontMetrics().elidedText(name, Qt::ElideRight, std::max(120, width())));
  mDetailName->setToolTip(name);
  mColor->setColor(first ? first->color : glm::vec3(0.5f));
  mOpacity->setValue(first ? first->opacity * 100.0 : 100.0);
  showSmoothing(first);
}

void StructurePanel::showSmoothing(const scene::Structure* structure) {
  const scene::Scene& scene = mDocument.shown();
  Length length(scene);
  bool isOfFile = structure && session::isOfFile(scene.labels, structure->id);
  mSmoothing->setEnabled(isOfFile);
  mSmoothing->setToolTip(
      isOfFile || !structure
          ? tr("How far the shape of the selected structures is smoothed, %1; 0 leaves it as the file has it")
                .arg(length.unit())
          : tr("What was grown follows the values of the scan; shapes of a file can be smoothed"));
  mSmoothing->setLength(length);
  mSmoothing->setRange(0.0, std::max(session::widestSmoothing(scene), 1e-9));
  mSmoothing->setValue(structure ? structure->smoothing : 0.0);
}

void StructurePanel::refresh() {
  const scene::Scene& scene = mDocument.shown();
  const scene::LabelLayer& labels = scene.labels;
  measureValues();
  if (mIsMade && labels == mShownLabels && scene.sections.labelOpacity == mShownOnSections) return;
  mIsMade = true;
  mShownLabels = labels;
  mShownOnSections = scene.sections.labelOpacity;
  bool any = bool(labels.data) || !labels.structures.empty();
  mEmpty->setVisible(!any);
  mFull->setVisible(any);
  mCommands.meter().measure(labels.data);
  QString name = labels.data ? QString::fromStdString(labels.data->name) : tr("Labels");
  mName->setText(mName->fontMetrics().elidedText(name.isEmpty() ? tr("Labels") : name, Qt::ElideMiddle, kNamePixels));
  mName->setToolTip(QString::fromStdString(labels.source.path));
  mShown->setChecked(labels.visible);
  mTint->setValue(labels.tint * 100.0);
  mUnlabelled->setValue(labels.unlabelled * 100.0);
  mOnSections->setValue(scene.sections.labelOpacity * 100.0);
  mList->rows().setLengthUnit(scene.unit);
  mList->rows().setRows(labels.structures, session::soloStructure(scene));
  if (!session::findStructure(scene, mSelection.structure())) mSelection.setStructure(0);
  mList->selectId(mSelection.structure());
  showSelected();
  showCount();
}

}  // namespace velum::gui
