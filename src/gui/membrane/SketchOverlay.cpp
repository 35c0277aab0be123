#include "SketchOverlay.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "SketchTool.h"
#include "StrengthCanvas.h"
#include "kit/Theme.h"
#include "velum/scene/Project.h"
#include "view/GizmoPaint.h"

namespace velum::gui {

namespace {

constexpr double kDabStep = 0.3;      // radii between two dabs of a band whose width may change
constexpr int kMostDabs = 4000;       // of a segment
constexpr double kLeastPixels = 1.5;  // of a radius: thinner bands would not be seen
constexpr double kBand = 0.34, kMarkedBand = 0.5, kFar = 0.45;  // opacities; the last of all in the 3D view
constexpr double kEdge = 1.3;                                   // pixels

}  // namespace

SketchOverlay::SketchOverlay(const SketchTool& tool, SliceView& view) : SketchOverlay(tool, view, &view) {}
SketchOverlay::SketchOverlay(const SketchTool& tool, Viewport& view) : SketchOverlay(tool, view, nullptr) {}

SketchOverlay::SketchOverlay(const SketchTool& tool, QWidget& view, SliceView* slice)
    : QWidget(&view), mTool(tool), mSlice(slice) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  resize(view.size());
  lower();  // below the view's buttons
  hide();
  view.installEventFilter(this);
}

bool SketchOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) resize(parentWidget()->size());
  return QWidget::eventFilter(watched, event);
}

void SketchOverlay::setPointer(std::optional<QPointF> place) {
  if (place == mPointer) return;
  mPointer = place;
  update();
}

/// Nothing where the stroke does not reach the slice, or lies behind the eye.
std::optional<SketchOverlay::Dab> SketchOverlay::dabAt(glm::dvec3 worldMm, double radiusMm) const {
  if (mSlice) {
    scene::SliceFrame frame = mSlice->frame();
    double height = scene::heightOverSlice(frame, worldMm);
    if (std::abs(height) >= radiusMm) return std::nullopt;
    glm::dvec2 place = scene::slicePixelFromWorld(frame, worldMm);
    return Dab{{place.x, place.y}, std::sqrt(radiusMm * radiusMm - height * height) / frame.mmPerPixel, true};
  }
  const scene::Camera& camera = mTool.document().scene().camera;
  glm::dvec2 size(std::max(1, width()), std::max(1, height()));
  auto place = scene::pixelFromWorld(camera, size, worldMm);
  if (!place) return std::nullopt;
  return Dab{{place->x, place->y}, radiusMm / std::max(1e-12, scene::mmPerPixel(camera, size, worldMm)), true};
}

std::vector<SketchOverlay::Dab> SketchOverlay::dabsOf(const scene::Stroke& stroke) const {
  std::vector<Dab> dabs;
  bool joins = false;
  auto add = [&](glm::dvec3 p) {
    auto dab = dabAt(p, stroke.radiusMm);
    if (dab) {
      dab->joins = joins;
      dab->radius = std::max(dab->radius, kLeastPixels);
      dabs.push_back(*dab);
    }
    joins = dab.has_value();
  };
  const auto& path = stroke.pathMm;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) {
      double share = kDabStep * std::max(stroke.radiusMm, 1e-9) / std::max(glm::distance(path[i - 1], path[i]), 1e-12);
      int count = std::clamp(int(std::min(1.0 / share, double(kMostDabs))), 1, kMostDabs);
      for (int k = 1; k < count; ++k) add(glm::mix(path[i - 1], path[i], double(k) / count));
    }
    add(path[i]);
  }
  return dabs;
}

/// A band of one opacity, however often it crosses itself, with an edge: drawn on a sheet of its own, the edge first,
/// then what it encloses in its place.
void SketchOverlay::paintStroke(QPainter& painter, const scene::Stroke& stroke, bool isMarked) const {
  std::vector<Dab> dabs = dabsOf(stroke);
  if (dabs.empty()) return;
  QRectF box;
  for (const Dab& dab : dabs) {
    double r = dab.radius + 2 * kEdge;
    box |= QRectF(dab.place.x() - r, dab.place.y() - r, 2 * r, 2 * r);
  }
  QRect part = box.toAlignedRect() & rect();
  if (part.isEmpty()) return;
  double ratio = devicePixelRatioF();
  QImage sheet(part.size() * ratio, QImage::Format_ARGB32_Premultiplied);
  sheet.setDevicePixelRatio(ratio);
  sheet.fill(Qt::transparent);
  QPainter layer(&sheet);
  layer.setRenderHint(QPainter::Antialiasing);
  layer.translate(-part.topLeft());
  QColor edge = stroke.avoid ? kAvoidColor : kKeepColor, ground = edge;
  if (isMarked) edge = kOverPicture;
  ground.setAlphaF(float(isMarked ? kMarkedBand : kBand));
  for (bool isGround : {false, true}) {
    layer.setCompositionMode(isGround ? QPainter::CompositionMode_Source : QPainter::CompositionMode_SourceOver);
    for (std::size_t i = 0; i < dabs.size(); ++i) {
      QPointF from = dabs[i].joins && i > 0 ? dabs[i - 1].place : dabs[i].place + QPointF(0.01, 0);
      layer.setPen(QPen(isGround ? ground : edge, 2.0 * (dabs[i].radius + (isGround ? 0.0 : kEdge)), Qt::SolidLine,
                        Qt::RoundCap));
      layer.drawLine(from, dabs[i].place);
    }
  }
  layer.end();
  painter.setOpacity(mSlice ? 1.0 : kFar);
  painter.drawImage(part.topLeft(), sheet);
  painter.setOpacity(1.0);
}

double SketchOverlay::brushRadius() const {
  if (mSlice) return mTool.radiusMm() / mSlice->frame().mmPerPixel;
  const scene::Camera& camera = mTool.document().scene().camera;
  glm::dvec2 size(std::max(1, width()), std::max(1, height()));
  return mTool.radiusMm() / std::max(1e-12, scene::mmPerPixel(camera, size, camera.targetMm));
}

void SketchOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  bool isSeen = !mSlice || mTool.document().scene().slices.showCuts;
  if (const auto* strokes = mTool.strokes(); strokes && (isSeen || mTool.isActive()))
    for (std::size_t i = 0; i < strokes->size(); ++i) paintStroke(painter, (*strokes)[i], int(i) == mTool.selected());
  if (const auto* draft = mTool.draft()) paintStroke(painter, *draft, false);
  if (!mPointer || !mTool.isActive()) return;
  QPainterPath brush;
  double radius = std::max(brushRadius(), kLeastPixels);
  brush.addEllipse(*mPointer, radius, radius);
  strokeTwice(painter, brush, mTool.isAvoiding() ? kAvoidColor : kKeepColor, 1.4);
}

}  // namespace velum::gui
