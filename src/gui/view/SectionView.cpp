#include "gui/view/SectionView.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QWidgetAction>
#include <cmath>

#include "gui/kit/Icons.h"
#include "gui/kit/Length.h"
#include "gui/kit/Text.h"
#include "gui/kit/Theme.h"
#include "gui/kit/Widgets.h"
#include "gui/view/GreyWindowCorner.h"
#include "gui/view/SideNames.h"
#include "gui/view/ViewChange.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/lettering/SeenNames.h"
#include "session/section/InstanceOutlines.h"

namespace velum::gui {

namespace {

constexpr double kAtOnceMs = 15.0;  // full pictures that take longer wait for a rest
constexpr int kRestMs = 140;        // as in the 3D view
constexpr int kMostCoarse = 4;
constexpr int kButton = 24;
constexpr unsigned kMostOutlines = 40000, kMostMoving = 6000;  // circles: at rest, and while something moves
constexpr double kDotPixels = 1.6;                             // smaller circles are dots

/// Windows by name, the whole range, and one that is typed.
void addWindowMenu(QMenu& menu, SectionView& view, session::Document& document) {
  const auto& volume = document.shown().volume.data;
  if (!volume || volume->isColor) return;
  QMenu* windows = menu.addMenu(SectionView::tr("&Grey window"));
  windows->setToolTipsVisible(true);
  for (const scene::GreyWindow& window : scene::greyWindowsFor(*volume))
    QObject::connect(windows->addAction(greyWindowTitle(window)), &QAction::triggered, &view,
                     [&document, name = window.name] { setGreyWindow(document, name); });
  if (!windows->isEmpty()) windows->addSeparator();
  QAction* whole = windows->addAction(SectionView::tr("&Whole range"));
  whole->setToolTip(SectionView::tr("From the smallest value to the largest"));
  QObject::connect(whole, &QAction::triggered, &view,
                   [&document] { session::edit(document, session::ChooseWindow{"whole"}); });
  QAction* typed = windows->addAction(SectionView::tr("&Type it...\tW"));
  typed->setToolTip(SectionView::tr("Width and level as numbers, or a name"));
  QObject::connect(typed, &QAction::triggered, &view, [&view] { GreyWindowCorner::of(view).startTyping(); });
}

}  // namespace

SectionView::SectionView(session::Document& document, Selection& selection, Toolbox& toolbox, scene::SectionKind kind,
                         QWidget* parent)
    : QWidget(parent), mDocument(document), mKind(kind), mSelection(selection), mToolbox(toolbox) {
  setObjectName(QString("section.%1").arg(toText(enumName(kind))));
  setAccessibleName(tr("%1 section").arg(sectionName(kind)));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(100, 80);
  setAttribute(Qt::WA_OpaquePaintEvent);
  mMenuButton = addButton("menu", tr("Interpolation, structures, crosshair, reset (right click)"), 1);
  mMenuButton->setIcon(makeIcon("view.menu", kOverPicture));
  mMaximise = addButton("maximise", QString(), 2);
  setMaximised(false);
  connect(mMenuButton, &QToolButton::clicked, this,
          [this] { showMenu(mMenuButton->mapToGlobal(QPoint(0, mMenuButton->height()))); });
  connect(mMaximise, &QToolButton::clicked, this, &SectionView::maximiseWanted);
  new GreyWindowCorner(mDocument, this);
  mToolbox.addView(*this);
  mRestTimer.setSingleShot(true);
  mRestTimer.setInterval(kRestMs);
  connect(&mRestTimer, &QTimer::timeout, this, [this] {
    if (mDrawnCoarse == 1 && mOutlinesMissing == 0) {
      if (session::needsSeenNames(mDocument.shown().lettering)) mToolbox.repaint(*this);  // they wait for a rest
      return;
    }
    mOutlinesPlane = {};  // with all circles
    mStale = mStale || mDrawnCoarse != 1;
    update();
  });
}

QToolButton* SectionView::addButton(const char* name, const QString& tip, int fromRight) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::NoFocus);
  button->setFixedSize(kButton, kButton);
  button->setProperty("fromRight", fromRight);
  button->setCursor(Qt::ArrowCursor);
  button->hide();
  return button;
}

void SectionView::setMaximised(bool maximised) {
  mMaximise->setIcon(makeIcon(maximised ? "view.restore" : "view.maximise", kOverPicture));
  QString tip = maximised ? tr("Show the other views again (double click)") : tr("Fill the window (double click)");
  mMaximise->setToolTip(tip);
  mMaximise->setAccessibleName(tip);
}

