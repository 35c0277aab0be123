#pragma once
#include "gui/service/PictureGrid.h"

namespace velum::gui {

/// The looks of models as small pictures of the loaded model. The list inside is named "modelLook"; its items hold the
/// look's name as their data.
class ModelLookGrid : public PictureGrid {
  Q_OBJECT
 public:
  ModelLookGrid(session::Document& document, QWidget* parent);
  void refresh();

 private:
  Shared<Model> mModel;  ///< The model that the pictures show; kept alive, so that no other model can get its id.
};

}  // namespace velum::gui
