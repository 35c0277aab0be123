#pragma once
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QWidget>
#include <glm/glm.hpp>
#include <optional>

#include "gui/kit/NumberField.h"

namespace velum::gui {

/// Asks for the edges of a voxel: three numbers, what they are in, and what usual scanners and microscopes give. While
/// the numbers are those that are known another unit tells the same lengths; what was guessed or typed are numbers, and
/// the unit says what they are in.
class VoxelSizeForm : public QWidget {
  Q_OBJECT
 public:
  explicit VoxelSizeForm(QWidget* parent);
  /// Millimetres along x, y, z.
  glm::dvec3 value() const;
  /// Lengths that are known.
  void setValue(glm::dvec3 millimetres);
  /// Something to begin with, where nothing is known.
  void setGuess(glm::dvec3 millimetres);
  /// The first number has the keyboard, and is replaced by what is typed.
  void startTyping();
  /// The next form begins with this one's answer.
  void remember() const;
  /// The answer before; nothing where there was none.
  static std::optional<glm::dvec3> lastAnswer();
  /// What a form begins with where nothing is known: the last answer; 1 mm, or 1 um for what microscopes write, where
  /// there is none of that kind.
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
  int mShownUnit = 0;     ///< Its place in the list.
  bool mIsKnown = false;  ///< The numbers are lengths that somebody knows
};

}  // namespace velum::gui
