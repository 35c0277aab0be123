#pragma once
#include <QHash>
#include <QPixmap>
#include <QPushButton>
#include <QTimer>
#include <memory>

#include "gui/rows/PictureList.h"
#include "gui/service/Job.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The presets as small pictures of the loaded data: those for this kind of data, the others behind "More". The
/// pictures are drawn in the background, when the view has nothing to do. The list inside is named "preset"; its items
/// hold the preset's name as their data.
class PresetGrid : public QWidget {
  Q_OBJECT
 public:
  PresetGrid(session::Document& document, QWidget* parent);
  ~PresetGrid() override;
  void refresh();
  /// All pictures that can be seen are drawn.
  bool isComplete() const;
  /// Gives the scene the look of a preset, as one undo step.
  void choose(const QString& name);

 public slots:
  /// Draws the pictures that are missing; to be called when the machine is free. It begins by itself after a while.
  void drawPictures();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fill();
  void takePicture(const QString& name, const QImage& picture);
  QStringList missing() const;

  session::Document& mDocument;
  PictureList* mList;
  QPushButton* mMore;
  QTimer mPatience;
  Shared<Volume> mVolume;  ///< Whose pictures these are; kept, so that its id is not taken for another's.
  int mChannel = -1;
  QHash<QString, QPixmap> mPictures;
  std::unique_ptr<Job> mJob;
};

}  // namespace velum::gui