scene::SectionPlane SectionView::plane() const {
  return scene::makeSectionPlane(mDocument.shown(), mKind, logicalSize());
}

void SectionView::refresh() {
  if (!isVisible()) return;  // showEvent makes up for it
  GreyWindowCorner::of(*this).refresh();
  const scene::Scene& scene = mDocument.shown();
  setAccessibleName(tr("%1 section").arg(planeName(scene, mKind)));
  scene::Scene wanted = scene::sectionScene(scene);
  wanted.background.transparent = false;  // a window has something behind
  auto wantedFrame = scene::makeSectionPlane(scene, mKind, glm::round(logicalSize() * devicePixelRatioF()));
  bool stale = wantedFrame != mWantedPlane || wanted != mWanted;
  bool sameModel = scene.model == mModelShown;
  if (!stale && sameModel && mSections == scene.sections && mCutsShown == scene.cuts) return;
  mSections = scene.sections;
  mCutsShown = scene.cuts;
  mWanted = std::move(wanted);
  mWantedPlane = wantedFrame;
  mStale = mStale || stale;
  if (stale) mRestTimer.start();
  update();
}

void SectionView::setSheets(render::SheetIndices sheets) {
  mSheets = std::move(sheets);
  mStale = true;
  update();
}

/// How coarse a picture is drawn: the time that the last full picture took tells what can be drawn at once.
int SectionView::coarseness() const {
  if (!mRestTimer.isActive() || mFullMs <= kAtOnceMs) return 1;
  return std::clamp(int(std::ceil(std::sqrt(mFullMs / kAtOnceMs))), 2, kMostCoarse);
}

void SectionView::drawImage() {
  QElapsedTimer clock;
  clock.start();
  mDrawnCoarse = coarseness();
  mImage = render::drawSection(mWanted, render::coarserPlane(mWantedPlane, mDrawnCoarse), mSheets,
                               render::SectionDetail::AtOnce);
  if (mDrawnCoarse == 1) mFullMs = double(clock.nsecsElapsed()) * 1e-6;
  mStale = false;
  ++mDrawnCount;
  fetchBricks();
}

std::optional<ToolView::ShownSection> SectionView::shownSection() const {
  if (mStale || mDrawnCoarse != 1) return std::nullopt;
  return ShownSection{mImage, mWantedPlane, mDrawnCount, mRestTimer.isActive()};
}

/// The circles in which the section meets the instances of the model, in their types' colours.
void SectionView::drawOutlines() {
  const scene::Scene& scene = mDocument.shown();
  if (mModelShown == scene.model && mOutlinesPlane == mWantedPlane) return;
  mModelShown = scene.model;
  mOutlinesPlane = mWantedPlane;
  mOutlines = {};
  if (!scene.model.data) return;
  session::InstanceOutlines outlines =
      session::outlineInstances(scene, mWantedPlane, mRestTimer.isActive() ? kMostMoving : kMostOutlines);
  mOutlinesMissing = outlines.missing;
  mOutlines = QImage(int(mWantedPlane.size.x), int(mWantedPlane.size.y), QImage::Format_ARGB32_Premultiplied);
  mOutlines.fill(Qt::transparent);
  QPainter painter(&mOutlines);
  painter.setRenderHint(QPainter::Antialiasing);
  std::vector<QColor> lines, fills;
  for (glm::vec3 color : scene::typeColors(scene.model)) {
    color = glm::clamp(color, 0.0f, 1.0f);
    lines.push_back(QColor::fromRgbF(color.r, color.g, color.b));
    fills.push_back(QColor::fromRgbF(color.r, color.g, color.b, 0.3f));
  }
  for (const session::InstanceOutline& circle : outlines.circles) {
    QPointF middle(circle.middle.x, circle.middle.y);
    if (circle.radius < kDotPixels) {
      double edge = 2.0 * circle.radius;
      painter.fillRect(QRectF(middle - QPointF(circle.radius, circle.radius), QSizeF(edge, edge)), lines[circle.type]);
      continue;
    }
    painter.setPen(QPen(lines[circle.type], 1.0));
    painter.setBrush(fills[circle.type]);
    painter.drawEllipse(middle, circle.radius, circle.radius);
  }
}

