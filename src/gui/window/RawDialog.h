#pragma once
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <memory>
#include <vector>

#include "gui/service/Job.h"
#include "gui/window/VoxelSizeForm.h"
#include "scene/Source.h"

namespace velum::gui {

/// Asks how the samples of a file without a header are laid out, and shows a plane of the volume as it would be read.
/// The dialog begins with the likeliest layout that fills the file.
class RawDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param source  the file, and what is known already of its layout: raw.dims of zero asks for a guess
  RawDialog(const scene::Source& source, QWidget* parent);
  ~RawDialog() override;
  /// The file with the layout in which it is to be read.
  scene::Source source() const;
  /// The guesses of the layout have been computed.
  bool hasGuessed() const { return !mJob; }

 private:
  QWidget* makeFields();
  QWidget* makePreview();
  void guess();
  void takeGuesses(std::vector<scene::RawLayout> guesses);
  void show(const scene::RawLayout& layout);
  scene::RawLayout layout() const;
  void changed();
  void drawPlane();

  scene::Source mSource;
  double mFileBytes = 0;
  std::vector<scene::RawLayout> mGuesses;
  QComboBox *mGuess, *mType, *mOrder;
  QSpinBox *mDims[3], *mChannels, *mHeader;
  VoxelSizeForm* mVoxel;
  QLabel *mPicture, *mFits;
  QSlider* mPlane;
  QPushButton* mOpen;
  std::unique_ptr<Job> mJob;
};

}  // namespace velum::gui
