#include "gui/mark/MarkPaint.h"

#include <QApplication>
#include <QFontMetrics>
#include <QPainterPath>

#include "gui/kit/Points.h"
#include "gui/kit/Text.h"
#include "gui/tool/HandlePaint.h"
#include "gui/view/GreyWindowCorner.h"
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
    QRectF box(words->x - half.x - 4.0, words->y - half.y, 2.0 * half.x + 8.0, 2.0 * half.y);
    drawOverTissue(over.painter, box, Qt::AlignCenter, toText(session::markWords(scene, mark)));
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
