#pragma once
#include "gui/model/Equalizer.h"
#include "gui/model/Legend.h"
#include "gui/model/ModelPanel.h"
#include "gui/model/TypeHighlight.h"
#include "gui/view/Room.h"
#include "session/model/CountPictures.h"

namespace velum::gui {

/// Models of molecules: their page, their legend, and what a click on an instance does.
class ModelRoom : public Room {
  Q_OBJECT
 public:
  explicit ModelRoom(const WindowParts& parts);
  void refresh(const session::Session&) override;
  ModelCommands& commands() { return *mCommands; }
  Legend& legend() { return mLegend; }
  Equalizer& equalizer() { return *mEqualizer; }
  TypeHighlight& highlight() { return mHighlight; }
  void findType();
  /// Adds the legend and the highlight to the toolbox, over the handles that have been added by then.
  void addLegend() {
    mParts.toolbox.add(mHighlight);
    mParts.toolbox.add(mLegend);
  }

 private:
  void connectViews();
  void addActions();
  void showLegend(bool shown);
  void connectEqualizer();
  void takeStep(EqualizeSteps::Step step);
  void findHiding(const QString& path);
  void findSeenRange(const QString& path);
  void askTarget(const QString& path, const session::SeenRange& range);
  glm::ivec2 pictureSize() const;
  void meetTargets();

  ModelCommands* mCommands;
  Equalizer* mEqualizer;
  ModelPanel* mPanel;
  Legend mLegend;
  TypeHighlight mHighlight;
  QAction* mLegendAction = nullptr;
  bool mHadModel = false;
};

}  // namespace velum::gui
