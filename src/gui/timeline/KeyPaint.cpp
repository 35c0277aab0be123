#include "gui/timeline/KeyPaint.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPixmap>

#include "gui/kit/Words.h"
#include "scene/Scene.h"
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"

namespace velum::gui {

namespace {

struct EaseRow {
  const char *name, *meaning;
};
/// In the order of scene::Ease.
constexpr EaseRow kEases[] = {
    {QT_TRANSLATE_NOOP("Words", "Hold"), QT_TRANSLATE_NOOP("Words", "Stays until the next key")},
    {QT_TRANSLATE_NOOP("Words", "Linear"), QT_TRANSLATE_NOOP("Words", "Goes evenly to the next key")},
    {QT_TRANSLATE_NOOP("Words", "In"), QT_TRANSLATE_NOOP("Words", "Begins slowly")},
    {QT_TRANSLATE_NOOP("Words", "Out"), QT_TRANSLATE_NOOP("Words", "Ends slowly")},
    {QT_TRANSLATE_NOOP("Words", "Both"), QT_TRANSLATE_NOOP("Words", "Begins and ends slowly, at rest in each key")},
    {QT_TRANSLATE_NOOP("Words", "Smooth"), QT_TRANSLATE_NOOP("Words", "Passes the keys between without a stop")}};
static_assert(std::size(kEases) == std::size(EnumNames<scene::Ease>::kNames), "each ease has its row");

/// The keys of a picture: smooth passes one.
std::vector<double> keysOf(scene::Ease ease) {
  return ease == scene::Ease::Smooth ? std::vector{0.0, 0.5, 1.0} : std::vector{0.0, 1.0};
}

/// A number that is each key's own time, on the way between them.
double onTheWay(scene::Ease ease, double t) {
  scene::Scene scene;
  for (double key : keysOf(ease))
    scene::setKey(scene.timeline, scene::kOrbitPath, key, {std::to_string(key)}).ease = ease;
  return scene::orbitAt(scene, t);
}

}  // namespace

QPainterPath keyShape(scene::Ease ease, double radius) {
  QPainterPath path;
  double r = radius;
  auto polygon = [&](std::initializer_list<QPointF> points) {
    path.addPolygon(QPolygonF(points));
    path.closeSubpath();
  };
  switch (ease) {
    case scene::Ease::Hold:
      path.addRoundedRect(QRectF(-0.8 * r, -0.8 * r, 1.6 * r, 1.6 * r), 1.0, 1.0);
      break;
    case scene::Ease::Linear:
      polygon({{0, -r}, {r, 0}, {0, r}, {-r, 0}});
      break;
    case scene::Ease::In:
      polygon({{-0.75 * r, -0.95 * r}, {r, 0}, {-0.75 * r, 0.95 * r}});
      break;
    case scene::Ease::Out:
      polygon({{0.75 * r, -0.95 * r}, {-r, 0}, {0.75 * r, 0.95 * r}});
      break;
    case scene::Ease::Both:
      polygon(
          {{-0.5 * r, -0.87 * r}, {0.5 * r, -0.87 * r}, {r, 0}, {0.5 * r, 0.87 * r}, {-0.5 * r, 0.87 * r}, {-r, 0}});
      break;
    case scene::Ease::Smooth:
      path.addEllipse(QPointF(), 0.9 * r, 0.9 * r);
  }
  return path;
}

QIcon easeIcon(scene::Ease ease, const QPalette& palette) {
  constexpr int kEasePicture = 16, kScale = 4;  // sharp on screens of any density
  QPixmap picture(kEasePicture * kScale, kEasePicture * kScale);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(kScale, kScale);
  auto place = [&](double t) { return QPointF(2.0 + 12.0 * t, 13.5 - 11.0 * onTheWay(ease, t)); };
  QPainterPath way(place(0.0));
  for (int i = 1; i <= 64; ++i) way.lineTo(place(i / 64.0));
  painter.setPen(QPen(palette.color(QPalette::Text), 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(way);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette.color(QPalette::Link));
  for (double t : keysOf(ease)) painter.drawEllipse(place(t), 1.6, 1.6);
  painter.end();
  return picture;
}

QString easeName(scene::Ease ease) { return wordsOf(kEases[std::size_t(ease)].name); }
QString easeMeaning(scene::Ease ease) { return wordsOf(kEases[std::size_t(ease)].meaning); }

}  // namespace velum::gui
