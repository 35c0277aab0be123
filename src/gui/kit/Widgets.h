#pragma once
#include <QColor>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QWidget>
#include <glm/glm.hpp>

#include "gui/kit/Length.h"
#include "gui/kit/NumberField.h"

namespace velum::gui {

/// A slider with its number. Its signals tell only what the user changes, never what the program sets.
class NumberRow : public QWidget {
  Q_OBJECT
 public:
  NumberRow(double min, double max, int decimals, const QString& suffix, QWidget* parent = nullptr);
  void setRange(double min, double max);
  void setSuffix(const QString& suffix) { mSpin->setSuffix(suffix); }
  void setDecimals(int decimals);
  /// Sets the decimals and the unit for a number that is a length.
  void setLength(const Length& length);
  void setValue(double value);
  /// Sets the name that screen readers say for the slider and the number.
  void setName(const QString& name);
  double value() const { return mSpin->value(); }
  NumberField* spin() const { return mSpin; }

 signals:
  void changed(double value);
  /// The slider was let go, or the number is entered: one undo step ends.
  void settled();

 private:
  void placeSlider();
  QSlider* mSlider;
  NumberField* mSpin;
};

/// A button that shows a colour and opens a colour dialog.
class ColorButton : public QPushButton {
  Q_OBJECT
 public:
  explicit ColorButton(const QString& title, QWidget* parent = nullptr);
  void setColor(glm::vec3 color);
  /// The colour of what is written on it.
  QColor ink() const;

 signals:
  void picked(glm::vec3 color);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void choose();
  QString mTitle;
  QColor mColor;
};

/// Makes Tab go through a panel's widgets in the order of its layouts, which is that of reading, rather than in the
/// order in which the widgets were made.
void tabInLayoutOrder(QWidget* panel);

QLabel* makeTitle(const QString& text, QWidget* parent);
QFrame* makeLine(QWidget* parent);
/// Shows a text in a label: in the colour of what stands in the way, or muted.
void sayIn(QLabel& label, const QString& text, bool isAlarm);

}  // namespace velum::gui
