#include "gui/model/EqualizeSteps.h"

#include <algorithm>

#include "scene/Scene.h"
#include "session/model/ClipState.h"

namespace velum::gui {

namespace {

const std::vector<GuidedStep> kSteps{
    {"equalizeCut", QT_TRANSLATE_NOOP("velum::gui::EqualizeSteps", "1 Cut"),
     QT_TRANSLATE_NOOP("velum::gui::EqualizeSteps", "Add a plane that opens the model"),
     QT_TRANSLATE_NOOP("velum::gui::EqualizeSteps", "Cut the model open: the bars say what of each type is left.")},
    {"equalizeBalance", QT_TRANSLATE_NOOP("velum::gui::EqualizeSteps", "2 Balance"),
     QT_TRANSLATE_NOOP("velum::gui::EqualizeSteps", "Go to the bars"),
     QT_TRANSLATE_NOOP("velum::gui::EqualizeSteps",
                       "Drag the end of a bar: to the right to bring back what was cut, to the left to thin what is in "
                       "the way.")},
    {"equalizeClear", QT_TRANSLATE_NOOP("velum::gui::EqualizeSteps", "3 Clear"),
     QT_TRANSLATE_NOOP("velum::gui::EqualizeSteps", "Keep the selected types in view: what stands before them goes"),
     QT_TRANSLATE_NOOP(
         "velum::gui::EqualizeSteps",
         "Select what the picture is about and press Clear: then nothing stands before it. Or go on without.")},
    {"equalizeSave", QT_TRANSLATE_NOOP("velum::gui::EqualizeSteps", "4 Save"),
     QT_TRANSLATE_NOOP("velum::gui::EqualizeSteps", "Save the picture, at any size"),
     QT_TRANSLATE_NOOP("velum::gui::EqualizeSteps", "Save the picture. It opens as its scene, to be changed again.")},
};

}  // namespace

EqualizeSteps::EqualizeSteps(QWidget* parent) : StepStrip("velum::gui::EqualizeSteps", kSteps, parent) {
  connect(this, &StepStrip::pressed, this, [this](int step) { emit asked(Step(step)); });
}

void EqualizeSteps::showScene(const scene::Scene& scene) {
  session::ClipState state = session::clipState(scene);
  bool isCut = std::any_of(scene.cuts.begin(), scene.cuts.end(), [](const scene::Cut& cut) { return cut.enabled; });
  bool isClear = std::any_of(scene.cuts.begin(), scene.cuts.end(),
                             [](const scene::Cut& cut) { return cut.enabled && cut.model.focus; });
  setDone({isCut, state == session::ClipState::Thinned, isClear, false}, bool(scene.model.data));
}

}  // namespace velum::gui
