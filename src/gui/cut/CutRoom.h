#pragma once
#include <functional>

#include "gui/cut/CutPanel.h"
#include "gui/cut/NothingLeftNote.h"
#include "gui/cut/PictureCutHandles.h"
#include "gui/cut/SectionCutHandles.h"
#include "gui/cut/ThreePointTool.h"
#include "gui/membrane/MembraneRoom.h"
#include "gui/view/Room.h"

namespace velum::gui {

/// Cuts: their panel, their commands, their handles over the views; and the room of membranes, which are cuts, too.
class CutRoom : public Room {
  Q_OBJECT
 public:
  explicit CutRoom(const WindowParts& parts);
  void refresh(const session::Session& session) override;
  MembraneRoom& membranes() { return mMembranes; }

 private:
  void add(const std::function<void()>& make);
  void addActions(QMenu* menu);
  void addHandles(QMenu* menu);
  void addShapes(QMenu* menu);

  CutPanel* mPanel;
  PictureCutHandles mOverPicture;
  SectionCutHandles mOnSections;
  ThreePointTool mThreePoints;
  MembraneRoom mMembranes;
  NothingLeftNote mNothingLeft;
};

}  // namespace velum::gui
