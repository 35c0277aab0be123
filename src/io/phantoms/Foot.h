#pragma once
#include <array>
#include <span>
#include <vector>

#include "io/phantoms/Limb.h"

/// The right foot of an adult who stands: world LPS in mm, so that the great toe's side is +x, the toes point to -y,
/// the sole is at the bottom. The axes of the foot's own frame: to the great toe's side, forward from the ankle, up
/// from the ground.
namespace velum::io::foot {

using namespace limb;

enum Part : std::uint16_t {
  kSkin = 1,
  kFat,
  kMuscle,
  kAchilles,
  kExtensors,
  kFlexors,
  kArtery,
  kVein,
  kCartilage,
  kTibia,
  kFibula,
  kTalus,
  kCalcaneus,
  kNavicular,
  kCuboid,
  kMedialCuneiform,
  kIntermediateCuneiform,
  kLateralCuneiform,
  kMetatarsal1,                  ///< Metatarsal of the great toe; those of the other toes follow.
  kPhalanx1 = kMetatarsal1 + 5,  ///< Proximal and distal of the great toe, then three of each other toe.
  kEnd = kPhalanx1 + 14
};

/// World positions and directions from those in the foot's own frame.
inline Vec at(float inward, float forward, float up) { return {inward + 4.0f, 62.0f - forward, up - 62.0f}; }
inline Vec towards(float inward, float forward, float up) { return {inward, -forward, up}; }
inline glm::vec4 at(float inward, float forward, float up, float radius) { return {at(inward, forward, up), radius}; }

/// A toe: the bases of its bones from the metatarsal on, and the tip.
struct Toe {
  std::vector<Joint> joints;
  float size = 1.0f;  ///< Size relative to the second toe's.
};
std::array<Toe, 5> toes();

/// Label of the first phalanx of a toe; toe 0 is the great one.
constexpr std::uint16_t phalanx(int toe) { return std::uint16_t(toe == 0 ? kPhalanx1 : kPhalanx1 + 2 + 3 * (toe - 1)); }

void addBones(Skeleton& skeleton, const std::array<Toe, 5>& toes);

}  // namespace velum::io::foot
