#include "gui/model/ModelPanel.h"

#include <QActionGroup>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "session/model/TypesAt.h"

namespace velum::gui {

namespace {

constexpr int kFieldHeight = 28;
constexpr int kMostNotes = 3;  // lines that are read at once; the rest is in the tip

QPushButton* makeQuiet(const QString& text, const char* name, const QString& tip, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  button->setProperty("role", "quiet");
  button->setToolTip(tip);
  return button;
}

QVBoxLayout* makeColumn(QWidget* widget, int spacing) {
  auto* layout = new QVBoxLayout(widget);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(spacing);
  return layout;
}

}  // namespace

ModelPanel::ModelPanel(ModelCommands& commands, Equalizer& equalizer, QWidget* parent)
    : QWidget(parent), mCommands(commands), mDocument(commands.document()), mForm(mDocument, this) {
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
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  mName = makeTitle({}, head);
  mName->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  mShown = new EyeButton(head);
  mShown->setObjectName("modelShown");
  mShown->setAccessibleName(tr("Model shown"));
  mShown->setToolTip(tr("Whether the model is drawn at all"));
  mLegend = new QCheckBox(tr("Legend"), head);
  mLegend->setObjectName("modelLegend");
  mLegend->setToolTip(tr("Colours and names of the types that are seen most, over the picture"));
  row->addWidget(mShown);
  row->addWidget(mName, 1);
  row->addWidget(mLegend);
  layout->addLayout(row);
  mNotes = new QLabel(head);
  mNotes->setObjectName("modelNotes");
  mNotes->setProperty("role", "muted");
  mNotes->setWordWrap(true);
  layout->addWidget(mNotes);
  connect(mLegend, &QCheckBox::clicked, this, &ModelPanel::legendAsked);
  connect(mShown, &EyeButton::clicked, this, [this](bool on) {
    mDocument.edit(on ? "Show model" : "Hide model", [on](scene::Scene& scene) { scene.model.visible = on; });
  });
  return head;
}

QWidget* ModelPanel::makeSearch() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  mSearch = new QLineEdit(bar);
  mSearch->setObjectName("modelSearch");
  mSearch->setPlaceholderText(tr("Search types"));
  mSearch->setClearButtonEnabled(true);
  mSearch->setToolTip(tr("Lists the types and compartments whose name holds these words"));
  mSearch->setAccessibleName(tr("Search types"));
  auto* sort = new QToolButton(bar);
  sort->setObjectName("modelSort");
  sort->setText(tr("Sort"));
  sort->setToolTip(tr("The order of the types in their compartments, and which of them are listed"));
  sort->setPopupMode(QToolButton::InstantPopup);
  sort->setMenu(makeOrderMenu(sort));
  for (QWidget* part : {static_cast<QWidget*>(mSearch), static_cast<QWidget*>(sort)})
    part->setFixedHeight(kFieldHeight);
  row->addWidget(mSearch, 1);
  row->addWidget(sort);
  connect(mSearch, &QLineEdit::textChanged, this, &ModelPanel::setSearch);
  connect(mSearch, &QLineEdit::returnPressed, this, [this] { mList->setFocus(); });
  return bar;
}

