// The bars of a model's types in the real window: what they say, and what their handles do.
#include <QComboBox>
#include <QElapsedTimer>
#include <QScrollBar>
#include <QToolButton>

#include "ModelFixture.h"
#include "Shots.h"
#include "gui/cut/TypeSpareList.h"
#include "gui/window/ExportCommands.h"
#include "patience.h"
#include "render/kept/KeptInstances.h"
#include "session/cut/CutEdit.h"
#include "session/model/ClipState.h"
#include "session/model/CountPictures.h"
#include "session/model/TypesAt.h"

namespace velum::gui {

class EqualizerWindow : public ModelWindow {
 protected:
  Equalizer& equalizer() { return mWindow->models().equalizer(); }
  void openCut(int types = 5) {
    openModel(types);
    mWindow->document().edit("Cut", [](scene::Scene& scene) {
      scene::Cut cut = session::makeCut(scene, scene::CutShape::Sphere);
      cut.size = glm::dvec3(360.0);
      cut.centre = glm::dvec3(0.0, -150.0, 0.0);
      scene::addCut(scene, cut);
    });
    ASSERT_TRUE(settle());
  }
  int rowOfType(int type) { return int(list().tree().indexOfType(type, 0).internalId()); }
  const TypeTree::Row& row(int number) { return list().tree().rows()[std::size_t(number)]; }
  Counts count(int number) { return list().tree().countOf(row(number)); }
  std::uint64_t drawn(const session::TypeNumbers& types) {
    std::vector<std::uint8_t> kept = render::keptInstances(scene());
    const Model& model = *scene().model.data;
    std::uint64_t sum = 0;
    for (std::uint32_t type : types)
      for (std::size_t i = 0; i < model.types[type].instanceCount; ++i)
        sum += kept[model.types[type].firstInstance + i];
    return sum;
  }
  QPoint placeOf(int number, double share) {
    CountBar bar = list().barOf(number);
    return QPointF(bar.box.left() + share * bar.box.width(), bar.box.center().y()).toPoint();
  }
  /// Takes the knob at a place of a row's bar and brings it to a share of it.
  void dragBar(int number, double from, double to) {
    drag(*list().viewport(), placeOf(number, from), placeOf(number, to));
  }
  double shareOf(std::uint64_t part, const Counts& of) { return double(part) / double(of.total()); }
};

TEST_F(EqualizerWindow, BarsSayWhatIsSeenHiddenAndRemoved) {
  openCut();
  Counts all = count(0);
  EXPECT_EQ(all.total(), 400u);
  EXPECT_TRUE(equalizer().counts().isExact());
  EXPECT_EQ(all.left(), drawn({0, 1, 2, 3, 4}));
  EXPECT_GT(all.clipped(), 0u);
  EXPECT_GT(all.visible(), 0u);
  Counts sum;
  for (int type = 0; type < 5; ++type) sum += count(rowOfType(type));
  EXPECT_EQ(sum, all) << "a compartment has what its types have";
  QModelIndex number = list().tree().indexOfRow(0, ModelTree::Count);
  EXPECT_EQ(number.data().toString(), QString("%1 %").arg(std::lround(100.0 * double(all.left()) / 400.0)));
  takeShot(*mWindow, "equalizer");
  child<QToolButton>("equalizerPercent")->click();
  EXPECT_EQ(number.data().toString(), QString::number(all.left()));
  takeShot(*mWindow, "equalizer-numbers");
}

TEST_F(EqualizerWindow, BarsFollowTheSceneAndTheEye) {
  openCut();
  Counts before = count(0);
  mWindow->document().edit("Larger", [](scene::Scene& scene) { scene.cuts[0].size = glm::dvec3(500.0); });
  ASSERT_TRUE(settle());
  EXPECT_LT(count(0).left(), before.left());
  EXPECT_EQ(count(0).left(), drawn({0, 1, 2, 3, 4}));
  clickEye(2);
  ASSERT_TRUE(settle());
  EXPECT_EQ(count(rowOfType(2)).clipped(), 80u) << "what is not shown is not drawn";
}

TEST_F(EqualizerWindow, AHandleDragsHowManyAreDrawnInOneStep) {
  openCut();
  int number = rowOfType(1);
  Counts before = count(number);
  double from = shareOf(before.left(), before);
  ASSERT_LT(from, 0.9);
  dragBar(number, from, 0.95);
  auto wanted = drawn({1});
  EXPECT_NEAR(double(wanted), 0.95 * 80.0, 1.5) << "a pixel of the bar";
  EXPECT_EQ(mWindow->document().undoLabel(), "Set number of type1");
  ASSERT_TRUE(settle());
  EXPECT_EQ(count(number).left(), wanted);
  EXPECT_EQ(session::clipState(scene()), session::ClipState::Thinned);
  takeShot(*mWindow, "equalizer-thinned");
  mWindow->document().undo();
  EXPECT_EQ(drawn({1}), before.left()) << "one step";
}

TEST_F(EqualizerWindow, AHandleOfACompartmentGivesEachOfItsTypesItsPart) {
  openCut();
  int above = int(list().tree().indexOfType(0, 0).parent().internalId());
  Counts before = count(above);
  dragBar(above, shareOf(before.left(), before), 1.0);
  EXPECT_EQ(drawn(row(above).types), before.total());
  EXPECT_LT(drawn({1}), 80u) << "those of other compartments stay as they are";
}

TEST_F(EqualizerWindow, ANumberIsTypedOrRefused) {
  openCut();
  int number = rowOfType(3);
  list().setCurrentIndex(list().order().mapFromSource(list().tree().indexOfRow(number, ModelTree::Name)));
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_F2, Qt::ShiftModifier);
  auto* field = list().findChild<QLineEdit*>("modelNumber");
  ASSERT_TRUE(field);
  field->selectAll();
  QTest::keyClicks(field, "71");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor([&] { return drawn({3}) == 71u; }, 2000)) << drawn({3});
  EXPECT_EQ(ModelTree::readNumber("20 %", 80.0), 16.0);
  EXPECT_EQ(ModelTree::readNumber(" 50 ", 80.0), 50.0);
  for (const char* bad : {"", "many", "-3", "5 x", "nan", "1e99"})
    EXPECT_FALSE(ModelTree::readNumber(bad, 80.0)) << bad;
}

