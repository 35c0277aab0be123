#pragma once
#include <QWidget>

#include "SheetTool.h"

namespace velum::gui {

/// Pins and kernels over one view. Takes no events: the tool does.
class SheetHandsOverlay : public QWidget {
 public:
  /// @param slice  nullptr: the 3D view
  SheetHandsOverlay(const SheetTool& tool, const session::Document& document, QWidget* view, const SliceView* slice);
  void refresh();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  const SheetTool& mTool;
  const session::Document& mDocument;
  QWidget* mView;
  const SliceView* mSlice;
};

}  // namespace velum::gui
