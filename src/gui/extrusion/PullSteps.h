#pragma once
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <array>

#include "velum/scene/Scene.h"

namespace velum::gui {

/// The way from what is open to a picture, in four steps: which are done, and in words what comes next. A step does
/// what it says when it is pressed.
class PullSteps : public QWidget {
  Q_OBJECT
 public:
  enum class Step { Cut, Pull, Finish, Save };
  static constexpr int kCount = 4;

  explicit PullSteps(QWidget* parent);
  void showScene(const scene::Scene& scene);

 signals:
  void asked(velum::gui::PullSteps::Step step);

 private:
  void showNext();

  std::array<QPushButton*, kCount> mButtons{};
  QLabel* mText;
  std::array<bool, kCount> mDone{};
};

}  // namespace velum::gui
