#include "ViewCommands.h"

#include "view/ViewChange.h"
#include "view/ViewIcons.h"

namespace velum::gui {

ViewCommands::ViewCommands(const WindowParts& parts) : Room(parts), mLayouts(new QActionGroup(this)) {
  QMenu* menu = parts.menu(MenuId::View);
  addDirections(menu);
  menu->addSeparator();
  mProjection = parts.actions.addForScene(menu, "view.parallel", tr("&Parallel projection"),
                                          tr("Parallel (orthographic) instead of perspective"),
                                          [this] { mParts.views.viewport().toggleProjection(); });
  mProjection->setIconText(tr("Parallel"));
  mProjection->setCheckable(true);
  QAction* reset = parts.actions.addForScene(
      menu, "view.reset", tr("&Reset view"), tr("See all of it from the front"),
      [this] { mParts.views.viewport().lookFrom(scene::defaultView(mParts.session.scene())); });
  reset->setIconText(tr("Reset"));
  parts.bar.addAction(mProjection);
  parts.bar.addAction(reset);
  parts.bar.addSeparator();
  menu->addSeparator();
  addLayouts(menu);
  menu->addSeparator();
  addSections(menu);
  parts.bar.addSeparator();
}

void ViewCommands::addDirections(QMenu* menu) {
  using scene::StandardView;
  struct Row {
    const char *id, *name, *letter;
    StandardView view;
  };
  static constexpr Row kRows[] = {{"view.anterior", "&Anterior", "A", StandardView::Anterior},
                                  {"view.posterior", "P&osterior", "P", StandardView::Posterior},
                                  {"view.left", "&Left", "L", StandardView::Left},
                                  {"view.right", "Ri&ght", "R", StandardView::Right},
                                  {"view.superior", "&Superior", "S", StandardView::Superior},
                                  {"view.inferior", "&Inferior", "I", StandardView::Inferior},
                                  {"view.oblique", "O&blique", "", StandardView::Oblique}};
  for (const Row& row : kRows) {
    QAction* action = mParts.actions.addForScene(menu, row.id, tr(row.name),
                                                 tr("Look from: %1").arg(tr(row.name).remove('&').toLower()),
                                                 [this, view = row.view] { mParts.views.viewport().lookFrom(view); });
    if (!*row.letter) continue;
    action->setIconText(row.letter);
    mParts.bar.addAction(action);
  }
}

void ViewCommands::addLayouts(QMenu* menu) {
  using scene::Layout;
  struct Row {
    const char *id, *name, *tip;
    ViewIcon icon;
  };
  // In the order of scene::Layout.
  static constexpr Row kRows[] = {
      {"layout.four", "&Four views", "Axial, coronal, sagittal and 3D", ViewIcon::FourUp},
      {"layout.volume", "3&D only", "The 3D view alone", ViewIcon::Volume},
      {"layout.beside", "3D and one s&ection", "The 3D view and the current section", ViewIcon::VolumeAndSection},
      {"layout.section", "One se&ction", "The current section alone", ViewIcon::Section}};
  static_assert(std::size(kRows) == std::size(EnumNames<Layout>::kNames), "each layout has its row");
  for (const Row& row : kRows) {
    auto layout = static_cast<Layout>(&row - kRows);
    QAction* action = mParts.actions.addForScene(menu, row.id, tr(row.name), tr(row.tip),
                                                 [this, layout] { mParts.views.setLayout(layout); });
    action->setIcon(makeViewIcon(row.icon));
    action->setIconVisibleInMenu(false);
    action->setCheckable(true);
    mLayouts->addAction(action);
    mParts.bar.addAction(action);
  }
}

void ViewCommands::addSections(QMenu* menu) {
  ActionTable& actions = mParts.actions;
  actions.addForScene(menu, "sections.next", tr("&Next section"), tr("Show the plane nearer to you"),
                      [this] { mParts.views.currentSection().scroll(1); });
  actions.addForScene(menu, "sections.previous", tr("Pre&vious section"), tr("Show the plane further away"),
                      [this] { mParts.views.currentSection().scroll(-1); });
  actions.addForScene(menu, "sections.reset", tr("Sections along the patient's a&xes"),
                      tr("Axial, coronal and sagittal again, crosshair in the middle"),
                      [this] { changeSections(mParts.document(), scene::resetSections); });
}

void ViewCommands::refresh(const session::Session& session) {
  const scene::Scene& scene = session.scene();
  mLayouts->actions()[int(scene.sections.layout)]->setChecked(true);
  mProjection->setChecked(scene.camera.projection == scene::Projection::Orthographic);
}

}  // namespace velum::gui
