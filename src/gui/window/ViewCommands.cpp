#include "gui/window/ViewCommands.h"

#include <algorithm>

#include "core/Assert.h"
#include "gui/kit/Length.h"
#include "gui/kit/Preferences.h"
#include "gui/kit/Words.h"
#include "gui/view/GreyWindowCorner.h"
#include "gui/view/SideNames.h"
#include "gui/view/ViewChange.h"
#include "scene/VisibleFrame.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"

namespace velum::gui {

namespace {

constexpr const char* kCubeKey = "view/cube";
constexpr const char* kFourViews = QT_TRANSLATE_NOOP("Words", "&Four views");

struct DirectionRow {
  const char *id, *ofPatient, *ofThing;
  scene::StandardView view;
};
constexpr DirectionRow kDirections[] = {
    {"view.anterior", QT_TRANSLATE_NOOP("Words", "&Anterior"), QT_TRANSLATE_NOOP("Words", "Fr&ont"),
     scene::StandardView::Anterior},
    {"view.posterior", QT_TRANSLATE_NOOP("Words", "P&osterior"), QT_TRANSLATE_NOOP("Words", "B&ack"),
     scene::StandardView::Posterior},
    {"view.left", QT_TRANSLATE_NOOP("Words", "&Left"), QT_TRANSLATE_NOOP("Words", "&Left"), scene::StandardView::Left},
    {"view.right", QT_TRANSLATE_NOOP("Words", "Ri&ght"), QT_TRANSLATE_NOOP("Words", "Ri&ght"),
     scene::StandardView::Right},
    {"view.superior", QT_TRANSLATE_NOOP("Words", "&Superior"), QT_TRANSLATE_NOOP("Words", "Top"),
     scene::StandardView::Superior},
    {"view.inferior", QT_TRANSLATE_NOOP("Words", "&Inferior"), QT_TRANSLATE_NOOP("Words", "Botto&m"),
     scene::StandardView::Inferior},
    {"view.oblique", QT_TRANSLATE_NOOP("Words", "O&blique"), QT_TRANSLATE_NOOP("Words", "O&blique"),
     scene::StandardView::Oblique}};

void resetCamera(session::Document& document, const QWidget& view) {
  double aspect = double(std::max(1, view.width())) / std::max(1, view.height());
  document.view(
      [camera = scene::firstCamera(document.shown(), aspect)](scene::Scene& scene) { scene.camera = camera; });
}

}  // namespace

ViewCommands::ViewCommands(const WindowParts& parts)
    : Room(parts), mLayouts(new QActionGroup(this)), mCube(new ViewCube(parts.document(), parts.views.viewport())) {
  QMenu* menu = parts.menu(MenuId::View);
  addDirections(menu);
  menu->addSeparator();
  mProjection = parts.actions.addForScene(menu, "view.parallel", tr("&Parallel projection"),
                                          tr("Parallel (orthographic) instead of perspective"),
                                          [this] { mParts.views.viewport().toggleProjection(); });
  mProjection->setIconText(tr("Parallel"));
  mProjection->setCheckable(true);
  QAction* reset = parts.actions.addForScene(menu, "view.reset", tr("&Reset view"), tr("See all of it from the front"),
                                             [this] { resetCamera(mParts.document(), mParts.views.viewport()); });
  reset->setIconText(tr("Reset"));
  addCube(menu);
  mScaleBar = parts.actions.addForScene(
      menu, "view.scaleBar", tr("Scale bar"),
      tr("A bar that says how long things are, over the picture, also in files"), [this] {
        session::edit(mParts.document(),
                      session::SetField{"lettering.scaleBar", mScaleBar->isChecked() ? "true" : "false"});
      });
  mScaleBar->setCheckable(true);
  mTimeStamp = parts.actions.addForScene(
      menu, "view.timeStamp", tr("Time stamp"), tr("The time of the time step, over the picture, also in files"),
      [this] {
        session::edit(mParts.document(),
                      session::SetField{"lettering.timeStamp", mTimeStamp->isChecked() ? "true" : "false"});
      });
  mTimeStamp->setCheckable(true);
  parts.actions.addForScene(menu, "view.addCaption", tr("Add caption"),
                            tr("Write words over the picture, also in files"), [this] { emit captionAsked(); });
  menu->addSeparator();
  addLayouts(menu);
  menu->addSeparator();
  addSections(menu);
  addGreyWindows(menu->addMenu(tr("Grey &window")));
  nameSides(parts.session.shown());
}

void ViewCommands::addDirections(QMenu* menu) {
  for (const DirectionRow& row : kDirections)
    mDirections << mParts.actions.addForScene(menu, row.id, wordsOf(row.ofPatient), {},
                                              [this, view = row.view] { mParts.views.viewport().lookFrom(view); });
}

/// Words of the clinic stand where there is a patient; all else has a front and a top.
void ViewCommands::nameSides(const scene::Scene& scene) {
  bool isPatient = hasPatientLetters(scene);
  ActionTable& actions = mParts.actions;
  for (std::size_t i = 0; i < std::size(kDirections); ++i) {
    const DirectionRow& row = kDirections[i];
    actions.rename(mDirections[qsizetype(i)], isPatient ? wordsOf(row.ofPatient) : wordsOf(row.ofThing),
                   tr("Look from: %1").arg(viewName(scene, row.view)));
  }
  actions.rename(mLayouts->actions()[int(scene::Layout::FourUp)], wordsOf(kFourViews),
                 isPatient ? tr("Axial, coronal, sagittal and 3D") : tr("Three sections and 3D"));
  actions.rename(mAxes, isPatient ? tr("Sections along the patient's a&xes") : tr("Sections along the a&xes"),
                 isPatient ? tr("Axial, coronal and sagittal again, crosshair in the middle")
                           : tr("XY, XZ and YZ again, crosshair in the middle"));
}

void ViewCommands::addLayouts(QMenu* menu) {
  using scene::Layout;
  struct Row {
    const char *id, *name, *tip;
  };
  // In the order of scene::Layout.
  static constexpr Row kRows[] = {
      {"layout.four", kFourViews, QT_TRANSLATE_NOOP("Words", "Three sections and 3D")},
      {"layout.volume", QT_TRANSLATE_NOOP("Words", "3&D only"), QT_TRANSLATE_NOOP("Words", "The 3D view alone")},
      {"layout.beside", QT_TRANSLATE_NOOP("Words", "3D and one s&ection"),
       QT_TRANSLATE_NOOP("Words", "The 3D view and the current section")},
      {"layout.section", QT_TRANSLATE_NOOP("Words", "One se&ction"),
       QT_TRANSLATE_NOOP("Words", "The current section alone")}};
  static_assert(std::size(kRows) == std::size(EnumNames<Layout>::kNames), "each layout has its row");
  for (const Row& row : kRows) {
    auto layout = static_cast<Layout>(&row - kRows);
    QAction* action = mParts.actions.addForScene(menu, row.id, wordsOf(row.name), wordsOf(row.tip),
                                                 [this, layout] { mParts.views.setLayout(layout); });
    action->setCheckable(true);
    mLayouts->addAction(action);
  }
}

void ViewCommands::addSections(QMenu* menu) {
  ActionTable& actions = mParts.actions;
  actions.addForScene(menu, "sections.next", tr("&Next section"), tr("Show the plane nearer to you"),
                      [this] { mParts.views.currentSection().scroll(1); });
  actions.addForScene(menu, "sections.previous", tr("Pre&vious section"), tr("Show the plane further away"),
                      [this] { mParts.views.currentSection().scroll(-1); });
  mAxes = actions.addForScene(menu, "sections.reset", tr("Sections along the a&xes"), {},
                              [this] { changeSections(mParts.document(), scene::resetSections); });
}

/// Each by its name, on while the values are of its unit.
void ViewCommands::addGreyWindows(QMenu* menu) {
  menu->setToolTipsVisible(true);
  static constexpr const char* kNames[] = {
      QT_TRANSLATE_NOOP("Words", "&Soft tissue"), QT_TRANSLATE_NOOP("Words", "&Abdomen"),
      QT_TRANSLATE_NOOP("Words", "&Lung"),        QT_TRANSLATE_NOOP("Words", "&Bone"),
      QT_TRANSLATE_NOOP("Words", "B&rain"),       QT_TRANSLATE_NOOP("Words", "An&giography"),
      QT_TRANSLATE_NOOP("Words", "SUV 0 to &5"),  QT_TRANSLATE_NOOP("Words", "SUV 0 to 1&0"),
      QT_TRANSLATE_NOOP("Words", "SUV 0 to &20")};
  auto windows = scene::greyWindows();
  VELUM_ASSERT(std::size(kNames) == windows.size(), "each grey window has its letter");
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const scene::GreyWindow& window = windows[i];
    QString id = "sections.window." + QString::fromUtf8(window.name.data(), int(window.name.size()));
    mWindows << mParts.actions.addForScene(menu, id, wordsOf(kNames[i]),
                                           tr("Grey window of sections: %1").arg(greyWindowTitle(window)),
                                           [this, name = window.name] { setGreyWindow(mParts.document(), name); });
  }
  menu->addSeparator();
  mTypeWindow =
      mParts.actions.addForScene(menu, "sections.window.type", tr("&Type it..."),
                                 tr("Type width and level of the grey window, or its name, in the section"),
                                 [this] { GreyWindowCorner::of(mParts.views.currentSection()).startTyping(); });
}

