// The list of structures in the real window, and what a click in the picture does with it.
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <cmath>

#include "Shots.h"
#include "StructureFixture.h"
#include "gui/rows/Amounts.h"
#include "scene/Scene.h"
#include "session/cut/CutEdit.h"

namespace velum::gui {

TEST_F(StructureWindow, WithoutLabelsThePanelSaysWhatToDoAndOpensThemBeside) {
  mWindow->openPaths({path("phantom.nrrd")});
  ASSERT_TRUE(wait([&] { return !mWindow->isBusy(); }));
  mWindow->actions().find("structure.list")->trigger();
  EXPECT_FALSE(list().isVisible());
  takeShot(*mWindow, "structures-empty");
  mWindow->openLabels(path("phantom_labels.seg.nrrd"));
  ASSERT_TRUE(wait([&] { return !mWindow->isBusy(); }));
  EXPECT_TRUE(list().isVisible());
  EXPECT_EQ(list().listedIds().size(), structures().size());
}

TEST_F(StructureWindow, TheEyeHidesUnderAName) {
  openWithLabels();
  int id = structures()[0].id;
  clickCell(id, StructureModel::Eye);
  EXPECT_FALSE(structures()[0].visible);
  EXPECT_EQ(document().undoLabel(), "Hide " + structures()[0].name);
  document().undo();
  EXPECT_TRUE(structures()[0].visible);
}

TEST_F(StructureWindow, SoloBySAndByAltOnTheEyeRestoresWhatWasVisible) {
  openWithLabels();
  clickCell(structures()[0].id, StructureModel::Eye);
  scene::LabelLayer before = scene().labels;
  clickCell(structures()[1].id, StructureModel::Eye, Qt::AltModifier);
  EXPECT_EQ(session::soloStructure(scene()), structures()[1].id);
  EXPECT_EQ(document().undoLabel(), "Solo " + structures()[1].name);
  clickCell(structures()[1].id, StructureModel::Solo);
  EXPECT_EQ(scene().labels, before);
}

TEST_F(StructureWindow, ADragOfTheOpacityIsOneStep) {
  openWithLabels();
  int id = structures()[0].id;
  QRect cell = list().cellOf(id, StructureModel::Opacity);
  QWidget* port = list().viewport();
  QTest::mousePress(port, Qt::LeftButton, {}, cell.center());
  for (int x = cell.center().x(); x > cell.left() + 12; x -= 4) QTest::mouseMove(port, {x, cell.center().y()});
  QTest::mouseRelease(port, Qt::LeftButton, {}, {cell.left() + 12, cell.center().y()});
  EXPECT_LT(structures()[0].opacity, 0.4);
  EXPECT_GT(structures()[0].opacity, 0.0);
  document().undo();
  EXPECT_EQ(structures()[0].opacity, 1.0);
  EXPECT_FALSE(document().undoLabel().starts_with("Opacity")) << "a drag is one step";
}

TEST_F(StructureWindow, SmoothingGivesShapesThatUndoTakesBack) {
  openWithLabels();
  int id = structures()[1].id;
  auto* smoothing = child<NumberRow>("structureSmoothing");
  clickCell(id, StructureModel::Name);
  ASSERT_TRUE(smoothing->isEnabled());
  EXPECT_EQ(smoothing->value(), structures()[1].smoothing);
  Shared<LabelVolume> file = scene().labels.unsmoothed ? scene().labels.unsmoothed : scene().labels.data;
  Shared<LabelVolume> before = scene().labels.data;
  smoothing->spin()->enter("2");
  ASSERT_TRUE(wait([&] { return !mWindow->isBusy() && !(scene().labels.data == before); }));
  EXPECT_EQ(structures()[1].smoothing, 2.0);
  EXPECT_EQ(scene().labels.unsmoothed, file);
  EXPECT_EQ(document().undoLabel(), "Smooth " + structures()[1].name);
  takeShot(*mWindow, "structures-smoothed");
  document().undo();
  EXPECT_EQ(scene().labels.data, before);
  EXPECT_EQ(smoothing->value(), structures()[1].smoothing);
}

TEST_F(StructureWindow, F2RenamesAndSpaceHides) {
  openWithLabels();
  int id = structures()[1].id;
  clickCell(id, StructureModel::Name);
  EXPECT_EQ(mWindow->selection().structure(), id);
  QTest::keyClick(&list(), Qt::Key_F2);
  auto* editor = list().findChild<QLineEdit*>();
  ASSERT_TRUE(editor);
  editor->setText("aorta");
  QTest::keyClick(editor, Qt::Key_Return);
  EXPECT_TRUE(wait([&] { return structures()[1].name == "aorta" && list().hasFocus(); }));
  QTest::keyClick(&list(), Qt::Key_Space);
  EXPECT_EQ(document().undoLabel(), "Hide aorta");
}

TEST_F(StructureWindow, ANameThatIsBeingTypedOutlivesTheCountAndClosesWithTheWindow) {
  openWithLabels();
  clickCell(structures()[1].id, StructureModel::Name);
  QTest::keyClick(&list(), Qt::Key_F2);
  auto* editor = list().findChild<QLineEdit*>();
  ASSERT_TRUE(editor);
  editor->setText("aorta");
  emit mWindow->structures().meter().measured();
  EXPECT_EQ(editor->text(), "aorta");
  mWindow.reset();
}

TEST_F(StructureWindow, SearchFindsByNameAndNumberAndTheButtonsActOnWhatIsListed) {
  openMany(1200);
  QTest::keyClick(mWindow.get(), Qt::Key_F, Qt::ControlModifier);
  auto* search = child<QLineEdit>("structureSearch");
  EXPECT_TRUE(search->hasFocus());
  QTest::keyClicks(search, "region 77");
  EXPECT_EQ(list().listedIds().size(), 21u);  // 77, 177 and so on, 770 to 779
  search->setText("1007");
  EXPECT_EQ(list().listedIds(), std::vector<int>{1007});
  search->setText("region 120");
  QTest::mouseClick(child<QPushButton>("hideAll"), Qt::LeftButton);
  EXPECT_FALSE(structures()[119].visible);
  EXPECT_FALSE(structures()[1199].visible);
  EXPECT_TRUE(structures()[0].visible);
  EXPECT_FALSE(structures()[1119].visible);
  EXPECT_EQ(document().undoLabel(), "Hide 3 structures");
  // What is selected elsewhere is shown, even where the search hides it.
  mWindow->selection().setStructure(5);
  EXPECT_TRUE(search->text().isEmpty());
  EXPECT_EQ(list().selectedIds(), std::vector<int>{5});
}

TEST_F(StructureWindow, ThousandsOfRowsCostNothingWhileTheCameraMoves) {
  openMany(3000);
  int resets = 0, changes = 0;
  QObject::connect(&list().rows(), &QAbstractItemModel::modelReset, [&] { ++resets; });
  QObject::connect(&list().rows(), &QAbstractItemModel::dataChanged, [&] { ++changes; });
  for (int i = 0; i < 50; ++i) document().view([i](scene::Scene& scene) { scene.camera.eye.x = i; });
  EXPECT_EQ(resets + changes, 0);
  clickCell(3, StructureModel::Eye);
  EXPECT_EQ(resets, 0);
  EXPECT_EQ(changes, 1);
}

TEST_F(StructureWindow, AClickInThePictureSelectsAndItsRowIsSeen) {
  openWithLabels();
  ASSERT_TRUE(settle());
  for (const auto& structure : structures()) {
    auto place = placeOf(structure.id);
    if (!place) continue;
    QTest::mouseClick(&viewport(), Qt::LeftButton, {}, *place);
    EXPECT_EQ(mWindow->selection().structure(), structure.id);
    EXPECT_EQ(list().selectedIds(), std::vector<int>{structure.id});
    EXPECT_TRUE(list().viewport()->rect().intersects(list().cellOf(structure.id, StructureModel::Name)));
  }
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, {3, 3});
  EXPECT_EQ(mWindow->selection().structure(), 0);
  EXPECT_FALSE(document().isModified());  // selecting is no edit
}

