// Membranes in the real window: one is added, settles, rests, is dragged, undone, saved and opened again.
#include <QCheckBox>
#include <QComboBox>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/membrane/MembraneForm.h"
#include "gui/membrane/StrengthCanvas.h"

namespace velum::gui {

class MembraneWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    mWindow->resize(640, 700);  // the panel is seen; a small picture is soon complete
  }
  session::Document& document() { return mWindow->document(); }
  void openWithLabels() {
    mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
    ASSERT_TRUE(waitForJob());
    ASSERT_TRUE(scene().labels.data);
    drawSoon();
  }
  void addMembrane() {
    openPhantom();
    drawSoon();
    mWindow->actions().find("cut.addMembrane")->trigger();
    ASSERT_TRUE(waitForJob());
    ASSERT_EQ(scene().cuts.size(), 1u);
    ASSERT_TRUE(settle());
  }
  session::MembraneStatus status() { return *viewport().membranes().status(scene().cuts[0].id); }
  QImage picture() { return viewport().picture(); }
  scene::SheetShape shape() { return viewport().membranes().withShapes(scene()).cuts[0].membrane->shape; }
};

TEST_F(MembraneWindow, ANewOneKeepsWholeWhatIsShownMost) {
  addMembrane();
  EXPECT_EQ(scene().cuts[0].shape, scene::CutShape::Membrane);
  EXPECT_EQ(document().undoLabel(), "Add membrane");
  EXPECT_FALSE(scene().cuts[0].membrane->field.byValue.empty());
  ASSERT_TRUE(status().isMeasured);
  EXPECT_GT(status().planePairs, 0);
  EXPECT_LT(status().keptWhole, 1.0);  // one ball fills the middle: no sheet in reach goes around it
  auto* figure = child<QLabel>("membraneFigure");
  ASSERT_TRUE(figure && figure->isVisible());
  EXPECT_TRUE(figure->text().contains("is removed whole")) << figure->text().toStdString();
  takeShot(*mWindow, "membrane-new");
  document().undo();
  EXPECT_TRUE(scene().cuts.empty());
  EXPECT_TRUE(settle());
}

TEST_F(MembraneWindow, SaysWhatSpecksItLeavesOutAndLetsThemCount) {
  addMembrane();
  auto* least = child<QSpinBox>("leastPiece");
  auto* denoise = child<QCheckBox>("denoise");
  auto* text = child<QLabel>("leftOutText");
  ASSERT_TRUE(least && denoise && text);
  EXPECT_EQ(least->text(), "automatic");
  EXPECT_FALSE(text->isVisibleTo(text->parentWidget())) << "a phantom without noise";
  auto field = [&]() -> const scene::ForceField& { return scene().cuts[0].membrane->field; };
  least->setValue(100000);  // more than there is of anything
  EXPECT_EQ(field().leastPiece, 100000);
  ASSERT_TRUE(settle());
  ASSERT_TRUE(QTest::qWaitFor([&] { return text->isVisibleTo(text->parentWidget()); }));
  EXPECT_TRUE(text->text().contains("specks under") && text->text().contains("100 %")) << text->text().toStdString();
  takeShot(*mWindow, "membrane-specks");
  document().undo();
  EXPECT_EQ(field().leastPiece, -1);
  EXPECT_EQ(least->text(), "automatic");
  denoise->click();
  EXPECT_TRUE(field().denoise);
  EXPECT_EQ(document().undoLabel(), "Change membrane: take noise out");
  document().undo();
  EXPECT_FALSE(denoise->isChecked());
}

TEST_F(MembraneWindow, WhereMuchIsCutItSaysWhyAndOffersWhatHelps) {
  addMembrane();
  auto* button = child<QPushButton>("membraneAdvice");
  ASSERT_TRUE(button);
  // A reach too short for anything, in the middle of the data.
  document().edit("Shallow", [](scene::Scene& scene) {
    scene.cuts[0].centre = centreOf(*scene.volume.data);
    scene.cuts[0].size.z = 8.0;
  });
  ASSERT_TRUE(settle());
  ASSERT_TRUE(status().isMeasured);
  ASSERT_GT(status().shares.cut, 0.6);
  ASSERT_FALSE(status().advice.empty());
  ASSERT_TRUE(QTest::qWaitFor([&] { return button->isVisible() && button->isEnabled(); }));
  takeShot(*mWindow, "membrane-advice");
  scene::Cut before = scene().cuts[0];
  std::string label = button->text().toStdString();
  button->click();
  EXPECT_NE(scene().cuts[0], before);
  EXPECT_EQ(document().undoLabel(), label);
  ASSERT_TRUE(settle());
  EXPECT_LT(status().shares.cut, 0.6);
}

