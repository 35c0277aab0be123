#include "gui/cut/TypeSpareList.h"

#include <fmt/format.h>

#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Text.h"
#include "gui/rows/FieldRow.h"
#include "gui/service/SelectedCut.h"
#include "session/command/CutCommands.h"
#include "session/command/ModelCommands.h"
#include "session/cut/CutEdit.h"

namespace velum::gui {

namespace {

constexpr double kDaltonPerKilo = 1000.0;

void setQuietly(NumberField* spin, double value) {
  const QSignalBlocker quiet(spin);
  spin->setValue(value);
}

}  // namespace

TypeSpareList::TypeSpareList(session::Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mSelection(selection),
      mForm(document, this, "cuts.N.", [this] { return scene::cutPlace(mDocument.shown(), mCut.id); }) {
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
  std::string cut = session::cutKey(mDocument.shown(), mCut.id);
  session::edit(mDocument, session::LeaveTypesBy{paths, "share", fmt::format("{}", std::clamp(share, 0.0, 1.0)), cut},
                true);
}

/// Adds the rows that tell how much is left of the selected types and compartments, and how.
void TypeSpareList::addHow(QGridLayout* grid) {
  mForm.setGrid(grid);
  auto add = [this](const std::string& field, double scene::TypeSpare::*member, const QString& title, FieldText text) {
    text.isEnabled = [this] { return !mView->selectedPaths().empty(); };
    text.number = [this, member] {
      std::vector<std::string> paths = mView->selectedPaths();
      return session::typeSpareFor(mCut, paths.empty() ? std::string() : paths[0]).*member;
    };
    text.call = [this, field](const std::string& value) {
      return session::LeaveTypesBy{mView->selectedPaths(), field, value, session::cutKey(mDocument.shown(), mCut.id)};
    };
    mForm.add("model.spares.N." + field, title, std::move(text));
  };
  add("share", &scene::TypeSpare::share, tr("Leaves"),
      {.object = "typeShare",
       .tip = tr("Share of the instances in what is removed that stay, % of the selected rows")});
  add("falloff", &scene::TypeSpare::falloff, tr("Falloff"),
      {.object = "typeFalloff",
       .tip = tr("Way from the cut's surface over which more stay; below 0: outside of it fewer do"),
       .step = tr("Change falloff"),
       .range = [this] {
         return Range{-mReach, mReach};
       }});
  add("amount", &scene::TypeSpare::amount, tr("Amount"),
      {.object = "typeAmount",
       .tip = tr("How far the falloff goes at the surface, %"),
       .step = tr("Change amount of falloff")});
  add("exponent", &scene::TypeSpare::exponent, tr("Exponent"),
      {.object = "typeExponent",
       .tip = tr("How the falloff runs: 1 evenly; above, it lasts longer"),
       .step = tr("Change exponent of falloff"),
       .range = [] {
         return Range{0.1, 8.0};
       }});
}

void TypeSpareList::makeRows(QVBoxLayout* layout) {
  mRow = new QLabel(this);
  mRow->setProperty("role", "muted");
  layout->addWidget(mRow);
  QGridLayout* grid = makeFieldGrid(nullptr, 72);
  grid->setVerticalSpacing(7);
  layout->addLayout(grid);
  addHow(grid);
  auto* whole = mForm.make(this, "model.wholeInstances", tr("Removes whole instances only"),
                           {.object = "wholeInstances",
                            .tip = tr("Instances go when all of them is in what is removed; else when their middle is"),
                            .step = tr("Remove whole instances"),
                            .stepOff = tr("Remove instances by their middle")});
  grid->addWidget(whole, grid->rowCount(), 0, 1, 2);
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

/// Two fields, from and to: of types outside this range nothing is left. 0 as the upper end means that there is none.
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
    session::edit(mDocument, session::LeaveAsAbove{paths, session::cutKey(mDocument.shown(), mCut.id)});
  });
  menu.exec(mView->viewport()->mapToGlobal(place));
}

void TypeSpareList::showSelected() {
  std::vector<std::string> paths = mView->selectedPaths();
  bool any = !paths.empty();
  mRow->setText(any ? inWords(nameText(session::rowsLabel(mDocument.shown(), paths))) : tr("Select a row to say how"));
  mForm.refresh();
  mFocus->showCut(mCut, paths);
}

void TypeSpareList::showCut(const scene::Scene& scene, const scene::Cut& cut) {
  setVisible(bool(scene.model.data));
  if (!scene.model.data) return;
  bool isOther = mView->tree().model() != scene.model.data;
  mCut = cut;
  mView->tree().showCut(scene.model.data, cut);
  mView->tree().showNames(scene.model);
  if (isOther) {
    mView->openSome();
    mView->setCurrentIndex(mView->model()->index(0, 0));
  }
  scene::Bounds bounds = scene::computeBounds(scene);
  mReach = glm::length(bounds.max - bounds.min) * 0.5;
  auto end = [](double most) { return most == scene::Spare::kEndless ? 0.0 : most; };
  setQuietly(mMass[0], cut.model.leastMass / kDaltonPerKilo);
  setQuietly(mMass[1], end(cut.model.mostMass) / kDaltonPerKilo);
  setQuietly(mCount[0], cut.model.leastCopies);
  setQuietly(mCount[1], end(cut.model.mostCopies));
  showSelected();
}

}  // namespace velum::gui
