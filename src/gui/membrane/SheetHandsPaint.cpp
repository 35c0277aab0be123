#include "gui/membrane/SheetHandsPaint.h"

#include <QPainterPath>

#include "gui/kit/Points.h"
#include "gui/kit/Theme.h"
#include "gui/membrane/StrengthCanvas.h"
#include "gui/tool/HandlePaint.h"
#include "session/cut/CutEdit.h"

namespace velum::gui {

namespace {

using session::Hand;
using session::HandKind;

const QColor kPin(0xf7, 0xf1, 0xdd), kEdge(0, 0, 0, 170);
constexpr double kHead = 4.6, kMiddle = 5.2;
const QPointF kNeedle(6.0, -10.0);  // from the point to the middle of the head

bool isOf(Hand mark, HandKind kind, std::size_t index) {
  bool sameThing = (mark.kind == HandKind::Pin) == (kind == HandKind::Pin) && mark.kind != HandKind::None;
  return sameThing && mark.index == int(index);
}

QColor ringColor(double strength, bool isMarked) {
  QColor color = strengthColor(strength);
  color.setAlpha(isMarked ? 255 : 190);
  return color;
}

}  // namespace

QColor strengthColor(double strength) { return strength < 0 ? kDrawColor : kKeepColor; }

void drawPin(QPainter& painter, QPointF point, bool hot, bool selected) {
  QPointF head = point + kNeedle;
  QPainterPath needle(point);
  needle.lineTo(head);
  strokeTwice(painter, needle, kPin, 1.6);
  double r = hot ? kHead + 1.2 : kHead;
  painter.setPen(QPen(selected ? kAccent : kEdge, selected ? 2.2 : 1.2));
  painter.setBrush(hot ? QColor(Qt::white) : kPin);
  painter.drawEllipse(head, r, r);
}

void drawKernel(QPainter& painter, QPointF middle, double strength, bool hot, bool selected) {
  double r = hot ? kMiddle + 1.2 : kMiddle;
  painter.setPen(QPen(selected ? QColor(Qt::white) : kEdge, selected ? 2.0 : 1.2));
  painter.setBrush(strengthColor(strength));
  painter.drawEllipse(middle, r, r);
  painter.setPen(QPen(QColor(20, 20, 24), 1.5));
  painter.drawLine(middle - QPointF(2.6, 0), middle + QPointF(2.6, 0));
  if (strength >= 0) painter.drawLine(middle - QPointF(0, 2.6), middle + QPointF(0, 2.6));
}

namespace {

void paintOverPicture(QPainter& painter, const scene::Cut& cut, const session::ViewSpace& view,
                      const HandMarks& marks) {
  const auto& kernels = cut.membrane->field.kernels;
  auto place = [&](glm::dvec3 world) { return view.pixelFromWorld(world); };
  auto ring = [&](const std::vector<glm::dvec3>& points) {
    QPolygonF polygon;
    for (const auto& p : points) {
      auto pixel = place(p);
      if (!pixel) return QPainterPath();  // a part of it is behind the eye
      polygon << toPoint(*pixel);
    }
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    return path;
  };
  glm::dmat3 axes = session::cutFrame(cut);
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    bool marked = isOf(marks.selected, HandKind::Kernel, i) || isOf(marks.hover, HandKind::Kernel, i);
    QColor color = ringColor(kernels[i].strength, marked);
    for (const auto& points : session::kernelRings(kernels[i], axes))
      strokeTwice(painter, ring(points), color, marked ? 1.4 : 0.9);
    if (auto middle = place(kernels[i].centre))
      drawKernel(painter, toPoint(*middle), kernels[i].strength, isOf(marks.hover, HandKind::Kernel, i),
                 isOf(marks.selected, HandKind::Kernel, i));
  }
  for (std::size_t i = 0; i < cut.membrane->pins.size(); ++i)
    if (auto point = place(cut.membrane->pins[i].place))
      drawPin(painter, toPoint(*point), isOf(marks.hover, HandKind::Pin, i), isOf(marks.selected, HandKind::Pin, i));
}

void paintOverSection(QPainter& painter, const scene::Cut& cut, const scene::SectionPlane& plane,
                      const HandMarks& marks) {
  const auto& kernels = cut.membrane->field.kernels;
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    auto circle = session::circleOnSection(plane, kernels[i]);
    if (!circle) continue;
    bool marked = isOf(marks.selected, HandKind::Kernel, i) || isOf(marks.hover, HandKind::Kernel, i);
    QPainterPath path;
    path.addEllipse(toPoint(circle->middle), circle->radius, circle->radius);
    QColor fill = strengthColor(kernels[i].strength);
    fill.setAlpha(marked ? 46 : 30);
    painter.fillPath(path, fill);
    strokeTwice(painter, path, ringColor(kernels[i].strength, marked), marked ? 1.8 : 1.3);
    drawKernel(painter, toPoint(circle->middle), kernels[i].strength, isOf(marks.hover, HandKind::Kernel, i),
               isOf(marks.selected, HandKind::Kernel, i));
  }
  for (std::size_t i = 0; i < cut.membrane->pins.size(); ++i) {
    glm::dvec3 place = cut.membrane->pins[i].place;
    double nearness = session::nearnessToSection(plane, place);
    if (nearness <= 0.0) continue;
    double before = painter.opacity();
    painter.setOpacity(before * (0.25 + 0.75 * nearness));
    drawPin(painter, toPoint(scene::sectionPixelFromWorld(plane, place)), isOf(marks.hover, HandKind::Pin, i),
            isOf(marks.selected, HandKind::Pin, i));
    painter.setOpacity(before);
  }
}

}  // namespace

void paintHands(QPainter& painter, const scene::Cut& cut, const session::ViewSpace& view, const HandMarks& marks) {
  if (const auto* section = view.section())
    paintOverSection(painter, cut, *section, marks);
  else
    paintOverPicture(painter, cut, view, marks);
}

}  // namespace velum::gui