TEST_F(MembraneWindow, TheViewSaysWhatBecomesOfWhatIsProtectedAndMovesToWhereItIsKept) {
  addMembrane();
  auto* bar = mWindow->findChild<QFrame*>("keptBar");
  auto* text = child<QLabel>("keptText");
  ASSERT_TRUE(bar && text);
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar->isVisible() && bar->isEnabled(); }));
  // Over the view, not on a page.
  QRect views(mWindow->views().mapToGlobal(QPoint()), mWindow->views().size());
  EXPECT_TRUE(views.contains(QRect(bar->mapToGlobal(QPoint()), bar->size())));
  for (const char* word : {"is kept", "removed whole", "cut off"}) EXPECT_TRUE(text->text().contains(word)) << word;
  takeShot(*mWindow, "membrane-kept");
  // Where all that is protected lies in front, it says so and offers a way.
  document().edit("Behind all", [](scene::Scene& scene) {
    scene::Cut& cut = scene.cuts[0];
    scene::Bounds bounds = scene::computeBounds(scene);
    cut.centre -=
        glm::dvec3(scene::worldFromCut(cut)[2]) * 0.45 * glm::length(bounds.max - bounds.min) / std::sqrt(3.0);
    cut.size.z = 4.0;
  });
  ASSERT_TRUE(settle());
  ASSERT_TRUE(status().isMeasured);
  ASSERT_LT(status().fate.kept, 0.5);
  ASSERT_TRUE(status().wantsAdvice);
  QPushButton* move = nullptr;
  for (auto* button : bar->findChildren<QPushButton*>())
    if (button->text() == "Move to where it can be kept" && button->isVisible()) move = button;
  ASSERT_TRUE(move);
  takeShot(*mWindow, "membrane-lost");
  QTest::mouseClick(move, Qt::LeftButton);
  EXPECT_EQ(document().undoLabel(), "Move to where it can be kept");
  ASSERT_TRUE(settle());
  EXPECT_GE(status().fate.kept, 0.9);
  EXPECT_FALSE(move->isVisible());
  document().undo();
  document().undo();
  document().undo();
  ASSERT_TRUE(settle());
  EXPECT_FALSE(bar->isVisible()) << "there is no membrane any more";
}

TEST_F(MembraneWindow, SettingsThatHaveNoSayByARuleAreNotShownForIt) {
  addMembrane();
  QTest::mouseClick(child<QPushButton>("membraneMore"), Qt::LeftButton);
  auto* rule = child<QComboBox>("membraneRule");
  ASSERT_TRUE(rule);
  for (int paper : {0, 1}) {
    rule->setCurrentIndex(paper);
    emit rule->activated(paper);
    for (const char* name : {"membraneLevel", "membraneArea", "membraneBend", "membraneParticles"})
      EXPECT_EQ(child<QWidget>(name)->isVisibleTo(mWindow.get()), paper == 1) << name;
    for (const char* name : {"membraneSide", "membraneFinest"})
      EXPECT_EQ(child<QWidget>(name)->isVisibleTo(mWindow.get()), paper == 0) << name;
    for (const char* name : {"membraneStretch", "membraneRestoring"})
      EXPECT_TRUE(child<QWidget>(name)->isVisibleTo(mWindow.get())) << name;
  }
}

TEST_F(MembraneWindow, AlignedToAnAxisTheFrameFitsTheDataThereAndKeepsWhatItProtects) {
  addMembrane();
  scene::Cut before = scene().cuts[0];
  auto* superior = child<QPushButton>("alignS");
  ASSERT_TRUE(superior);
  superior->click();
  ASSERT_TRUE(waitForJob());
  const scene::Cut& cut = scene().cuts[0];
  EXPECT_EQ(document().undoLabel(), "Align cut");
  EXPECT_EQ(cut.axis, glm::dvec3(0, 0, 1));
  scene::Bounds bounds = scene::computeBounds(scene());
  glm::dvec3 edges = bounds.max - bounds.min;
  EXPECT_NEAR(cut.size.x * cut.size.y, edges.x * edges.y, 1e-6 * edges.x * edges.y);
  ASSERT_TRUE(settle());
  EXPECT_GE(status().fate.kept, 0.9);
}

