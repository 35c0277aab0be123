#include "gui/extrusion/SeedStroke.h"

#include "gui/tool/StrokePaint.h"
#include "session/growth/Growths.h"

namespace velum::gui {

void SeedStroke::goOn(glm::dvec3 world, Ground ground) {
  if (mGround != ground) mPieces.emplace_back();
  mGround = ground;
  mPieces.back().push_back(world);
}

std::vector<glm::dvec3> SeedStroke::places(const Volume& volume) const {
  std::vector<glm::dvec3> all;
  for (const auto& piece : mPieces) {
    auto some = session::placesAlong(volume, piece);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

void SeedStroke::paint(ViewPainter& over, double radius, const QColor& color) const {
  for (const auto& piece : mPieces) paintStroke(over, piece, radius, color, false);
}

}  // namespace velum::gui
