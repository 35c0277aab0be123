#pragma once
#include <QPushButton>
#include <QToolButton>
#include <vector>

#include "gui/model/Equalizer.h"

namespace velum::gui {

/// The row of buttons over the bars: whether the model is whole, cut, or thinned by lot ([VE] fig. 4), which cuts the
/// handles set, and whether bars are in percent or numbers.
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
  Shared<Model> mModel;              ///< the model that mThinned belongs to
  std::vector<scene::Cut> mThinned;  ///< the cuts as they were before the user left the state "Thinned", which restores
                                     ///< them; neither saved nor undone
};

}  // namespace velum::gui
