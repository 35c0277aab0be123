#pragma once
#include "gui/membrane/Sketch.h"
#include "gui/view/Room.h"

namespace velum::gui {

/// The brush with which the user strokes over tissue that the selected membrane is to keep whole, or that its sheet may
/// pass through, on any section or on what the 3D view shows. [ and ], or Alt and the wheel, change its radius.
class BrushTool : public Tool {
  Q_OBJECT
 public:
  /// @param avoid  the tissue under the stroke is not to be kept whole
  BrushTool(bool avoid, const WindowParts& parts, Sketch& sketch);

  bool start() override;
  void stop() override;
  bool press(const PointerEvent& event) override;
  void drag(const PointerEvent& event) override;
  void release(const PointerEvent& event) override;
  std::optional<Qt::CursorShape> hover(const ViewPoint& at) override;
  void leave() override;
  bool wheel(const PointerEvent& event, double notches) override;
  KeyAnswer key(const KeyStroke& stroke) override { return mSketch.radiusKey(stroke); }
  void refresh() override;
  void paint(ViewPainter& over) const override;

 private:
  void goOn(const ViewPoint& at, double leastRadii);
  void showBrush(const ViewPoint& at);
  std::optional<glm::dvec3> placeUnder(const ViewPoint& at) const;

  bool mAvoid;
  session::Document& mDocument;
  Selection& mSelection;
  Sketch& mSketch;
  Toolbox& mToolbox;
  MessageBar& mMessages;
  std::optional<scene::Stroke> mDraft;  ///< The stroke that is being drawn.
  const ToolView* mView = nullptr;      ///< The view in which the brush is; null: in none.
  QPointF mPointer;
};

}  // namespace velum::gui
