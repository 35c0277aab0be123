// Models of molecules in the real window: their page, clicks in the picture, and what cuts leave of them.
#include <QComboBox>
#include <QTabBar>
#include <cmath>
#include <map>

#include "ModelFixture.h"
#include "Shots.h"
#include "ShownPictures.h"
#include "core/ModelBuilder.h"
#include "gui/cut/TypeSpareList.h"
#include "patience.h"
#include "session/cut/CutEdit.h"

namespace velum::gui {

TEST_F(ModelWindow, ThePageIsThereWithAModelOnly) {
  EXPECT_FALSE(hasPage());
  openModel();
  EXPECT_TRUE(hasPage());
  openPhantom();
  EXPECT_FALSE(hasPage());
}

namespace {

/// A closed shell of balls with others in it.
Model closedShell() {
  ModelBuilder builder("shell");
  auto add = [&](const std::vector<std::string>& path, float radius, int count, float from) {
    MoleculeType type;
    type.name = path.back();
    type.compartment = builder.compartment(path);
    std::uint32_t molecule = builder.addMolecule(builder.addType(type), {}, {{glm::vec4(0, 0, 0, radius)}});
    for (int i = 0; i < count; ++i) {
      float z = 1.0f - 2.0f * (float(i) + 0.5f) / float(count), turn = 2.39996323f * float(i);
      glm::vec2 flat = std::sqrt(1.0f - z * z) * glm::vec2(std::cos(turn), std::sin(turn));
      builder.addInstance(molecule, from * glm::vec3(flat, z), glm::quat(1, 0, 0, 0));
    }
  };
  add({"membrane"}, 40.0f, 600, 200.0f);
  add({"membrane", "capsid"}, 15.0f, 60, 80.0f);
  return builder.build();
}

}  // namespace

TEST_F(ModelWindow, WhatAMembraneHidesIsSaidAndOneClickCutsItOpen) {
  scene::Scene shell;
  shell.unit = LengthUnit::Angstrom;
  shell.model.data = Shared<Model>(closedShell());
  mWindow->resize(1100, 860);
  mWindow->showScene(shell, "shell");
  drawSoon();
  auto* line = child<QWidget>("modelInside");
  ASSERT_TRUE(QTest::qWaitFor([&] { return line->isVisible(); }, kPatience));
  EXPECT_TRUE(line->findChild<QLabel*>()->text().contains("capsid"));
  QTest::mouseClick(child<QPushButton>("modelCutOpen"), Qt::LeftButton);
  ASSERT_EQ(scene().cuts.size(), 1u);
  EXPECT_FALSE(line->isVisible());
  EXPECT_TRUE(list().isVisible()) << "the page stays";
  mWindow->document().undo();
  EXPECT_TRUE(QTest::qWaitFor([&] { return line->isVisible(); }, kPatience));
}

// Nobody counts the instances of a crowd: what was counted before is not true of it.
TEST_F(ModelWindow, CountsAreForgottenWhereCopiesBecomeACrowd) {
  openModel();
  const Equalizer& equalizer = mWindow->models().equalizer();
  ASSERT_TRUE(QTest::qWaitFor([&] { return equalizer.counts().isExact(); }, kPatience));
  mWindow->document().edit("Copies", [](scene::Scene& scene) { scene.model.copies = 5000; });
  EXPECT_FALSE(equalizer.counts().model());
  drawSoon();
  EXPECT_FALSE(equalizer.counts().model());
  mWindow->document().undo();
  EXPECT_TRUE(QTest::qWaitFor([&] { return equalizer.counts().isExact(); }, kPatience));
}

TEST_F(ModelWindow, AnEyeHidesItsTypeAndUndoBringsItBack) {
  openModel();
  clickEye(2);
  EXPECT_EQ(shown(), (std::vector<bool>{true, true, false, true, true}));
  EXPECT_EQ(mWindow->document().undoLabel(), "Hide type2");
  EXPECT_EQ(child<QLabel>("modelCount")->text(), "4 of 5");
  clickEye(2);
  EXPECT_TRUE(scene().model.types.empty());
  mWindow->document().undo();
  EXPECT_FALSE(shown()[2]);
  mWindow->document().undo();
  EXPECT_TRUE(shown()[2]);
}

TEST_F(ModelWindow, TheEyeOfACompartmentHidesAllBelow) {
  openModel();
  QModelIndex type0 = list().tree().indexOfType(0, 0), above = type0.parent();
  QModelIndex eye = list().order().mapFromSource(above.siblingAtColumn(ModelTree::Eye));
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualRect(eye).center());
  EXPECT_EQ(shown(), (std::vector<bool>{false, true, false, true, false}));
  EXPECT_EQ(list().tree().index(0, 0).data(ModelTree::VisibleRole).toInt(), int(ModelTree::Some));
}

