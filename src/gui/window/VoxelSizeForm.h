#pragma once
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QWidget>
#include <glm/glm.hpp>
#include <optional>

#include "gui/kit/NumberField.h"

namespace velum::gui {

/// Asks for the edges of a voxel: three numbers, their unit, and a list of sizes that usual scanners and microscopes
/// give. While the numbers show known lengths, another unit converts them to the same lengths; numbers that were
/// guessed or typed stay as they are when another unit is chosen.
class VoxelSizeForm : public QWidget {
  Q_OBJECT
 public:
  explicit VoxelSizeForm(QWidget* parent);
  /// Millimetres along x, y, z.
  glm::dvec3 value() const;
  /// Shows lengths that are known.
  void setValue(glm::dvec3 millimetres);
  /// Shows lengths to begin with, where nothing is known.
  void setGuess(glm::dvec3 millimetres);
  /// Gives the keyboard to the first number, which is replaced by what is typed.
  void startTyping();
  /// Keeps this form's answer, with which the next form begins.
  void remember() const;
  /// The answer of the form before; nothing where there was none. Millimetres along x, y, z.
  static std::optional<glm::dvec3> lastAnswer();
  /// What a form begins with where nothing is known: the last answer, or, where there is no last answer of this kind, 1
  /// mm, and 1 um for files of microscopes. In millimetres.
  static glm::dvec3 firstGuess(bool isMicroscope);

 signals:
  void changed();

 private:
  void addEdges(QGridLayout& grid);
  void addUsual();
  void chooseUnit(int index);
  void showIn(int unit, glm::dvec3 numbers);
  glm::dvec3 numbers() const;
  NumberField* mEdges[3];
  QComboBox *mUnit, *mUsual;
  QCheckBox* mSame;
  int mShownUnit = 0;     ///< The place of the shown unit in the list.
  bool mIsKnown = false;  ///< The numbers are known lengths: neither guessed nor typed.
};

}  // namespace velum::gui
