#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "gui/view/Room.h"
#include "scene/Mark.h"
#include "session/mark/MarkHands.h"

namespace velum::gui {

class MarkGrips;

/// Sets marks of one kind by clicks on what is seen, in any view, one after the other until Esc. Before the first point
/// of a mark the points of other marks can be taken hold of.
class MarkTool : public ClickTool {
  Q_OBJECT
 public:
  MarkTool(scene::MarkKind kind, const WindowParts& parts, const MarkGrips& grips);

  scene::MarkKind kind() const { return mKind; }
  /// Points have been set of a mark that is not complete.
  bool isSetting() const { return !mPoints.empty(); }

  bool start() override;
  void stop() override { clear(); }
  bool press(const PointerEvent& event) override;
  void click(const PointerEvent& event) override;
  std::optional<Qt::CursorShape> hover(const ViewPoint& at) override;
  void leave() override;
  KeyAnswer key(const KeyStroke& stroke) override;
  QString hint() const override { return mHint; }
  void paint(ViewPainter& over) const override;

 signals:
  /// A mark was added.
  void made(int mark);

 private:
  bool takesMore() const { return scene::markPoints(mKind).most > 3; }
  bool isComplete() const { return mPoints.size() >= scene::markPoints(mKind).least; }
  bool endsAt(const PointerEvent& event) const;
  QString whatIsNext() const;
  void say(const QString& text);
  void takeBack();
  void clear();
  void finish(const session::ViewSpace& space);
  void name(const PointerEvent& event);
  void add(scene::Mark mark);
  std::optional<session::MarkAim> aimAt(const ViewPoint& at) const;
  void pointAtWhatIsSeen(scene::Mark& mark) const;

  const scene::MarkKind mKind;
  session::Document& mDocument;
  Selection& mSelection;
  Toolbox& mToolbox;
  MessageBar& mMessages;
  const MarkGrips& mGrips;
  std::vector<glm::dvec3> mPoints;
  std::vector<int> mInstances;        ///< of the model, whose middles the points are; -1: of none
  std::optional<render::Pick> mPick;  ///< what is seen where the last point was set
  session::ViewSpace mSpace;          ///< of the view in which the last point was set
  const ToolView* mView = nullptr;    ///< in which the pointer is
  QPointF mPlace;                     ///< of the pointer
  std::optional<glm::dvec3> mNext;    ///< under the pointer; none: nothing is there
  QString mHint;
};

}  // namespace velum::gui
