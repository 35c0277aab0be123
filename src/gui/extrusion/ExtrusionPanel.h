#pragma once
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "ExtrusionList.h"
#include "kit/Selection.h"
#include "kit/Widgets.h"
#include "velum/session/Session.h"

namespace velum::gui {

/// The page "Pull out": what stands out of the cuts, how far, and how it was grown.
class ExtrusionPanel : public QWidget {
  Q_OBJECT
 public:
  ExtrusionPanel(session::Session& session, Selection& selection, QWidget* parent);
  void refresh();

  QPushButton& pullButton() { return *mPull; }
  QPushButton& barrierButton() { return *mBarrier; }

 public slots:
  /// A second plane, joined to the selected one.
  void addPlane();
  void putBack();
  void putAllBack();

 signals:
  /// In words: why nothing was done.
  void refused(const QString& why);

 private:
  QWidget* buildForm();
  void buildGrowth(class QGridLayout* grid);
  void buildLeak(class QVBoxLayout* layout);
  void showForm();
  void showLeak();
  /// Of the selected structure, where it was grown.
  const scene::Growth* growth() const;
  void changeGrowth(const QString& label, const std::function<void(scene::Growth&)>& change);
  void setDistance(double distance);

  session::Session& mSession;
  session::Document& mDocument;
  Selection& mSelection;
  QPushButton *mPull, *mSecond, *mBarrier = nullptr, *mBack = nullptr, *mAllBack = nullptr;
  QLabel* mEmpty;
  ExtrusionList* mList;
  QWidget *mForm, *mGrown = nullptr, *mLeak = nullptr;
  NumberRow* mDistance = nullptr;
  QDoubleSpinBox *mLow = nullptr, *mHigh = nullptr, *mSteepest = nullptr;
  QLabel *mText = nullptr, *mLeakText = nullptr;
};

}  // namespace velum::gui