TEST_F(ModelWindow, AltClickShowsATypeAloneAndEndsSo) {
  openModel();
  clickEye(4);
  clickEye(1, Qt::AltModifier);
  EXPECT_EQ(shown(), (std::vector<bool>{false, true, false, false, false}));
  clickEye(1, Qt::AltModifier);
  EXPECT_EQ(shown(), (std::vector<bool>{true, true, true, true, false}));
}

TEST_F(ModelWindow, SearchLeavesWhatFitsAndButtonsChangeOnlyThat) {
  openModel(12);
  auto* search = child<QLineEdit>("modelSearch");
  search->setText("TYPE1");
  EXPECT_EQ(list().listedTypes(), (session::TypeNumbers{1, 10, 11}));
  QTest::mouseClick(child<QPushButton>("modelHideAll"), Qt::LeftButton);
  std::vector<bool> now = shown();
  EXPECT_EQ(std::count(now.begin(), now.end(), false), 3);
  mWindow->selection().setType(5);
  EXPECT_TRUE(search->text().isEmpty()) << "what is selected elsewhere is found";
  QTest::mouseClick(child<QPushButton>("modelReset"), Qt::LeftButton);
  EXPECT_TRUE(scene().model.types.empty());
}

TEST_F(ModelWindow, AColourIsSeenInItsRowAndGoesWithUndo) {
  openModel();
  QColor before = list().tree().indexOfType(3, 0).data(ModelTree::ColorRole).value<QColor>();
  mWindow->models().commands().setColor({3}, {1.0f, 0.0f, 0.0f});
  EXPECT_EQ(list().tree().indexOfType(3, 0).data(ModelTree::ColorRole).value<QColor>(), QColor(255, 0, 0));
  mWindow->document().undo();
  EXPECT_EQ(list().tree().indexOfType(3, 0).data(ModelTree::ColorRole).value<QColor>(), before);
}

TEST_F(ModelWindow, AClickInThePictureSelectsTheRowAndADoubleClickGoesThere) {
  openModel();
  ASSERT_TRUE(settle());
  auto found = findInstance();
  ASSERT_TRUE(found);
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, found->first);
  EXPECT_EQ(mWindow->selection().type(), found->second.type);
  EXPECT_EQ(list().selectedTypes(), session::TypeNumbers{std::uint32_t(found->second.type)});
  EXPECT_TRUE(list().viewport()->rect().intersects(list().cellOfType(found->second.type, ModelTree::Name)));
  takeShot(*mWindow, "model-page");
  auto place = session::instancePlace(scene(), found->second.modelInstance);
  ASSERT_TRUE(place);
  EXPECT_LT(glm::distance(place->middle, found->second.world), place->radius * 1.05);
  QTest::mouseDClick(&viewport(), Qt::LeftButton, {}, found->first);
  EXPECT_TRUE(QTest::qWaitFor([&] { return glm::distance(scene().camera.target, place->middle) < 1e-3; }, kPatience));
  EXPECT_EQ(scene().sections.layout, scene::Layout::Volume);
}

