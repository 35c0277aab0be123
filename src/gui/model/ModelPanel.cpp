#include "gui/model/ModelPanel.h"

#include <QVBoxLayout>
#include <algorithm>
#include <bit>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Text.h"
#include "gui/kit/Words.h"
#include "gui/rows/CountKey.h"
#include "session/command/Command.h"
#include "session/command/ModelCommands.h"
#include "session/model/ModelScale.h"
#include "session/model/TypesAt.h"

namespace velum::gui {

namespace {

constexpr int kMostNotes = 3;  // lines that are read at once; the rest is in the tip

}  // namespace

ModelPanel::ModelPanel(ModelCommands& commands, Equalizer& equalizer, QWidget* parent)
    : QWidget(parent),
      mCommands(commands),
      mEqualizer(equalizer),
      mDocument(commands.document()),
      mForm(mDocument, this) {
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
  rows->addWidget(new CountKey(CountKey::Of::Instances, list));
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
  mLegend->setToolTip(
      tr("Colours and names of types over the picture, also in files: those that are seen most, or that are listed"));
  title.row->addWidget(mLegend);
  layout->addLayout(title.row);
  mNotes = new QLabel(head);
  mNotes->setObjectName("modelNotes");
  mNotes->setProperty("role", "muted");
  mNotes->setWordWrap(true);
  layout->addWidget(mNotes);
  layout->addWidget(makeScale(head));
  layout->addWidget(mInside = new InsideLine(mDocument, mEqualizer, head));
  connect(mLegend, &QCheckBox::clicked, this, &ModelPanel::legendAsked);
  connect(mInside, &InsideLine::cutAsked, this, &ModelPanel::cutAsked);
  connect(mShown, &EyeButton::clicked, this, [this](bool on) { session::edit(mDocument, session::ShowModel{on}); });
  return head;
}

/// Where model and other data do not fit each other: a line that says so, and a button that mends it.
QWidget* ModelPanel::makeScale(QWidget* parent) {
  mScale = new QWidget(parent);
  mScale->setObjectName("modelScale");
  auto* column = makeColumn(mScale, 4);
  mScaleWords = new QLabel(mScale);
  mScaleWords->setWordWrap(true);
  column->addWidget(mScaleWords);
  auto* button = new QPushButton(tr("Bring to size"), mScale);
  button->setObjectName("modelBringToSize");
  button->setToolTip(tr("Makes the model a third as long as the other data, and puts it beside them"));
  column->addWidget(button, 0, Qt::AlignLeft);
  connect(button, &QPushButton::clicked, this, [this] { session::edit(mDocument, session::BringToSize{}); });
  mScale->hide();
  return mScale;
}

void ModelPanel::showScale(const scene::Scene& scene) {
  std::vector<std::uint64_t> data{scene.volume.data.id(), scene.labels.data.id(), scene.model.data.id(),
                                  std::bit_cast<std::uint64_t>(scene.model.enlargement)};
  for (const scene::Surface& surface : scene.surfaces) data.push_back(surface.data.id());
  if (data == mScaleOf) return;
  mScaleOf = std::move(data);
  std::string words = session::scaleWords(scene);
  mScaleWords->setText(inWords(words));
  mScale->setVisible(!words.empty());
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
    orders.emplace_back(tr("By share that is %1").arg(wordsOf(kCountKinds[i].adjective)), TypeOrder::keyOf(CountOf(i)));
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
    return session::typesAt(*mDocument.shown().model.data, path.toStdString()).types;
  };
  connect(mHiders, &HidersBox::hideAsked, this,
          [this, typesOf](const QString& path) { mCommands.setVisible(typesOf(path), false); });
  connect(mHiders, &HidersBox::selectAsked, this,
          [this, typesOf](const QString& path) { mCommands.selection().setType(int(typesOf(path).front())); });
}

void ModelPanel::showHiding(const session::Hiding& hiding) {
  mHiders->showHiding(hiding, mDocument.shown().model);
  std::string path = hiding.path;
  session::TypeNumbers types = session::typesAt(*mDocument.shown().model.data, path).types;
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
  mOneColor = new QLabel(section);
  mOneColor->setObjectName("modelOneColor");
  mOneColor->setProperty("role", "muted");
  mOneColor->setWordWrap(true);
  mForm.addWidget(mOneColor);
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
             .isEnabled = [this] { return scene::hasGhosts(mDocument.shown().model); }});
  mForm.add(
      "model.detail", tr("Detail"),
      {.object = "modelDetail",
       .tip =
           tr("How much of a pixel drawn shapes may be off by, at one sample a pixel: smaller is finer, and slower")});
  mForm.add("model.copies", tr("Copies"),
            {.object = "modelCopies", .tip = tr("Of the whole model, side by side in a block"), .range = [this] {
               return Range{1.0, double(std::max(64, mDocument.shown().model.copies))};
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

/// Shows in words what differs from the file.
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
  const scene::Scene& scene = mDocument.shown();
  const scene::ModelLayer& layer = scene.model;
  if (layer.data) mLooks->refresh();  // follows more than this page shows
  showScale(scene);
  mInside->refresh();
  mBar->refresh();
  mSteps->showScene(scene);
  mLegend->setChecked(scene.lettering.legend);
  if (mIsMade && layer == mLayerShown && scene.lighting == mLightShown) return;
  bool isOther = !mIsMade || layer.data != mLayerShown.data;
  mIsMade = true;
  mLayerShown = layer;
  mLightShown = scene.lighting;
  if (isOther && !mSearch->text().isEmpty()) mSearch->clear();
  mList->showLayer(layer);
  if (isOther) {
    mCommands.selection().setType(-1);
    QString name = layer.data ? readableText(layer.data->name) : QString();
    mName->setText(name.isEmpty() ? tr("Model") : name);
    mName->setToolTip(QString::fromStdString(layer.source.path));
    if (layer.data) showNotes(*layer.data);
  }
  if (isOther) mHiders->hide();
  mShown->setChecked(layer.visible);
  mOneColor->setText(inWords(scene::whyOneColor(layer)));
  mOneColor->setVisible(!mOneColor->text().isEmpty());
  mForm.refresh();
  showCount();
}

}  // namespace velum::gui