QMenu* ModelPanel::makeOrderMenu(QWidget* parent) {
  auto* menu = new QMenu(parent);
  auto add = [menu](QActionGroup* group, const QString& name, bool isFirst) {
    QAction* action = menu->addAction(name);
    action->setCheckable(true);
    action->setChecked(isFirst);
    group->addAction(action);
    return action;
  };
  using Key = TypeOrder::Key;
  menu->addSection(tr("Sort"));
  auto* keys = new QActionGroup(menu);
  for (auto [name, key] : {std::pair(tr("By number of instances"), Key::Count),
                           {tr("By name"), Key::Name},
                           {tr("By mass"), Key::Mass},
                           {tr("By share that is seen"), Key::Seen},
                           {tr("By share that is hidden"), Key::Hidden},
                           {tr("By share that is removed"), Key::Removed}})
    connect(add(keys, name, key == Key::Count), &QAction::triggered, this,
            [this, key = key] { mList->order().setKey(key); });
  using Only = TypeOrder::Only;
  menu->addSection(tr("List"));
  auto* filters = new QActionGroup(menu);
  for (auto [name, only] : {std::pair(tr("All types"), Only::All),
                            {tr("Types that are seen"), Only::Seen},
                            {tr("Types of which none is seen"), Only::Unseen},
                            {tr("Types of which some are removed"), Only::Removed}})
    connect(add(filters, name, only == Only::All), &QAction::triggered, this,
            [this, only = only] { mList->order().setOnly(only); });
  return menu;
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
  auto* row = new QHBoxLayout(foot);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  auto* all = makeQuiet(tr("Show all"), "modelShowAll", tr("Show all that are listed"), foot);
  auto* none = makeQuiet(tr("Hide all"), "modelHideAll", tr("Hide all that are listed"), foot);
  auto* reset = makeQuiet(tr("Reset"), "modelReset",
                          tr("Show all that are listed, in the palette's colours and the finish's material"), foot);
  mCount = new QLabel(foot);
  mCount->setObjectName("modelCount");
  mCount->setProperty("role", "muted");
  mCount->setToolTip(tr("Types that are shown, of all"));
  row->addWidget(all);
  row->addWidget(none);
  row->addWidget(reset);
  row->addStretch(1);
  row->addWidget(mCount);
  connect(all, &QPushButton::clicked, this, [this] { mCommands.setVisible(mList->listedTypes(), true); });
  connect(none, &QPushButton::clicked, this, [this] { mCommands.setVisible(mList->listedTypes(), false); });
  connect(reset, &QPushButton::clicked, this, [this] { mCommands.reset(mList->listedTypes()); });
  return foot;
}

QWidget* ModelPanel::makeRows() {
  auto* section = new QWidget(this);
  QGridLayout* grid = makeFieldGrid(section, 84);
  grid->setVerticalSpacing(7);
  mForm.setGrid(grid);
  mForm.add("model.palette", tr("Palette"),
            {.object = "modelPalette",
             .tip = tr("What instances have their colours by; a type's own colour goes before"),
             .step = tr("Choose palette"),
             .choices = {tr("By type"), tr("By compartment"), tr("By function"), tr("By element"), tr("By chain")}});
  mForm.add("model.nearColors", tr("Up close"),
            {.object = "modelNear",
             .tip = tr("How far chains and elements show as shades of the colour where one is close, %"),
             .step = tr("Change colours up close")});
  mForm.add("lighting.occlusion", tr("Occlusion"),
            {.object = "modelOcclusion", .tip = tr("Darkening between instances, %")});
  mForm.add("lighting.shadow", tr("Shadows"),
            {.object = "modelShadow", .tip = tr("Strength of the shadows that the key light casts, %")});
  mForm.add("lighting.fog", tr("Fog"),
            {.object = "modelFog", .tip = tr("How far what lies deepest fades into the background, %")});
  mForm.add("model.ghosts", tr("Ghosts"),
            {.object = "modelGhosts",
             .tip = tr("How instances that cuts have removed still show; a type's own choice goes before"),
             .step = tr("Choose ghosts"),
             .choices = {tr("None"), tr("Filled"), tr("Contour")}});
  mForm.add("model.ghostOpacity", tr("Opacity"),
            {.object = "modelGhostOpacity",
             .tip = tr("Of the ghosts, %"),
             .step = tr("Change opacity of ghosts"),
             .isEnabled = [this] { return scene::hasGhosts(mDocument.scene().model); }});
  mForm.add("model.detail", tr("Detail"),
            {.object = "modelDetail",
             .tip = tr("How much of a pixel drawn shapes may be off by: smaller is finer, and slower")});
  mForm.add("model.copies", tr("Copies"),
            {.object = "modelCopies", .tip = tr("Of the whole model, side by side in a block"), .range = [this] {
               return Range{1.0, double(std::max(64, mDocument.scene().model.copies))};
             }});
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
  mShown->setChecked(layer.visible);
  mForm.refresh();
  showCount();
}

}  // namespace velum::gui
