#pragma once
#include <QPushButton>

#include "gui/service/PictureGrid.h"

namespace velum::gui {

/// The presets as small pictures of the loaded data: those for this kind of data, the others behind "More". The list
/// inside is named "preset"; its items hold the preset's name as their data.
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
  Shared<Volume> mVolume;  ///< Whose pictures these are; kept, so that its id is not taken for another's.
  int mChannel = -1;
};

}  // namespace velum::gui
