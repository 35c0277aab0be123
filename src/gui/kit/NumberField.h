#pragma once
#include <QDoubleSpinBox>
#include <QString>

#include "gui/kit/Length.h"
#include "gui/kit/TypedNumber.h"

namespace velum::gui {

/// A number to type. It understands units of length, a decimal comma and letters of direction; what it does not
/// understand, or what is out of its range, stays in it, marked, and changes nothing. A length is a value in the
/// scene's unit, and is shown in the unit that suits the data. The wheel changes it only while it has the keyboard.
class NumberField : public QDoubleSpinBox {
  Q_OBJECT
 public:
  explicit NumberField(QWidget* parent = nullptr);

  /// Makes the number one of a length: unit and decimals. @param hasUnit  false where there is no room for it: the
  /// row's name tells it
  void setLength(const Length& length, bool hasUnit = true);
  /// The same with its range, which reaches a hundred times as far as the data, and its step.
  /// @param isPositive  at least one step of the last decimal
  void setFreeLength(const Length& length, bool isPositive, bool hasUnit = true);
  /// The unit that stands beside the field, not in it. @param millimetres  in it; 0: it is none of length
  void setUnitBeside(const QString& unit, double millimetres);
  /// The sign is told by these letters: "L 12.5" and "R 12.5". Empty ones: it is a sign.
  void setDirections(const QString& positive, const QString& negative);
  /// Of the number as it is shown.
  void setDecimals(int decimals);
  int decimals() const { return mDecimals; }
  /// As if it was typed and entered.
  void enter(const QString& text);
  /// What was typed was not taken.
  bool isMarked() const { return mIsMarked && !isTaken(); }
  /// "12.5 mm".
  QString withUnit(double value) const { return textFromValue(value) + (suffix().isEmpty() ? mUnit : suffix()); }

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;
  QSize sizeHint() const override { return minimumSizeHint(); }
  /// Room for the number that is shown, and for the longest that is likely.
  QSize minimumSizeHint() const override;
  /// Nothing is guessed: the base would take "1,234.5" for 1234.5.
  void fixup(QString&) const override {}

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  NumberKind kind() const;
  bool isTaken() const;
  template <class Base>
  void keepUntaken(Base base);

  int mDecimals = 2;
  double mShownPerValue = 1.0;
  double mMillimetres = 0.0;  ///< In the unit that is shown; 0: it is no length.
  QString mUnit;              ///< Of lengths, with a space before it.
  QString mPositive, mNegative;
  bool mIsMarked = false;
};

}  // namespace velum::gui
