// The form of what was grown, without the main window.
#include "gui/extrusion/GrowthForm.h"

#include <gtest/gtest.h>

#include <QTest>

#include "makeVolume.h"
#include "session/growth/Growths.h"

namespace velum::gui {
namespace {

class GrowthFormTest : public testing::Test {
 protected:
  void SetUp() override {
    scene::Scene scene;
    scene.volume.data = Shared<Volume>(makeVolume({20, 20, 20}, SampleType::UInt8, [](glm::ivec3 v) { return v.x; }));
    scene::Growth step;
    step.structure = 3;
    step.low = 2, step.high = 9;
    scene.labels.growths = {step, step};
    scene.labels.structures = {{.id = 3, .name = "seed"}};
    mSession.document().replace(scene);
    mForm.showStructure(3);
  }
  void type(const char* name, const char* text) {
    auto* spin = mForm.findChild<QDoubleSpinBox*>(name);
    spin->setFocus();
    spin->selectAll();
    QTest::keyClicks(spin, text);
    QTest::keyClick(spin, Qt::Key_Return);
  }
  const std::vector<scene::Growth>& steps() const { return mSession.scene().labels.growths; }
  session::Session mSession;
  GrowthForm mForm{mSession, nullptr};
};

TEST_F(GrowthFormTest, SmoothsAllStepsOfAStructureAndUndoTakesItBack) {
  scene::Scene before = mSession.scene();
  type("growClosing", "2.5");
  for (const auto& step : steps()) EXPECT_EQ(step.closing, 2.5);
  auto* holes = mForm.findChild<QCheckBox*>("growFillHoles");
  holes->click();
  for (const auto& step : steps()) EXPECT_TRUE(step.fillHoles);
  mSession.document().undo();
  for (const auto& step : steps()) EXPECT_FALSE(step.fillHoles);
  mForm.showStructure(3);
  EXPECT_FALSE(holes->isChecked()) << "it shows what is";
  EXPECT_EQ(mForm.findChild<QDoubleSpinBox*>("growClosing")->value(), 2.5);
  mSession.document().undo();
  EXPECT_EQ(mSession.scene(), before);
  type("growClosing", "-1");
  EXPECT_EQ(mSession.scene(), before) << "a radius";
}

}  // namespace
}  // namespace velum::gui
