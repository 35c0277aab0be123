#pragma once
#include <optional>

#include "gui/view/Room.h"
#include "scene/Growth.h"

namespace velum::gui {

/// Draws a stroke that the selected structure does not grow through: a barrier. The structure is grown anew behind the
/// barrier at once.
class BarrierTool : public Tool {
  Q_OBJECT
 public:
  explicit BarrierTool(const WindowParts& parts);

  bool start() override;
  void stop() override;
  bool press(const PointerEvent& event) override;
  void drag(const PointerEvent& event) override;
  void release(const PointerEvent& event) override;
  std::optional<Qt::CursorShape> hover(const ViewPoint& at) override;
  void leave() override;
  bool wheel(const PointerEvent& event, double notches) override;
  KeyAnswer key(const KeyStroke& stroke) override;
  void refresh() override;
  QString hint() const override;
  void paint(ViewPainter& over) const override;

 private:
  bool isReady() const;
  void showBrush(const ViewPoint& at);
  void goOn(const ViewPoint& at);
  void widen(double notches);

  session::Document& mDocument;
  Selection& mSelection;
  Toolbox& mToolbox;
  double mRadius = 0.0;  ///< 0: not chosen yet
  std::optional<scene::Barrier> mDraft;
  ToolView* mView = nullptr;
  QPointF mPointer;
};

}  // namespace velum::gui