void ViewCommands::addCube(QMenu* menu) {
  bool isShown = Preferences().value(kCubeKey, true).toBool();
  mCube->setShown(isShown);
  QAction* cube = mParts.actions.add(menu, "view.cube", tr("Orien&tation cube"),
                                     tr("A cube in the corner of the 3D view: click a side to look from there"), [] {});
  cube->setCheckable(true);
  cube->setChecked(isShown);
  connect(cube, &QAction::toggled, this, [this](bool shown) {
    Preferences().setValue(kCubeKey, shown);
    mCube->setShown(shown);
  });
}

void ViewCommands::refresh(const session::Session& session) {
  const scene::Scene& scene = session.shown();
  mLayouts->actions()[int(scene.sections.layout)]->setChecked(true);
  mCube->refresh();
  nameSides(scene);
  const auto& volume = scene.volume.data;
  auto windows = volume ? scene::greyWindowsFor(*volume) : std::span<const scene::GreyWindow>();
  for (qsizetype i = 0; i < mWindows.size(); ++i) {
    const scene::GreyWindow* window = &scene::greyWindows()[std::size_t(i)];
    mWindows[i]->setEnabled(window >= windows.data() && window < windows.data() + windows.size());
  }
  mTypeWindow->setEnabled(volume && !volume->isColor && scene.sections.layout != scene::Layout::Volume);
  mProjection->setChecked(scene.camera.projection == scene::Projection::Orthographic);
  mScaleBar->setChecked(scene.lettering.scaleBar);
  mTimeStamp->setChecked(scene.lettering.timeStamp);
  mTimeStamp->setEnabled(volume && volume->timeSteps > 1);
}

}  // namespace velum::gui
