#include "gui/cut/FocusForm.h"

#include <algorithm>

#include "gui/service/SelectedCut.h"
#include "session/cut/CutEdit.h"
#include "session/model/TypesAt.h"

namespace velum::gui {

namespace {

bool keeps(const scene::Cut& cut, const std::string& path) {
  return cut.model.focus && std::any_of(cut.model.focus->types.begin(), cut.model.focus->types.end(),
                                        [&](const scene::FocusType& type) { return type.type == path; });
}

QCheckBox* makeCheck(const QString& text, const char* name, const QString& tip, QWidget* parent) {
  auto* check = new QCheckBox(text, parent);
  check->setObjectName(name);
  check->setToolTip(tip);
  return check;
}

}  // namespace

FocusForm::FocusForm(session::Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent), mDocument(document), mSelection(selection), mGrid(new QGridLayout(this)) {
  mGrid->setContentsMargins(0, 0, 0, 0);
  mGrid->setHorizontalSpacing(10);
  mGrid->setVerticalSpacing(7);
  mGrid->setColumnMinimumWidth(0, 72);
  mGrid->setColumnStretch(1, 1);
  mKept = makeCheck(tr("Keeps it in view"), "focusKept",
                    tr("What stands before the selected types and lies in the cut's region is not drawn"), this);
  mGrid->addWidget(mKept, 0, 1);
  mFocus = new QLabel(this);
  mFocus->setObjectName("focusTypes");
  mFocus->setProperty("role", "muted");
  mFocus->setWordWrap(true);
  mGrid->addWidget(mFocus, 1, 0, 1, 2);
  mViewShare = addShare(tr("Stay before"), "typeViewShare",
                        tr("Share of the selected types' instances that stay though they hide what is kept in view, %"),
                        "Change share before the view", &scene::TypeSpare::viewShare);
  mAperture =
      addShare(tr("Aperture"), "typeAperture",
               tr("How far the view is opened for the selected types, from a hole in its middle to all of it, %"),
               "Change aperture", &scene::TypeSpare::aperture);
  mDepth = makeCheck(
      tr("Leaves what stands about it"), "focusDepth",
      tr("Only what is before the nearest of what is kept in view goes, so that one sees how deep it lies"), this);
  mLock = makeCheck(tr("As seen from here"), "focusLock",
                    tr("What is cleared stays so when you turn: to look at the opening from the side"), this);
  for (QCheckBox* check : {mDepth, mLock}) mGrid->addWidget(check, mGrid->rowCount(), 1);
  mOfFocus.insert(mOfFocus.end(), {mFocus, mDepth, mLock});
  connect(mKept, &QCheckBox::clicked, this, &FocusForm::keep);
  connect(mLock, &QCheckBox::clicked, this, &FocusForm::lockAsked);
  connect(mDepth, &QCheckBox::clicked, this, [this](bool on) {
    editSelectedCut(mDocument, mSelection, on ? "Leave what stands about the view" : "Clear what stands about the view",
                    [on](scene::Cut& cut) {
                      if (cut.model.focus) cut.model.focus->guidesDepth = on;
                    });
  });
}

NumberRow* FocusForm::addShare(const QString& name, const char* objectName, const QString& tip, const char* label,
                               double scene::TypeSpare::*field) {
  auto* row = new NumberRow(0, 100, 0, " %", this);
  row->setObjectName(objectName);
  row->setName(name);
  row->setToolTip(tip);
  int line = mGrid->rowCount();
  auto* title = new QLabel(name, this);
  mGrid->addWidget(title, line, 0);
  mGrid->addWidget(row, line, 1);
  mOfFocus.insert(mOfFocus.end(), {title, row});
  connect(row, &NumberRow::settled, this, [this] { mDocument.endMerge(); });
  connect(row, &NumberRow::changed, this, [this, label, field](double percent) {
    changeSpares(label, [field, percent](scene::TypeSpare& spare) { spare.*field = percent / 100.0; });
  });
  return row;
}

void FocusForm::changeSpares(const char* label, const std::function<void(scene::TypeSpare&)>& change) {
  if (mPaths.empty()) return;
  editSelectedCut(
      mDocument, mSelection, label,
      [&](scene::Cut& cut) {
        for (const std::string& path : mPaths) change(session::ownTypeSpare(cut, path));
      },
      true);
}

void FocusForm::keep(bool kept) {
  editSelectedCut(mDocument, mSelection, kept ? "Keep in view" : "Let be hidden", [&](scene::Cut& cut) {
    if (!cut.model.focus) cut.model.focus.emplace();
    for (const std::string& path : mPaths) {
      std::erase_if(cut.model.focus->types, [&](const scene::FocusType& type) { return type.type == path; });
      if (kept) cut.model.focus->types.push_back({path});
    }
    if (cut.model.focus->types.empty()) cut.model.focus.reset();
  });
}

void FocusForm::lock(bool locked, double aspect) {
  editSelectedCut(mDocument, mSelection, locked ? "Lock the view" : "Follow the view", [&](scene::Cut& cut) {
    if (!cut.model.focus) return;
    cut.model.focus->lock.reset();
    if (locked) cut.model.focus->lock = scene::ViewLock{mDocument.scene().camera, aspect};
  });
}

void FocusForm::showCut(const scene::Cut& cut, const std::vector<std::string>& paths) {
  mPaths = paths;
  mKept->setEnabled(!paths.empty());
  mKept->setChecked(!paths.empty() &&
                    std::all_of(paths.begin(), paths.end(), [&](const std::string& path) { return keeps(cut, path); }));
  bool hasFocus = cut.model.focus && !cut.model.focus->types.empty();
  for (QWidget* widget : mOfFocus) widget->setVisible(hasFocus);
  if (!hasFocus) return;
  QStringList names;
  for (const scene::FocusType& type : cut.model.focus->types) {
    std::string_view name = session::shortName(type.type);
    names << QString::fromUtf8(name.data(), int(name.size())).replace('_', ' ');
  }
  mFocus->setText(tr("In view: %1").arg(names.join(", ")));
  scene::TypeSpare spare = session::typeSpareFor(cut, paths.empty() ? std::string() : paths[0]);
  mViewShare->setValue(spare.viewShare * 100.0);
  mAperture->setValue(spare.aperture * 100.0);
  mViewShare->setEnabled(!paths.empty());
  mAperture->setEnabled(!paths.empty());
  mDepth->setChecked(cut.model.focus->guidesDepth);
  mLock->setChecked(cut.model.focus->lock.has_value());
}

}  // namespace velum::gui
