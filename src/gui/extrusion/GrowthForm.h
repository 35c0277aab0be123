#pragma once
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <functional>

#include "gui/kit/NumberField.h"
#include "session/Session.h"

namespace velum::gui {

/// How a structure was grown: its values, the edges that stop it, its barriers, how it is smoothed. Hidden for one that
/// was not.
class GrowthForm : public QWidget {
  Q_OBJECT
 public:
  GrowthForm(session::Session& session, QWidget* parent);
  /// @param structure  0: none
  void showStructure(int structure);
  /// How far it has come.
  void showProgress();

  QPushButton& barrierButton() { return *mBarrier; }

 private:
  NumberField* addNumber(const char* name, const QString& spoken, const QString& tip, const QString& step,
                         const std::function<void(scene::Growth&, double)>& change);
  const scene::Growth* growth() const;
  void showNumbers(const Volume& volume, const scene::Growth& grown);

  session::Session& mSession;
  int mStructure = 0;
  NumberField *mLow, *mHigh, *mSteepest, *mClosing;
  QCheckBox* mFillHoles;
  QPushButton* mBarrier;
  QLabel* mText;
};

}  // namespace velum::gui
