#pragma once
#include <QWidget>
#include <array>
#include <optional>

#include "gui/view/SectionView.h"
#include "gui/view/Viewport.h"

namespace velum::gui {

/// The centre of the window: the 3D view and the three sections in one of four layouts, with gaps that can be dragged.
/// The scene holds the layout. Views are moved and hidden, never made anew, so that the 3D view keeps its GL context.
class ViewGrid : public QWidget {
  Q_OBJECT
 public:
  ViewGrid(session::Session& session, Selection& selection, Toolbox& toolbox, QWidget* parent);

  /// To be called after every change of the document.
  void refresh();
  /// Puts the views where the sections' layout has them.
  void place(const scene::Sections& sections);
  Viewport& viewport() { return *mViewport; }
  SectionView& section(scene::SectionKind kind) { return *mSections[std::size_t(kind)]; }
  /// The section that commands act on: the one that has the keyboard, else the one that is shown beside the 3D view.
  SectionView& currentSection();
  /// Of the views that are shown, the one that had the keyboard last.
  QWidget& keyboardView();

  void setLayout(scene::Layout layout);
  /// Fills the window with a view, or, if the view fills it already, shows the other views again. @param kind  of the
  /// section; nothing: the 3D view
  void maximise(std::optional<scene::SectionKind> kind);
  /// All views that are shown show the scene as it is, if only coarsely.
  bool isCurrent() const;
  /// All views that are shown are complete.
  bool isComplete() const;

  /// The layout for newly opened data: the one that the user has chosen or had last, if the data has depth.
  static scene::Layout layoutFor(const scene::Scene& scene);

 signals:
  void pointedAt(const velum::render::Pick& pick);
  void pointedAtNothing();
  void structureMenuAsked(int structure, QPoint globalPlace);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

 private:
  bool isOnGap(QPoint place, int axis) const;

  session::Document& mDocument;
  Viewport* mViewport;
  std::array<SectionView*, 3> mSections;
  std::optional<scene::Layout> mPlaced;  ///< The layout that the views stand in.
  scene::SectionKind mBeside = scene::SectionKind::Axial;
  scene::Layout mBefore = scene::Layout::FourUp;  ///< The layout that comes back when a view is no longer maximised.
  glm::dvec2 mFourSplit{0.5, 0.5};                ///< Where the gaps are, as shares of the grid's width and height.
  double mBesideSplit = 0.6;
  bool mDragX = false, mDragY = false;
};

}  // namespace velum::gui
