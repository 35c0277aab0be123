#include "gui/cut/TypeSpareList.h"

#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/rows/FieldRow.h"
#include "gui/service/SelectedCut.h"
#include "session/cut/CutEdit.h"

namespace velum::gui {

namespace {

constexpr double kDaltonPerKilo = 1000.0;

void setQuietly(NumberField* spin, double value) {
  const QSignalBlocker quiet(spin);
  spin->setValue(value);
}

std::string nameOf(const std::vector<std::string>& paths) {
  if (paths.size() != 1) return std::to_string(paths.size()) + " rows";
  std::size_t dot = paths[0].rfind('.');
  return dot == std::string::npos ? "all types" : paths[0].substr(dot + 1);
}

}  // namespace

TypeSpareList::TypeSpareList(session::Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent), mDocument(document), mSelection(selection) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(makeTitle(tr("Leaves of types"), this));
  mSearch = new QLineEdit(this);
  mSearch->setObjectName("typeSpareSearch");
  mSearch->setPlaceholderText(tr("Search types"));
  mSearch->setClearButtonEnabled(true);
  mSearch->setAccessibleName(tr("Search types that the cut leaves"));
  mSearch->setToolTip(tr("Lists the types and compartments whose name holds these words"));
  layout->addWidget(mSearch);
  mView = new TypeSpareView(this);
  mView->setContextMenuPolicy(Qt::CustomContextMenu);
  layout->addWidget(mView, 1);
  makeRows(layout);
  layout->addWidget(mFocus = new FocusForm(document, selection, this));
  connect(mSearch, &QLineEdit::textChanged, mView, &TypeSpareView::setSearch);
  connect(mView, &TypeSpareView::dragged, this, &TypeSpareList::setShare);
  connect(mView, &TypeSpareView::settled, this, [this] { mDocument.endMerge(); });
  connect(mView, &QWidget::customContextMenuRequested, this, &TypeSpareList::showMenu);
  connect(mView->selectionModel(), &QItemSelectionModel::selectionChanged, this, &TypeSpareList::showSelected);
}

void TypeSpareList::editCut(const std::string& label, const Change& change, bool merge) {
  editSelectedCut(mDocument, mSelection, label, change, merge);
}

void TypeSpareList::setShare(const std::vector<std::string>& paths, double share) {
  if (paths.empty()) return;
  editCut(
      "Leave of " + nameOf(paths),
      [&](scene::Cut& cut) {
        for (const std::string& path : paths) session::setTypeShare(cut, path, share);
      },
      true);
}

void TypeSpareList::changeSpares(const char* label, const std::function<void(scene::TypeSpare&)>& change) {
  std::vector<std::string> paths = mView->selectedPaths();
  if (paths.empty()) return;
  editCut(
      label,
      [&](scene::Cut& cut) {
        for (const std::string& path : paths) change(session::ownTypeSpare(cut, path));
      },
      true);
}

