#include "gui/mark/MarkRoom.h"

#include <algorithm>
#include <map>
#include <memory>

#include <QFileInfo>

#include "core/FileName.h"
#include "core/ReplaceFile.h"
#include "gui/kit/Words.h"
#include "gui/mark/MarkKinds.h"
#include "gui/service/SavePath.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"
#include "session/measure/Table.h"

namespace velum::gui {

namespace {

constexpr int kMeterPatienceMs = 200;

}  // namespace

MarkRoom::MarkRoom(const WindowParts& parts, LetteringOverlay& lettering)
    : Room(parts),
      mLettering(lettering),
      mMeter(kMeterPatienceMs, this),
      mMenu(parts.document(), parts.jobs, nullptr),
      mPanel(new MarkPanel(parts.document(), parts.selection, mMenu, &parts.tabs)),
      mGrips(parts.document(), parts.selection, parts.toolbox, lettering, nullptr) {
  parts.tabs.addPage(mPanel, QT_TRANSLATE_NOOP("Words", "Marks"),
                     tr("Measures, arrows, labels, and all that is written over the picture"));
  parts.toolbox.add(mGrips);
  QMenu* menu = parts.menu(MenuId::Mark);
  addTools(menu);
  menu->addSeparator();
  addActions(menu);
  connect(&mMenu, &MarkMenu::renameAsked, this, &MarkRoom::rename);
  // After the lettering has looked at the picture.
  connect(&parts.views.viewport(), &Viewport::refined, this, [this] { mPanel->setHidden(mLettering.hidden()); });
  connect(&mGrips, &MarkGrips::removeAsked, &mMenu, &MarkMenu::remove);
  connect(&mGrips, &MarkGrips::menuAsked, this, [this](int mark, QPoint place) {
    QMenu marks(&mParts.window);
    mMenu.fill(marks, mark);
    marks.exec(place);
  });
  Toolbox& toolbox = parts.toolbox;
  connect(&parts.selection, &Selection::markChanged, &toolbox, [&toolbox](int mark) {
    if (mark != 0) toolbox.setHandlesShown(true);
  });
  // One thing has the keys of the views.
  connect(&parts.selection, &Selection::cutChanged, this, [this](int cut) {
    if (cut != 0) mParts.selection.setMark(0);
  });
}

void MarkRoom::addTools(QMenu* menu) {
  for (const MarkKindRow& row : markKinds()) {
    if (!row.id) continue;
    MarkTool& tool = *mTools.emplace_back(std::make_unique<MarkTool>(row.kind, mParts, mGrips));
    QAction* action = mParts.actions.addForScene(menu, row.id, wordsOf(row.menu), wordsOf(row.tip), [] {});
    if (row.kind == scene::MarkKind::Distance) action->setIconText(tr("Measure"));
    mParts.toolbox.bind(tool, *action);
    mParts.toolbox.bind(tool, mPanel->toolButton(row.kind));
    connect(&tool, &MarkTool::made, this, [this, &tool](int mark) {
      mParts.selection.setMark(mark);
      if (tool.kind() != scene::MarkKind::Label) return;
      mParts.toolbox.stop(tool);
      rename(mark);
    });
  }
}

void MarkRoom::addActions(QMenu* menu) {
  mNames = mParts.actions.addForScene(
      menu, "mark.names", tr("Names of what is &seen"),
      tr("Write the names of structures and types over the picture, with leaders, also in files"), [this] {
        session::edit(mParts.document(), session::SetField{"lettering.names", mNames->isChecked() ? "true" : "false"},
                      false, tr("Names of what is seen").toStdString());
      });
  mNames->setCheckable(true);
  mParts.actions.addForScene(menu, "mark.saveTable", tr("Save &table..."),
                             tr("Write what all marks and structures measure: .csv or .json"), [this] { saveTable(); });
  mParts.actions.addForScene(menu, "mark.list", tr("L&ist"), tr("Show the list of marks"),
                             [this] { mParts.tabs.showPage(mPanel); });
}

void MarkRoom::saveTable() {
  QString start = QFileInfo(QString::fromStdString(mParts.session.file().path())).completeBaseName() + "-measures.csv";
  QString path =
      askSavePath(&mParts.window, tr("Save table"), start, tr("Table (*.csv);;Table with profiles and ways (*.json)"));
  if (!path.isEmpty()) saveTableTo(path);
}

void MarkRoom::saveTableTo(const QString& path) {
  scene::Scene scene = mParts.session.membranes().withShapes(mParts.session.shown());
  mParts.jobs.start(
      tr("Measuring"),
      [scene = std::move(scene), path = path.toStdString()](Progress& progress) {
        session::TableParts parts{true, bool(scene.labels.data), false};
        auto rows = session::measureAll(scene, parts, progress);
        bool isJson = lowerExtension(path) == ".json";
        replaceFile(path, isJson ? session::tableJson(rows, scene.unit) : session::tableCsv(rows));
      },
      [this, path] { mParts.messages.showNote(tr("Saved %1").arg(path)); });
}

void MarkRoom::rename(int mark) {
  mParts.tabs.showPage(mPanel);
  mPanel->startRenaming(mark);
}

void MarkRoom::refresh(const session::Session& session) {
  mNames->setChecked(session.shown().lettering.names);
  mPanel->setHidden(mLettering.hidden());
  mPanel->refresh();
  measure(session);
}

/// Measures in the background what takes its time: values in circles, boxes and structures, ways along surfaces.
void MarkRoom::measure(const session::Session& session) {
  if (std::ranges::all_of(session.shown().lettering.marks, session::isMeasuredAtOnce)) {
    mMeasured = {};
    return mMeter.stop();
  }
  scene::Scene wanted = session::measuredScene(session.shown());
  if (wanted == mMeasured) return;
  mMeasured = wanted;
  auto found = std::make_shared<std::map<int, session::Measured>>();
  mMeter.want(
      [this, found] {
        scene::Scene scene = mParts.session.membranes().withShapes(mParts.session.shown());
        return
            [found, scene = std::move(scene)](Progress& progress) { *found = session::measuredMarks(scene, progress); };
      },
      [this, found] {
        mPanel->setMeasured(*found);
        mLettering.setMeasured(std::move(*found));
        mParts.toolbox.repaint();
      });
}

void MarkRoom::addCaption() {
  mParts.tabs.showPage(mPanel);
  mPanel->captions().add();
}

}  // namespace velum::gui
