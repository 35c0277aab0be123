#pragma once
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "gui/tool/Toolbox.h"
#include "gui/view/ViewSurface.h"
#include "render/Renderer.h"
#include "session/Session.h"

namespace velum::gui {

class PreparingVeil;

/// The progressive 3D view. While the scene changes the view shows coarse pictures, sized so that each is ready at
/// once; when the scene rests the picture is refined in short pieces of work between events, and when the picture is
/// complete the view does no work at all.
class Viewport : public QWidget, public ToolView {
  Q_OBJECT
 public:
  Viewport(session::Session& session, Toolbox& toolbox, QWidget* parent);
  ~Viewport() override;

  /// To be called after every change of the document.
  void sceneChanged();
  /// Leaves the machine to another view: stops work on the picture until pause() has not been called for so long.
  void pause(int ms);

  void lookFrom(scene::StandardView view);
  /// A camera that sees all of a scene in this view.
  scene::Camera frame(const scene::Scene& scene, scene::StandardView view) const;
  void toggleProjection();

  /// The picture on the screen shows the scene as it is, with its sheets at rest, even if the picture is only a coarse
  /// one.
  bool isCurrent() const { return !mPending && mHasPicture && !mSession.isOnItsWay(); }
  bool isConverged() const { return mStage == Stage::Idle && !mPending && !mAwaitsCounts && mSession.isSettled(); }
  /// Empty before the driver is known.
  render::Stats stats() const { return mRenderer ? mRenderer->stats() : render::Stats{}; }
  /// How many pictures the view has shown; for tests and measurements.
  int shownCount() const { return mShownCount; }
  /// Where it draws.
  ViewSurface& surface() { return *mSurface; }
  /// The picture on the screen.
  QImage picture() { return mSurface->picture(); }
  /// Gets another GL context and draws all anew in it, as after the driver has lost the one before.
  void renewContext();
  /// To be called when jobs of the session's players have ended: their results may ask for work although no picture is
  /// being drawn.
  void playersTold();
  const session::MembraneMover& membranes() const { return mSession.membranes(); }
  void playMembranes(bool play);
  void stepMembranes();
  void resetMembrane(int cut);

  QWidget& widget() override { return *this; }
  session::ViewSpace space() const override { return {mDocument.shown().camera, logicalSize()}; }
  std::optional<render::Pick> pickAt(QPointF place) override;
  /// What each pixel of the picture shows.
  struct PixelIds : render::PixelIds {
    glm::ivec2 size{0};  ///< 0: there is no picture
  };
  PixelIds idsOfPixels(bool withDistances = false);
  /// Another one for each picture that is drawn, coarse or full.
  int pictureNumber() const { return mPictureNumber; }
  bool showsHandles() const override { return true; }
  Qt::CursorShape restCursor() const override { return Qt::ArrowCursor; }

 signals:
  /// The sheets' indices have changed: sections are to be drawn anew.
  void sheetsMoved();
  /// What membranes().status() says has changed; a few times a second at most.
  void sheetsTold();
  /// A result that players computed in the background has come in.
  void playersHeard();
  /// How far the picture is refined. @param stage  in words; empty when complete
  void refined(double fraction, const QString& stage);
  void pointedAt(const velum::render::Pick& pick);
  void pointedAtNothing();
  /// A click, neither a drag nor used by a tool, and what it hit, which may be nothing.
  void clickedAt(const velum::render::Pick& pick);
  /// A click as above with the right button.
  void menuAskedAt(const velum::render::Pick& pick, QPoint globalPlace);
  /// What became of the model's instances in a picture of the scene; it comes a moment after the picture, as nothing
  /// waits for the counts.
  /// @param isComplete  true: of the picture that stays; false: of a coarse picture, while something moves
  void counted(const velum::render::InstanceBits& bits, bool isComplete);
  void failed(const QString& message);
  /// The driver has lost the GL context, and there is a picture again.
  void drawnAnew();
  /// A double click that hit neither a handle nor an instance of a model.
  void maximiseWanted();
  /// A double click on an instance of the model.
  void instanceWanted(const velum::render::Pick& pick);
  /// The crosshair of the sections is to go to a point of the world: Ctrl+click on what the picture shows.
  void placeWanted(glm::dvec3 world);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  /// What is being drawn: a coarse picture, then (after a rest) one of half the size, then all samples of the full one.
  enum class Stage { Idle, Coarse, Half, Full };
  enum class Drag { None, Orbit, Pan, Zoom, Roll };

  void startAnew();
  void wakeSheets();
  bool driveSheets();
  void tellSheets();
  ViewSurface::Listener listener();
  void makeRenderer();
  void resizePicture();
  void release();
  bool bindContext();
  bool tries(const std::function<void()>& work);
  void failForSize();
  void noteLoss();
  void recover();
  void section();
  bool drawSome();
  scene::Scene drawnScene() const;
  bool marksOverlaps() const;
  void begin(Stage stage);
  bool finishStage();
  bool hearCounts();
  void show();
  void adaptCoarseScale();
  void tellProgress();
  void tellLevels(double fraction);
  void pickUnderPointer();
  void dragCamera(glm::dvec2 from, glm::dvec2 to);
  void beginDrag(QMouseEvent* event);
  void tellClick(QMouseEvent* event, bool isRoll);
  glm::dvec2 logicalSize() const { return {std::max(1, width()), std::max(1, height())}; }
  glm::ivec2 deviceSize() const;

  session::Session& mSession;
  session::Document& mDocument;
  Toolbox& mToolbox;
  PreparingVeil* mVeil;
  std::unique_ptr<ViewSurface> mSurface;
  std::unique_ptr<render::Renderer> mRenderer;
  bool mIsLost = false;      ///< The driver has lost the context; recover() comes next.
  bool mTellsLoss = false;   ///< drawnAnew() is to be told with the next picture.
  int mLosses = 0;           ///< since a picture was complete, or a while without
  bool mHasGivenUp = false;  ///< After too many losses; the next change tries anew.
  QElapsedTimer mSinceLoss;
  render::Frame mFrame;
  std::uint64_t mSheetsShown = 0;  ///< The session's shownCount() when mFrame was begun.
  render::SheetIndices mIndicesTold;
  QElapsedTimer mSinceSheetsTold;
  bool mSheetsWereSettled = true;
  scene::Scene mWanted;  ///< What the 3D view last heard that it should show.
  Stage mStage = Stage::Idle;
  bool mPending = true;        ///< The scene has changed since mFrame was made.
  bool mAwaitsCounts = false;  ///< The counts of mFrame have not arrived yet.
  bool mHasPicture = false;    ///< mFrame has a complete sample, so that it can be picked from.
  double mCoarseScale = 0;     ///< Device pixels to one pixel of a coarse picture; 0: not known yet.
  QTimer mSectionTimer, mRestTimer, mPickTimer, mPauseTimer, mLevelTimer;
  QElapsedTimer mSinceShown, mSinceTold;
  Stage mToldStage = Stage::Idle;
  bool mIsFresh = false;  ///< The next paint puts a new picture on the screen.
  int mShownCount = 0, mPictureNumber = 0;
  // Pointer.
  Drag mDrag = Drag::None;
  glm::dvec2 mDragStart{0.0}, mDragLast{0.0};
  QPointF mPointer;
};

}  // namespace velum::gui
