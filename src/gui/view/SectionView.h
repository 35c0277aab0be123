#pragma once
#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "gui/service/NewestJob.h"
#include "gui/service/Selection.h"
#include "gui/tool/Toolbox.h"
#include "gui/view/SectionOverlay.h"
#include "render/Renderer.h"
#include "render/section/SectionImage.h"
#include "session/document/Document.h"

namespace velum::gui {

/// One section view: picture, lines and words over it, and the mouse. It draws on the processor, so that the view
/// answers whatever the graphics driver does.
class SectionView : public QWidget, public ToolView {
  Q_OBJECT
 public:
  SectionView(session::Document& document, Selection& selection, Toolbox& toolbox, scene::SectionKind kind,
              QWidget* parent);

  /// To be called after every change of the document.
  void refresh();
  /// The sheets of the scene's membranes as they stand now.
  void setSheets(render::SheetIndices sheets);
  scene::SectionKind kind() const { return mKind; }
  /// What part of the world the widget's (logical) pixels show.
  scene::SectionPlane plane() const;
  /// A picture of the scene as it is, if only a coarse one, is on the screen, or the view is hidden.
  bool isCurrent() const { return !isVisible() || !mStale; }
  /// The full picture of the scene is on the screen, or the view is hidden.
  bool isComplete() const { return !isVisible() || (!mStale && mDrawnCoarse == 1); }
  /// How often the view has been painted; for tests and measurements.
  int paintCount() const { return mPaintCount; }
  /// Shows in the maximise button whether the view fills the window.
  void setMaximised(bool maximised);
  /// Shows all of the data, in the view's middle.
  void fit();
  /// Moves the section by some planes, towards the viewer (+1) or away from the viewer (-1).
  void scroll(double steps);

  QWidget& widget() override { return *this; }
  session::ViewSpace space() const override { return session::ViewSpace(plane()); }
  std::optional<render::Pick> pickAt(QPointF place) override;
  std::optional<ShownSection> shownSection() const override;
  bool showsHandles() const override { return mDocument.shown().sections.showCuts; }
  Qt::CursorShape restCursor() const override { return Qt::CrossCursor; }

 signals:
  void pointedAt(const velum::render::Pick& pick);
  void pointedAtNothing();
  /// The user does something in this view: other views are to leave the machine to it.
  void touched();
  void maximiseWanted();
  /// The right button was clicked over a structure, which is selected now.
  void structureMenuAsked(int structure, QPoint globalPlace);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  static constexpr int kBricksPatienceMs = 20;
  enum class Drag { None, Crosshair, Turn, Pan, Window };

  QToolButton* addButton(const char* name, const QString& tip, int fromRight);
  void drawImage();
  void fetchBricks();
  void drawOutlines();
  int coarseness() const;
  Drag dragFor(const QMouseEvent& event) const;
  void dragTo(glm::dvec2 place);
  void endDrag();
  void hover(QPointF place);
  void tellWhatIsAt(QPointF place);
  void change(const session::Document::Change& change);
  void pickStructure(QPointF place);
  void showMenu(QPoint globalPlace);
  glm::dvec2 logicalSize() const { return {std::max(1, width()), std::max(1, height())}; }

  session::Document& mDocument;
  scene::SectionKind mKind;
  QToolButton *mMenuButton, *mMaximise;
  // What is shown.
  scene::Scene mWanted;
  scene::SectionPlane mWantedPlane;  ///< In device pixels.
  scene::Sections mSections;         ///< As the lines over the picture show them.
  std::vector<scene::Cut> mCutsShown;
  render::SheetIndices mSheets;
  render::SectionImage mImage;
  NewestJob mBricks{kBricksPatienceMs, this};
  std::vector<BrickAddress> mAskedBricks;  ///< Those that were missing when some were asked for last.
  QImage mOutlines;                        ///< Outlines of the model's instances; null where there is no model.
  std::size_t mOutlinesMissing = 0;        ///< How many outlines there was no time to draw.
  scene::ModelLayer mModelShown;           ///< the model whose outlines these are
  scene::SectionPlane mOutlinesPlane;
  Selection& mSelection;
  Toolbox& mToolbox;
  bool mStale = true;
  int mDrawnCoarse = 1;  ///< How many device pixels one pixel of mImage is wide.
  double mFullMs = 0.0;  ///< How long the last full picture took to draw.
  QTimer mRestTimer;
  int mPaintCount = 0;
  // Pointer.
  Drag mDrag = Drag::None;
  glm::dvec2 mDragStart{0.0}, mDragLast{0.0};
  bool mHasMoved = false;
  scene::Scene mDragScene;  ///< The scene as it was when the drag began.
  scene::SectionPlane mDragPlane;
  glm::dvec3 mCrosshairBefore{0.0};  ///< The crosshair before the last click; a double click puts it back there.
  QElapsedTimer mSincePress;
  double mWheelRest = 0.0;  ///< The part of a notch that a fine wheel has turned so far.
  SectionHints mHints;
  int mDrawnCount = 0;  ///< How many images were drawn.
};

}  // namespace velum::gui
