#include "gui/model/ModelPanel.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/kit/Text.h"
#include "session/command/Command.h"
#include "session/command/ModelCommands.h"
#include "session/model/TypesAt.h"

namespace velum::gui {

namespace {

constexpr int kMostNotes = 3;  // lines that are read at once; the rest is in the tip

}  // namespace

ModelPanel::ModelPanel(ModelCommands& commands, Equalizer& equalizer, QWidget* parent)
    : QWidget(parent), mCommands(commands), mDocument(commands.document()) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  auto* layout = makeColumn(this, 10);
  layout->addWidget(makeHead());
  layout->addWidget(mSteps = new EqualizeSteps(this));
  auto* list = new QWidget(this);
  auto* rows = makeColumn(list, 6);
  mBar = new EqualizerBar(mDocument, equalizer, list);
  mList = new ModelList(commands, equalizer, list);
  mHiders = new HidersBox(list);
  rows->addWidget(mBar);
  rows->addWidget(makeSearch());
  rows->addWidget(mList, 1);
  rows->addWidget(mHiders);
  rows->addWidget(makeFoot());
  layout->addWidget(list, 1);
  layout->addWidget(makeLine(this));
  layout->addWidget(mLooks = new ModelLookGrid(mDocument, this));
  layout->addWidget(makeRows());
  connect(mBar, &EqualizerBar::percentAsked, mList, &ModelList::setPercent);
  connectHiders();
  connect(mList, &ModelList::picked, &mCommands.selection(), &Selection::setType);
  connect(&mCommands.selection(), &Selection::typeChanged, this, [this](int type) {
    // What was clicked in the picture is shown, even if the search would hide it.
    if (type >= 0 && !mList->order().mapFromSource(mList->tree().indexOfType(type, 0)).isValid()) mSearch->clear();
    mList->selectType(type);
  });
  refresh();
}

QWidget* ModelPanel::makeHead() {
  auto* head = new QWidget(this);
  auto* layout = makeColumn(head, 6);
  ListHead title = makeListHead("modelShown", tr("Model shown"), tr("Whether the model is drawn at all"), head);
  mName = title.name, mShown = title.shown;
  mLegend = new QCheckBox(tr("Legend"), head);
  mLegend->setObjectName("modelLegend");
  mLegend->setToolTip(tr("Colours and names of the types that are seen most, over the picture"));
  title.row->addWidget(mLegend);
  layout->addLayout(title.row);
  mNotes = new QLabel(head);
  mNotes->setObjectName("modelNotes");
  mNotes->setProperty("role", "muted");
  mNotes->setWordWrap(true);
  layout->addWidget(mNotes);
  connect(mLegend, &QCheckBox::clicked, this, &ModelPanel::legendAsked);
  connect(mShown, &EyeButton::clicked, this, [this](bool on) { session::edit(mDocument, session::ShowModel{on}); });
  return head;
}

QWidget* ModelPanel::makeSearch() {
  auto* bar = new QWidget(this);
  ListSearch search = makeListSearch("model", bar);
  mSearch = search.field;
  mSearch->setPlaceholderText(tr("Search types"));
  mSearch->setToolTip(tr("Lists the types and compartments whose name holds these words"));
  mSearch->setAccessibleName(tr("Search types"));
  search.sort->setToolTip(tr("The order of the types in their compartments, and which of them are listed"));
  fillOrders(search);
  connect(mSearch, &QLineEdit::textChanged, this, &ModelPanel::setSearch);
  connect(mSearch, &QLineEdit::returnPressed, this, [this] { mList->setFocus(); });
  return bar;
}

void ModelPanel::fillOrders(const ListSearch& search) {
  using Key = TypeOrder::Key;
  search.menu->addSection(tr("Sort"));
  auto* keys = new QActionGroup(search.menu);
  std::vector<std::pair<QString, Key>> orders = {
      {tr("By number of instances"), Key::Count}, {tr("By name"), Key::Name}, {tr("By mass"), Key::Mass}};
  for (std::size_t i = 0; i < kCountKinds.size(); ++i)
    orders.emplace_back(tr("By share that is %1").arg(toText(kCountKinds[i].adjective)), TypeOrder::keyOf(CountOf(i)));
  for (const auto& [name, key] : orders)
    connect(search.addChoice(keys, name, key == Key::Count), &QAction::triggered, this,
            [this, key = key] { mList->order().setKey(key); });
  using Only = TypeOrder::Only;
  search.menu->addSection(tr("List"));
  auto* filters = new QActionGroup(search.menu);
  for (auto [name, only] : {std::pair(tr("All types"), Only::All),
                            {tr("Types that are seen"), Only::Seen},
                            {tr("Types of which none is seen"), Only::Unseen},
                            {tr("Types of which some are removed"), Only::Removed}})
    connect(search.addChoice(filters, name, only == Only::All), &QAction::triggered, this,
            [this, only = only] { mList->order().setOnly(only); });
}

