#include "gui/kit/NumberField.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyleOptionSpinBox>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "scene/Scene.h"

namespace velum::gui {

namespace {

constexpr int kMostDecimals = 15;
constexpr double kRounding = 1e-9;  ///< of the range, by which an end may be missed
constexpr double kLikely = 9999.9;  ///< as it is shown: units are such that larger ones are rare
constexpr int kAround = 5;  ///< pixels beside the letters: two at each end that a line edit keeps free, and the cursor
const QColor kRefused(0xd9, 0x4a, 0x3a);

}  // namespace

NumberField::NumberField(QWidget* parent) : QDoubleSpinBox(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setKeyboardTracking(false);
  connect(lineEdit(), &QLineEdit::textEdited, this, [this] {
    if (isTaken()) mIsMarked = false;
    update();
  });
}

void NumberField::setLength(const Length& length, bool hasUnit) {
  const QSignalBlocker quiet(this);
  mShownPerValue = length.shownPerLength();
  mMillimetres = length.millimetresShown();
  mUnit = length.suffix();
  QString shown = hasUnit ? mUnit : QString();
  if (suffix() != shown) setSuffix(shown);
  setDecimals(length.decimals());
}

void NumberField::setFreeLength(const Length& length, bool isPositive, bool hasUnit) {
  const QSignalBlocker quiet(this);
  setLength(length, hasUnit);
  double least = std::pow(10.0, -mDecimals) / mShownPerValue;
  setRange(isPositive ? least : -length.far(), length.far());
  setSingleStep(length.step());
}

void NumberField::setUnitBeside(const QString& unit, double millimetres) {
  mUnit = " " + unit;
  mMillimetres = millimetres;
}

void NumberField::setDirections(const QString& positive, const QString& negative) {
  if (positive == mPositive && negative == mNegative) return;
  mPositive = positive;
  mNegative = negative;
  setDecimals(mDecimals);  // says the number anew
}

void NumberField::setDecimals(int decimals) {
  mDecimals = decimals;
  int more = int(std::ceil(std::log10(mShownPerValue) - kRounding));
  QDoubleSpinBox::setDecimals(std::clamp(decimals + more, 0, kMostDecimals));
  updateGeometry();
}

QSize NumberField::minimumSizeHint() const {
  double likely = kLikely / mShownPerValue;
  int width = fontMetrics().horizontalAdvance(specialValueText());
  for (double number : {std::clamp(minimum(), -likely, likely), std::clamp(maximum(), -likely, likely), value()})
    width = std::max(width, fontMetrics().horizontalAdvance(prefix() + textFromValue(number) + suffix()));
  QStyleOptionSpinBox option;
  initStyleOption(&option);
  QSize contents(width + kAround, lineEdit()->minimumSizeHint().height());
  return style()->sizeFromContents(QStyle::CT_SpinBox, &option, contents, this);
}

NumberKind NumberField::kind() const {
  QString unit = suffix().isEmpty() ? mUnit : suffix();
  return {prefix(), unit.trimmed(), mMillimetres, mPositive, mNegative};
}

QString NumberField::textFromValue(double value) const {
  double shown = value * mShownPerValue;
  if (std::abs(shown) < 0.5 * std::pow(10.0, -mDecimals)) shown = 0.0;
  if (mPositive.isEmpty()) return locale().toString(shown, 'f', mDecimals).remove(locale().groupSeparator());
  QString number = locale().toString(std::abs(shown), 'f', mDecimals).remove(locale().groupSeparator());
  return (shown < 0.0 ? mNegative : mPositive) + " " + number;
}

double NumberField::valueFromText(const QString& text) const {
  if (!specialValueText().isEmpty() && text == specialValueText()) return minimum();
  auto shown = readTyped(text, kind());
  return shown ? std::clamp(*shown / mShownPerValue, minimum(), maximum()) : value();
}

QValidator::State NumberField::validate(QString& text, int&) const {
  if (!specialValueText().isEmpty() && text == specialValueText()) return QValidator::Acceptable;
  auto shown = readTyped(text, kind());
  if (!shown) return QValidator::Intermediate;
  double typed = *shown / mShownPerValue, margin = kRounding * (maximum() - minimum());
  bool isInside = typed >= minimum() - margin && typed <= maximum() + margin;
  return isInside ? QValidator::Acceptable : QValidator::Intermediate;
}

bool NumberField::isTaken() const {
  QString text = lineEdit()->text();
  int position = 0;
  return validate(text, position) == QValidator::Acceptable;
}

QString NumberField::whyUntaken(const QString& typed) const {
  return readTyped(typed, kind())
             ? tr("%1 is outside %2 to %3").arg(typed.trimmed(), withUnit(minimum()), withUnit(maximum()))
             : tr("\u201c%1\u201d is not understood; nothing was changed").arg(typed.trimmed());
}

/// The base class puts the number back where the text is no number; here the text stays, so that the user sees why
/// nothing has changed.
template <class Base>
void NumberField::keepUntaken(Base base) {
  if (isTaken()) return base();
  QString typed = lineEdit()->text();
  base();
  const QSignalBlocker quiet(lineEdit());
  lineEdit()->setText(typed);
  mIsMarked = true;
  update();
  QString why = whyUntaken(typed);
  setAccessibleDescription(why);
  if (isVisible()) QToolTip::showText(mapToGlobal(QPoint(0, height())), why, this);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enters) {
    keepUntaken([&] { QDoubleSpinBox::keyPressEvent(event); });
    if (isMarked()) return;
    // A number that has been entered is undone in the scene, not in the text.
    const QSignalBlocker quiet(lineEdit());
    lineEdit()->setText(lineEdit()->text());
    return selectAll();
  }
  if (event->key() == Qt::Key_Escape && isMarked()) {
    mIsMarked = false;
    return setValue(value());  // says the number again
  }
  QDoubleSpinBox::keyPressEvent(event);
}

void NumberField::enter(const QString& text) {
  lineEdit()->setText(text);
  keepUntaken([this] {
    interpretText();
    emit editingFinished();
  });
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  keepUntaken([&] { QDoubleSpinBox::focusOutEvent(event); });
}

void NumberField::paintEvent(QPaintEvent* event) {
  QDoubleSpinBox::paintEvent(event);
  if (!isMarked()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(kRefused, 2.0));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
}

}  // namespace velum::gui
