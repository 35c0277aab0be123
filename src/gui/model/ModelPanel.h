#pragma once
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>

#include "gui/kit/Widgets.h"
#include "gui/model/EqualizeSteps.h"
#include "gui/model/EqualizerBar.h"
#include "gui/model/HidersBox.h"
#include "gui/model/InsideLine.h"
#include "gui/model/ModelList.h"
#include "gui/model/ModelLookGrid.h"
#include "gui/rows/FieldForm.h"
#include "gui/rows/ListParts.h"

namespace velum::gui {

/// The page "Model": what the model is made of, and how it looks.
class ModelPanel : public QWidget {
  Q_OBJECT
 public:
  ModelPanel(ModelCommands& commands, Equalizer& equalizer, QWidget* parent);
  void refresh();
  void startSearch();
  ModelList& list() { return *mList; }
  EqualizeSteps& steps() { return *mSteps; }
  ModelLookGrid& looks() { return *mLooks; }
  /// The answer to "What hides this?".
  void showHiding(const session::Hiding& hiding);

 signals:
  void legendAsked(bool shown);
  /// A plane that shows what is inside.
  void cutAsked();

 private:
  QWidget* makeHead();
  QWidget* makeScale(QWidget* parent);
  void showScale(const scene::Scene& scene);
  QWidget* makeSearch();
  QWidget* makeFoot();
  QWidget* makeRows();
  void fillOrders(const ListSearch& search);
  void connectHiders();
  void setSearch(const QString& text);
  void showNotes(const Model& model);
  void showCount();

  ModelCommands& mCommands;
  Equalizer& mEqualizer;
  session::Document& mDocument;
  EyeButton* mShown = nullptr;
  QWidget* mScale = nullptr;
  InsideLine* mInside = nullptr;
  std::vector<std::uint64_t> mScaleOf;  ///< the data of which it was last asked whether they fit each other
  QLabel *mName = nullptr, *mNotes = nullptr, *mScaleWords = nullptr, *mCount = nullptr;
  QLabel* mOneColor = nullptr;  ///< why the palette tells nothing apart
  QCheckBox* mLegend = nullptr;
  QLineEdit* mSearch = nullptr;
  EqualizeSteps* mSteps = nullptr;
  EqualizerBar* mBar = nullptr;
  ModelList* mList = nullptr;
  HidersBox* mHiders = nullptr;
  ModelLookGrid* mLooks = nullptr;
  FieldForm mForm;
  // What is shown.
  bool mIsMade = false;
  scene::ModelLayer mLayerShown;
  scene::Lighting mLightShown;
};

}  // namespace velum::gui
