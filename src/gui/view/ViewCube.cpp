#include "gui/view/ViewCube.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <QTransform>
#include <algorithm>

#include "gui/kit/Length.h"
#include "gui/kit/Theme.h"
#include "gui/view/SideNames.h"
#include "scene/Navigate.h"
#include "scene/Project.h"

namespace velum::gui {

namespace {

constexpr int kSize = 104, kFromCorner = 8;
constexpr int kLeastView = 220;     // a smaller view is all picture
constexpr double kHalfEdge = 28.0;  // pixels: its corners stay within the widget however it is turned
constexpr double kInner = 0.62;     // half the middle of a face; what is about it belongs to edges and corners
constexpr double kLegible = 0.22;   // of a face's width, from which on its name can be read
constexpr double kCubeClickPixels = 4.0;
constexpr double kTurn = 1.0 / 220;                     // of half a turn, a pixel of a drag
constexpr double kNameHeight = 0.44, kNameWidth = 1.7;  // of half an edge
const QColor kFaceDark(0x2c, 0x32, 0x3a, 0xe6), kFaceLight(0x4a, 0x54, 0x60, 0xe6), kLine(0xf0, 0xf3, 0xf7, 0x78);

glm::dvec3 toDouble(glm::ivec3 side) { return glm::dvec3(side); }

/// The two axes of a face, in its plane: to the right and up as it is read.
struct FaceAxes {
  glm::dvec3 right, up;
};
FaceAxes axesOf(glm::ivec3 face) {
  scene::CameraBasis basis = scene::cameraBasis(scene::seenFrom({}, toDouble(face)));
  return {basis.right, basis.up};
}

}  // namespace

ViewCube::ViewCube(session::Document& document, QWidget& view)
    : QWidget(&view), mDocument(document), mView(view), mFlight(document, nullptr), mCamera(document.shown().camera) {
  setObjectName("viewCube");
  setAccessibleName(tr("From where one looks"));
  setAttribute(Qt::WA_NoSystemBackground);
  setMouseTracking(true);
  setFocusPolicy(Qt::NoFocus);
  resize(kSize, kSize);
  view.installEventFilter(this);
  place();
}

void ViewCube::setShown(bool shown) {
  mIsShown = shown;
  place();
}

/// In the upper right corner, where nothing else is written.
void ViewCube::place() {
  move(mView.width() - kSize - kFromCorner, kFromCorner);
  setVisible(mIsShown && std::min(mView.width(), mView.height()) >= kLeastView);
  raise();
}

bool ViewCube::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &mView && event->type() == QEvent::Resize) place();
  return QWidget::eventFilter(watched, event);
}

void ViewCube::refresh() {
  QString front = nameOf({0, -1, 0});
  if (mCamera == mDocument.shown().camera && front == mFront) return;
  mCamera = mDocument.shown().camera;
  mFront = front;
  update();
}

// Where its parts are.

QPointF ViewCube::pointOf(glm::dvec3 place) const {
  scene::CameraBasis basis = scene::cameraBasis(mCamera);
  return QPointF(width() * 0.5 + kHalfEdge * glm::dot(place, basis.right),
                 height() * 0.5 - kHalfEdge * glm::dot(place, basis.up));
}

std::vector<glm::ivec3> ViewCube::facesSeen() const {
  glm::dvec3 toEye = -scene::cameraBasis(mCamera).forward;
  std::vector<glm::ivec3> faces;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(toEye[axis]) > 1e-3) {
      glm::ivec3 face(0);
      face[axis] = toEye[axis] > 0 ? 1 : -1;
      faces.push_back(face);
    }
  return faces;
}

std::vector<ViewCube::Cell> ViewCube::cellsOf(glm::ivec3 face) const {
  auto [right, up] = axesOf(face);
  const double bounds[] = {-1.0, -kInner, kInner, 1.0};
  std::vector<Cell> cells;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y) {
      auto at = [&](int i, int j) { return pointOf(toDouble(face) + right * bounds[x + i] + up * bounds[y + j]); };
      glm::dvec3 side = toDouble(face) + right * double(x - 1) + up * double(y - 1);
      cells.push_back({glm::ivec3(glm::round(side)), QPolygonF({at(0, 0), at(1, 0), at(1, 1), at(0, 1)})});
    }
  return cells;
}

std::optional<glm::ivec3> ViewCube::partAt(QPointF place) const {
  for (glm::ivec3 face : facesSeen())
    for (const Cell& cell : cellsOf(face))
      if (cell.outline.containsPoint(place, Qt::OddEvenFill)) return cell.side;
  return std::nullopt;
}