TEST_F(StructureWindow, EverySizeHasItsUnitAndHasRoom) {
  openWithLabels();
  ASSERT_TRUE(wait([&] { return !mWindow->structures().meter().isMeasuring(); }));
  for (const auto& structure : structures()) {
    const StructureModel& rows = list().rows();
    QString text = rows.data(rows.index(rows.rowOf(structure.id), StructureModel::Size), Qt::DisplayRole).toString();
    EXPECT_TRUE(text.endsWith(" ml")) << text.toStdString();
    int room = list().cellOf(structure.id, StructureModel::Size).width() - 8;
    EXPECT_LE(list().fontMetrics().horizontalAdvance(text), room) << text.toStdString();
  }
  EXPECT_LE(list().fontMetrics().horizontalAdvance(QString::fromUtf8("9999 \u00b5m\u00b3")), 62);
}

TEST(Amounts, AreToldInTheUnitThatPeopleUseForSoMuch) {
  auto mm = LengthUnit::Millimetre, angstrom = LengthUnit::Angstrom;
  EXPECT_EQ(volumeText(699e3, mm), "699 ml");
  EXPECT_EQ(volumeText(1.65e6, mm), "1650 ml");
  EXPECT_EQ(volumeText(7.2e7, mm), "72.0 l");
  EXPECT_EQ(volumeText(42.0, mm), QString::fromUtf8("42.0 mm\u00b3"));
  EXPECT_EQ(volumeText(523e-9, mm), QString::fromUtf8("523 \u00b5m\u00b3")) << "a nucleus of 10 um";
  EXPECT_EQ(volumeText(4.2e6, angstrom), QString::fromUtf8("4200 nm\u00b3"));
  EXPECT_EQ(areaText(5.5e4, mm), QString::fromUtf8("550 cm\u00b2"));
  EXPECT_EQ(areaText(314e-6, mm), QString::fromUtf8("314 \u00b5m\u00b2"));
  EXPECT_EQ(areaText(2.5e4, angstrom), QString::fromUtf8("250 nm\u00b2"));
}

