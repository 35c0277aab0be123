#pragma once
#include <QHash>
#include <QPixmap>
#include <QTimer>
#include <memory>

#include "gui/rows/PictureList.h"
#include "gui/service/Job.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The looks of models as small pictures of the loaded one, drawn in the background when the view has nothing to do.
/// The list inside is named "modelLook"; its items hold the look's name as their data.
class ModelLookGrid : public QWidget {
  Q_OBJECT
 public:
  ModelLookGrid(session::Document& document, QWidget* parent);
  ~ModelLookGrid() override;
  void refresh();
  /// All pictures are drawn.
  bool isComplete() const { return !mModel || (!mJob && mPictures.size() == mList->count()); }

 public slots:
  /// Draws the pictures if they are missing; to be called when the machine is free. It begins by itself after a while.
  void drawPictures();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void choose(const QString& name);

  session::Document& mDocument;
  PictureList* mList;
  QTimer mPatience;
  Shared<Model> mModel;  ///< Whose pictures these are; kept, so that its id is not taken for another's.
  bool mHasTried = false;
  QHash<QString, QPixmap> mPictures;
  std::unique_ptr<Job> mJob;
};

}  // namespace velum::gui
