#pragma once
#include "gui/kit/StepStrip.h"
#include "scene/SceneFwd.h"

namespace velum::gui {

/// The steps from the data that is open to a picture of structures that are pulled out.
class PullSteps : public StepStrip {
  Q_OBJECT
 public:
  enum class Step { Cut, Pull, Finish, Save };

  explicit PullSteps(QWidget* parent);
  void showScene(const scene::Scene& scene);

 signals:
  void asked(velum::gui::PullSteps::Step step);
};

}  // namespace velum::gui
