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

/// A slider with its number. It tells only what the user changes, never what the program sets.
class NumberRow : public QWidget {
  Q_OBJECT
 public:
  NumberRow(double min, double max, int decimals, const QString& suffix, QWidget* parent = nullptr);
  void setRange(double min, double max);
  void setSuffix(const QString& suffix) { mSpin->setSuffix(suffix); }
  void setDecimals(int decimals);
  /// Decimals and unit of lengths.
  void setLength(const Length& length);
  void setValue(double value);
  /// What is read out of slider and number.
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

/// A colour that opens the system's colour dialog.
class ColorButton : public QPushButton {
  Q_OBJECT
 public:
  explicit ColorButton(const QString& title, QWidget* parent = nullptr);
  void setColor(glm::vec3 color);

 signals:
  void picked(glm::vec3 color);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void choose();
  QString mTitle;
  QColor mColor;
};

/// Tab goes through a panel as its layouts have it, which is the order of reading, rather than as it was built.
void tabInLayoutOrder(QWidget* panel);

QLabel* makeTitle(const QString& text, QWidget* parent);
QFrame* makeLine(QWidget* parent);

}  // namespace velum::gui
