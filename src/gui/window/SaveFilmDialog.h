#pragma once
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <optional>

#include "gui/kit/NumberField.h"
#include "gui/window/FilmDialog.h"
#include "gui/window/SamplesRow.h"
#include "scene/Scene.h"
#include "session/film/MakeFilm.h"

namespace velum::gui {

/// Asks how the film of a scene is to be drawn and where it goes, shows it as small pictures, and says how long it is
/// and how long it will take. A scene without a film gets the usual one, session::usualFilm().
class SaveFilmDialog : public FilmDialog {
  Q_OBJECT
 public:
  /// In the order of the list.
  enum Format { Mp4, WebM, Gif, PngFrames, ExrFrames };
  /// @param viewSize  size of the 3D view, which can be chosen, too, pixels  @param name  of the file that is proposed,
  /// without folder and ending
  SaveFilmDialog(glm::ivec2 viewSize, const scene::Scene& scene, const QString& name, QWidget* parent);
  /// Chooses what was chosen for the film before. The number of samples, the background and the
  /// rate are the scene's.
  void recall();
  /// Keeps these choices for the next film.
  void remember() const;
  void setFormat(Format format) { mFormat->setCurrentIndex(format); }
  /// Frames that are there of the same film are kept, those of another film are written over.
  session::FilmOutput output() const;
  /// The scene with its film as it is chosen.
  scene::Scene filmScene() const;
  /// The command line that makes this film, of a scene that keepScene() keeps.
  QString command() const;

 public slots:
  /// Closes the dialog if the film can be written, and if what is there may be written over.
  void accept() override;

 private:
  QGridLayout* makeFile(const QString& name);
  QGridLayout* makeQuality();
  void makeSize(QGridLayout* grid, glm::ivec2 viewSize);
  void makeRate(QGridLayout* grid);
  void browse();
  void takeFormat();
  void takePath();
  void setSize(glm::ivec2 size);
  void showSize();
  void showFilm();
  void tell(const QString& why) override;
  void updateText();
  QString facts() const;
  bool mayReplace();
  void copyCommand();

  scene::Scene mScene;
  QLineEdit* mPath = nullptr;
  QComboBox *mFormat = nullptr, *mSizes = nullptr, *mRange = nullptr;
  QSpinBox *mWidth = nullptr, *mHeight = nullptr, *mBlur = nullptr, *mVideoQuality = nullptr;
  NumberField* mRate = nullptr;
  SamplesRow* mSamples = nullptr;
  QCheckBox *mTransparent = nullptr, *mSixteenBits = nullptr, *mLayers = nullptr;
  QLabel *mFacts = nullptr, *mNote = nullptr;
  std::optional<DrawingTime> mTime;
  QString mWhyNot;    ///< no film can be drawn of the scene
  QString mReplaced;  ///< path that the user has said may be written over
};

}  // namespace velum::gui
