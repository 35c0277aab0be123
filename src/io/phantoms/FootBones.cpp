#include "io/phantoms/Foot.h"

namespace velum::io::foot {

namespace {

/// An ellipsoid in the foot's frame.
Lump lump(float inward, float forward, float up, float rInward, float rForward, float rUp) {
  return {at(inward, forward, up), {rInward, rForward, rUp}};
}

Distance ball(const Lump& lump) {
  return [lump](Vec p) { return ellipsoid(p, lump.centre, lump.radii); };
}

void joinLump(Bone& bone, const Lump& lump, float fillet) {
  join(bone, boxAround(lump.centre, lump.radii + 3.0f), ball(lump), fillet);
}

void addLeg(Skeleton& skeleton) {
  LongBone tibia{at(6, -3, 190), at(3, -1, 81), towards(0, 1, 0), {13, 13}, {12.5f, 12.5f}, {23, 18}};
  tibia.round = 0.05f;
  Bone bone = longBone(kTibia, tibia, 1.1f, 2.6f);
  joinLump(bone, lump(24, 2, 78, 5.5f, 10, 12), 6.0f);  // the inner malleolus
  skeleton.add(std::move(bone), {kTalus});

  LongBone fibula{at(-24, -9, 190), at(-22.5f, -7, 68), towards(0, 1, 0), {6.2f, 6.5f}, {5.8f, 6.2f}, {7.5f, 9.5f}};
  bone = longBone(kFibula, fibula, 1.0f, 1.4f);
  joinLump(bone, lump(-23, -6, 66, 5, 7.5f, 9), 4.0f);
  skeleton.add(std::move(bone), {kTalus, kTibia});
}

Bone makeTalus() {
  // The trochlea is a roller across the foot, wider in front.
  Bone bone =
      shortBone(kTalus, {lump(3, -4, 62, 15, 19, 12), lump(6, 14, 63, 11, 11, 10), lump(10, 27, 61, 13, 10, 11.5f)}, 9);
  Vec axle = at(3, -2, 62);
  join(
      bone, boxAround(axle, Vec(18, 22, 22)),
      [axle](Vec p) {
        Vec q = p - axle;
        float half = 14.5f - 0.08f * q.y, roller = glm::length(glm::vec2(q.y, q.z)) - 19.0f;
        roller += 1.2f * std::exp(-q.x * q.x / 30.0f);  // the furrow of the pulley
        return smoothMax(smoothMax(roller, std::abs(q.x) - half, 3.0f), -q.z - 4.0f, 6.0f);
      },
      5.0f);
  return bone;
}

Bone makeCalcaneus() {
  Bone bone = shortBone(kCalcaneus,
                        {lump(-3, -50, 28, 14.5f, 13, 20), lump(-5, -34, 30, 12, 20, 17),
                         lump(-8, -8, 34, 12.5f, 22, 16), lump(-12, 17, 34, 11.5f, 14, 13.5f),
                         lump(-8, -6, 45, 12, 14, 10), lump(7, 2, 43, 11, 11, 7), lump(-2, -53, 17, 12, 11, 10)},
                        10, 1.1f);
  return bone;
}

void addTarsals(Skeleton& skeleton) {
  skeleton.add(makeTalus(), {});
  skeleton.add(makeCalcaneus(), {kTalus});
  skeleton.add(shortBone(kNavicular, {lump(11, 40, 58, 17, 8.5f, 13.5f), lump(25, 37, 50, 7.5f, 7, 8.5f)}, 7),
               {kTalus});
  skeleton.add(shortBone(kCuboid, {lump(-15, 43, 35, 12.5f, 17, 12), lump(-23, 47, 31, 8, 11, 9)}, 7),
               {kCalcaneus, kNavicular});
  skeleton.add(shortBone(kMedialCuneiform, {lump(20, 59, 50, 7.5f, 14, 11), lump(23.5f, 60, 40, 9, 14.5f, 10)}, 6),
               {kNavicular});
  skeleton.add(shortBone(kIntermediateCuneiform,
                         {lump(8.5f, 55.5f, 57, 7.5f, 10.5f, 8.5f), lump(9.5f, 55.5f, 50, 5, 9.5f, 8)}, 5),
               {kNavicular, kMedialCuneiform});
  skeleton.add(shortBone(kLateralCuneiform, {lump(-4, 58, 52, 8, 12.5f, 9), lump(-3, 57, 44, 5.5f, 11.5f, 9)}, 5),
               {kNavicular, kIntermediateCuneiform, kCuboid});
}

constexpr Sizes kGreatMetatarsal{{10.0f, 14.0f}, {6.6f, 7.0f}, {11.5f, 10.5f}, 0.9f, 1.4f, 2.0f, 0.0f, 0.8f};
constexpr Sizes kMetatarsal{{7.0f, 9.0f}, {3.9f, 4.4f}, {5.8f, 7.6f}, 0.8f, 1.0f, 2.5f, 0.0f, 1.0f};
constexpr Sizes kGreatPhalanges[] = {{{10.5f, 8.5f}, {6.6f, 5.6f}, {9.0f, 6.0f}, 0.8f, 0.9f, 1.0f, 1.2f, 0.8f},
                                     {{9.5f, 6.0f}, {5.8f, 3.8f}, {7.5f, 3.2f}, 0.8f, 0.3f, 0.0f, 0.0f, 0.6f}};
constexpr Sizes kPhalanges[] = {{{6.2f, 5.8f}, {3.3f, 3.3f}, {4.6f, 4.0f}, 0.8f, 0.5f, 1.0f, 0.8f, 0.9f},
                                {{5.0f, 4.4f}, {3.7f, 3.2f}, {4.4f, 3.4f}, 0.8f, 0.2f, 0.3f, 0.6f, 0.8f},
                                {{4.5f, 3.6f}, {3.0f, 2.5f}, {3.5f, 2.1f}, 0.8f, 0.0f, 0.0f, 0.0f, 0.6f}};

/// What metatarsals stand on, and beside which others.
void addMetatarsal(Skeleton& skeleton, int toe, Bone bone) {
  switch (toe) {
    case 0:
      return skeleton.add(std::move(bone), {kMedialCuneiform, kIntermediateCuneiform, kMetatarsal1 + 1});
    case 1:
      return skeleton.add(std::move(bone), {kIntermediateCuneiform, kMedialCuneiform, kLateralCuneiform});
    case 2:
      return skeleton.add(std::move(bone), {kLateralCuneiform, kMetatarsal1 + 1});
    case 3:
      return skeleton.add(std::move(bone), {kCuboid, kLateralCuneiform, kMetatarsal1 + 2});
    default:
      joinLump(bone, lump(-35, 55, 24, 6, 9, 6.5f), 5.0f);  // where the short peroneal muscle pulls
      return skeleton.add(std::move(bone), {kCuboid, kMetatarsal1 + 3});
  }
}

}  // namespace

std::array<Toe, 5> toes() {
  struct Row {
    Vec base, head;
    std::array<float, 3> lengths, flexDeg;  ///< Of phalanges; the great toe has one less. Bent up where negative.
    float size;
  };
  const Row rows[] = {{at(21, 73, 45), at(24, 132, 17), {33, 24, 0}, {-30, 4, 0}, 1.0f},
                      {at(9, 65, 54), at(8, 137, 18), {28, 15, 12}, {-38, 20, 14}, 1.0f},
                      {at(-3.5f, 69, 48), at(-6, 133, 17), {26, 13, 11}, {-38, 24, 16}, 0.95f},
                      {at(-15, 61, 38), at(-19, 125, 16), {24, 11, 10}, {-34, 26, 18}, 0.92f},
                      {at(-27, 56, 28), at(-31, 115, 14), {22, 9, 9}, {-30, 28, 18}, 0.9f}};
  std::array<Toe, 5> all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Row& row = rows[i];
    Joint start{row.base, glm::normalize(row.head - row.base), {}};
    start.up = glm::normalize(towards(0, 0, 1) - glm::dot(towards(0, 0, 1), start.along) * start.along);
    std::vector<float> lengths{glm::length(row.head - row.base)}, flexDeg{0.0f};
    for (std::size_t b = 0; b < (i == 0 ? 2u : 3u); ++b)
      lengths.push_back(row.lengths[b]), flexDeg.push_back(row.flexDeg[b]);
    all[i] = {walk(start, lengths, flexDeg), row.size};
  }
  return all;
}

void addBones(Skeleton& skeleton, const std::array<Toe, 5>& toes) {
  addTarsals(skeleton);
  addLeg(skeleton);
  for (int toe : {1, 0, 2, 3, 4}) {
    const auto& [joints, size] = toes[std::size_t(toe)];
    auto metatarsal = std::uint16_t(kMetatarsal1 + toe);
    const Sizes& sizes = toe == 0 ? kGreatMetatarsal : kMetatarsal;
    addMetatarsal(skeleton, toe, boneBetween(metatarsal, joints[0], joints[1], sizes, size, 1.5f));
    std::uint16_t before = metatarsal;
    for (std::size_t bone = 1; bone + 1 < joints.size(); ++bone) {
      auto label = std::uint16_t(phalanx(toe) + bone - 1);
      const Sizes& ofPhalanx = toe == 0 ? kGreatPhalanges[bone - 1] : kPhalanges[bone - 1];
      bool isLast = bone + 2 == joints.size();
      skeleton.add(boneBetween(label, joints[bone], joints[bone + 1], ofPhalanx, size, isLast ? 0.6f : 1.2f), {before});
      before = label;
    }
  }
}

}  // namespace velum::io::foot
