#pragma once
#include <QDoubleSpinBox>
#include <QString>

#include "gui/kit/Length.h"
#include "gui/kit/TypedNumber.h"

namespace velum::gui {

/// A field in which a number is typed. It understands units of length, a decimal comma and letters of direction; a text
/// that it does not understand, or a number out of its range, stays in the field, marked, and does not change the
/// value. A length is a value in the scene's unit, and is shown in the unit that suits the data. The wheel changes the
/// number only while the field has the keyboard.
class NumberField : public QDoubleSpinBox {
  Q_OBJECT
 public:
  explicit NumberField(QWidget* parent = nullptr);

  /// Makes the number a length: sets its unit and decimals. @param hasUnit  false where there is no room for the unit,
  /// which the row's name tells then
  void setLength(const Length& length, bool hasUnit = true);
  /// Does what setLength() does, and sets the step and the range, which reaches a hundred times as far as the data.
  /// @param isPositive  the least number is one step of the last decimal
  void setFreeLength(const Length& length, bool isPositive, bool hasUnit = true);
  /// Sets a unit that is shown beside the field, not in it. @param millimetres  how many the unit has; 0: it is no unit
  /// of length
  void setUnitBeside(const QString& unit, double millimetres);
  /// Shows the number's sign as one of two letters: "L 12.5" and "R 12.5". Empty texts: the sign is shown as such.
  void setDirections(const QString& positive, const QString& negative);
  /// Sets how many decimals the number has as it is shown.
  void setDecimals(int decimals);
  int decimals() const { return mDecimals; }
  /// Takes a text as if the user had typed and entered it.
  void enter(const QString& text);
  /// The text that was typed was not taken as a number.
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
  QString whyUntaken(const QString& typed) const;
  template <class Base>
  void keepUntaken(Base base);

  int mDecimals = 2;
  double mShownPerValue = 1.0;
  double mMillimetres = 0.0;  ///< Millimetres in the shown unit; 0: the number is no length.
  QString mUnit;              ///< The unit of a length, with a space before it.
  QString mPositive, mNegative;
  bool mIsMarked = false;
};

}  // namespace velum::gui
