#include "membrane/forces/SidedPush.h"

#include <algorithm>
#include <cmath>

#include "core/Parallel.h"
#include "membrane/forces/FrameBox.h"

namespace velum::membrane {

namespace {

/// Strength of a kernel that draws the sheet half of the way to its centre.
constexpr double kHalfLift = 100.0;
/// A ball lets go of the sheet over the last quarter of its radius.
constexpr double kLetGo = 4.0;

/// -1 for what belongs above the sheet, 1 for what belongs below, in between for a kernel through which it passes.
class Sides {
 public:
  explicit Sides(const Corridor& corridor, double smear)
      : mCorridor(corridor), mSmear(std::max(smear, 1e-9 * std::max(corridor.step.x, corridor.step.y))) {}
  double at(glm::dvec3 local) const {
    glm::dvec2 p = glm::floor((glm::dvec2(local) - mCorridor.origin) / mCorridor.step + 0.5 + kHair);
    glm::ivec2 column = glm::clamp(glm::ivec2(p), glm::ivec2(0), mCorridor.dims - 1);
    double height = double(mCorridor.height[std::size_t(column.y * mCorridor.dims.x + column.x)]);
    return std::clamp((height - local.z) / mSmear, -1.0, 1.0);
  }

 private:
  const Corridor& mCorridor;
  double mSmear;
};

/// Differs: not in the paper. The loose cloth of the sided rule is pulled back to the rest plane so strongly that a
/// force would hardly move it: what attracts lifts the rest plane itself towards its centre instead, as long as its
/// ball reaches the rest plane.
double liftOf(const PlacedKernel& kernel) {
  double reaches = (1.0 - std::abs(kernel.centre.z) / kernel.halfWidth) * kLetGo;
  return kernel.centre.z * std::clamp(reaches, 0.0, 1.0) * kernel.pull / (kernel.pull - kHalfLift);
}

}  // namespace

void turnToSides(PushField& field, const Corridor& corridor) {
  glm::dmat4 localFromKernel = glm::inverse(field.kernelFromLocal);
  glm::dmat3 axes(localFromKernel);
  double thick = std::abs(axes[0].z) + std::abs(axes[1].z) + std::abs(axes[2].z);
  Sides sides(corridor, 0.5 * thick);
  parallelFor(0, field.dims.z, [&](int z) {
    std::size_t i = std::size_t(z) * std::size_t(field.dims.y) * std::size_t(field.dims.x);
    for (int y = 0; y < field.dims.y; ++y)
      for (int x = 0; x < field.dims.x; ++x, ++i) {
        float strength = field.strengths[i].y;
        field.strengths[i] = glm::vec2(0.0f);
        if (strength <= 0.0f) continue;
        double side = sides.at(glm::dvec3(localFromKernel * glm::dvec4(x, y, z, 1.0)));
        field.strengths[i] = {float(side) * strength, 0.0f};
      }
  });
  for (auto& kernel : field.placed) {
    if (kernel.pull <= 0.0) {
      kernel.lift = liftOf(kernel);
      continue;
    }
    kernel.push = Sides(corridor, 0.25 * kernel.halfWidth).at(kernel.centre) * kernel.pull;
    kernel.pull = 0.0;
  }
}

}  // namespace velum::membrane
