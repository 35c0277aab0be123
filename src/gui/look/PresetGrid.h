#pragma once
#include <QPushButton>

#include "gui/service/PictureGrid.h"

namespace velum::gui {

/// The presets as small pictures of the loaded data: the presets for this kind of data, and behind "More" all others.
/// The list inside is named "preset"; its items hold the preset's name as their data.
class PresetGrid : public PictureGrid {
  Q_OBJECT
 public:
  PresetGrid(session::Document& document, QWidget* parent);
  void refresh();
  /// Gives the scene the look of a preset, as one undo step.
  void choose(const QString& name);

 private:
  void fill();

  QPushButton* mMore;
  Shared<Volume> mVolume;  ///< The volume that the pictures show; kept alive, so that no other volume can get its id.
  int mChannel = -1;
};

}  // namespace velum::gui
