#include "gui/mark/MarkMenu.h"

#include <fmt/format.h>

#include <QApplication>
#include <QClipboard>

#include "gui/kit/Text.h"
#include "gui/view/ViewChange.h"
#include "scene/SectionPlane.h"
#include "scene/json/Paths.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"
#include "session/command/MarkCommands.h"
#include "session/mark/MarkHands.h"
#include "session/mark/MarkWords.h"
#include "session/measure/Follow.h"

namespace velum::gui {

namespace {
std::vector<std::string> keyOfMark(int mark) { return {"#" + std::to_string(mark)}; }
}  // namespace

void MarkMenu::remove(int mark) {
  if (session::findMark(mDocument.shown(), mark)) session::edit(mDocument, session::RemoveMarks{keyOfMark(mark)});
}

void MarkMenu::duplicate(int mark) {
  bool hasRoom = mDocument.shown().lettering.marks.size() < scene::kMostMarks;
  if (hasRoom && session::findMark(mDocument.shown(), mark))
    session::edit(mDocument, session::DuplicateMarks{keyOfMark(mark)});
}

void MarkMenu::setVisible(int mark, bool visible) {
  if (session::findMark(mDocument.shown(), mark))
    session::edit(mDocument, session::ShowMarks{keyOfMark(mark), visible});
}

void MarkMenu::setWords(int mark, const QString& words) {
  if (!session::findMark(mDocument.shown(), mark)) return;
  session::edit(mDocument,
                session::SetField{fmt::format("lettering.marks[#{}].text", mark),
                                  scene::valueOfText(words.trimmed().toStdString())},
                false, tr("Rename mark").toStdString());
}

void MarkMenu::goTo(int mark) {
  const scene::Mark* found = session::findMark(mDocument.shown(), mark);
  if (!found || found->points.empty()) return;
  glm::dvec3 place = session::followed(mDocument.shown(), *found).points[0];
  changeSections(mDocument, [place](scene::Scene& scene) { scene::moveCrosshair(scene, place); });
}

void MarkMenu::setFollowing(int mark, bool follows) {
  if (!session::findMark(mDocument.shown(), mark)) return;
  session::FollowMarks command{keyOfMark(mark), follows};
  follows ? mJobs.run(command) : session::edit(mDocument, command);
}

void MarkMenu::copy(int mark) {
  const scene::Scene& scene = mDocument.shown();
  const scene::Mark* found = session::findMark(scene, mark);
  if (!found) return;
  QApplication::clipboard()->setText(
      toText(session::markName(scene, *found) + "\t" + session::markValue(scene, *found)));
}

void MarkMenu::fill(QMenu& menu, int mark) {
  const scene::Mark* found = session::findMark(mDocument.shown(), mark);
  if (!found) return;
  menu.setObjectName("markMenu");
  menu.setToolTipsVisible(true);
  menu.addAction(toText(session::markWords(mDocument.shown(), *found)).section('\n', 0, 0))->setEnabled(false);
  menu.addSeparator();
  auto add = [&](const QString& text, const QString& tip, auto act) {
    QAction* action = menu.addAction(text, this, act);
    action->setToolTip(tip);
    return action;
  };
  add(tr("Rename..."), tr("Type its words"), [this, mark] { emit renameAsked(mark); });
  add(tr("Go there"), tr("Bring the crosshair to it"), [this, mark] {
    goTo(mark);
  })->setEnabled(!found->points.empty());
  add(tr("Copy value"), tr("Name and value, for tables and texts"), [this, mark] { copy(mark); });
  add(tr("Duplicate"), tr("Add a copy of it"), [this, mark] { duplicate(mark); });
  bool follows = session::isFollowing(*found);
  QString followTip = follows ? tr("Its points stay where they are now")
                              : tr("Its points go to the middles of the molecules or structures in which they lie, "
                                   "and follow them");
  bool canFollow = mDocument.shown().model.data || mDocument.shown().labels.data;
  add(follows ? tr("Let go") : tr("Follow what is there"), followTip, [this, mark, follows] {
    setFollowing(mark, !follows);
  })->setEnabled(!found->points.empty() && (follows || canFollow));
  bool isSeen = found->visible;
  add(isSeen ? tr("Hide") : tr("Show"), tr("A hidden mark is still measured"),
      [this, mark, isSeen] { setVisible(mark, !isSeen); });
  add(tr("Remove\tDel"), tr("Take it away"), [this, mark] { remove(mark); });
}

}  // namespace velum::gui
