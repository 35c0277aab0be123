#include "gui/cut/ThreePointTool.h"

#include <QPainterPath>

#include "gui/kit/Theme.h"
#include "gui/tool/HandlePaint.h"
#include "session/cut/CutEdit.h"

namespace velum::gui {

ThreePointTool::ThreePointTool(const session::Document& document, Toolbox& toolbox, QObject* parent)
    : ClickTool(parent), mDocument(document), mToolbox(toolbox) {}

void ThreePointTool::say(const QString& text) {
  mHint = text;
  mToolbox.repaint();
}

QString ThreePointTool::whatIsNext() const {
  const QString next[] = {tr("Click the first of three points. Esc gives up."),
                          tr("Click the second point. Esc gives up."), tr("Click the third point. Esc gives up.")};
  return next[mPoints.size()];
}

bool ThreePointTool::start() {
  mPoints.clear();
  say(whatIsNext());
  return true;
}

void ThreePointTool::click(const PointerEvent& event) {
  if (event.keys != Qt::NoModifier) return;
  auto world = event.at.world();
  if (!world) return say(tr("Nothing is there: click on what is drawn. %1").arg(whatIsNext()));
  mPoints.push_back(*world);
  if (mPoints.size() < 3) return say(whatIsNext());
  auto cut = session::cutThrough(mDocument.shown(), mPoints[0], mPoints[1], mPoints[2]);
  if (!cut) {
    mPoints.pop_back();
    return say(tr("The three lie on one line: click a third beside it. Esc gives up."));
  }
  mToolbox.stop(*this);
  emit made(*cut);
}

void ThreePointTool::paint(ViewPainter& over) const {
  QPolygonF polygon;
  for (const auto& point : mPoints)
    if (auto pixel = over.space.pixelFromWorld(point)) polygon << QPointF(pixel->x, pixel->y);
  QPainterPath line;
  line.addPolygon(polygon);
  strokeTwice(over.painter, line, kHandle, 1.4);
  for (int i = 0; i < polygon.size(); ++i) {
    drawKnob(over.painter, polygon[i], false);
    drawTag(over.painter, polygon[i] - QPointF(8, 8), over.size, QString::number(i + 1));
  }
}

}  // namespace velum::gui
