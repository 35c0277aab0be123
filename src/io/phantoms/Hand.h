#pragma once
#include <array>
#include <span>
#include <vector>

#include "io/phantoms/Limb.h"

/// The right hand of an adult that hangs down, palm forward: world LPS in mm, so that the thumb points to -x, the palm
/// to -y, the fingers to -z. The axes of the hand's own frame: to the thumb, to the back of the hand, to the finger
/// tips; its origin is where the radius ends.
namespace velum::io::hand {

using namespace limb;

enum Part : std::uint16_t {
  kSkin = 1,
  kFat,
  kMuscle,
  kFlexors,
  kExtensors,
  kArtery,
  kVein,
  kCartilage,
  kRadius,
  kUlna,
  kScaphoid,
  kLunate,
  kTriquetrum,
  kPisiform,
  kTrapezium,
  kTrapezoid,
  kCapitate,
  kHamate,
  kMetacarpal1,                  ///< Metacarpal of the thumb; those of the fingers follow.
  kPhalanx1 = kMetacarpal1 + 5,  ///< Proximal and distal of the thumb, then three of each finger.
  kEnd = kPhalanx1 + 14
};

/// World positions and directions from those in the hand's own frame.
inline Vec at(float thumb, float back, float tip) { return {8.0f - thumb, back + 16.0f, 62.0f - tip}; }
inline Vec towards(float thumb, float back, float tip) { return {-thumb, back, -tip}; }
inline glm::vec4 at(float thumb, float back, float tip, float radius) { return {at(thumb, back, tip), radius}; }

/// A finger, or the thumb: the bases of its bones, and the tip.
struct Finger {
  std::vector<Joint> joints;
  float size = 1.0f;  ///< Size relative to the middle finger's.
};
std::array<Finger, 5> fingers();

/// Label of the first phalanx of a finger; finger 0 is the thumb.
constexpr std::uint16_t phalanx(int finger) {
  return std::uint16_t(finger == 0 ? kPhalanx1 : kPhalanx1 + 2 + 3 * (finger - 1));
}

void addBones(Skeleton& skeleton, const std::array<Finger, 5>& fingers);

}  // namespace velum::io::hand
