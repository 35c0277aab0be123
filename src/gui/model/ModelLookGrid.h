#pragma once
#include "gui/service/PictureGrid.h"

namespace velum::gui {

/// The looks of models as small pictures of the loaded one. The list inside is named "modelLook"; its items hold the
/// look's name as their data.
class ModelLookGrid : public PictureGrid {
  Q_OBJECT
 public:
  ModelLookGrid(session::Document& document, QWidget* parent);
  void refresh();

 private:
  Shared<Model> mModel;  ///< Whose pictures these are; kept, so that its id is not taken for another's.
};

}  // namespace velum::gui
