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

/// How a structure was grown: its range of values, the edges that stop the growth, its barriers, how it is smoothed.
/// Hidden for a structure that was not grown.
class GrowthForm : public QWidget {
  Q_OBJECT
 public:
  GrowthForm(session::Session& session, QWidget* parent);
  /// @param structure  0: none
  void showStructure(int structure);
  /// Shows how far the growth has come.
  void showProgress();

  QPushButton& barrierButton() { return *mBarrier; }

 private:
  /// @param field  of scene::Growth  @param allowed  turns the number that was typed into the number that is set
  NumberField* addNumber(const char* name, const QString& spoken, const QString& tip, const QString& step,
                         const char* field, const std::function<double(const scene::Growth&, double)>& allowed);
  /// Sets a field of the growth. Changes join one undo step until endMerge() of the document.
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
