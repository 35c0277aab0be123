#pragma once
#include "gui/service/PictureGrid.h"

namespace velum::gui {

/// The finishes as small pictures of the data that is open. The list inside is named "finish"; its items hold the
/// finish's name as their data.
class FinishGrid : public PictureGrid {
  Q_OBJECT
 public:
  FinishGrid(session::Document& document, QWidget* parent);
  void refresh();

 private:
  /// What the pictures were drawn from.
  struct Key {
    Shared<Volume> volume;  ///< Kept alive, so that no other volume can get its id.
    int channel = 0;
    scene::TransferFunction transfer;
    // Where there is no volume.
    scene::ModelLayer model;
    scene::Lighting lighting;
    glm::vec3 top{0.0f}, bottom{0.0f};  ///< Of the background.
    bool operator==(const Key&) const = default;
  };
  Key mKey;
};

}  // namespace velum::gui
