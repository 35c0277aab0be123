#include "gui/mark/MarkPaint.h"

#include <QApplication>
#include <QFontMetrics>
#include <QPainterPath>

#include "gui/kit/Points.h"
#include "gui/kit/Text.h"
#include "gui/kit/Theme.h"
#include "gui/tool/HandlePaint.h"
#include "session/mark/MarkHands.h"
#include "session/mark/MarkWords.h"

namespace velum::gui {

namespace {

constexpr double kLineWidth = 1.5, kHeadLength = 11.0;

QPainterPath markPathOf(const std::vector<glm::dvec2>& line) {
  QPainterPath path;
  for (const glm::dvec2& p : line) path.elementCount() == 0 ? path.moveTo(toPoint(p)) : path.lineTo(toPoint(p));
  return path;
}

/// The two strokes of an arrow's head.
QPainterPath headOf(glm::dvec2 from, glm::dvec2 to) {
  QPainterPath path;
  double length = glm::distance(from, to);
  if (length < 1.0) return path;
  glm::dvec2 along = (to - from) / length, aside(-along.y, along.x);
  path.moveTo(toPoint(to - along * kHeadLength + aside * (0.45 * kHeadLength)));
  path.lineTo(toPoint(to));
  path.lineTo(toPoint(to - along * kHeadLength - aside * (0.45 * kHeadLength)));
  return path;
}

/// Light words in a dark seam that is wide enough for bright bone.
void drawWords(QPainter& painter, QPointF corner, const QString& words) {
  QFontMetrics metrics(painter.font());
  QPainterPath path;
  for (const QString& line : words.split('\n')) {
    path.addText(corner + QPointF(0.0, metrics.ascent()), painter.font(), line);
    corner.ry() += metrics.lineSpacing();
  }
  painter.strokePath(path, QPen(QColor(0, 0, 0, 210), 3.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.fillPath(path, kOverPicture);
}

}  // namespace

void paintMark(ViewPainter& over, const scene::Scene& scene, const scene::Mark& mark, const QColor& color) {
  double share = session::markShare(over.space, mark, scene::sectionStep(scene)) * mark.opacity;
  if (share <= 0.0) return;
  over.painter.setOpacity(share);
  for (const auto& line : session::markLines(over.space, mark)) {
    QPainterPath path = markPathOf(line);
    if (mark.kind == scene::MarkKind::Arrow) path.addPath(headOf(line.front(), line.back()));
    strokeTwice(over.painter, path, color, kLineWidth);
  }
  auto words = session::wordsPlace(over.space, mark);
  glm::dvec2 half = halfWords(scene, mark);
  if (words && half.x > 0.0) {
    bool isAside = mark.kind == scene::MarkKind::Label || mark.kind == scene::MarkKind::Name;
    if (isAside) strokeTwice(over.painter, markPathOf({*session::wordsBelongTo(over.space, mark), *words}), color, 1.0);
    drawWords(over.painter, toPoint(*words - half), toText(session::markWords(scene, mark)));
  }
  over.painter.setOpacity(1.0);
}

glm::dvec2 halfWords(const scene::Scene& scene, const scene::Mark& mark) {
  std::string words = session::markWords(scene, mark);
  if (words.empty()) return glm::dvec2(0.0);
  QRect box = QFontMetrics(QApplication::font()).boundingRect(QRect(0, 0, 4000, 4000), Qt::AlignLeft, toText(words));
  return {0.5 * box.width(), 0.5 * box.height()};
}

}  // namespace velum::gui