void ModelPanel::connectHiders() {
  connect(mHiders, &HidersBox::clearAsked, this,
          [this](const QString& path) { mCommands.setInView(path.toStdString(), true); });
  auto typesOf = [this](const QString& path) {
    return session::typesAt(*mDocument.scene().model.data, path.toStdString()).types;
  };
  connect(mHiders, &HidersBox::hideAsked, this,
          [this, typesOf](const QString& path) { mCommands.setVisible(typesOf(path), false); });
  connect(mHiders, &HidersBox::selectAsked, this,
          [this, typesOf](const QString& path) { mCommands.selection().setType(int(typesOf(path).front())); });
}

void ModelPanel::showHiding(const session::Hiding& hiding) {
  mHiders->showHiding(hiding, mDocument.scene().model);
  std::string path = hiding.path;
  session::TypeNumbers types = session::typesAt(*mDocument.scene().model.data, path).types;
  if (types.size() == 1) mCommands.selection().setType(int(types[0]));
}

QWidget* ModelPanel::makeFoot() {
  auto* foot = new QWidget(this);
  auto* all = makeQuiet(tr("Show all"), "modelShowAll", tr("Show all that are listed"), foot);
  auto* none = makeQuiet(tr("Hide all"), "modelHideAll", tr("Hide all that are listed"), foot);
  auto* reset = makeQuiet(tr("Reset"), "modelReset",
                          tr("Show all that are listed, in the palette's colours and the finish's material"), foot);
  mCount = makeListFoot({all, none, reset}, tr("Types that are shown, of all"), foot);
  mCount->setObjectName("modelCount");
  connect(all, &QPushButton::clicked, this, [this] { mCommands.setVisible(mList->listedTypes(), true); });
  connect(none, &QPushButton::clicked, this, [this] { mCommands.setVisible(mList->listedTypes(), false); });
  connect(reset, &QPushButton::clicked, this, [this] { mCommands.reset(mList->listedTypes()); });
  return foot;
}

