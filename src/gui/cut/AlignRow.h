#pragma once
#include <QPushButton>
#include <QWidget>
#include <array>
#include <glm/glm.hpp>

#include "scene/SceneFwd.h"

namespace velum::gui {

/// Buttons that point the axis of a cut along one of the world's: one for each side, and one for the nearest.
class AlignRow : public QWidget {
  Q_OBJECT
 public:
  explicit AlignRow(QWidget* parent);
  /// Names the buttons after the sides of what is open.
  void nameSides(const scene::Scene& scene);

 signals:
  void aligned(const glm::dvec3& axis);
  void nearestAsked();

 private:
  std::array<QPushButton*, 6> mSides{};
  QPushButton* mNearest;
};

}  // namespace velum::gui