NumberRow* TypeSpareList::addNumber(QGridLayout* grid, const QString& name, const char* objectName, const QString& tip,
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

void TypeSpareList::makeRows(QVBoxLayout* layout) {
  mRow = new QLabel(this);
  mRow->setProperty("role", "muted");
  layout->addWidget(mRow);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(7);
  grid->setColumnMinimumWidth(0, 72);
  grid->setColumnStretch(1, 1);
  layout->addLayout(grid);
  mShare = addNumber(grid, tr("Leaves"), "typeShare",
                     tr("Share of the instances in what is removed that stay, % of the selected rows"),
                     new NumberRow(0, 100, 0, " %", this));
  mFalloff = addNumber(grid, tr("Falloff"), "typeFalloff",
                       tr("Way from the cut's surface over which more stay; below 0: outside of it fewer do"),
                       new NumberRow(-1, 1, 0, {}, this));
  mAmount = addNumber(grid, tr("Amount"), "typeAmount", tr("How far the falloff goes at the surface, %"),
                      new NumberRow(0, 100, 0, " %", this));
  mExponent =
      addNumber(grid, tr("Exponent"), "typeExponent", tr("How the falloff runs: 1 evenly; above, it lasts longer"),
                new NumberRow(0.1, 8, 1, {}, this));
  connect(mShare, &NumberRow::changed, this,
          [this](double percent) { setShare(mView->selectedPaths(), percent / 100.0); });
  connect(mFalloff, &NumberRow::changed, this, [this](double length) {
    changeSpares("Change falloff", [length](scene::TypeSpare& spare) { spare.falloff = length; });
  });
  connect(mAmount, &NumberRow::changed, this, [this](double percent) {
    changeSpares("Change amount of falloff", [percent](scene::TypeSpare& spare) { spare.amount = percent / 100.0; });
  });
  connect(mExponent, &NumberRow::changed, this, [this](double exponent) {
    changeSpares("Change exponent of falloff", [exponent](scene::TypeSpare& spare) { spare.exponent = exponent; });
  });
  mWhole = new QCheckBox(tr("Removes whole instances only"), this);
  mWhole->setObjectName("wholeInstances");
  mWhole->setToolTip(tr("Instances go when all of them is in what is removed; else when their middle is"));
  grid->addWidget(mWhole, grid->rowCount(), 0, 1, 2);
  connect(mWhole, &QCheckBox::clicked, this, [this](bool on) {
    editCut(on ? "Remove whole instances" : "Remove instances by their middle",
            [on](scene::Cut& cut) { cut.model.wholeInstances = on; });
  });
  int line = grid->rowCount();
  grid->addWidget(new QLabel(tr("Mass, kDa"), this), line, 0);
  grid->addWidget(
      makeRange(tr("mass"), {}, 1, kDaltonPerKilo, &scene::ModelCut::leastMass, &scene::ModelCut::mostMass, mMass),
      line, 1);
  grid->addWidget(new QLabel(tr("Instances"), this), line + 1, 0);
  grid->addWidget(makeRange(tr("number of instances"), {}, 0, 1.0, &scene::ModelCut::leastCopies,
                            &scene::ModelCut::mostCopies, mCount),
                  line + 1, 1);
}

/// From, to: of types outside nothing is left. 0 as the end means that there is none.
QWidget* TypeSpareList::makeRange(const QString& name, const QString& suffix, int decimals, double factor,
                                  double scene::ModelCut::*least, double scene::ModelCut::*most,
                                  NumberField* (&spins)[2]) {
  auto* row = new QWidget(this);
  auto* layout = new FieldRow(row);
  for (bool isMost : {false, true}) {
    auto* spin = spins[isMost] = new NumberField(row);
    spin->setRange(0.0, 1e9);
    spin->setDecimals(decimals);
    spin->setSuffix(suffix);
    spin->setAlignment(Qt::AlignRight);
    spin->setPrefix(isMost ? tr("to ") : tr("from "));
    if (isMost) spin->setSpecialValueText(tr("to any"));
    QString tip = isMost ? tr("Types of a greater %1 are not left; 0: none is too great").arg(name)
                         : tr("Types of a smaller %1 are not left").arg(name);
    spin->setToolTip(tip);
    spin->setAccessibleName(tip);
    spin->setObjectName(QString("%1%2").arg(isMost ? "most" : "least", decimals ? "Mass" : "Copies"));
    layout->addWidget(spin);
    auto member = isMost ? most : least;
    connect(spin, &QDoubleSpinBox::valueChanged, this, [this, member, isMost, factor](double value) {
      double wanted = isMost && value == 0.0 ? scene::Spare::kEndless : value * factor;
      editCut("Change range of types", [&](scene::Cut& cut) { cut.model.*member = wanted; });
    });
  }
  return row;
}

void TypeSpareList::showMenu(QPoint place) {
  std::vector<std::string> paths = mView->selectedPaths();
  if (paths.empty()) return;
  QMenu menu(this);
  menu.addAction(tr("As what it is in"), this, [this, paths] {
    editCut("Leave " + nameOf(paths) + " as above", [&](scene::Cut& cut) {
      for (const std::string& path : paths) session::removeTypeSpare(cut, path);
    });
  });
  menu.exec(mView->viewport()->mapToGlobal(place));
}

void TypeSpareList::showSelected() {
  std::vector<std::string> paths = mView->selectedPaths();
  bool any = !paths.empty();
  mRow->setText(any ? QString::fromStdString(nameOf(paths)).replace('_', ' ') : tr("Select a row to say how"));
  for (NumberRow* row : {mShare, mFalloff, mAmount, mExponent}) row->setEnabled(any);
  scene::TypeSpare spare = session::typeSpareFor(mCut, any ? paths[0] : std::string());
  mShare->setValue(spare.share * 100.0);
  mFalloff->setValue(spare.falloff);
  mAmount->setValue(spare.amount * 100.0);
  mExponent->setValue(spare.exponent);
  mFocus->showCut(mCut, paths);
}

void TypeSpareList::showCut(const scene::Scene& scene, const scene::Cut& cut) {
  setVisible(bool(scene.model.data));
  if (!scene.model.data) return;
  bool isOther = mView->tree().model() != scene.model.data;
  mCut = cut;
  mView->tree().showCut(scene.model.data, cut);
  if (isOther) {
    mView->openSome();
    mView->setCurrentIndex(mView->model()->index(0, 0));
  }
  scene::Bounds bounds = scene::computeBounds(scene);
  double reach = glm::length(bounds.max - bounds.min) * 0.5;
  mFalloff->setLength(Length(scene));
  mFalloff->setRange(-reach, reach);
  mWhole->setChecked(cut.model.wholeInstances);
  auto end = [](double most) { return most == scene::Spare::kEndless ? 0.0 : most; };
  setQuietly(mMass[0], cut.model.leastMass / kDaltonPerKilo);
  setQuietly(mMass[1], end(cut.model.mostMass) / kDaltonPerKilo);
  setQuietly(mCount[0], cut.model.leastCopies);
  setQuietly(mCount[1], end(cut.model.mostCopies));
  showSelected();
}

}  // namespace velum::gui
