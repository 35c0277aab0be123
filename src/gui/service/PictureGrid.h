#pragma once
#include <QHash>
#include <QLabel>
#include <QPixmap>
#include <QSet>
#include <QTimer>
#include <QVBoxLayout>
#include <functional>
#include <memory>
#include <optional>

#include "gui/rows/PictureList.h"
#include "gui/service/Job.h"
#include "session/document/Document.h"

namespace velum::gui {

/// Small pictures of the data that is open, one for each choice, drawn in the background when the view has nothing to
/// do. Where that fails, without a driver or its memory, the names are shown and why; the next time it is tried again.
class PictureGrid : public QWidget {
  Q_OBJECT
 public:
  /// Draws the pictures that are named of a scene, and calls `done` with each as it is ready. Called in another thread.
  using Draw = std::function<void(const scene::Scene& scene, const std::vector<std::string>& names, glm::ivec2 size,
                                  const std::function<void(const std::string&, const Image&)>& done, Progress&)>;
  struct Kind {
    int columns = 3, pictureHeight = 64;
    Draw draw;
    int patienceMs =
        0;  ///< After so long the pictures are drawn even if the view is still busy; 0: they always wait for it.
    bool keepsOld = false;     ///< Old pictures stay until the new ones come.
    bool onlyVisible = false;  ///< Nothing is drawn while the grid is hidden.
  };
  PictureGrid(session::Document& document, Kind kind, QWidget* parent);
  ~PictureGrid() override;
  /// All pictures are drawn, or will not be.
  bool isComplete() const;

 public slots:
  /// Draws the pictures that are missing; to be called when the machine is free.
  void drawPictures();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  PictureList& list() { return *mList; }
  QVBoxLayout& column() { return *mColumn; }
  session::Document& document() const { return mDocument; }
  /// The picture of a name; null while it has not been drawn.
  QPixmap picture(const QString& name) const { return mPictures.value(name); }
  /// Makes the pictures out of date, as they are to show something else than before. @param isOpen  whether there is
  /// anything to draw
  void renew(bool isOpen);

 private:
  bool mayDraw() const { return mIsOpen && (!mKind.onlyVisible || isVisible()); }
  QStringList missing() const;
  void takePicture(const QString& name, const QImage& picture);
  void end(const QString& error);

  session::Document& mDocument;
  const Kind mKind;
  QVBoxLayout* mColumn;
  PictureList* mList;
  QTimer mPatience;
  bool mIsOpen = false;
  int mTurn = 0;                   ///< Counts the calls of renew(), so that pictures of an earlier call are known.
  QSet<QString> mTried, mAwaited;  ///< of the latter the job at work has drawn none yet
  QLabel* mWhyNot;                 ///< shown where some could not be drawn
  QHash<QString, QPixmap> mPictures;
  std::unique_ptr<Job> mJob;
};

}  // namespace velum::gui
