#include "gui/extrusion/PullSteps.h"

#include <algorithm>

#include "scene/Finishes.h"
#include "session/extrusion/Extrusion.h"

namespace velum::gui {

namespace {

const std::vector<GuidedStep> kSteps{
    {"stepCut", QT_TRANSLATE_NOOP("velum::gui::PullSteps", "1 Cut"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps", "Add a plane that opens what is shown"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps",
                       "Cut what is shown open, and drag the cut to where it meets what you want to show.")},
    {"stepPull", QT_TRANSLATE_NOOP("velum::gui::PullSteps", "2 Pull"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps", "Take up the tool that drags structures out of the cut"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps",
                       "Press on a bone, a vessel or an organ in the cut's face and drag it towards you. What has no "
                       "label yet is found from its values as you pull.")},
    {"stepFinish", QT_TRANSLATE_NOOP("velum::gui::PullSteps", "3 Finish"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps", "Go to the page Finish"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps",
                       "Pull out what else belongs to the picture; then choose how it is drawn: as a plate, in pencil, "
                       "in ink.")},
    {"stepSave", QT_TRANSLATE_NOOP("velum::gui::PullSteps", "4 Save"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps", "Save the picture, at any size"),
     QT_TRANSLATE_NOOP("velum::gui::PullSteps", "Save the picture. It opens as its scene, to be changed again.")},
};

}  // namespace

PullSteps::PullSteps(QWidget* parent) : StepStrip("velum::gui::PullSteps", kSteps, parent) {
  connect(this, &StepStrip::pressed, this, [this](int step) { emit asked(Step(step)); });
}

void PullSteps::showScene(const scene::Scene& scene) {
  bool isCut = std::any_of(scene.cuts.begin(), scene.cuts.end(), session::canPullFrom);
  bool isPulled = !session::extrusionsOf(scene).empty();
  setDone({isCut, isPulled, isPulled && scene::addsAnything(scene.finish), false}, scene::hasData(scene));
}

}  // namespace velum::gui