NumberRow* ModelPanel::addNumber(QGridLayout* grid, const QString& name, const char* objectName, const QString& tip,
                                 NumberRow* row) {
  row->setObjectName(objectName);
  row->setName(name);
  row->setToolTip(tip);
  int line = grid->rowCount();
  grid->addWidget(new QLabel(name, this), line, 0);
  grid->addWidget(row, line, 1);
  connect(row, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
  return row;
}

NumberRow* ModelPanel::addShare(QGridLayout* grid, const QString& name, const char* objectName, const QString& tip,
                                const char* label, std::function<double&(scene::Scene&)> field) {
  NumberRow* row = addNumber(grid, name, objectName, tip, new NumberRow(0, 100, 0, " %", this));
  connect(row, &NumberRow::changed, this, [this, label, field = std::move(field)](double percent) {
    mDocument.edit(
        label, [&](scene::Scene& scene) { field(scene) = percent / 100.0; }, true);
  });
  return row;
}

QWidget* ModelPanel::makeRows() {
  auto* section = new QWidget(this);
  auto* grid = new QGridLayout(section);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(7);
  grid->setColumnMinimumWidth(0, 84);
  grid->setColumnStretch(1, 1);
  mPalette = new QComboBox(section);
  mPalette->setObjectName("modelPalette");
  mPalette->setAccessibleName(tr("Palette"));
  mPalette->addItems({tr("By type"), tr("By compartment"), tr("By function"), tr("By element"), tr("By chain")});
  mPalette->setToolTip(tr("What instances have their colours by; a type's own colour goes before"));
  grid->addWidget(new QLabel(tr("Palette"), section), 0, 0);
  grid->addWidget(mPalette, 0, 1);
  connect(mPalette, &QComboBox::activated, this, [this](int index) {
    mDocument.edit("Choose palette", [&](scene::Scene& scene) { scene.model.palette = scene::Palette(index); });
  });
  mNear = addShare(grid, tr("Up close"), "modelNear",
                   tr("How far chains and elements show as shades of the colour where one is close, %"),
                   "Change colours up close", [](scene::Scene& s) -> double& { return s.model.nearColors; });
  mOcclusion = addShare(grid, tr("Occlusion"), "modelOcclusion", tr("Darkening between instances, %"),
                        "Change occlusion", [](scene::Scene& s) -> double& { return s.lighting.occlusion; });
  mShadow = addShare(grid, tr("Shadows"), "modelShadow", tr("Strength of the shadows that the key light casts, %"),
                     "Change shadows", [](scene::Scene& s) -> double& { return s.lighting.shadow; });
  mFog = addShare(grid, tr("Fog"), "modelFog", tr("How far what lies deepest fades into the background, %"),
                  "Change fog", [](scene::Scene& s) -> double& { return s.lighting.fog; });
  mGhosts = new QComboBox(section);
  mGhosts->setObjectName("modelGhosts");
  mGhosts->setAccessibleName(tr("Ghosts"));
  mGhosts->addItems({tr("None"), tr("Filled"), tr("Contour")});
  mGhosts->setToolTip(tr("How instances that cuts have removed still show; a type's own choice goes before"));
  int ghostLine = grid->rowCount();
  grid->addWidget(new QLabel(tr("Ghosts"), section), ghostLine, 0);
  grid->addWidget(mGhosts, ghostLine, 1);
  connect(mGhosts, &QComboBox::activated, this, [this](int index) {
    mDocument.edit("Choose ghosts", [&](scene::Scene& scene) { scene.model.ghosts = scene::Ghosts(index); });
  });
  mGhostOpacity = addShare(grid, tr("Opacity"), "modelGhostOpacity", tr("Of the ghosts, %"), "Change opacity of ghosts",
                           [](scene::Scene& s) -> double& { return s.model.ghostOpacity; });
  mDetail = addNumber(grid, tr("Detail"), "modelDetail",
                      tr("How much of a pixel drawn shapes may be off by: smaller is finer, and slower"),
                      new NumberRow(0.1, 16, 1, " px", section));
  connect(mDetail, &NumberRow::changed, this, [this](double pixels) {
    mDocument.edit(
        "Change detail", [&](scene::Scene& scene) { scene.model.detail = pixels; }, true);
  });
  mCopies = addNumber(grid, tr("Copies"), "modelCopies", tr("Of the whole model, side by side in a block"),
                      new NumberRow(1, 64, 0, {}, section));
  connect(mCopies, &NumberRow::changed, this, [this](double count) {
    mDocument.edit(
        "Change copies", [&](scene::Scene& scene) { scene.model.copies = int(std::lround(count)); }, true);
  });
  return section;
}

void ModelPanel::startSearch() {
  mSearch->setFocus(Qt::ShortcutFocusReason);
  mSearch->selectAll();
}

void ModelPanel::setSearch(const QString& text) {
  mList->setSearch(text);
  mList->selectType(mCommands.selection().type());
}

/// What is not as the file has it, in words.
void ModelPanel::showNotes(const Model& model) {
  QStringList lines;
  auto add = [&lines](const std::string& line) {
    lines << QString::fromUtf8("\u2022 ") + QString::fromStdString(line);
  };
  for (const std::string& line : model.added) add(line);
  for (const std::string& line : model.warnings) add(line);
  QStringList first = lines.mid(0, kMostNotes);
  if (lines.size() > kMostNotes) first << tr("and %1 more").arg(lines.size() - kMostNotes);
  mNotes->setText(first.join("\n"));
  mNotes->setToolTip(lines.join("\n"));
  mNotes->setVisible(!lines.isEmpty());
}

void ModelPanel::showCount() {
  int all = mLayerShown.data ? int(mLayerShown.data->types.size()) : 0;
  mCount->setText(tr("%1 of %2").arg(mList->tree().shownCount()).arg(all));
}

void ModelPanel::refresh() {
  const scene::Scene& scene = mDocument.scene();
  const scene::ModelLayer& layer = scene.model;
  if (layer.data) mLooks->refresh();  // follows more than this page shows
  mBar->refresh();
  mSteps->showScene(scene);
  if (mIsMade && layer == mLayerShown && scene.lighting == mLightShown) return;
  bool isOther = !mIsMade || layer.data != mLayerShown.data;
  mIsMade = true;
  mLayerShown = layer;
  mLightShown = scene.lighting;
  if (isOther && !mSearch->text().isEmpty()) mSearch->clear();
  mList->showLayer(layer);
  if (isOther) {
    mCommands.selection().setType(-1);
    QString name = layer.data ? QString::fromStdString(layer.data->name) : QString();
    mName->setText(name.isEmpty() ? tr("Model") : name);
    mName->setToolTip(QString::fromStdString(layer.source.path));
    if (layer.data) showNotes(*layer.data);
  }
  if (isOther) mHiders->hide();
  mGhosts->setCurrentIndex(int(layer.ghosts));
  mGhostOpacity->setValue(layer.ghostOpacity * 100.0);
  mGhostOpacity->setEnabled(scene::hasGhosts(layer));
  mShown->setChecked(layer.visible);
  mPalette->setCurrentIndex(int(layer.palette));
  mNear->setValue(layer.nearColors * 100.0);
  mDetail->setValue(layer.detail);
  mCopies->setRange(1, std::max(64, layer.copies));
  mCopies->setValue(layer.copies);
  mFog->setValue(scene.lighting.fog * 100.0);
  mOcclusion->setValue(scene.lighting.occlusion * 100.0);
  mShadow->setValue(scene.lighting.shadow * 100.0);
  showCount();
}

}  // namespace velum::gui
