#include "gui/model/ModelRoom.h"

#include <fmt/format.h>

#include <QInputDialog>
#include <QLocale>
#include <QTimer>
#include <memory>
#include <numeric>

#include "gui/kit/Text.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"
#include "session/command/ModelCommands.h"
#include "session/model/CountPictures.h"

namespace velum::gui {

ModelRoom::ModelRoom(const WindowParts& parts)
    : Room(parts),
      mCommands(new ModelCommands(parts.document(), parts.selection, this)),
      mEqualizer(new Equalizer(parts.session, parts.views.viewport(), parts.jobs, this)),
      mPanel(new ModelPanel(*mCommands, *mEqualizer, &parts.tabs)),
      mLettering(parts.document(), parts.views.viewport()),
      mHighlight(parts.views.viewport()) {
  parts.tabs.addPage(mPanel, QT_TRANSLATE_NOOP("Words", "Model"), tr("Compartments and types of the model, its look"));
  parts.tabs.setPageShown(mPanel, false);
  connect(mPanel, &ModelPanel::legendAsked, this, &ModelRoom::showLegend);
  connect(mPanel, &ModelPanel::cutAsked, this, [this] {
    mParts.actions.find("cut.alongView")->trigger();
    mParts.tabs.showPage(mPanel);
  });
  connectViews();
  connectEqualizer();
  addActions();
}

void ModelRoom::refresh(const session::Session& session) {
  bool hasModel = bool(session.shown().model.data);
  if (hasModel != mHadModel) {
    mHadModel = hasModel;
    mParts.tabs.setPageShown(mPanel, hasModel);
    if (hasModel) mParts.tabs.showPage(mPanel);
    mParts.side.setRoomy(hasModel);
  }
  mEqualizer->refresh();
  mPanel->refresh();
  refreshLettering(session.shown());
}

void ModelRoom::connectEqualizer() {
  Viewport& viewport = mParts.views.viewport();
  connect(mCommands, &ModelCommands::hidingAsked, this, &ModelRoom::findHiding);
  connect(mCommands, &ModelCommands::targetWanted, this, &ModelRoom::findSeenRange);
  connect(mCommands, &ModelCommands::renameAsked, this, [this](const QString& path) {
    mParts.tabs.showPage(mPanel);
    mPanel->list().startRename(path.toStdString());
  });
  connect(mCommands, &ModelCommands::targetsAsked, this, &ModelRoom::meetTargets);
  connect(&mPanel->steps(), &EqualizeSteps::asked, this, &ModelRoom::takeStep);
  connect(&mPanel->list(), &ModelList::refused, this, [this](const QString& why) { mParts.messages.showNote(why); });
  connect(&mPanel->list(), &ModelList::hovered, this, [this, &viewport](const session::TypeNumbers& types) {
    bool isAll = mParts.session.shown().model.data && types.size() == mParts.session.shown().model.data->types.size();
    if (mHighlight.show(isAll ? session::TypeNumbers() : types)) mParts.toolbox.repaint(viewport);
  });
  connect(&viewport, &Viewport::pointedAt, this,
          [this](const render::Pick& pick) { mPanel->list().setPointed(pick.hit ? pick.type : -1); });
  connect(&viewport, &Viewport::pointedAtNothing, this, [this] { mPanel->list().setPointed(-1); });
}

void ModelRoom::takeStep(EqualizeSteps::Step step) {
  switch (step) {
    case EqualizeSteps::Step::Cut:
      if (mParts.session.shown().cuts.empty()) mParts.actions.find("cut.addPlane")->trigger();
      mParts.tabs.showPage(mPanel);
      break;
    case EqualizeSteps::Step::Balance:
      mPanel->list().setFocus();
      break;
    case EqualizeSteps::Step::Clear: {
      std::string path = mPanel->list().selectedPath();
      if (path.empty()) return mParts.messages.showNote(tr("Select a type or compartment first: it is kept in view."));
      mCommands->setInView(path, true);
      break;
    }
    case EqualizeSteps::Step::Save:
      mParts.actions.find("file.savePicture")->trigger();
  }
}

/// Finds by pictures that are drawn in the background what hides a type: the answer comes a moment later.
void ModelRoom::findHiding(const QString& path) {
  auto hiding = std::make_shared<session::Hiding>();
  auto work = [hiding, scene = mParts.session.shown(), name = path.toStdString(), size = pictureSize()](
                  Progress& progress) { *hiding = session::findHiding(scene, name, size, progress); };
  mParts.jobs.start(tr("Looking what hides %1").arg(nameOf(path)), work, [this, hiding] {
    if (!mParts.session.shown().model.data) return;
    mParts.tabs.showPage(mPanel);
    mPanel->showHiding(*hiding);
  });
}

void ModelRoom::connectViews() {
  Selection& selection = mParts.selection;
  Viewport& viewport = mParts.views.viewport();
  connect(&viewport, &Viewport::clickedAt, this,
          [&selection](const render::Pick& pick) { selection.setType(pick.hit ? pick.type : -1); });
  connect(&viewport, &Viewport::menuAskedAt, this, [this, &selection](const render::Pick& pick, QPoint place) {
    if (!pick.hit || pick.type < 0) return;
    selection.setType(pick.type);
    const Model& model = *mParts.session.shown().model.data;
    QMenu menu(&mParts.window);
    const MoleculeType& type = model.types[std::size_t(pick.type)];
    mCommands->fillMenu(menu, {std::uint32_t(pick.type)},
                        typeText(mParts.session.shown().model, std::uint32_t(pick.type)), pathOf(model, type));
    menu.exec(place);
  });
  connect(&viewport, &Viewport::instanceWanted, this,
          [this](const render::Pick& pick) { mCommands->goToInstance(pick.modelInstance); });
  connect(&viewport, &Viewport::refined, this, [this, &viewport](double, const QString& stage) {
    if (!stage.isEmpty()) {
      if (mHighlight.takeAway()) mParts.toolbox.repaint(viewport);
      return;
    }
    bool isOther = mLettering.count();
    if (mHighlight.look() || isOther) mParts.toolbox.repaint(viewport);
    if (mParts.session.shown().model.data) mPanel->looks().drawPictures();
  });
}

/// Finds by pictures how many instances of a type are seen and can be, then asks how many are to be.
void ModelRoom::findSeenRange(const QString& path) {
  auto range = std::make_shared<session::SeenRange>();
  auto work = [range, scene = mParts.session.shown(), name = path.toStdString(), size = pictureSize()](
                  Progress& progress) { *range = session::findSeenRange(scene, name, size, progress); };
  mParts.jobs.start(tr("Looking how many of %1 can be seen").arg(nameOf(path)), work, [this, range, path] {
    // After the job has ended: what is asked for is another.
    QTimer::singleShot(0, this, [this, range, path] { askTarget(path, *range); });
  });
}

void ModelRoom::askTarget(const QString& path, const session::SeenRange& range) {
  if (!mParts.session.shown().model.data) return;
  QLocale locale;
  QString name = nameOf(path), text;
  auto before = session::visibleTarget(mParts.session.shown(), path.toStdString());
  text = locale.toString(qulonglong(before ? std::uint64_t(*before) : range.now));
  QString facts = tr("Of %1 %2, %3 are seen now. At most about %4 can be, where cuts leave all of them.")
                      .arg(locale.toString(qulonglong(range.total)), name, locale.toString(qulonglong(range.now)),
                           locale.toString(qulonglong(range.most)));
  QString why;
  for (;;) {
    bool isGiven = false;
    text = QInputDialog::getText(
        &mParts.window, tr("Number to be seen"),
        facts + "\n" + (why.isEmpty() ? QString() : why + "\n") + tr("To be seen, a number or a share such as 20 %:"),
        QLineEdit::Normal, text, &isGiven);
    if (!isGiven) return;
    if (auto number = ModelTree::readNumber(text, double(range.total))) {
      mCommands->setTarget(path.toStdString(), *number);
      return meetTargets();
    }
    why = tr("\"%1\" is neither a whole number nor a share up to 100 %.").arg(text);
  }
}

/// The name of a type or compartment as it is shown.
QString ModelRoom::nameOf(const QString& path) const {
  return toText(
      scene::shownName(mParts.session.shown().model, path.toStdString(), path.section('.', -1).toStdString()));
}

/// Of the view, in pixels.
glm::ivec2 ModelRoom::pictureSize() const {
  const Viewport& viewport = mParts.views.viewport();
  glm::dvec2 size = glm::dvec2(viewport.width(), viewport.height()) * viewport.devicePixelRatioF();
  return glm::max(glm::ivec2(glm::round(size)), glm::ivec2(1));
}

/// Meets all targets at once, by pictures that are drawn in the background; targets that cannot be met are told.
void ModelRoom::meetTargets() {
  if (mParts.session.shown().model.targets.empty())
    return mParts.messages.showNote(tr("No type has a number to be seen: give one in its menu."));
  glm::ivec2 size = pictureSize();
  session::Call call = session::MeetTargets{fmt::format("{}x{}", size.x, size.y)};
  auto make = [call](const scene::Scene& scene, Progress& progress) { return session::editOf(scene, call, progress); };
  auto commit = [this, call](const session::Edit& edit) {
    session::commitCuts(mParts.document(), edit, call);
    mParts.messages.showNote(edit.told.empty() ? tr("All numbers are met.") : tr("As near as can be"), edit.told);
  };
  mParts.jobs.edit(tr("Meeting the numbers to be seen"), {JobRunner::Beside::Ground::Cuts, make, commit});
}

void ModelRoom::findType() {
  if (!mParts.session.shown().model.data) return mParts.messages.showNote(tr("No model is open."));
  mParts.tabs.showPage(mPanel);
  mPanel->startSearch();
}

void ModelRoom::showLegend(bool shown) {
  session::edit(mParts.document(), session::SetField{"lettering.legend", shown ? "true" : "false"});
}

/// Shows what the scene says of the lettering.
void ModelRoom::refreshLettering(const scene::Scene& scene) {
  if (scene.lettering == mWritten && scene.model.types == mNamed) return;
  mWritten = scene.lettering, mNamed = scene.model.types;
  mLegendAction->setChecked(scene.lettering.legend);
  mLettering.recount();
  mParts.toolbox.repaint(mParts.views.viewport());
}

void ModelRoom::addActions() {
  ActionTable& actions = mParts.actions;
  QMenu* menu = mParts.menu(MenuId::Structures);
  menu->addSeparator();
  auto hasModel = [this] { return bool(mParts.session.shown().model.data); };
  actions.addForScene(menu, "model.list", tr("&Model"), tr("Show the types of the model"), [this, hasModel] {
    hasModel() ? mParts.tabs.showPage(mPanel) : mParts.messages.showNote(tr("No model is open."));
  });
  actions.addForScene(menu, "model.find", tr("Find &type..."), tr("Search a type of the model by name"),
                      [this] { findType(); });
  actions.addForScene(menu, "model.showAll", tr("Show all t&ypes"), tr("Show every type of the model"), [this] {
    session::TypeNumbers types(mParts.session.shown().model.data ? mParts.session.shown().model.data->types.size() : 0);
    std::iota(types.begin(), types.end(), 0u);
    mCommands->setVisible(types, true);
  });
  actions.addForScene(menu, "model.meetTargets", tr("Meet num&bers to be seen"),
                      tr("Set what cuts leave so that of each type as many are seen as is wanted"), [this, hasModel] {
                        if (hasModel()) meetTargets();
                      });
  mLegendAction = actions.addForScene(
      menu, "model.legend", tr("Lege&nd"),
      tr("Colours and names of types over the picture, also in files: those that are seen most, or that are listed"),
      [this] { showLegend(mLegendAction->isChecked()); });
  mLegendAction->setCheckable(true);
}

}  // namespace velum::gui
