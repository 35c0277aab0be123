#pragma once
#include <QActionGroup>

#include "gui/view/Room.h"
#include "gui/view/ViewCube.h"

namespace velum::gui {

/// The commands of the View menu: directions to look from, layouts of the views, and what moves sections.
class ViewCommands : public Room {
  Q_OBJECT
 public:
  explicit ViewCommands(const WindowParts& parts);
  void refresh(const session::Session& session) override;

 signals:
  void captionAsked();

 private:
  void addDirections(QMenu* menu);
  void nameSides(const scene::Scene& scene);
  void addLayouts(QMenu* menu);
  void addSections(QMenu* menu);
  void addCube(QMenu* menu);
  void addGreyWindows(QMenu* menu);

  QAction *mProjection = nullptr, *mAxes = nullptr, *mScaleBar = nullptr, *mTimeStamp = nullptr;
  QList<QAction*> mDirections;  ///< in the order of their table
  QActionGroup* mLayouts;
  QList<QAction*> mWindows;  ///< In the order of scene::greyWindows().
  QAction* mTypeWindow = nullptr;
  ViewCube* mCube;
};

}  // namespace velum::gui
