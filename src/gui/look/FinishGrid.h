#pragma once
#include "gui/service/PictureGrid.h"

namespace velum::gui {

/// The finishes as small pictures of what is open. The list inside is named "finish"; its items hold the finish's name
/// as their data.
class FinishGrid : public PictureGrid {
  Q_OBJECT
 public:
  FinishGrid(session::Document& document, QWidget* parent);
  void refresh();

 private:
  /// Of what the pictures are.
  struct Key {
    Shared<Volume> volume;  ///< Kept, so that its id is not taken for another's.
    int channel = 0;
    scene::TransferFunction transfer;
    bool operator==(const Key&) const = default;
  };
  Key mKey;
};

}  // namespace velum::gui
