#include "ThreePointTool.h"

#include <QFontMetrics>
#include <QKeyEvent>
#include <QPainter>

#include "kit/Theme.h"
#include "velum/scene/Project.h"
#include "velum/session/cut/CutEdit.h"
#include "view/GizmoPaint.h"
#include "view/Viewport.h"

namespace velum::gui {

ThreePointTool::ThreePointTool(session::Document& document, Viewport& view)
    : QWidget(&view), mDocument(document), mView(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  hide();
  view.installEventFilter(this);
  connect(&view, &Viewport::clickedAt, this, [this](const render::Pick& pick) {
    if (mActive) takePick(pick);
  });
}

void ThreePointTool::say(const QString& text) {
  mText = text;
  update();
}

void ThreePointTool::start() {
  mPoints.clear();
  mActive = true;
  resize(mView.size());
  show();
  raise();
  mView.selectCut(0);  // its handles would be in the way
  mView.setFocus();
  mView.setCursor(Qt::CrossCursor);
  say(tr("Click the first of three points. Esc gives up."));
}

void ThreePointTool::cancel() {
  if (!mActive) return;
  mActive = false;
  mPoints.clear();
  hide();
  mView.setCursor(Qt::ArrowCursor);
  emit ended();
}

void ThreePointTool::takePick(const render::Pick& pick) {
  if (!pick.hit) return say(tr("Nothing is there: click on what is drawn. Esc gives up."));
  mPoints.push_back(pick.worldMm);
  if (mPoints.size() == 1) return say(tr("Click the second point. Esc gives up."));
  if (mPoints.size() == 2) return say(tr("Click the third point. Esc gives up."));
  auto cut = session::cutThrough(mDocument.scene(), mPoints[0], mPoints[1], mPoints[2]);
  if (!cut) {
    mPoints.pop_back();
    return say(tr("The three lie on one line: click a third beside it. Esc gives up."));
  }
  cancel();
  emit made(*cut);
}

bool ThreePointTool::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) resize(mView.size());
  bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (mActive && isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();  // before a command that has the same key
    if (event->type() == QEvent::KeyPress) cancel();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void ThreePointTool::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  glm::dvec2 size(std::max(1, width()), std::max(1, height()));
  QPolygonF polygon;
  for (const auto& point : mPoints)
    if (auto pixel = scene::pixelFromWorld(mDocument.scene().camera, size, point))
      polygon << QPointF(pixel->x, pixel->y);
  QPainterPath line;
  line.addPolygon(polygon);
  strokeTwice(painter, line, kHandle, 1.4);
  for (int i = 0; i < polygon.size(); ++i) {
    drawKnob(painter, polygon[i], false);
    drawTag(painter, polygon[i] - QPointF(8, 8), this->size(), QString::number(i + 1));
  }
  QRectF box(0, 0, QFontMetrics(font()).horizontalAdvance(mText) + 32, 30);
  box.moveCenter(QPointF(width() / 2.0, 30));
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 190));
  painter.drawRoundedRect(box, 8, 8);
  painter.setPen(Qt::white);
  painter.drawText(box, Qt::AlignCenter, mText);
}

}  // namespace velum::gui