TEST_F(EqualizerWindow, KeysSetMoreAndFewer) {
  openCut();
  int number = rowOfType(0);
  list().setCurrentIndex(list().order().mapFromSource(list().tree().indexOfRow(number, ModelTree::Name)));
  list().setFocus();
  std::uint64_t before = drawn({0});
  QTest::keyClick(&list(), Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(drawn({0}), before + 4) << "5 % of 80";
  QTest::keyClick(&list(), Qt::Key_Left, Qt::ControlModifier);
  ASSERT_TRUE(settle());
  EXPECT_EQ(drawn({0}), before);
}

TEST_F(EqualizerWindow, EscapeLetsAHandleGoWithoutChange) {
  openCut();
  int number = rowOfType(1);
  Counts before = count(number);
  auto* area = list().viewport();
  QTest::mousePress(area, Qt::LeftButton, {}, placeOf(number, shareOf(before.left(), before)));
  QMouseEvent move(QEvent::MouseMove, placeOf(number, 0.99), area->mapToGlobal(placeOf(number, 0.99)), Qt::NoButton,
                   Qt::LeftButton, {});
  QApplication::sendEvent(area, &move);
  ASSERT_NE(drawn({1}), before.left());
  QTest::keyClick(&list(), Qt::Key_Escape);
  EXPECT_FALSE(equalizer().isHeld());
  EXPECT_EQ(drawn({1}), before.left());
  EXPECT_EQ(mWindow->document().undoLabel(), "Cut") << "no step is left";
  QTest::mouseRelease(area, Qt::LeftButton, {}, placeOf(number, 0.99));
  EXPECT_EQ(drawn({1}), before.left());
}

TEST_F(EqualizerWindow, EscapeHidesAgainWhatAHandleHasShown) {
  openCut();
  clickEye(1);
  ASSERT_TRUE(settle());
  ASSERT_FALSE(shown()[1]);
  scene::Scene before = scene();
  int number = rowOfType(1);
  auto* area = list().viewport();
  QTest::mousePress(area, Qt::LeftButton, {}, placeOf(number, 0.0));
  QMouseEvent move(QEvent::MouseMove, placeOf(number, 0.5), area->mapToGlobal(placeOf(number, 0.5)), Qt::NoButton,
                   Qt::LeftButton, {});
  QApplication::sendEvent(area, &move);
  ASSERT_TRUE(shown()[1]) << "who asks for more of what is hidden wants to see it";
  QTest::keyClick(&list(), Qt::Key_Escape);
  EXPECT_EQ(scene().model.types, before.model.types);
  EXPECT_EQ(scene().cuts, before.cuts);
  QTest::mouseRelease(area, Qt::LeftButton, {}, placeOf(number, 0.5));
  EXPECT_EQ(scene().model.types, before.model.types);
}

TEST_F(EqualizerWindow, WithoutACutTheFirstHandleAddsOneThatIsEverywhere) {
  openModel();
  ASSERT_TRUE(settle());
  dragBar(rowOfType(2), 1.0, 0.5);
  ASSERT_EQ(scene().cuts.size(), 1u);
  EXPECT_EQ(scene().cuts[0].shape, scene::CutShape::Everywhere);
  EXPECT_NEAR(double(drawn({2})), 40.0, 1.0);
  EXPECT_EQ(drawn({0, 1, 3, 4}), 320u) << "nothing else goes";
  mWindow->tabs().showPage("Cuts");
  QApplication::processEvents();
  takeShot(*mWindow, "equalizer-everywhere");
}

TEST_F(EqualizerWindow, OnlyTheCutsThatAreChosenAreSet) {
  openCut();
  int second = 0;
  mWindow->document().edit("Cut", [&](scene::Scene& scene) {
    scene::Cut cut = session::makeCut(scene, scene::CutShape::Everywhere);
    second = scene::addCut(scene, cut);
  });
  ASSERT_TRUE(settle());
  std::vector<scene::TypeSpare> before = scene().cuts[0].model.spares;
  equalizer().setCuts({second});
  int number = rowOfType(1);
  Counts now = count(number);
  dragBar(number, shareOf(now.left(), now), 0.2);
  EXPECT_EQ(scene().cuts[0].model.spares, before);
  EXPECT_NEAR(double(drawn({1})), 16.0, 1.0);
}

TEST_F(EqualizerWindow, AHandleSetsHowManyAreSeen) {
  openDenseModel();
  ASSERT_TRUE(settle());
  int number = rowOfType(1);
  Counts before = count(number);
  ASSERT_GT(before.visible(), 60u);
  ASSERT_GT(before.hidden(), 60u) << "both knobs can be told apart";
  double to = 0.5 * shareOf(before.visible(), before);
  dragBar(number, shareOf(before.visible(), before), to);
  EXPECT_NEAR(double(drawn({1})), 0.5 * double(before.left()), 12.0) << "what the last picture lets expect";
  ASSERT_TRUE(waitForJob());
  ASSERT_TRUE(settle());
  EXPECT_NEAR(double(count(number).visible()), to * 600.0, 6.0) << "pictures were drawn until it was so many";
  mWindow->document().undo();
  ASSERT_TRUE(settle());
  EXPECT_EQ(count(number), before) << "one step";
}

TEST_F(EqualizerWindow, StatesAreToldApartAndGoneTo) {
  openCut();
  auto isOn = [&](const char* name) { return child<QPushButton>(name)->isChecked(); };
  EXPECT_TRUE(isOn("stateCut"));
  int number = rowOfType(1);
  Counts now = count(number);
  dragBar(number, shareOf(now.left(), now), 0.9);
  std::vector<scene::Cut> thinned = scene().cuts;
  EXPECT_TRUE(isOn("stateThinned"));
  child<QPushButton>("stateWhole")->click();
  EXPECT_TRUE(isOn("stateWhole"));
  EXPECT_EQ(drawn({0, 1, 2, 3, 4}), 400u);
  child<QPushButton>("stateThinned")->click();
  EXPECT_EQ(scene().cuts, thinned);
  child<QPushButton>("stateCut")->click();
  EXPECT_TRUE(isOn("stateCut"));
  EXPECT_EQ(drawn({1}), now.left());
}

TEST_F(EqualizerWindow, TheRowUnderThePointerIsSeenInThePicture) {
  openModel();
  ASSERT_TRUE(settle());
  int pixels = 0;
  for (std::int32_t type : viewport().idsOfPixels().types) pixels += type == 2;
  ASSERT_GT(pixels, 0);
  emit list().hovered({2});
  EXPECT_EQ(mWindow->models().highlight().pixels(), pixels);
  QApplication::processEvents();
  takeShot(*mWindow, "equalizer-hover");
  emit list().hovered({});
  EXPECT_EQ(mWindow->models().highlight().pixels(), 0);
}

TEST_F(EqualizerWindow, RowsAreSortedAndListedByWhatIsSeen) {
  openCut();
  clickEye(3);
  ASSERT_TRUE(settle());
  list().order().setOnly(TypeOrder::Only::Unseen);
  EXPECT_EQ(list().listedTypes(), session::TypeNumbers{3});
  list().order().setOnly(TypeOrder::Only::Seen);
  EXPECT_EQ(list().listedTypes(), (session::TypeNumbers{0, 1, 2, 4}));
  list().order().setOnly(TypeOrder::Only::All);
  list().order().setKey(TypeOrder::keyOf(CountOf::Clipped));
  QModelIndex above = list().order().mapFromSource(list().tree().indexOfType(1, 0)).parent();
  EXPECT_EQ(list().order().index(0, ModelTree::Name, above).data().toString(), "type3") << "all of it is removed";
}

TEST_F(EqualizerWindow, WhatHidesATypeIsSaidAndClearedInOneClick) {
  openDenseModel();
  ASSERT_TRUE(settle());
  std::string path = row(rowOfType(4)).path;
  Counts before = count(rowOfType(4));
  emit mWindow->models().commands().hidingAsked(QString::fromStdString(path));
  ASSERT_TRUE(waitForJob());
  auto* box = child<QFrame>("hiders");
  ASSERT_TRUE(QTest::qWaitFor([&] { return box->isVisible(); }, 2000));
  EXPECT_FALSE(child<QLabel>("hidersWords")->text().isEmpty());
  takeShot(*mWindow, "equalizer-hiders");
  child<QPushButton>("clearTheWay")->click();
  ASSERT_TRUE(settle());
  EXPECT_FALSE(box->isVisible());
  EXPECT_TRUE(session::isKeptInView(scene(), path));
  EXPECT_GT(count(rowOfType(4)).visible(), before.visible());
  takeShot(*mWindow, "equalizer-cleared");
  mWindow->models().commands().setInView(path, false);
  EXPECT_TRUE(scene().cuts.empty());
}

TEST_F(EqualizerWindow, NumbersToBeSeenAreMetTogether) {
  openDenseModel();
  ASSERT_TRUE(settle());
  Counts one = count(rowOfType(1)), two = count(rowOfType(2));
  ModelCommands& commands = mWindow->models().commands();
  commands.setTarget(row(rowOfType(1)).path, double(one.visible() / 2));
  commands.setTarget(row(rowOfType(2)).path, double(two.visible() / 4));
  ASSERT_EQ(scene().model.targets.size(), 2u);
  emit commands.targetsAsked();
  ASSERT_TRUE(waitForJob());
  ASSERT_TRUE(settle());
  EXPECT_NEAR(double(count(rowOfType(1)).visible()), double(one.visible() / 2), 4.0);
  EXPECT_NEAR(double(count(rowOfType(2)).visible()), double(two.visible() / 4), 4.0);
  mWindow->document().undo();
  EXPECT_TRUE(scene().cuts.empty()) << "one step";
  commands.setTarget(row(rowOfType(1)).path, std::nullopt);
  EXPECT_EQ(scene().model.targets.size(), 1u);
}

TEST_F(EqualizerWindow, BarsAndWhatIsLeftAreWritten) {
  openCut();
  Counts all = count(0);  // of the view as it is without the strip of a job
  auto* commands = mWindow->findChild<ExportCommands*>();
  ASSERT_TRUE(commands);
  for (const char* name : {"bars.csv", "bars.svg"}) {
    commands->exportBarsTo(path(name));
    ASSERT_TRUE(waitForJob());
  }
  QByteArray line =
      QString("compartment,root,root,%1,%2,%3,400").arg(all.visible()).arg(all.hidden()).arg(all.clipped()).toUtf8();
  EXPECT_TRUE(bytesOf(path("bars.csv")).contains(line)) << bytesOf(path("bars.csv")).toStdString();
  EXPECT_TRUE(bytesOf(path("bars.svg")).startsWith("<svg"));
  commands->exportModelTo(path("left.csv"));
  ASSERT_TRUE(waitForJob());
  EXPECT_EQ(bytesOf(path("left.csv")).count('\n'), int(all.left()) + 1) << "a line an instance, and their heads";
}

TEST_F(EqualizerWindow, FourStepsLeadToAPicture) {
  openModel();
  ASSERT_TRUE(settle());
  auto step = [&](const char* name) { return child<QPushButton>(name); };
  auto press = [&](const char* name) { QTest::mouseClick(step(name), Qt::LeftButton); };
  EXPECT_TRUE(step("equalizeCut")->isChecked());
  press("equalizeCut");
  ASSERT_EQ(scene().cuts.size(), 1u);
  EXPECT_TRUE(list().isVisible()) << "the page stays";
  EXPECT_TRUE(step("equalizeBalance")->isChecked());
  press("equalizeBalance");
  EXPECT_TRUE(list().hasFocus());
  equalizer().set(row(rowOfType(1)).path, Equalizer::Handle::Left, 70.0);
  EXPECT_TRUE(step("equalizeClear")->isChecked());
  press("equalizeClear");
  EXPECT_FALSE(session::isKeptInView(scene(), row(rowOfType(2)).path)) << "nothing is selected";
  mWindow->selection().setType(2);
  press("equalizeClear");
  EXPECT_TRUE(session::isKeptInView(scene(), row(rowOfType(2)).path));
  EXPECT_TRUE(step("equalizeSave")->isChecked());
  // What a cut that is off keeps in view is not kept.
  mWindow->document().edit("Off", [](scene::Scene& scene) {
    for (scene::Cut& cut : scene.cuts) cut.enabled = !cut.model.focus;
  });
  EXPECT_TRUE(step("equalizeClear")->isChecked());
  // Without any cut that is on one is to be made first.
  mWindow->document().edit("Off", [](scene::Scene& scene) {
    for (scene::Cut& cut : scene.cuts) cut.enabled = false;
  });
  EXPECT_TRUE(step("equalizeCut")->isChecked());
}

TEST_F(EqualizerWindow, TheCutsPageHasItsFocus) {
  openCut();
  mWindow->tabs().showPage("Cuts");
  mWindow->selection().setCut(scene().cuts[0].id);
  auto* view = child<TypeSpareView>("typeSpares");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view->isVisible(); }, kPatience));
  view->setCurrentIndex(view->order().mapFromSource(view->tree().indexOfType(3, 0)));
  child<QCheckBox>("focusKept")->click();
  ASSERT_TRUE(scene().cuts[0].model.focus);
  EXPECT_EQ(scene().cuts[0].model.focus->types[0].type, row(rowOfType(3)).path);
  child<NumberRow>("typeAperture")->spin()->setValue(40.0);
  child<NumberRow>("typeViewShare")->spin()->setValue(20.0);
  const scene::TypeSpare* own = session::findTypeSpare(scene().cuts[0], row(rowOfType(3)).path);
  ASSERT_TRUE(own);
  EXPECT_DOUBLE_EQ(own->aperture, 0.4);
  EXPECT_DOUBLE_EQ(own->viewShare, 0.2);
  child<QCheckBox>("focusDepth")->click();
  child<QCheckBox>("focusLock")->click();
  EXPECT_TRUE(scene().cuts[0].model.focus->guidesDepth);
  ASSERT_TRUE(scene().cuts[0].model.focus->lock);
  EXPECT_EQ(scene().cuts[0].model.focus->lock->camera, scene().camera);
  QApplication::processEvents();
  takeShot(*mWindow, "equalizer-focus");
  child<QCheckBox>("focusKept")->click();
  EXPECT_FALSE(scene().cuts[0].model.focus);
}

