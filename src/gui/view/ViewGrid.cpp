#include "ViewGrid.h"

#include <QMouseEvent>
#include <QPainter>
#include <cmath>

#include "ViewChange.h"
#include "window/Preferences.h"

namespace velum::gui {

using scene::Layout;
using scene::SliceKind;

namespace {

constexpr int kGap = 4;          // as wide as a hand can hold, and no wider
constexpr int kReach = 3;        // beside it
constexpr double kLeast = 0.12;  // of the window for each side
constexpr int kPauseMs = 180;    // the 3D view works on when nothing has been done elsewhere for so long
constexpr const char* kLayoutKey = "view/layout";

}  // namespace

ViewGrid::ViewGrid(session::Session& session, Selection& selection, Toolbox& toolbox, QWidget* parent)
    : QWidget(parent), mDocument(session.document()), mViewport(new Viewport(session, toolbox, this)) {
  setObjectName("viewGrid");
  setMouseTracking(true);
  for (auto kind : {SliceKind::Axial, SliceKind::Coronal, SliceKind::Sagittal}) {
    auto* view = new SliceView(mDocument, selection, toolbox, kind, this);
    mSlices[std::size_t(kind)] = view;
    view->hide();
    connect(view, &SliceView::touched, this, [this] { mViewport->pause(kPauseMs); });
    connect(view, &SliceView::maximiseWanted, this, [this, kind] { maximise(kind); });
    connect(view, &SliceView::pointedAt, this, &ViewGrid::pointedAt);
    connect(view, &SliceView::pointedAtNothing, this, &ViewGrid::pointedAtNothing);
    connect(view, &SliceView::structureMenuAsked, this, &ViewGrid::structureMenuAsked);
  }
  connect(mViewport, &Viewport::pointedAt, this, &ViewGrid::pointedAt);
  connect(mViewport, &Viewport::pointedAtNothing, this, &ViewGrid::pointedAtNothing);
  connect(mViewport, &Viewport::sheetsMoved, this, [this] {
    for (auto* view : mSlices) view->setSheets(mViewport->membranes().indices());
  });
  connect(mViewport, &Viewport::maximiseWanted, this, [this] { maximise(std::nullopt); });
  connect(mViewport, &Viewport::placeWanted, this, [this](glm::dvec3 worldMm) {
    changeSlices(mDocument, [worldMm](scene::Scene& scene) { scene::moveCrosshair(scene, worldMm); });
  });
}

Layout ViewGrid::layoutFor(const scene::Scene& scene) {
  const auto& volume = scene.volume.data;
  glm::ivec3 dims = volume ? volume->dims : scene.labels.data ? scene.labels.data->dims() : glm::ivec3(0);
  if (dims == glm::ivec3(0)) return Layout::Volume;  // surfaces alone
  if (std::min(dims.x, std::min(dims.y, dims.z)) < 2) return Layout::Slice;
  std::string last = Preferences().value(kLayoutKey).toString().toStdString();
  return enumValue<Layout>(last).value_or(Layout::FourUp);
}

SliceView& ViewGrid::currentSlice() {
  for (auto* view : mSlices)
    if (view->isVisible() && view->hasFocus()) return *view;
  return slice(mDocument.scene().slices.beside);
}

QWidget& ViewGrid::keyboardView() {
  if (QWidget* last = focusWidget(); last && last->isVisible()) return *last;
  if (mViewport->isVisible()) return *mViewport;
  return currentSlice();
}

void ViewGrid::setLayout(Layout layout) {
  auto name = enumName(layout);
  Preferences().setValue(kLayoutKey, QString::fromUtf8(name.data(), int(name.size())));
  SliceKind beside = currentSlice().kind();
  changeSlices(mDocument, [layout, beside](scene::Scene& scene) {
    scene.slices.layout = layout;
    scene.slices.beside = beside;
  });
}

void ViewGrid::maximise(std::optional<SliceKind> kind) {
  const auto& slices = mDocument.scene().slices;
  bool fills = kind ? slices.layout == Layout::Slice : slices.layout == Layout::Volume;
  if (!fills && slices.layout != Layout::Slice && slices.layout != Layout::Volume) mBefore = slices.layout;
  Layout layout = fills ? mBefore : kind ? Layout::Slice : Layout::Volume;
  changeSlices(mDocument, [&](scene::Scene& scene) {
    scene.slices.layout = layout;
    // Beside the 3D view stays what stood there.
    if (kind && (!fills || layout != Layout::VolumeAndSlice)) scene.slices.beside = *kind;
  });
}

bool ViewGrid::isComplete() const {
  for (const auto* view : mSlices)
    if (!view->isComplete()) return false;
  return !mViewport->isVisible() || mViewport->isConverged();
}

bool ViewGrid::isCurrent() const {
  for (const auto* view : mSlices)
    if (!view->isCurrent()) return false;
  return !mViewport->isVisible() || mViewport->isCurrent();
}

void ViewGrid::refresh() {
  const auto& slices = mDocument.scene().slices;
  if (mPlaced != slices.layout || mBeside != slices.beside) place(slices);
  mViewport->sceneChanged();
  for (auto* view : mSlices) view->refresh();
}

void ViewGrid::place(const scene::Slices& slices) {
  QWidget* focus = focusWidget();
  mPlaced = slices.layout;
  mBeside = slices.beside;
  struct Part {
    QWidget* view;
    QRect rect;
  };
  std::vector<Part> parts;
  QRect all = rect();
  auto cut = [](int length, double share) { return int(std::lround((length - kGap) * share)); };
  if (slices.layout == Layout::FourUp) {
    int x = cut(all.width(), mFourSplit.x), y = cut(all.height(), mFourSplit.y);
    QRect left(0, 0, x, y), right(x + kGap, 0, all.width() - x - kGap, y);
    int below = y + kGap, rest = all.height() - below;
    parts = {{&slice(SliceKind::Axial), left},
             {mViewport, right},
             {&slice(SliceKind::Coronal), QRect(0, below, x, rest)},
             {&slice(SliceKind::Sagittal), QRect(right.left(), below, right.width(), rest)}};
  } else if (slices.layout == Layout::VolumeAndSlice) {
    int x = cut(all.width(), mBesideSplit);
    parts = {{mViewport, QRect(0, 0, x, all.height())},
             {&slice(slices.beside), QRect(x + kGap, 0, all.width() - x - kGap, all.height())}};
  } else if (slices.layout == Layout::Slice) {
    parts = {{&slice(slices.beside), all}};
  } else {
    parts = {{mViewport, all}};
  }
  std::vector<QWidget*> views{mViewport};
  views.insert(views.end(), mSlices.begin(), mSlices.end());
  for (QWidget* view : views) {
    auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.view == view; });
    if (found != parts.end()) view->setGeometry(found->rect);
    view->setVisible(found != parts.end());
  }
  for (auto* view : mSlices) view->setMaximised(slices.layout == Layout::Slice);
  // The keyboard goes on where the hand was.
  bool lost = focus && isAncestorOf(focus) && !focus->isVisible();
  if (lost) parts.front().view->setFocus();
  update();
}

