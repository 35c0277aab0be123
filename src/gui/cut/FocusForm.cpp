#include "gui/cut/FocusForm.h"

#include <algorithm>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Text.h"
#include "gui/service/SelectedCut.h"
#include "session/command/CutCommands.h"
#include "session/command/ModelCommands.h"
#include "session/cut/CutEdit.h"
#include "session/model/TypesAt.h"
#include "session/model/WhatHides.h"

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
    : QWidget(parent),
      mDocument(document),
      mSelection(selection),
      mForm(document, this, "cuts.N.", [this] { return scene::cutPlace(mDocument.shown(), mCut.id); }) {
  QGridLayout* grid = makeFieldGrid(this, 72);
  grid->setVerticalSpacing(7);
  mForm.setGrid(grid);
  mKept = makeCheck(tr("Keeps it in view"), "focusKept",
                    tr("What stands before the selected types and lies in the cut's region is not drawn"), this);
  grid->addWidget(mKept, 0, 1);
  mFocus = new QLabel(this);
  mFocus->setObjectName("focusTypes");
  mFocus->setProperty("role", "muted");
  mFocus->setWordWrap(true);
  grid->addWidget(mFocus, 1, 0, 1, 2);
  addShare("viewShare", &scene::TypeSpare::viewShare, tr("Stay before"),
           {.object = "typeViewShare",
            .tip = tr("Share of the selected types' instances that stay though they hide what is kept in view, %"),
            .step = tr("Change share before the view")});
  addShare("aperture", &scene::TypeSpare::aperture, tr("Aperture"),
           {.object = "typeAperture",
            .tip = tr("How far the view is opened for the selected types, from a hole in its middle to all of it, %"),
            .step = tr("Change aperture")});
  mForm.add("model.focus.guidesDepth", tr("Leaves what stands about it"),
            {.object = "focusDepth",
             .tip = tr("Only what is before the nearest of what is kept in view goes, so that one sees how deep it "
                       "lies"),
             .step = tr("Leave what stands about the view"),
             .stepOff = tr("Clear what stands about the view"),
             .isShown = [this] { return hasFocus(); }});
  mLock = makeCheck(tr("As seen from here"), "focusLock",
                    tr("What is cleared stays so when you turn: to look at the opening from the side"), this);
  grid->addWidget(mLock, grid->rowCount(), 1);
  connect(mKept, &QCheckBox::clicked, this, &FocusForm::keep);
  connect(mLock, &QCheckBox::clicked, this, &FocusForm::lockAsked);
}

void FocusForm::addShare(const std::string& field, double scene::TypeSpare::*member, const QString& title,
                         FieldText text) {
  text.isShown = [this] { return hasFocus(); };
  text.isEnabled = [this] { return !mPaths.empty(); };
  text.number = [this, member] {
    return session::typeSpareFor(mCut, mPaths.empty() ? std::string() : mPaths[0]).*member;
  };
  text.call = [this, field](const std::string& value) {
    return session::LeaveTypesBy{mPaths, field, value, session::cutKey(mDocument.shown(), mCut.id)};
  };
  mForm.add("model.spares.N." + field, title, std::move(text));
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
    if (locked) cut.model.focus->lock = scene::ViewLock{mDocument.shown().camera, aspect};
  });
}

void FocusForm::showCut(const scene::Cut& cut, const std::vector<std::string>& paths) {
  mCut = cut;
  mPaths = paths;
  mForm.refresh();
  mKept->setEnabled(!paths.empty());
  mKept->setChecked(!paths.empty() &&
                    std::all_of(paths.begin(), paths.end(), [&](const std::string& path) { return keeps(cut, path); }));
  for (QWidget* widget : {static_cast<QWidget*>(mFocus), static_cast<QWidget*>(mLock)}) widget->setVisible(hasFocus());
  if (!hasFocus()) return;
  QStringList names;
  for (const scene::FocusType& type : cut.model.focus->types)
    names << toText(scene::shownName(mDocument.shown().model, type.type, session::shortName(type.type)));
  std::string words = session::clearingWords(mDocument.shown());
  mFocus->setText(tr("In view: %1").arg(names.join(", ")) + (words.empty() ? "" : "\n" + inWords(words)));
  mLock->setChecked(cut.model.focus->lock.has_value());
}

}  // namespace velum::gui