/// Another context is current while it lives, as the window's own is; our GL asserts that it is in the viewport's.
class OtherContext {
 public:
  explicit OtherContext(Viewport& viewport) {
    auto* widget = dynamic_cast<QOpenGLWidget*>(&viewport.surface().widget());
    if (!widget) return;
    mSurface.create();
    mContext.setShareContext(widget->context());
    EXPECT_TRUE(mContext.create() && mContext.makeCurrent(&mSurface));
  }
  ~OtherContext() { mContext.doneCurrent(); }

 private:
  QOffscreenSurface mSurface;
  QOpenGLContext mContext;
};

/// In another context that shares its programs, Mesa forgets the one that is to run next: the window died later.
TEST_F(MembraneWindow, WhatASheetHasOnTheGpuIsGivenBackInItsOwnContext) {
  addMembrane();
  {
    OtherContext other(viewport());
    document().undo();
  }
  EXPECT_TRUE(scene().cuts.empty());
  ASSERT_TRUE(settle());
  document().redo();
  EXPECT_TRUE(settle());
  EXPECT_EQ(scene().cuts.size(), 1u);
}

TEST_F(MembraneWindow, AtRestNothingIsSteppedAndNothingIsDrawn) {
  addMembrane();
  QTest::qWait(400);
  int steps = status().steps, shown = viewport().shownCount();
  QTest::qWait(600);
  EXPECT_TRUE(mWindow->isSettled());
  EXPECT_EQ(status().steps, steps);
  EXPECT_EQ(viewport().shownCount(), shown);
}

TEST_F(MembraneWindow, DraggingTheFrameIsOneStepAndTheSheetFollows) {
  addMembrane();
  viewport().lookFrom(scene::StandardView::Oblique);
  ASSERT_TRUE(settle());
  scene::Cut before = scene().cuts[0];
  scene::SheetShape rest = shape();
  QImage still = picture();
  auto gizmo = session::makeCutGizmo(scene(), before, size());
  auto tip = scene::pixelFromWorld(scene().camera, size(), gizmo.arrowTip);
  auto foot = scene::pixelFromWorld(scene().camera, size(), gizmo.centre);
  ASSERT_TRUE(tip && foot);
  QPoint from(int(tip->x), int(tip->y));
  glm::dvec2 along = glm::normalize(*tip - *foot) * 24.0;
  drag(from, from + QPoint(int(along.x), int(along.y)));
  EXPECT_NE(scene().cuts[0].centre, before.centre);
  EXPECT_EQ(document().undoLabel(), "Move cut");
  ASSERT_TRUE(settle());
  EXPECT_NE(shape(), rest);
  EXPECT_NE(picture(), still);
  document().undo();
  EXPECT_EQ(scene().cuts[0], before);
  ASSERT_TRUE(settle());
  EXPECT_EQ(shape(), rest) << "a passive sheet rests where it did";
  EXPECT_EQ(picture(), still);
}

TEST_F(MembraneWindow, SavedAndOpenedAgainItGivesTheSamePicture) {
  addMembrane();
  QImage before = picture();
  mWindow->saveSceneTo(path("membrane.json"));
  mWindow->openPaths({path("membrane.json")});
  ASSERT_TRUE(waitForJob());
  ASSERT_TRUE(settle());
  EXPECT_EQ(picture(), before);
  viewport().renewContext();
  ASSERT_TRUE(settle());
  EXPECT_EQ(picture(), before);
}

TEST_F(MembraneWindow, AnActiveOneIsWrittenIntoTheSceneWithoutAStepOfItsOwn) {
  addMembrane();
  auto* moving = child<QComboBox>("membraneMoving");
  ASSERT_TRUE(moving);
  moving->setCurrentIndex(1);
  emit moving->activated(1);
  ASSERT_TRUE(settle());
  EXPECT_FALSE(scene().cuts[0].membrane->shape.places.empty());
  auto steps = document().undoLabels();
  ASSERT_GE(steps.size(), 2u);
  EXPECT_EQ(steps[0], "Change membrane: moving");
  EXPECT_EQ(steps[1], "Add membrane");
  QImage before = picture();
  mWindow->saveSceneTo(path("active.json"));
  mWindow->openPaths({path("active.json")});
  ASSERT_TRUE(waitForJob());
  ASSERT_TRUE(settle());
  EXPECT_EQ(picture(), before);
}