TEST_F(StructureWindow, ADoubleClickGoesThere) {
  openWithLabels();
  ASSERT_TRUE(wait([&] { return !mWindow->structures().meter().isMeasuring(); }));
  int id = structures().back().id;
  const auto* size = mWindow->structures().meter().find(id);
  ASSERT_TRUE(size);
  glm::dvec3 middle = session::middleOfStructure(*scene().labels.data, id, *size);
  QTest::mouseDClick(list().viewport(), Qt::LeftButton, {}, list().cellOf(id, StructureModel::Name).center());
  EXPECT_EQ(scene().sections.crosshair, middle);
  EXPECT_TRUE(wait([&] { return glm::length(scene().camera.target - middle) < 1e-9; }));
  EXPECT_FALSE(document().isModified());
}

TEST_F(StructureWindow, ABarPullsAStructureOutOfACutUntilSoMuchOfItIsLeft) {
  openWithLabels();
  document().edit("Cut", [](scene::Scene& scene) {
    scene::Cut cut = session::makeCut(scene, scene::CutShape::Plane);
    scene::addCut(scene, cut);
  });
  AreaMeter& areas = mWindow->areas();
  child<QToolButton>("structureBars")->click();
  ASSERT_TRUE(wait([&] { return !areas.isMeasuring() && areas.find(structures()[0].id); }));
  int id = 0;
  for (const scene::Structure& structure : structures())
    if (const auto* area = areas.find(structure.id); area && area->clipped() > 50 && area->left() > 50)
      id = structure.id;
  ASSERT_NE(id, 0) << "the plane goes through one of them";
  Counts before = *areas.find(id);
  CountBar bar = list().barOf(id);
  auto place = [&](double share) {
    return QPointF(bar.box.left() + share * bar.box.width(), bar.box.center().y()).toPoint();
  };
  auto* area = list().viewport();
  double from = double(before.left()) / double(before.total()), to = 0.5 + 0.5 * from;
  QTest::mousePress(area, Qt::LeftButton, {}, place(from));
  QMouseEvent move(QEvent::MouseMove, place(to), area->mapToGlobal(place(to)), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(area, &move);
  QTest::mouseRelease(area, Qt::LeftButton, {}, place(to));
  ASSERT_EQ(scene().cuts[0].spares.size(), 1u);
  EXPECT_EQ(scene().cuts[0].spares[0].structure, id);
  EXPECT_TRUE(std::isfinite(scene().cuts[0].spares[0].distance));
  ASSERT_TRUE(wait([&] { return !areas.isMeasuring(); }));
  EXPECT_NEAR(double(areas.find(id)->left()) / double(before.total()), to, 0.03) << "measured anew";
  takeShot(*mWindow, "structure-bars");
  document().undo();
  EXPECT_TRUE(scene().cuts[0].spares.empty()) << "one step";
  list().selectId(id);
  list().setFocus();
  ASSERT_TRUE(wait([&] { return !areas.isMeasuring(); }));
  QTest::keyClick(&list(), Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(scene().cuts[0].spares.size(), 1u) << "by the keyboard, too";
}

}  // namespace velum::gui
