// Forms are made from what fields() says of a scene's fields: held for every form of the window.
#include <QSlider>

#include "WindowFixture.h"
#include "gui/rows/FieldForm.h"
#include "patience.h"
#include "scene/json/FieldFacts.h"
#include "scene/json/Paths.h"

namespace velum::gui {
namespace {

class FieldForms : public Window {
 protected:
  std::vector<FieldForm::Told> rows() {
    std::vector<FieldForm::Told> all;
    for (FieldForm* form : mWindow->findChildren<FieldForm*>())
      for (const FieldForm::Told& row : form->rows()) all.push_back(row);
    return all;
  }
  std::vector<std::string> lines() { return mWindow->document().lastCommandLines(); }
};

TEST_F(FieldForms, EveryRowIsOfAFieldAndOffersNothingThatTheFieldCannotBe) {
  openPhantom();
  auto all = rows();
  EXPECT_GE(all.size(), 40u);
  for (const auto& row : all) {
    scene::FieldFacts facts = scene::fieldFacts(row.path);
    EXPECT_FALSE(row.control->toolTip().isEmpty()) << row.path;
    if (auto* number = qobject_cast<NumberRow*>(row.control)) {
      EXPECT_GE(row.offered.min, facts.range.min - 1e-9) << row.path;
      EXPECT_LE(row.offered.max, facts.range.max + 1e-9) << row.path;
      EXPECT_FALSE(number->spin()->accessibleName().isEmpty()) << row.path;
    } else {
      EXPECT_FALSE(row.control->accessibleName().isEmpty()) << row.path;
    }
  }
}

TEST_F(FieldForms, ADragIsOneStepAndOneLineOfAScript) {
  openPhantom();
  ASSERT_TRUE(mWindow->tabs().showPage("Finish"));
  auto* contours = child<NumberRow>("contours");
  auto* slider = contours->findChild<QSlider*>();
  QPoint middle = slider->rect().center();
  drag(*slider, {8, middle.y()}, middle);
  ASSERT_EQ(lines().size(), 1u);
  EXPECT_EQ(lines()[0], "set finish.contours " + scene::getField(scene(), "finish.contours"));
  EXPECT_EQ(mWindow->document().undoLabel(), "Change contours");
}

TEST_F(FieldForms, AControlOfTheSelectedCutSetsAFieldOfThatCut) {
  openPhantom();
  mWindow->document().edit("Add cuts", [](scene::Scene& scene) {
    scene::addCut(scene, {});
    scene::addCut(scene, {});
  });
  mWindow->selection().setCut(scene().cuts[1].id);
  ASSERT_TRUE(mWindow->tabs().showPage("Cuts"));
  auto* face = child<QComboBox>("cutFace");
  face->setCurrentIndex(1);
  emit face->activated(1);
  EXPECT_EQ(lines(), std::vector<std::string>{"set cuts.1.face section"});
  auto* opacity = child<NumberRow>("cutFaceOpacity");
  opacity->spin()->setValue(30);
  EXPECT_EQ(lines(), std::vector<std::string>{"set cuts.1.faceOpacity 0.3"});
  EXPECT_EQ(scene().cuts[1].faceOpacity, 0.3);
}

}  // namespace
}  // namespace velum::gui