void SectionView::paintEvent(QPaintEvent*) {
  if (mStale) drawImage();
  drawOutlines();
  QPainter painter(this);
  double ratio = devicePixelRatioF();
  QImage image(reinterpret_cast<const uchar*>(mImage.pixels.data()), mImage.size.x, mImage.size.y,
               QImage::Format_RGB32);
  QSizeF shown = QSizeF(image.size()) * (mDrawnCoarse / ratio);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, mDrawnCoarse > 1);
  painter.drawImage(QRectF(QPointF(), shown), image);
  if (!mOutlines.isNull()) painter.drawImage(QRectF(rect()), mOutlines);
  if (!mOutlines.isNull() && mOutlinesMissing > 0) {
    painter.setPen(kOverPicture);
    painter.drawText(rect().adjusted(10, 10, -10, -10), Qt::AlignHCenter | Qt::AlignBottom,
                     tr("%1 more instances are not outlined").arg(QLocale().toString(qulonglong(mOutlinesMissing))));
  }
  mHints.hasFocus = hasFocus();
  paintSectionOverlay(painter, mDocument.shown(), mKind, plane(), mHints);
  ++mPaintCount;
}

void SectionView::resizeEvent(QResizeEvent*) {
  for (auto* button : {mMenuButton, mMaximise})
    button->move(width() - 6 - kButton * button->property("fromRight").toInt(), 6);
  refresh();
}

void SectionView::showEvent(QShowEvent*) { refresh(); }

void SectionView::change(const session::Document::Change& change) {
  emit touched();
  changeSections(mDocument, change);
}

void SectionView::fit() {
  change([this](scene::Scene& scene) {
    scene::Section& section = scene::sectionOf(scene.sections, mKind);
    section.pan = glm::dvec2(0.0);
    section.height = 0.0;
  });
}

void SectionView::scroll(double steps) {
  change([this, steps](scene::Scene& scene) {
    scene::scrollSection(scene, mKind, steps * scene::planesPerStep(scene, plane()));
  });
}

void SectionView::showMenu(QPoint globalPlace) {
  const scene::Sections& sections = mDocument.shown().sections;
  QMenu menu(this);
  menu.setToolTipsVisible(true);
  // What is shown.
  auto addTick = [&](const QString& text, const QString& tip, bool scene::Sections::*field) {
    QAction* action = menu.addAction(text);
    action->setToolTip(tip);
    action->setCheckable(true);
    action->setChecked(sections.*field);
    connect(action, &QAction::toggled, this,
            [this, field](bool on) { change([field, on](scene::Scene& scene) { scene.sections.*field = on; }); });
  };
  addTick(tr("&Interpolate"), tr("Off: voxels as blocks"), &scene::Sections::interpolate);
  addTick(tr("&Crosshair"), tr("Lines where the other sections cross"), &scene::Sections::showCrosshair);
  addTick(tr("C&uts"), tr("Cuts as lines; what they remove is dimmed"), &scene::Sections::showCuts);
  // Structures, where there are any: a slider in the menu.
  if (mDocument.shown().labels.data) {
    auto* row = new NumberRow(0, 100, 0, " %", &menu);
    row->setValue(sections.labelOpacity * 100.0);
    row->setToolTip(tr("Opacity of the structures over the grey values"));
    connect(row, &NumberRow::changed, this, [this](double percent) {
      change([percent](scene::Scene& scene) { scene.sections.labelOpacity = percent / 100.0; });
    });
    auto* holder = new QWidget(&menu);
    auto* layout = new QHBoxLayout(holder);
    layout->setContentsMargins(22, 4, 12, 4);
    layout->addWidget(new QLabel(tr("Structures"), holder));
    layout->addWidget(row);
    auto* action = new QWidgetAction(&menu);
    action->setDefaultWidget(holder);
    menu.addAction(action);
  }
  menu.addSeparator();
  // What to go back to.
  auto addCommand = [&](const QString& text, const QString& tip, std::function<void()> run) {
    QAction* action = menu.addAction(text);
    action->setToolTip(tip);
    connect(action, &QAction::triggered, this, std::move(run));
  };
  addCommand(tr("&Fit\tF"), tr("All of the data in this view"), [this] { fit(); });
  bool isPatient = hasPatientLetters(mDocument.shown());
  addCommand(isPatient ? tr("&Patient's axes\tR") : tr("A&xes\tR"),
             isPatient ? tr("Axial, coronal and sagittal again, crosshair in the middle")
                       : tr("Along the axes again, crosshair in the middle"),
             [this] { change(scene::resetSections); });
  addWindowMenu(menu, *this, mDocument);
  menu.exec(globalPlace);
}

}  // namespace velum::gui
