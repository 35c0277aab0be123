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
  /// @param field  of scene::Growth  @param allowed  the number that is set for one that was typed
  NumberField* addNumber(const char* name, const QString& spoken, const QString& tip, const QString& step,
                         const char* field, const std::function<double(const scene::Growth&, double)>& allowed);
  /// Joins one undo step until endMerge() of the document.
  void change(const QString& step, const char* field, const std::string& value);
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