void ViewGrid::resizeEvent(QResizeEvent*) { place(mDocument.scene().slices); }

void ViewGrid::paintEvent(QPaintEvent*) { QPainter(this).fillRect(rect(), palette().color(QPalette::Mid)); }

/// @param axis  0: the gap between left and right; 1: between top and bottom
bool ViewGrid::isOnGap(QPoint place, int axis) const {
  bool four = mPlaced == Layout::FourUp, beside = mPlaced == Layout::VolumeAndSlice;
  if (!four && !(beside && axis == 0)) return false;
  double share = beside ? mBesideSplit : mFourSplit[axis];
  int length = axis == 0 ? width() : height();
  double middle = (length - kGap) * share + kGap * 0.5;
  return std::abs((axis == 0 ? place.x() : place.y()) - middle) <= kGap * 0.5 + kReach;
}

void ViewGrid::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  mDragX = isOnGap(event->pos(), 0);
  mDragY = isOnGap(event->pos(), 1);
}

void ViewGrid::mouseMoveEvent(QMouseEvent* event) {
  if (!mDragX && !mDragY) {
    bool x = isOnGap(event->pos(), 0), y = isOnGap(event->pos(), 1);
    setCursor(x && y ? Qt::SizeAllCursor : x ? Qt::SplitHCursor : y ? Qt::SplitVCursor : Qt::ArrowCursor);
    return;
  }
  glm::dvec2 share(event->position().x() / std::max(1, width()), event->position().y() / std::max(1, height()));
  share = glm::clamp(share, glm::dvec2(kLeast), glm::dvec2(1.0 - kLeast));
  if (mDragX) (mPlaced == Layout::VolumeAndSlice ? mBesideSplit : mFourSplit.x) = share.x;
  if (mDragY) mFourSplit.y = share.y;
  mViewport->pause(kPauseMs);
  place(mDocument.scene().slices);
}

void ViewGrid::mouseReleaseEvent(QMouseEvent*) { mDragX = mDragY = false; }

void ViewGrid::mouseDoubleClickEvent(QMouseEvent*) {
  mFourSplit = glm::dvec2(0.5);
  mBesideSplit = 0.6;
  place(mDocument.scene().slices);
}

}  // namespace velum::gui
