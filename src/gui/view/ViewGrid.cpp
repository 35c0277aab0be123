#include "gui/view/ViewGrid.h"

#include <QMouseEvent>
#include <QPainter>
#include <cmath>

#include "gui/kit/Preferences.h"
#include "gui/view/ViewChange.h"

namespace velum::gui {

using scene::Layout;
using scene::SectionKind;

namespace {

constexpr int kHandleWidth = 4;  // as wide as a hand can hold, and no wider
constexpr int kReach = 3;        // beside it
constexpr double kLeast = 0.12;  // of the window for each side
constexpr int kPauseMs = 180;    // the 3D view works on when nothing has been done elsewhere for so long
constexpr const char* kLayoutKey = "view/layout";

}  // namespace

ViewGrid::ViewGrid(session::Session& session, Selection& selection, Toolbox& toolbox, QWidget* parent)
    : QWidget(parent), mDocument(session.document()), mViewport(new Viewport(session, toolbox, this)) {
  setObjectName("viewGrid");
  setMouseTracking(true);
  for (auto kind : {SectionKind::Axial, SectionKind::Coronal, SectionKind::Sagittal}) {
    auto* view = new SectionView(mDocument, selection, toolbox, kind, this);
    mSections[std::size_t(kind)] = view;
    view->hide();
    connect(view, &SectionView::touched, this, [this] { mViewport->pause(kPauseMs); });
    connect(view, &SectionView::maximiseWanted, this, [this, kind] { maximise(kind); });
    connect(view, &SectionView::pointedAt, this, &ViewGrid::pointedAt);
    connect(view, &SectionView::pointedAtNothing, this, &ViewGrid::pointedAtNothing);
    connect(view, &SectionView::structureMenuAsked, this, &ViewGrid::structureMenuAsked);
  }
  connect(mViewport, &Viewport::pointedAt, this, &ViewGrid::pointedAt);
  connect(mViewport, &Viewport::pointedAtNothing, this, &ViewGrid::pointedAtNothing);
  connect(mViewport, &Viewport::sheetsMoved, this, [this] {
    for (auto* view : mSections) view->setSheets(mViewport->membranes().indices());
  });
  connect(mViewport, &Viewport::maximiseWanted, this, [this] { maximise(std::nullopt); });
  connect(mViewport, &Viewport::placeWanted, this, [this](glm::dvec3 world) {
    changeSections(mDocument, [world](scene::Scene& scene) { scene::moveCrosshair(scene, world); });
  });
}

Layout ViewGrid::layoutFor(const scene::Scene& scene) {
  const auto& volume = scene.volume.data;
  glm::ivec3 dims = volume ? volume->dims : scene.labels.data ? scene.labels.data->dims() : glm::ivec3(0);
  if (dims == glm::ivec3(0)) return Layout::Volume;  // surfaces alone
  if (std::min(dims.x, std::min(dims.y, dims.z)) < 2) return Layout::Section;
  Preferences stored;
  QString chosen = stored.firstLayout();
  std::string last = (chosen.isEmpty() ? stored.value(kLayoutKey).toString() : chosen).toStdString();
  return enumValue<Layout>(last).value_or(Layout::FourUp);
}

SectionView& ViewGrid::currentSection() {
  for (auto* view : mSections)
    if (view->isVisible() && view->hasFocus()) return *view;
  return section(mDocument.shown().sections.beside);
}

QWidget& ViewGrid::keyboardView() {
  if (QWidget* last = focusWidget(); last && last->isVisible()) return *last;
  if (mViewport->isVisible()) return *mViewport;
  return currentSection();
}

void ViewGrid::setLayout(Layout layout) {
  auto name = enumName(layout);
  Preferences().setValue(kLayoutKey, QString::fromUtf8(name.data(), int(name.size())));
  SectionKind beside = currentSection().kind();
  changeSections(mDocument, [layout, beside](scene::Scene& scene) {
    scene.sections.layout = layout;
    scene.sections.beside = beside;
  });
}

void ViewGrid::maximise(std::optional<SectionKind> kind) {
  const auto& sections = mDocument.shown().sections;
  bool fills = kind ? sections.layout == Layout::Section : sections.layout == Layout::Volume;
  if (!fills && sections.layout != Layout::Section && sections.layout != Layout::Volume) mBefore = sections.layout;
  Layout layout = fills ? mBefore : kind ? Layout::Section : Layout::Volume;
  changeSections(mDocument, [&](scene::Scene& scene) {
    scene.sections.layout = layout;
    // Beside the 3D view stays what stood there.
    if (kind && (!fills || layout != Layout::VolumeAndSection)) scene.sections.beside = *kind;
  });
}

bool ViewGrid::isComplete() const {
  for (const auto* view : mSections)
    if (!view->isComplete()) return false;
  return !mViewport->isVisible() || mViewport->isConverged();
}

bool ViewGrid::isCurrent() const {
  for (const auto* view : mSections)
    if (!view->isCurrent()) return false;
  return !mViewport->isVisible() || mViewport->isCurrent();
}

void ViewGrid::refresh() {
  const auto& sections = mDocument.shown().sections;
  if (mPlaced != sections.layout || mBeside != sections.beside) place(sections);
  mViewport->sceneChanged();
  for (auto* view : mSections) view->refresh();
}

void ViewGrid::place(const scene::Sections& sections) {
  QWidget* focus = focusWidget();
  mPlaced = sections.layout;
  mBeside = sections.beside;
  struct Part {
    QWidget* view;
    QRect rect;
  };
  std::vector<Part> parts;
  QRect all = rect();
  auto cut = [](int length, double share) { return int(std::lround((length - kHandleWidth) * share)); };
  if (sections.layout == Layout::FourUp) {
    int x = cut(all.width(), mFourSplit.x), y = cut(all.height(), mFourSplit.y);
    QRect left(0, 0, x, y), right(x + kHandleWidth, 0, all.width() - x - kHandleWidth, y);
    int below = y + kHandleWidth, rest = all.height() - below;
    parts = {{&section(SectionKind::Axial), left},
             {mViewport, right},
             {&section(SectionKind::Coronal), QRect(0, below, x, rest)},
             {&section(SectionKind::Sagittal), QRect(right.left(), below, right.width(), rest)}};
  } else if (sections.layout == Layout::VolumeAndSection) {
    int x = cut(all.width(), mBesideSplit);
    parts = {{mViewport, QRect(0, 0, x, all.height())},
             {&section(sections.beside), QRect(x + kHandleWidth, 0, all.width() - x - kHandleWidth, all.height())}};
  } else if (sections.layout == Layout::Section) {
    parts = {{&section(sections.beside), all}};
  } else {
    parts = {{mViewport, all}};
  }
  std::vector<QWidget*> views{mViewport};
  views.insert(views.end(), mSections.begin(), mSections.end());
  for (QWidget* view : views) {
    auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.view == view; });
    if (found != parts.end()) view->setGeometry(found->rect);
    view->setVisible(found != parts.end());
  }
  for (auto* view : mSections) view->setMaximised(sections.layout == Layout::Section);
  // The keyboard goes on where the hand was.
  bool lost = focus && isAncestorOf(focus) && !focus->isVisible();
  if (lost) parts.front().view->setFocus();
  update();
}

