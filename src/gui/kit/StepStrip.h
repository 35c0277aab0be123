#pragma once
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <vector>

namespace velum::gui {

/// One step on the way to a picture. The texts are translated where they are shown.
struct GuidedStep {
  const char* name;   ///< object name of the step's button, for tests
  const char* title;  ///< the button's text, with the step's number: "1 Cut"
  const char* tip;    ///< what a press does
  const char* text;   ///< what the user is to do, shown while this step comes next
};

/// The way from the data that is open to a picture, as a row of a few steps: shows which steps are done, and says in
/// words what comes next. A press on a step asks for what the step says.
class StepStrip : public QWidget {
  Q_OBJECT
 public:
  StepStrip(const char* context, std::vector<GuidedStep> steps, QWidget* parent);
  /// @param done  for each step  @param isUsable  false: no step can be pressed
  void setDone(const std::vector<bool>& done, bool isUsable);

 signals:
  void pressed(int step);

 private:
  void showNext();
  QString say(const char* text) const;

  const char* mContext;
  std::vector<GuidedStep> mSteps;
  std::vector<QPushButton*> mButtons;
  QLabel* mText;
  std::vector<bool> mDone;
};

}  // namespace velum::gui
