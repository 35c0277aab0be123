#pragma once
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <vector>

namespace velum::gui {

/// A step of a way to a picture. Texts are translated where they are shown.
struct GuidedStep {
  const char* name;   ///< of its button, for tests
  const char* title;  ///< with its number: "1 Cut"
  const char* tip;    ///< what a press does
  const char* text;   ///< what to do, while it comes next
};

/// The way from what is open to a picture, in a few steps: which are done, and in words what comes next. A step does
/// what it says when it is pressed.
class StepStrip : public QWidget {
  Q_OBJECT
 public:
  StepStrip(const char* context, std::vector<GuidedStep> steps, QWidget* parent);
  /// @param done  by step
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
