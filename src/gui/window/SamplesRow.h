#pragma once
#include <QComboBox>
#include <QSpinBox>
#include <QWidget>

namespace velum::gui {

/// Asks how many pictures are averaged, in words and as a number, which say the same.
class SamplesRow : public QWidget {
  Q_OBJECT
 public:
  /// @param name  what the names of the two controls begin with: "picture" for pictureQuality and pictureSamples
  SamplesRow(const QString& name, QWidget* parent);
  int samples() const { return mNumber->value(); }
  /// @param samples  1..256
  void setSamples(int samples) { mNumber->setValue(samples); }

 signals:
  void changed();

 private:
  void showWords();

  QComboBox* mWords;
  QSpinBox* mNumber;
};

}  // namespace velum::gui