TEST_F(ModelWindow, TheLegendNamesWhatIsSeenMost) {
  openModel();
  mWindow->actions().find("model.legend")->trigger();
  ASSERT_TRUE(settle());
  EXPECT_EQ(mWindow->models().lettering().names().size(), 5u);
  std::map<std::int32_t, int> pixels;
  for (std::int32_t type : viewport().idsOfPixels().types)
    if (type >= 0) --pixels[type];
  std::vector<std::pair<int, std::int32_t>> mostFirst;
  for (auto [type, count] : pixels) mostFirst.emplace_back(count, type);
  std::sort(mostFirst.begin(), mostFirst.end());
  ASSERT_EQ(mostFirst.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(mWindow->models().lettering().names()[i], QString("type%1").arg(mostFirst[i].second)) << i;
  clickEye(0);
  ASSERT_TRUE(settle());
  const auto names = mWindow->models().lettering().names();
  EXPECT_EQ(names.size(), 4u);
  EXPECT_EQ(std::count(names.begin(), names.end(), "type0"), 0);
  takeShot(*mWindow, "model-legend");
}

TEST_F(ModelWindow, F2GivesATypeANameThatIsShownEverywhereAndFoundBesideTheFiles) {
  openModel();
  mWindow->actions().find("model.legend")->trigger();
  QModelIndex row = list().order().mapFromSource(list().tree().indexOfType(2, ModelTree::Name));
  auto type = [&](const char* name) {
    list().setCurrentIndex(row);
    list().setFocus();
    QTest::keyClick(&list(), Qt::Key_F2);
    auto* field = list().findChild<QLineEdit*>("modelTypeName");
    ASSERT_TRUE(field);
    field->selectAll();
    QTest::keyClicks(field, name);
    QTest::keyClick(field, Qt::Key_Return);
  };
  type("Spike");
  EXPECT_TRUE(QTest::qWaitFor([&] { return list().tree().indexOfType(2, ModelTree::Name).data() == "Spike"; }, 2000));
  ASSERT_TRUE(settle());
  auto names = mWindow->models().lettering().names();
  EXPECT_EQ(std::count(names.begin(), names.end(), "Spike"), 1);
  EXPECT_TRUE(list().tree().indexOfType(2, ModelTree::Name).data(Qt::ToolTipRole).toString().contains("root.a.type2"));
  for (const char* words : {"spike", "TYPE2"}) {
    child<QLineEdit>("modelSearch")->setText(words);
    EXPECT_EQ(list().listedTypes(), session::TypeNumbers{2}) << words;
  }
  child<QLineEdit>("modelSearch")->clear();
  EXPECT_EQ(mWindow->document().undoLabel(), "Rename type2 to Spike");
  row = list().order().mapFromSource(list().tree().indexOfType(2, ModelTree::Name));
  type("type2");
  EXPECT_TRUE(QTest::qWaitFor([&] { return scene().model.types.empty(); }, 2000)) << "the file's name again";
  mWindow->document().undo();
  EXPECT_EQ(list().tree().indexOfType(2, ModelTree::Name).data().toString(), "Spike");
}

TEST_F(ModelWindow, LegendAndScaleBarOverTheViewAreTheScenesAndNoNewPicture) {
  openModel();
  ASSERT_TRUE(settle());
  QImage without = mWindow->grab().toImage();
  int pictures = shownPictures(viewport());
  mWindow->actions().find("model.legend")->trigger();
  mWindow->actions().find("view.scaleBar")->trigger();
  EXPECT_TRUE(scene().lettering.legend && scene().lettering.scaleBar);
  EXPECT_TRUE(child<QCheckBox>("modelLegend")->isChecked());
  EXPECT_EQ(mWindow->models().lettering().names().size(), 5u) << "of the picture that is there";
  EXPECT_NE(mWindow->grab().toImage(), without);
  EXPECT_EQ(viewport().shownCount(), pictures);
  takeShot(*mWindow, "model-lettering");
  mWindow->document().undo();
  mWindow->document().undo();
  EXPECT_FALSE(mWindow->actions().find("model.legend")->isChecked());
  EXPECT_FALSE(mWindow->actions().find("view.scaleBar")->isChecked());
}

TEST_F(ModelWindow, RowsBelowTheTreeChangeTheSceneInOneStepEach) {
  openModel();
  auto type = [&](const char* name, double value) { child<NumberRow>(name)->spin()->setValue(value); };
  type("modelNear", 40);
  type("modelDetail", 3);
  type("modelCopies", 8);
  type("modelFog", 25);
  EXPECT_DOUBLE_EQ(scene().model.nearColors, 0.4);
  EXPECT_DOUBLE_EQ(scene().model.detail, 3.0);
  EXPECT_EQ(scene().model.copies, 8);
  EXPECT_DOUBLE_EQ(scene().lighting.fog, 0.25);
  auto* palette = child<QComboBox>("modelPalette");
  palette->setCurrentIndex(1);
  emit palette->activated(1);
  EXPECT_EQ(scene().model.palette, scene::Palette::Compartment);
  for (int i = 0; i < 5; ++i) mWindow->document().undo();
  EXPECT_EQ(scene().model.palette, scene::Palette::Type);
  EXPECT_EQ(scene().model.copies, 1);
}

TEST_F(ModelWindow, WordsBesideThePaletteSayThatNoFunctionIsKnown) {
  openModel();
  auto* words = child<QLabel>("modelOneColor");
  EXPECT_FALSE(words->isVisible());
  auto* palette = child<QComboBox>("modelPalette");
  emit palette->activated(2);
  EXPECT_EQ(scene().model.palette, scene::Palette::Function);
  EXPECT_TRUE(words->isVisible());
  EXPECT_TRUE(words->text().contains("palette by type")) << "what to choose";
  mWindow->document().undo();
  EXPECT_FALSE(words->isVisible());
}

TEST_F(ModelWindow, ABarOfACutSaysHowMuchOfATypeItLeaves) {
  openModel();
  mWindow->tabs().showPage("Cuts");
  QTest::mouseClick(child<QPushButton>("addPlane"), Qt::LeftButton);
  ASSERT_EQ(scene().cuts.size(), 1u);
  auto* view = child<TypeSpareView>("typeSpares");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view->isVisible(); }, kPatience));
  QRect bar = view->cellOfRow(0, TypeSpareTree::Bar);
  QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, bar.center());
  ASSERT_EQ(scene().cuts[0].model.spares.size(), 1u);
  EXPECT_EQ(scene().cuts[0].model.spares[0].type, "root");
  EXPECT_NEAR(scene().cuts[0].model.spares[0].share, 0.5, 0.04);  // a pixel is 2 %
  EXPECT_EQ(mWindow->document().undoLabel(), "Leave of all types");
  child<NumberRow>("typeFalloff")->spin()->setValue(30.0);
  EXPECT_DOUBLE_EQ(scene().cuts[0].model.spares[0].falloff, 30.0);
  child<QCheckBox>("wholeInstances")->click();
  EXPECT_TRUE(scene().cuts[0].model.wholeInstances);
  child<QDoubleSpinBox>("leastMass")->setValue(2.5);
  EXPECT_DOUBLE_EQ(scene().cuts[0].model.leastMass, 2500.0);
  QApplication::processEvents();
  takeShot(*mWindow, "model-cuts");
}

TEST_F(ModelWindow, SectionsOutlineInstances) {
  openModel();
  mWindow->views().setLayout(scene::Layout::FourUp);
  QApplication::processEvents();
  takeShot(*mWindow, "model-sections");
  SectionView& view = mWindow->views().section(scene::SectionKind::Axial);
  QImage with = view.grab().toImage();
  session::TypeNumbers all{0, 1, 2, 3, 4};
  mWindow->models().commands().setVisible(all, false);
  EXPECT_NE(view.grab().toImage(), with);
}

}  // namespace velum::gui
