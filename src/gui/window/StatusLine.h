#pragma once
#include <QLabel>
#include <QStatusBar>

#include "gui/view/Room.h"

namespace velum::gui {

/// The status bar: what is open, what is under the pointer, how far the picture is, and which graphics driver draws it.
class StatusLine : public Room {
  Q_OBJECT
 public:
  StatusLine(const WindowParts& parts, QStatusBar& bar);
  void refresh(const session::Session& session) override;

 private:
  void showPick(const render::Pick& pick);
  void showProgress(double fraction, const QString& stage);
  void showStreaming(const render::Streaming& streaming);

  QLabel *mData, *mPick, *mStreaming, *mReduction, *mRefine, *mDriver;
};

}  // namespace velum::gui
