#pragma once
#include <QCheckBox>
#include <QDialog>
#include <QSpinBox>

#include "velum/session/Picture.h"

namespace velum::gui {

/// Asks how large and how fine a picture is to be.
class SavePictureDialog : public QDialog {
  Q_OBJECT
 public:
  SavePictureDialog(glm::ivec2 viewSize, const scene::Scene& scene, QWidget* parent);
  session::PictureOptions options() const;

 private:
  QSpinBox *mWidth, *mHeight, *mSamples;
  QCheckBox *mTransparent, *mLayers;
};

}  // namespace velum::gui
