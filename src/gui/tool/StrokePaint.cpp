#include "gui/tool/StrokePaint.h"

#include <QImage>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <vector>

#include "gui/kit/Theme.h"
#include "gui/tool/HandlePaint.h"

namespace velum::gui {

namespace {

constexpr double kDabStep = 0.3;      // radii between two dabs of a band whose width may change
constexpr int kMostDabs = 4000;       // of a segment
constexpr double kLeastPixels = 1.5;  // of a radius: thinner bands would not be seen
constexpr double kBand = 0.34, kMarkedBand = 0.5, kFar = 0.45;  // opacities; the last of all in the 3D view
constexpr double kEdge = 1.3;                                   // pixels

/// A disc of the stroke as the view shows it.
struct Dab {
  QPointF place;
  double radius = 0;   ///< pixels
  bool joins = false;  ///< to the one before
};

std::vector<Dab> dabsOf(const session::ViewSpace& view, std::span<const glm::dvec3> path, double radius) {
  std::vector<Dab> dabs;
  bool joins = false;
  auto add = [&](glm::dvec3 p) {
    auto circle = view.circleOfBall(p, radius);
    if (circle) dabs.push_back({{circle->middle.x, circle->middle.y}, std::max(circle->radius, kLeastPixels), joins});
    joins = circle.has_value();
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) {
      double share = kDabStep * std::max(radius, 1e-9) / std::max(glm::distance(path[i - 1], path[i]), 1e-12);
      int count = std::clamp(int(std::min(1.0 / share, double(kMostDabs))), 1, kMostDabs);
      for (int k = 1; k < count; ++k) add(glm::mix(path[i - 1], path[i], double(k) / count));
    }
    add(path[i]);
  }
  return dabs;
}

/// The part of the view that dabs touch.
QRect partOf(const std::vector<Dab>& dabs, QSize view) {
  QRectF box;
  for (const Dab& dab : dabs) {
    double r = dab.radius + 2 * kEdge;
    box |= QRectF(dab.place.x() - r, dab.place.y() - r, 2 * r, 2 * r);
  }
  return box.toAlignedRect() & QRect(QPoint(), view);
}

}  // namespace

/// A band of one opacity, however often it crosses itself, with an edge: drawn on a sheet of its own, the edge first,
/// then what it encloses in its place.
void paintStroke(ViewPainter& over, std::span<const glm::dvec3> path, double radius, const QColor& color,
                 bool isMarked) {
  std::vector<Dab> dabs = dabsOf(over.space, path, radius);
  QRect part = partOf(dabs, over.size);
  if (dabs.empty() || part.isEmpty()) return;
  double ratio = over.painter.device()->devicePixelRatioF();
  QImage sheet(part.size() * ratio, QImage::Format_ARGB32_Premultiplied);
  sheet.setDevicePixelRatio(ratio);
  sheet.fill(Qt::transparent);
  QPainter layer(&sheet);
  layer.setRenderHint(QPainter::Antialiasing);
  layer.translate(-part.topLeft());
  QColor edge = color, ground = color;
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
  over.painter.setOpacity(over.space.section() ? 1.0 : kFar);
  over.painter.drawImage(part.topLeft(), sheet);
  over.painter.setOpacity(1.0);
}

void paintBrush(ViewPainter& over, QPointF pointer, double radius, const QColor& color) {
  double pixels = std::max(radius / over.space.lengthPerPixel(), kLeastPixels);
  QPainterPath brush;
  brush.addEllipse(pointer, pixels, pixels);
  strokeTwice(over.painter, brush, color, 1.4);
}

}  // namespace velum::gui
