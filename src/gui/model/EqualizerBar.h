#pragma once
#include <QPushButton>
#include <QToolButton>
#include <vector>

#include "gui/model/Equalizer.h"

namespace velum::gui {

/// Over the bars: whether the model is whole, cut, or thinned by lots ([VE] fig. 4), which cuts the handles set, and
/// whether bars are in percent or numbers.
class EqualizerBar : public QWidget {
  Q_OBJECT
 public:
  EqualizerBar(session::Document& document, Equalizer& equalizer, QWidget* parent);
  void refresh();

 signals:
  void percentAsked(bool percent);

 private:
  QWidget* makeStates();
  void showState();
  void goToState(int state);
  void fillCuts();
  void toggleCut(int id, bool on);

  session::Document& mDocument;
  Equalizer& mEqualizer;
  std::vector<QPushButton*> mStates;
  QToolButton *mCuts = nullptr, *mPercent = nullptr;
  Shared<Model> mModel;              ///< whose cuts these are
  std::vector<scene::Cut> mThinned;  ///< as they were before another state was looked at; passing state
};

}  // namespace velum::gui
