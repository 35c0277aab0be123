#include "gui/view/GreyWindowCorner.h"

#include <QKeyEvent>
#include <QToolTip>
#include <algorithm>

#include "core/Assert.h"
#include "gui/kit/Theme.h"
#include "gui/kit/Words.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/section/TypedWindow.h"

namespace velum::gui {

namespace {

constexpr const char* kWindowStep = "Change window";
constexpr int kFieldWidth = 190, kCornerEdge = 4;
constexpr QSize kAround(10, 6);  ///< pixels about the words, which can be clicked

}  // namespace

QString greyWindowTitle(const scene::GreyWindow& window) {
  return GreyWindowCorner::tr("%1: W %2  L %3 %4")
      .arg(wordsOf(window.title))
      .arg(window.width)
      .arg(window.level)
      .arg(QString::fromUtf8(window.unit.data(), int(window.unit.size())));
}

void setGreyWindow(session::Document& document, std::string_view name) {
  session::edit(document, session::ChooseWindow{std::string(name)});
}

void drawOverTissue(QPainter& painter, const QRectF& box, int flags, const QString& text, int alpha) {
  painter.setPen(QColor(0, 0, 0, alpha * 3 / 5));
  for (QPointF off : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
    painter.drawText(box.translated(off), flags, text);
  QColor light = kOverPicture;
  light.setAlpha(alpha);
  painter.setPen(light);
  painter.drawText(box, flags, text);
}

GreyWindowCorner::GreyWindowCorner(session::Document& document, QWidget* section)
    : QWidget(section), mDocument(document), mField(new QLineEdit(section)) {
  setObjectName("greyWindowCorner");
  setToolTip(tr("Click to type the grey window (W)"));
  setAccessibleName(tr("Grey window"));
  setCursor(Qt::IBeamCursor);
  hide();
  mField->setObjectName("greyWindow");
  mField->setAccessibleName(tr("Grey window"));
  mField->setAlignment(Qt::AlignRight);
  mField->installEventFilter(this);
  mField->hide();
}

GreyWindowCorner& GreyWindowCorner::of(QWidget& section) {
  auto* corner = section.findChild<GreyWindowCorner*>("greyWindowCorner", Qt::FindDirectChildrenOnly);
  VELUM_ASSERT(corner, "each section has one");
  return *corner;
}

void GreyWindowCorner::refresh() {
  glm::dvec2 whole(parentWidget()->width(), parentWidget()->height());
  QPointF corner = lowerRight(whole);
  mText = localNumber(session::windowText(mDocument.shown().volume));
  QSize size = fontMetrics().boundingRect(mText).size() + kAround;
  setVisible(!mText.isEmpty() && size.width() - kAround.width() < cornerRoom(whole));
  setGeometry(
      QRect(corner.toPoint() + QPoint(kAround.width() / 2, kAround.height() / 2) - QPoint(size.width(), size.height()),
            size));
  update();
}

void GreyWindowCorner::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (underMouse()) {
    painter.setPen(QPen(kOverPicture, 1.0));
    painter.setBrush(QColor(16, 18, 21, 120));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  }
  QRectF box = QRectF(rect()).adjusted(0, 0, -kAround.width() / 2, -kAround.height() / 2);
  drawOverTissue(painter, box, Qt::AlignRight | Qt::AlignBottom, mText);
}

void GreyWindowCorner::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || event->modifiers() != Qt::NoModifier) return event->ignore();
  startTyping();
}

void GreyWindowCorner::enterEvent(QEnterEvent*) { update(); }
void GreyWindowCorner::leaveEvent(QEvent*) { update(); }

void GreyWindowCorner::startTyping() {
  const scene::VolumeLayer& layer = mDocument.shown().volume;
  if (session::windowText(layer).empty()) return;
  mField->setText(QString::fromStdString(session::windowText(layer)));
  mField->setToolTip(tr("Type %1").arg(QString::fromStdString(session::typedWindowForms(layer))));
  mark(false);
  QWidget& section = *parentWidget();
  QSize size(std::min(kFieldWidth, section.width() - 2 * kCornerEdge), mField->sizeHint().height());
  mField->setGeometry(QRect(
      QPoint(section.width() - kCornerEdge - size.width(), section.height() - kCornerEdge - size.height()), size));
  mField->show();
  mField->raise();
  mField->setFocus();
  mField->selectAll();
}

void GreyWindowCorner::take() {
  auto window = session::typedWindow(mField->text().toStdString(), mDocument.shown().volume);
  if (!window) {
    mark(true);
    return QToolTip::showText(mField->mapToGlobal(QPoint(0, 0)), mField->toolTip(), mField);
  }
  session::edit(mDocument, session::ChooseWindow{mField->text().toStdString()});
  parentWidget()->setFocus();
}

void GreyWindowCorner::mark(bool isRefused) {
  mField->setStyleSheet(isRefused ? "border: 2px solid #d94a3a" : QString());
  mField->setAccessibleDescription(isRefused ? tr("Not understood; nothing was changed") : QString());
}

/// Keys of the field: Esc is its own while it is open, not the window's.
bool GreyWindowCorner::eventFilter(QObject* object, QEvent* event) {
  bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  int key = isKey ? static_cast<QKeyEvent*>(event)->key() : 0;
  if (event->type() == QEvent::ShortcutOverride && key == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::KeyPress && key == Qt::Key_Escape) {
    parentWidget()->setFocus();
    return true;
  }
  if (event->type() == QEvent::KeyPress && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
    take();
    return true;
  }
  if (event->type() == QEvent::FocusOut) {
    Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
    if (reason != Qt::PopupFocusReason && reason != Qt::ActiveWindowFocusReason) mField->hide();
  }
  return QWidget::eventFilter(object, event);
}

}  // namespace velum::gui
