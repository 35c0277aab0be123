#include "gui/membrane/SketchForm.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/membrane/StrengthCanvas.h"
#include "scene/Scene.h"

namespace velum::gui {

namespace {

constexpr int kMostSketchRows = 4, kSketchSwatch = 12;

QPushButton* makeButton(QWidget* parent, const char* name, const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  button->setToolTip(tip);
  return button;
}

QIcon swatchOf(const QColor& color) {
  QPixmap pixmap(2 * kSketchSwatch, 2 * kSketchSwatch);
  pixmap.setDevicePixelRatio(2.0);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(color, 5.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(3, kSketchSwatch - 3.5), QPointF(kSketchSwatch - 3, 3.5));
  return pixmap;
}

}  // namespace

SketchForm::SketchForm(QWidget* parent)
    : QWidget(parent),
      mKeep(makeButton(this, "sketchKeep", tr("Protect"),
                       tr("Stroke over what the sheet is to go around, on a section or in the picture;\n"
                          "[ and ] or Alt and the wheel change the radius, Esc ends"))),
      mAvoid(makeButton(this, "sketchAvoid", tr("Let through"),
                        tr("Stroke over what the sheet may cut: its values are taken out of the curve"))),
      mRemove(makeButton(this, "sketchRemove", tr("Remove stroke"), tr("Remove the selected stroke (Del)"))),
      mRadius(new NumberRow(0.0, 0.0, 1, QString(), this)),
      mList(new QListWidget(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  auto* head = new QHBoxLayout;
  head->addWidget(makeTitle(tr("Sketch"), this), 1);
  head->addWidget(mRemove);
  layout->addLayout(head);
  auto* brushes = new QHBoxLayout;
  for (auto* button : {mKeep, mAvoid}) brushes->addWidget(button, 1);
  layout->addLayout(brushes);
  auto* radius = new QHBoxLayout;
  auto* name = new QLabel(tr("Radius"), this);
  name->setMinimumWidth(62);
  radius->addWidget(name);
  radius->addWidget(mRadius, 1);
  mRadius->setObjectName("sketchRadius");
  mRadius->setName(tr("Radius of the brush"));
  mRadius->setToolTip(tr("Radius of the brush, and of the selected stroke ([ and ] in the views)"));
  layout->addLayout(radius);
  mList->setObjectName("sketchList");
  mList->setAccessibleName(tr("Strokes"));
  mList->setToolTip(tr("The strokes to which the curve is fitted; Del removes one"));
  mList->setIconSize(QSize(kSketchSwatch, kSketchSwatch));
  mList->installEventFilter(this);
  layout->addWidget(mList);
  mRemove->setProperty("role", "quiet");
  connect(mRadius, &NumberRow::changed, this, &SketchForm::radiusAsked);
  connect(mRadius, &NumberRow::settled, this, &SketchForm::radiusSettled);
  connect(mRemove, &QPushButton::clicked, this, [this] { emit removeAsked(mList->currentRow()); });
  connect(mList, &QListWidget::currentRowChanged, this, [this](int row) {
    mRemove->setEnabled(row >= 0);
    emit strokeSelected(row);
  });
  fillList();
}

void SketchForm::showStrokes(const std::vector<scene::Stroke>& strokes) {
  if (strokes == mStrokes) return;
  mStrokes = strokes;
  fillList();
}

void SketchForm::fillList() {
  int row = mList->currentRow();
  const QSignalBlocker quiet(mList);
  mList->clear();
  for (const auto& stroke : mStrokes)
    mList->addItem(new QListWidgetItem(
        swatchOf(stroke.avoid ? kAvoidColor : kKeepColor),
        tr("%1, radius %2")
            .arg(stroke.avoid ? tr("Let through") : tr("Protect"), mRadius->spin()->withUnit(stroke.radius))));
  int rows = int(mStrokes.size());
  if (row < rows) mList->setCurrentRow(row);
  int height = rows > 0 ? mList->sizeHintForRow(0) + 2 * mList->spacing() : 0;
  mList->setFixedHeight(std::min(rows, kMostSketchRows) * height + 2 * mList->frameWidth() + 6);
  mList->setVisible(rows > 0);
  mRemove->setVisible(rows > 0);
  mRemove->setEnabled(mList->currentRow() >= 0);
}

/// The slider reaches some times further than the brush that suits the data.
void SketchForm::showRadius(double radius) {
  if (radius <= 0.0) return;  // nobody knows yet what suits the data
  double power = std::floor(std::log10(std::max(radius * mShownPerLength, 1e-9)));
  mRadius->setDecimals(std::clamp(1 - int(power), 0, 9));
  const auto* spin = mRadius->spin();
  if (radius > spin->maximum() || radius < spin->minimum()) mRadius->setRange(radius / 25.0, 8.0 * radius);
  mRadius->setValue(radius);
}

void SketchForm::showLength(const Length& length) {
  if (mShownPerLength == length.shownPerLength() && mRadius->spin()->suffix() == length.suffix()) return;
  mShownPerLength = length.shownPerLength();
  mRadius->setLength(length);
  showRadius(mRadius->value());
}

void SketchForm::showSelected(int index) {
  const QSignalBlocker quiet(mList);
  mList->setCurrentRow(index);
  if (index < 0) mList->clearSelection();
  mRemove->setEnabled(index >= 0);
}

/// Del comes before the command that has the same key.
bool SketchForm::eventFilter(QObject* watched, QEvent* event) {
  bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (watched == mList && isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete &&
      mList->currentRow() >= 0) {
    event->accept();
    if (event->type() == QEvent::KeyPress) emit removeAsked(mList->currentRow());
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace velum::gui