QString ViewCube::nameOf(glm::ivec3 side) const {
  QStringList names;
  for (int axis : {1, 0, 2})
    if (side[axis] != 0) names << (hasWords() ? sideName : sideSign)(mDocument.shown(), axis, side[axis] > 0);
  return names.join(", ");
}

/// A scan whose file does not say how it lay has axes alone.
bool ViewCube::hasWords() const { return hasPatientLetters(mDocument.shown()) || mDocument.shown().model.data; }

// Painting.

void ViewCube::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (glm::ivec3 face : facesSeen()) paintFace(painter, face);
}

void ViewCube::paintFace(QPainter& painter, glm::ivec3 face) const {
  double facing = -glm::dot(toDouble(face), scene::cameraBasis(mCamera).forward);
  auto mix = [facing](int dark, int light) { return int(dark + (light - dark) * facing); };
  QColor ground(mix(kFaceDark.red(), kFaceLight.red()), mix(kFaceDark.green(), kFaceLight.green()),
                mix(kFaceDark.blue(), kFaceLight.blue()), kFaceDark.alpha());
  auto [right, up] = axesOf(face);
  auto at = [&](double x, double y) { return pointOf(toDouble(face) + right * x + up * y); };
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  QPolygonF outline({at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)});
  painter.drawPolygon(outline);
  painter.setBrush(kAccent);
  for (const Cell& cell : cellsOf(face))
    if (mHover && cell.side == *mHover) painter.drawPolygon(cell.outline);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kLine, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolygon(outline);
  if (facing > kLegible) paintName(painter, face);
}

/// As if it were written on the face.
void ViewCube::paintName(QPainter& painter, glm::ivec3 face) const {
  QString name = nameOf(face);
  if (hasWords()) name[0] = name[0].toUpper();
  QFont letters = font();
  letters.setPixelSize(100);
  letters.setWeight(QFont::DemiBold);
  QPainterPath text;
  text.addText(0, 0, letters, name);
  QRectF box = text.boundingRect();
  double scale = std::min(kNameHeight / 100.0, kNameWidth / box.width());
  auto [right, up] = axesOf(face);
  auto at = [&](double x, double y) { return pointOf(toDouble(face) + right * x + up * y); };
  QPointF origin = at(0, 0), x = at(1, 0) - origin, y = origin - at(0, 1);
  QTransform onFace(x.x(), x.y(), y.x(), y.y(), origin.x(), origin.y());
  onFace.scale(scale, scale);
  onFace.translate(-box.center().x(), -box.center().y());
  bool isOn = mHover && *mHover == face;
  painter.fillPath(onFace.map(text), isOn ? QColor(0x10, 0x16, 0x1c) : kOverPicture);
}

// The pointer. What is beside the cube is the view's.

void ViewCube::setHover(std::optional<glm::ivec3> side) {
  if (mHover == side) return;
  mHover = side;
  side ? setCursor(Qt::PointingHandCursor) : unsetCursor();
  update();
}

bool ViewCube::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  auto* help = static_cast<QHelpEvent*>(event);
  auto side = partAt(help->pos());
  side ? QToolTip::showText(help->globalPos(), tr("Look from: %1. Drag to turn").arg(nameOf(*side)), this)
       : QToolTip::hideText();
  return true;
}

void ViewCube::mousePressEvent(QMouseEvent* event) {
  mPressed = event->button() == Qt::LeftButton ? partAt(event->position()) : std::nullopt;
  if (!mPressed) return event->ignore();
  mFrom = mLast = event->position();
  mIsDragged = false;
}

void ViewCube::mouseMoveEvent(QMouseEvent* event) {
  if (!mPressed) {
    setHover(partAt(event->position()));
    return mHover ? event->accept() : event->ignore();
  }
  mIsDragged = mIsDragged || (event->position() - mFrom).manhattanLength() > kCubeClickPixels;
  if (!mIsDragged) return;
  QPointF way = (event->position() - mLast) * kTurn;
  mLast = event->position();
  scene::Camera camera = scene::orbit(mDocument.shown().camera, {way.x(), way.y()});
  mDocument.view([camera](scene::Scene& scene) { scene.camera = camera; });
}

void ViewCube::mouseReleaseEvent(QMouseEvent* event) {
  auto side = std::exchange(mPressed, std::nullopt);
  if (!side) return event->ignore();
  if (!mIsDragged) mFlight.start(scene::seenFrom(mDocument.shown().camera, toDouble(*side)));
  setHover(partAt(event->position()));
}

void ViewCube::leaveEvent(QEvent*) { setHover(std::nullopt); }

}  // namespace velum::gui
