#include "ModelRoom.h"

#include <numeric>

namespace velum::gui {

ModelRoom::ModelRoom(const WindowParts& parts)
    : Room(parts),
      mCommands(new ModelCommands(parts.document(), parts.selection, this)),
      mPanel(new ModelPanel(*mCommands, &parts.tabs)),
      mLegend(parts.document(), parts.views.viewport()) {
  parts.tabs.addPage(mPanel, tr("Model"), tr("Compartments and types of the model, its look"));
  parts.tabs.setPageShown(mPanel, false);
  connect(mPanel, &ModelPanel::legendAsked, this, &ModelRoom::showLegend);
  connectViews();
  addActions();
}

void ModelRoom::refresh(const session::Session& session) {
  bool hasModel = bool(session.scene().model.data);
  if (hasModel != mHadModel) {
    mHadModel = hasModel;
    mParts.tabs.setPageShown(mPanel, hasModel);
    if (hasModel) mParts.tabs.showPage(mPanel);
  }
  mPanel->refresh();
}

void ModelRoom::connectViews() {
  Selection& selection = mParts.selection;
  Viewport& viewport = mParts.views.viewport();
  connect(&viewport, &Viewport::clickedAt, this,
          [&selection](const render::Pick& pick) { selection.setType(pick.hit ? pick.type : -1); });
  connect(&viewport, &Viewport::menuAskedAt, this, [this, &selection](const render::Pick& pick, QPoint place) {
    if (!pick.hit || pick.type < 0) return;
    selection.setType(pick.type);
    const Model& model = *mParts.session.scene().model.data;
    QMenu menu(&mParts.window);
    mCommands->fillMenu(menu, {std::uint32_t(pick.type)},
                        QString::fromStdString(model.types[std::size_t(pick.type)].name));
    menu.exec(place);
  });
  connect(&viewport, &Viewport::instanceWanted, this,
          [this](const render::Pick& pick) { mCommands->goToInstance(pick.modelInstance); });
  connect(&viewport, &Viewport::refined, this, [this, &viewport](double, const QString& stage) {
    if (!stage.isEmpty()) return;
    if (mLegend.count()) mParts.toolbox.repaint(viewport);
    if (mParts.session.scene().model.data) mPanel->looks().drawPictures();
  });
}

void ModelRoom::findType() {
  if (!mParts.session.scene().model.data) return mParts.messages.showNote(tr("No model is open."));
  mParts.tabs.showPage(mPanel);
  mPanel->startSearch();
}

void ModelRoom::showLegend(bool shown) {
  mLegend.setShown(shown);
  mLegendAction->setChecked(shown);
  mPanel->setLegendShown(shown);
  mParts.toolbox.repaint(mParts.views.viewport());
}

void ModelRoom::addActions() {
  ActionTable& actions = mParts.actions;
  QMenu* menu = mParts.menu(MenuId::Structures);
  menu->addSeparator();
  auto hasModel = [this] { return bool(mParts.session.scene().model.data); };
  actions.addForScene(menu, "model.list", tr("&Model"), tr("Show the types of the model"), [this, hasModel] {
    hasModel() ? mParts.tabs.showPage(mPanel) : mParts.messages.showNote(tr("No model is open."));
  });
  actions.addForScene(menu, "model.find", tr("Find &type..."), tr("Search a type of the model by name"),
                      [this] { findType(); });
  actions.addForScene(menu, "model.showAll", tr("Show all t&ypes"), tr("Show every type of the model"), [this] {
    session::TypeNumbers types(mParts.session.scene().model.data ? mParts.session.scene().model.data->types.size() : 0);
    std::iota(types.begin(), types.end(), 0u);
    mCommands->setVisible(types, true);
  });
  mLegendAction = actions.addForScene(menu, "model.legend", tr("Lege&nd"),
                                      tr("Colours and names of the types that are seen most, over the picture"),
                                      [this] { showLegend(mLegendAction->isChecked()); });
  mLegendAction->setCheckable(true);
}

}  // namespace velum::gui
