#include "gui/kit/Widgets.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QList>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyle>
#include <algorithm>
#include <cmath>

#include "gui/kit/Theme.h"

namespace velum::gui {

namespace {

constexpr int kSliderSteps = 1000;

double stepOf(int decimals) { return std::pow(10.0, -decimals) * (decimals > 1 ? 5 : 1); }

}  // namespace

NumberRow::NumberRow(double min, double max, int decimals, const QString& suffix, QWidget* parent)
    : QWidget(parent), mSlider(new QSlider(Qt::Horizontal, this)), mSpin(new NumberField(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  layout->addWidget(mSlider, 1);
  layout->addWidget(mSpin);
  mSlider->setRange(0, kSliderSteps);
  mSlider->setMinimumWidth(60);
  mSpin->setMinimumWidth(92);
  mSpin->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  mSpin->setAlignment(Qt::AlignRight);
  mSpin->setSuffix(suffix);
  setDecimals(decimals);
  setRange(min, max);
  mSlider->setFocusPolicy(Qt::ClickFocus);  // one stop for Tab: the number
  connect(mSlider, &QSlider::valueChanged, this, [this](int step) {
    double value = mSpin->minimum() + (mSpin->maximum() - mSpin->minimum()) * step / kSliderSteps;
    const QSignalBlocker quiet(mSpin);
    mSpin->setValue(value);
    emit changed(mSpin->value());
    if (!mSlider->isSliderDown()) emit settled();
  });
  connect(mSlider, &QSlider::sliderReleased, this, &NumberRow::settled);
  connect(mSpin, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    placeSlider();
    emit changed(value);
    emit settled();
  });
}

void NumberRow::setDecimals(int decimals) {
  const QSignalBlocker quiet(mSpin);
  mSpin->setDecimals(decimals);
  mSpin->setSingleStep(stepOf(decimals));
}

void NumberRow::setLength(const Length& length) {
  mSpin->setLength(length);
  mSpin->setSingleStep(stepOf(length.decimals()) / length.shownPerLength());
}

void NumberRow::setRange(double min, double max) {
  const QSignalBlocker quiet(mSpin);
  mSpin->setRange(min, max);
  placeSlider();
}

void NumberRow::setValue(double value) {
  const QSignalBlocker quiet(mSpin);
  mSpin->setValue(value);
  placeSlider();
}

void NumberRow::setName(const QString& name) {
  mSpin->setAccessibleName(name);
  mSlider->setAccessibleName(name);
}

void NumberRow::placeSlider() {
  if (mSlider->isSliderDown()) return;  // the hand holds it
  const QSignalBlocker quiet(mSlider);
  double span = mSpin->maximum() - mSpin->minimum();
  mSlider->setValue(span > 0 ? int(std::lround((mSpin->value() - mSpin->minimum()) / span * kSliderSteps)) : 0);
}

ColorButton::ColorButton(const QString& title, QWidget* parent) : QPushButton(parent), mTitle(title) {
  setFixedHeight(28);
  setToolTip(tr("%1: click to choose another colour").arg(title));
  setAccessibleName(title);
  connect(this, &QPushButton::clicked, this, &ColorButton::choose);
}

void ColorButton::setColor(glm::vec3 color) {
  color = glm::clamp(color, 0.0f, 1.0f);
  mColor = QColor::fromRgbF(color.r, color.g, color.b);
  update();
}

QColor ColorButton::ink() const {
  return qGray(mColor.rgb()) > 140 ? QColor(0x16, 0x18, 0x1c) : QColor(0xe3, 0xe7, 0xec);
}

void ColorButton::choose() {
  QColor color = QColorDialog::getColor(mColor, window(), mTitle);
  if (color.isValid()) emit picked({color.redF(), color.greenF(), color.blueF()});
}

void ColorButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!isEnabled()) painter.setOpacity(0.4);
  painter.setPen(QPen(hasFocus() || underMouse() ? kAccent : palette().color(QPalette::Dark), 1.0));
  painter.setBrush(mColor);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
  painter.setPen(ink());
  painter.drawText(rect(), Qt::AlignCenter, text());
}

namespace {

void collectTabs(QWidget* widget, QList<QWidget*>& found);

void collectTabs(const QLayout& layout, QList<QWidget*>& found) {
  for (int i = 0; i < layout.count(); ++i) {
    QLayoutItem* item = layout.itemAt(i);
    if (item->widget()) collectTabs(item->widget(), found);
    if (item->layout()) collectTabs(*item->layout(), found);
  }
}

void collectTabs(QWidget* widget, QList<QWidget*>& found) {
  if (widget->focusPolicy() & Qt::TabFocus) found << widget;
  if (widget->layout()) collectTabs(*widget->layout(), found);
}

}  // namespace

void tabInLayoutOrder(QWidget* panel) {
  QList<QWidget*> widgets;
  collectTabs(panel, widgets);
  for (int i = 1; i < widgets.size(); ++i) QWidget::setTabOrder(widgets[i - 1], widgets[i]);
}

QLabel* makeTitle(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", "title");
  return label;
}

QFrame* makeLine(QWidget* parent) {
  auto* line = new QFrame(parent);
  line->setProperty("role", "line");
  return line;
}

void sayIn(QLabel& label, const QString& text, bool isAlarm) {
  label.setProperty("role", isAlarm ? "alarm" : "muted");
  label.style()->unpolish(&label);  // the style is chosen anew
  label.style()->polish(&label);
  label.setText(text);
}

}  // namespace velum::gui