void ViewGrid::resizeEvent(QResizeEvent*) { place(mDocument.shown().sections); }

void ViewGrid::paintEvent(QPaintEvent*) { QPainter(this).fillRect(rect(), palette().color(QPalette::Mid)); }

/// @param axis  0: the gap between left and right; 1: between top and bottom
bool ViewGrid::isOnGap(QPoint place, int axis) const {
  bool four = mPlaced == Layout::FourUp, beside = mPlaced == Layout::VolumeAndSection;
  if (!four && !(beside && axis == 0)) return false;
  double share = beside ? mBesideSplit : mFourSplit[axis];
  int length = axis == 0 ? width() : height();
  double middle = (length - kHandleWidth) * share + kHandleWidth * 0.5;
  return std::abs((axis == 0 ? place.x() : place.y()) - middle) <= kHandleWidth * 0.5 + kReach;
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
  if (mDragX) (mPlaced == Layout::VolumeAndSection ? mBesideSplit : mFourSplit.x) = share.x;
  if (mDragY) mFourSplit.y = share.y;
  mViewport->pause(kPauseMs);
  place(mDocument.shown().sections);
}

void ViewGrid::mouseReleaseEvent(QMouseEvent*) { mDragX = mDragY = false; }

void ViewGrid::mouseDoubleClickEvent(QMouseEvent*) {
  mFourSplit = glm::dvec2(0.5);
  mBesideSplit = 0.6;
  place(mDocument.shown().sections);
}

}  // namespace velum::gui
