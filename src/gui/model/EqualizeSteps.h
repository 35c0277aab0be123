#pragma once
#include "gui/kit/StepStrip.h"
#include "scene/SceneFwd.h"

namespace velum::gui {

/// The steps from a model to a picture in which as many instances of each type are seen as should be ([VE] fig. 4).
class EqualizeSteps : public StepStrip {
  Q_OBJECT
 public:
  enum class Step { Cut, Balance, Clear, Save };

  explicit EqualizeSteps(QWidget* parent);
  void showScene(const scene::Scene& scene);

 signals:
  void asked(velum::gui::EqualizeSteps::Step step);
};

}  // namespace velum::gui
