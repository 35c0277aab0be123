#pragma once
#include <QTimer>
#include <memory>

#include "gui/rows/PictureList.h"
#include "gui/service/Job.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The finishes as small pictures of what is open, drawn in the background when the view has nothing to do. The list
/// inside is named "finish"; its items hold the finish's name as their data.
class FinishGrid : public QWidget {
  Q_OBJECT
 public:
  FinishGrid(session::Document& document, QWidget* parent);
  ~FinishGrid() override;
  void refresh();
  /// All pictures are drawn, or will not be.
  bool isComplete() const;

 public slots:
  /// Draws the pictures that are missing; to be called when the machine is free.
  void drawPictures();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  /// Of what the pictures are.
  struct Key {
    Shared<Volume> volume;  ///< Kept, so that its id is not taken for another's.
    int channel = 0;
    scene::TransferFunction transfer;
    bool operator==(const Key&) const = default;
  };
  Key keyOf(const scene::Scene& scene) const;

  session::Document& mDocument;
  PictureList* mList;
  Key mWanted, mDrawn;
  std::unique_ptr<Job> mJob;
};

}  // namespace velum::gui