TEST_F(MembraneWindow, TheCurveIsDraggedAsOneStep) {
  addMembrane();
  auto* canvas = child<StrengthCanvas>("strengthCanvas");
  ASSERT_TRUE(canvas && canvas->isVisible());
  auto curve = scene().cuts[0].membrane->field.byValue;
  ASSERT_FALSE(curve.empty());
  std::size_t at = 1;
  QPoint from = canvas->placeOf(curve[at]).toPoint();
  drag(*canvas, from, from + QPoint(0, -20));
  EXPECT_EQ(document().undoLabel(), "Move force point");
  EXPECT_GT(scene().cuts[0].membrane->field.byValue[at].strength, curve[at].strength);
  document().undo();
  EXPECT_EQ(scene().cuts[0].membrane->field.byValue, curve);
  EXPECT_EQ(document().undoLabel(), "Add membrane");
  canvas->setFocus();
  QTest::keyClick(canvas, Qt::Key_PageDown);
  QTest::keyClick(canvas, Qt::Key_Delete);
  EXPECT_EQ(scene().cuts[0].membrane->field.byValue.size(), curve.size() - 1);
  ASSERT_TRUE(settle());
}

TEST_F(MembraneWindow, AClickProtectsAStructureOrLetsTheSheetThrough) {
  openWithLabels();
  mWindow->actions().find("cut.addMembrane")->trigger();
  ASSERT_TRUE(waitForJob());
  ASSERT_TRUE(settle());
  document().edit("Clear", [](scene::Scene& scene) { scene.cuts[0].membrane->field = {}; });
  ASSERT_TRUE(settle());
  QTest::mouseClick(child<QPushButton>("protectThis"), Qt::LeftButton);
  // Whatever is under the middle, or beside it.
  for (int x = 0; x < viewport().width() && scene().cuts[0].membrane->field == scene::ForceField(); x += 15)
    QTest::mouseClick(&viewport(), Qt::LeftButton, {}, QPoint(x, viewport().height() / 2));
  EXPECT_FALSE(scene().cuts[0].membrane->field == scene::ForceField());
  EXPECT_EQ(document().undoLabel(), "Protect from sheet");
  EXPECT_FALSE(child<QPushButton>("protectThis")->isChecked());
  ASSERT_TRUE(settle());
}

TEST_F(MembraneWindow, OneClickOnASectionProtectsAndDoesNothingElse) {
  addMembrane();
  mWindow->resize(800, 700);
  mWindow->views().setLayout(scene::Layout::FourUp);
  document().edit("Clear", [](scene::Scene& scene) { scene.cuts[0].membrane->field = {}; });
  ASSERT_TRUE(settle());
  scene::Scene before = scene();
  auto steps = document().undoLabels();
  QTest::mouseClick(child<QPushButton>("protectThis"), Qt::LeftButton);
  SectionView& axial = mWindow->views().section(scene::SectionKind::Axial);
  QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.rect().center());
  ASSERT_FALSE(scene().cuts[0].membrane->field == scene::ForceField());
  EXPECT_EQ(document().undoLabels().size(), steps.size() + 1);
  EXPECT_EQ(document().undoLabel(), "Protect from sheet");
  EXPECT_EQ(scene().volume.transfer, before.volume.transfer) << "the look is no business of this tool";
  document().undo();
  EXPECT_EQ(scene(), before);
}

TEST_F(MembraneWindow, PausedTheWindowIsSettledAndStepsByHand) {
  addMembrane();
  QTest::mouseClick(child<QPushButton>("membranePlay"), Qt::LeftButton);
  QTest::mouseClick(child<QPushButton>("membraneFlat"), Qt::LeftButton);
  ASSERT_TRUE(settle());
  EXPECT_EQ(status().phase, session::MembraneStatus::Phase::Paused);
  int steps = status().steps;
  QTest::mouseClick(child<QPushButton>("membraneStep"), Qt::LeftButton);
  EXPECT_NE(status().steps, steps);
  {
    OtherContext other(viewport());
    EXPECT_FALSE(shape().places.empty()) << "a sheet that is held can be exported from a menu";
  }
  QTest::mouseClick(child<QPushButton>("membranePlay"), Qt::LeftButton);
  ASSERT_TRUE(settle());
  EXPECT_EQ(status().phase, session::MembraneStatus::Phase::Resting);
}

}  // namespace velum::gui