TEST_F(EqualizerWindow, GhostsAreChosenForTheModelAndForAType) {
  openCut();
  auto* ghosts = child<QComboBox>("modelGhosts");
  ghosts->setCurrentIndex(2);
  emit ghosts->activated(2);
  EXPECT_EQ(scene().model.ghosts, scene::Ghosts::Contour);
  mWindow->models().commands().setGhosts({1}, scene::Ghosts::None);
  EXPECT_EQ(scene::typeLook(scene().model, row(rowOfType(1)).path).ghosts, scene::Ghosts::None);
  ASSERT_TRUE(settle());
  takeShot(*mWindow, "equalizer-ghosts");
}

TEST_F(EqualizerWindow, ThousandsOfRowsScrollSmoothly) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.types = 5000, .atoms = 4, .instances = 20000}.make());
  mWindow->resize(1100, 860);
  mWindow->showScene(scene, "made");
  drawSoon();
  ASSERT_TRUE(settle());
  list().expandAll();
  QApplication::processEvents();
  QElapsedTimer clock;
  clock.start();
  constexpr int kSteps = 40;
  for (int i = 0; i < kSteps; ++i) {
    list().verticalScrollBar()->setValue(list().verticalScrollBar()->value() + 1000);
    list().viewport()->repaint();
  }
  EXPECT_LT(double(clock.elapsed()) / kSteps, 100.0) << "milliseconds a step";
}

}  // namespace velum::gui
