#pragma once
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QSpinBox>
#include <QTimer>
#include <memory>
#include <optional>

#include "gui/kit/NumberField.h"
#include "gui/service/Job.h"
#include "gui/window/SamplesRow.h"
#include "session/picture/Picture.h"

namespace velum::gui {

/// The key of the preference that holds the size in pixels of the picture saved last.
inline constexpr const char* kPictureSizeKey = "picture/size";

/// Asks how large and how fine a picture is to be, and shows a small preview, drawn as the picture will be.
class SavePictureDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param viewSize  size of the 3D view, which can be chosen, too  @param size  size that the dialog begins with,
  /// both in pixels
  SavePictureDialog(glm::ivec2 viewSize, glm::ivec2 size, const scene::Scene& scene, QWidget* parent);
  ~SavePictureDialog() override;
  /// Chooses what was chosen for the picture before: unit, resolution, layers, as far as this scene can have
  /// them. The number of samples and the background are taken from the scene, and the width of its page where it has
  /// one.
  void recall();
  /// Keeps these choices, and the size, for the next picture.
  void remember() const;
  session::PictureOptions options() const;
  /// The scene with the background that is chosen.
  scene::Scene pictureScene() const;
  /// The command line that makes this picture, of a scene that keepScene() keeps.
  QString command() const;
  bool hasPreview() const { return mHasPreview; }

 private:
  QWidget* makeSize(glm::ivec2 viewSize);
  QWidget* makeQuality();
  void setPixels(glm::ivec2 size);
  void showSize();
  void takeWidth();
  void takeHeight();
  void updateText();
  void drawPreview();
  void copyCommand();

  scene::Scene mScene;
  double mAspect;
  glm::ivec2 mPixels{1280, 720};
  QComboBox *mUnit = nullptr, *mBackground = nullptr;
  NumberField *mWidth = nullptr, *mHeight = nullptr;
  QSpinBox* mDpi = nullptr;
  SamplesRow* mSamples = nullptr;
  QCheckBox *mKeepShape = nullptr, *mLayers = nullptr;
  QLabel *mPreview = nullptr, *mFacts = nullptr;
  QTimer mDrawTimer;
  std::unique_ptr<Job> mJob;
  bool mHasPreview = false;
};

}  // namespace velum::gui
