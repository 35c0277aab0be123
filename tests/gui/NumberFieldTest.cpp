// Numbers as people type them, without the main window.
#include "gui/kit/NumberField.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QTest>

#include "makeVolume.h"
#include "scene/Scene.h"

namespace velum::gui {
namespace {

scene::Scene sceneOfVoxels(double spacing) {
  scene::Scene scene;
  Volume volume = makeVolume({20, 20, 20}, SampleType::UInt8, [](glm::ivec3 v) { return v.x; });
  volume.worldFromVoxel = glm::dmat4(glm::dmat3(spacing));
  scene.volume.data = Shared<Volume>(std::move(volume));
  return scene;
}

TEST(TypedNumber, UnitsCommasAndDirectionsAreReadOrNothingIs) {
  NumberKind plain, along{{}, "mm", 1.0, "L", "R"}, sagittal{{}, "mm", 1.0, "P", "A"},
      angle{"az ", "\u00b0", 0.0, {}, {}}, tiny{{}, "\u00b5m", 1e-3, {}, {}};
  struct Row {
    const char* text;
    const NumberKind* kind;
    std::optional<double> value;
  };
  const Row rows[] = {{"12.5", &plain, 12.5},
                      {"12,5", &plain, 12.5},
                      {"-,5", &plain, -0.5},
                      {"\u221212", &plain, -12.0},
                      {"1e3", &plain, 1000.0},
                      {" +7 ", &plain, 7.0},
                      {"", &plain, {}},
                      {"1,234.5", &plain, {}},
                      {"12 13", &plain, {}},
                      {"12 mm", &plain, {}},
                      {"abc", &plain, {}},
                      {"8cm", &along, 80.0},
                      {"8 cm mm", &along, 80.0},
                      {"0.3 um", &along, 3e-4},
                      {"5 nm", &along, 5e-6},
                      {"2 \u00c5", &along, 2e-7},
                      {"3 in", &along, 76.2},
                      {"0,1 m", &along, 100.0},
                      {"R 12,5", &along, -12.5},
                      {"r12.5", &along, -12.5},
                      {"L 12.5 mm", &along, 12.5},
                      {"12.5 R", &along, -12.5},
                      {"1 cm R", &along, -10.0},
                      {"12 R mm", &along, -12.0},
                      {"L -3", &along, -3.0},
                      {"A 12", &along, {}},
                      {"R 12 L", &along, {}},
                      {"12 px", &along, {}},
                      {"A 4", &sagittal, -4.0},
                      {"4 cm A", &sagittal, -40},
                      {"az 90\u00b0", &angle, 90.0},
                      {"90 deg", &angle, 90.0},
                      {"az 90deg\u00b0", &angle, 90.0},
                      {"90 mm", &angle, {}},
                      {"1 mm", &tiny, 1000.0},
                      {"7", &tiny, 7.0}};
  for (const Row& row : rows) {
    auto read = readTyped(QString::fromUtf8(row.text), *row.kind);
    ASSERT_EQ(read.has_value(), row.value.has_value()) << row.text;
    if (read) {
      EXPECT_NEAR(*read, *row.value, 1e-12 * std::abs(*row.value)) << row.text;
    }
  }
}

/// A field in a window that has the keyboard.
class Field : public testing::Test {
 protected:
  void SetUp() override {
    mField.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&mField));
    mField.activateWindow();
    mField.setFocus();
  }
  void type(const char* text) {
    mField.selectAll();
    QTest::keyClicks(&mField, QString::fromUtf8(text));
    QTest::keyClick(&mField, Qt::Key_Return);
  }
  QString shown() { return mField.findChild<QLineEdit*>()->text(); }
  NumberField mField;
};

TEST_F(Field, WhatIsNotUnderstoodOrOutOfRangeStaysMarkedAndChangesNothing) {
  mField.setFreeLength(Length(sceneOfVoxels(1.0)), false);
  mField.setValue(3.0);
  int changes = 0;
  QObject::connect(&mField, &QDoubleSpinBox::valueChanged, &mField, [&] { ++changes; });
  for (const char* text : {"8 apples", "1,234.5", "900 km"}) {
    type(text);
    EXPECT_TRUE(mField.isMarked()) << text;
    EXPECT_TRUE(shown().startsWith(text)) << shown().toStdString();
    EXPECT_EQ(mField.value(), 3.0);
    EXPECT_FALSE(mField.accessibleDescription().isEmpty());
  }
  EXPECT_EQ(changes, 0);
  type("8cm");
  EXPECT_FALSE(mField.isMarked());
  EXPECT_EQ(mField.value(), 80.0);
  EXPECT_EQ(shown(), "80.0 mm");
  type("none");
  QTest::keyClick(&mField, Qt::Key_Escape);
  EXPECT_FALSE(mField.isMarked());
  EXPECT_EQ(shown(), "80.0 mm");
}

TEST_F(Field, DirectionsAreReadAsTheyAreShown) {
  mField.setFreeLength(Length(sceneOfVoxels(1.0)), false);
  mField.setDirections("L", "R");
  for (auto [text, value, says] : {std::tuple("R 12,5", -12.5, "R 12.5 mm"),
                                   {"-3", -3.0, "R 3.0 mm"},
                                   {"L 125", 125.0, "L 125.0 mm"},
                                   {"4 cm R", -40.0, "R 40.0 mm"}}) {
    type(text);
    EXPECT_EQ(mField.value(), value) << text;
    EXPECT_EQ(shown(), says);
  }
}

TEST_F(Field, FineDataIsShownAndTypedInItsUnit) {
  mField.setFreeLength(Length(sceneOfVoxels(0.3e-3)), true);
  EXPECT_EQ(mField.suffix().trimmed(), QString::fromUtf8("\u00b5m"));
  type("1.5");
  EXPECT_NEAR(mField.value(), 1.5e-3, 1e-12) << "the scene is in millimetres";
  EXPECT_EQ(shown(), QString::fromUtf8("1.50 \u00b5m"));
  double before = mField.value();
  mField.stepUp();
  EXPECT_LT(mField.value() - before, 0.3e-3) << "a step is no more than a voxel";
  EXPECT_GT(mField.value(), before);
  type("2 mm");
  EXPECT_TRUE(mField.isMarked() || mField.value() == 2.0);
  mField.setFreeLength(Length(sceneOfVoxels(1e-6)), true);
  EXPECT_EQ(mField.suffix().trimmed(), "nm");
}

}  // namespace
}  // namespace velum::gui
