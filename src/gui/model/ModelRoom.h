#pragma once
#include "gui/model/Equalizer.h"
#include "gui/model/ModelPanel.h"
#include "gui/model/TypeHighlight.h"
#include "gui/view/LetteringOverlay.h"
#include "gui/view/Room.h"
#include "scene/Scene.h"
#include "session/model/CountPictures.h"

namespace velum::gui {

/// Models of molecules: their page, their lettering, and what a click on an instance does.
class ModelRoom : public Room {
  Q_OBJECT
 public:
  explicit ModelRoom(const WindowParts& parts);
  void refresh(const session::Session&) override;
  ModelCommands& commands() { return *mCommands; }
  LetteringOverlay& lettering() { return mLettering; }
  Equalizer& equalizer() { return *mEqualizer; }
  TypeHighlight& highlight() { return mHighlight; }
  void findType();
  /// Adds the lettering and the highlight to the toolbox, over the handles that have been added by then.
  void addLettering() {
    mParts.toolbox.add(mHighlight);
    mParts.toolbox.add(mLettering);
  }

 private:
  void connectViews();
  void addActions();
  void showLegend(bool shown);
  void refreshLettering(const scene::Scene& scene);
  QString nameOf(const QString& path) const;
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
  LetteringOverlay mLettering;
  TypeHighlight mHighlight;
  QAction* mLegendAction = nullptr;
  scene::Lettering mWritten;            ///< what the view and the actions show
  std::vector<scene::TypeLook> mNamed;  ///< by which names and colours
  bool mHadModel = false;
};

}  // namespace velum::gui
