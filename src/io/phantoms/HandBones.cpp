#include "io/phantoms/Hand.h"

namespace velum::io::hand {

namespace {

void addForearm(Skeleton& skeleton) {
  LongBone ulna{at(-15, 1, -75), at(-15.5f, 2, -3), towards(0, 1, 0), {6.5f, 7}, {6, 6.5f}, {7.6f, 7.8f}};
  ulna.round = 0.6f;
  Bone bone = longBone(kUlna, ulna, 1.0f, 1.2f);
  // The styloid process.
  Vec tip = at(-20.5f, 5, -2);
  join(
      bone, boxAround(tip, Vec(8)),
      [tip](Vec p) {
        return ellipsoid(p, tip, {2.6f, 2.6f, 5.5f});
      },
      3.0f);
  skeleton.add(std::move(bone), {});

  LongBone radius{at(6, 0, -75), at(6.5f, 0.5f, 3.5f), towards(0, 1, 0), {8.5f, 7.5f}, {8, 7}, {16, 10.5f}};
  radius.round = 0.15f;
  bone = longBone(kRadius, radius, 1.0f, 1.4f);
  Vec styloid = at(19.5f, -1, 3.5f), tubercle = at(8, 9.5f, -5);
  join(
      bone, boxAround(styloid, Vec(12)),
      [styloid](Vec p) {
        return ellipsoid(p, styloid, {4.6f, 6.5f, 10.5f});
      },
      5.0f);
  join(
      bone, boxAround(tubercle, Vec(9)),
      [tubercle](Vec p) {
        return ellipsoid(p, tubercle, {2.6f, 2.6f, 6});
      },
      3.0f);
  skeleton.add(std::move(bone), {kScaphoid, kLunate, kUlna});
}

/// An ellipsoid in the hand's frame.
Lump lump(float thumb, float back, float tip, float rThumb, float rBack, float rTip) {
  return {at(thumb, back, tip), {rThumb, rBack, rTip}};
}

void addCarpals(Skeleton& skeleton) {
  skeleton.add(shortBone(kCapitate, {lump(0, 0, 14.5f, 6.5f, 7.5f, 7), lump(0.5f, 0.5f, 23, 7.5f, 8.5f, 8.5f)}, 6), {});
  skeleton.add(
      shortBone(
          kScaphoid,
          {lump(9, 2, 7, 7, 7.5f, 6.5f), lump(15, -2.5f, 11.5f, 6, 6, 6.5f), lump(19, -6.5f, 14.5f, 4.8f, 4.8f, 5)}, 8),
      {kCapitate});
  skeleton.add(shortBone(kLunate, {lump(-4.5f, 0, 7.5f, 9.2f, 9.5f, 8.5f)}), {kCapitate, kScaphoid});
  skeleton.add(shortBone(kHamate,
                         {lump(-11, 1, 21, 7.5f, 8, 9), lump(-9.5f, 0, 15, 5, 6.5f, 6),
                          lump(-11.5f, -8, 22, 2.8f, 6, 4.5f), lump(-10.5f, -12.5f, 22, 3.2f, 3.2f, 4.5f)},
                         4),
               {kCapitate, kLunate});
  skeleton.add(shortBone(kTriquetrum, {lump(-17, -0.5f, 11.5f, 8, 8, 8.5f)}), {kLunate, kHamate});
  skeleton.add(shortBone(kPisiform, {lump(-18.5f, -11.5f, 12, 5.6f, 5.4f, 6.6f)}), {kTriquetrum});
  skeleton.add(shortBone(kTrapezoid, {lump(11.5f, 2.5f, 22, 6.5f, 7.5f, 7), lump(11, -4, 22, 4.5f, 5, 5.5f)}, 5),
               {kCapitate, kScaphoid});
  skeleton.add(shortBone(kTrapezium, {lump(20.5f, -4.5f, 22.5f, 8, 7.5f, 7.5f), lump(18, -10, 22, 3.5f, 4.5f, 5)}, 4),
               {kTrapezoid, kScaphoid});
}

// Of a middle finger. Half widths and half depths, mm.
constexpr Sizes kMetacarpal{{7.2f, 7.8f}, {4.2f, 4.6f}, {7.0f, 7.4f}, 0.8f, 1.0f, 2.0f, 0.0f, 1.0f};
constexpr Sizes kFirstMetacarpal{{8.0f, 8.0f}, {5.6f, 4.6f}, {7.8f, 6.6f}, 0.8f, 1.0f, 1.2f, 0.0f, 0.8f};
constexpr Sizes kPhalanges[] = {{{7.6f, 6.4f}, {4.7f, 3.6f}, {5.8f, 4.4f}, 0.7f, 0.8f, 1.2f, 1.1f, 0.9f},
                                {{6.6f, 5.2f}, {3.9f, 3.0f}, {5.0f, 3.6f}, 0.7f, 0.6f, 0.8f, 0.9f, 0.9f},
                                {{5.5f, 4.0f}, {2.7f, 2.2f}, {4.2f, 2.1f}, 0.7f, 0.2f, 0.3f, 0.0f, 0.6f}};

/// What metacarpals stand on, and beside which others.
void addMetacarpal(Skeleton& skeleton, int finger, Bone bone) {
  switch (finger) {
    case 0:
      return skeleton.add(std::move(bone), {kTrapezium});
    case 1:
      return skeleton.add(std::move(bone), {kTrapezoid, kTrapezium, kCapitate, kMetacarpal1 + 2});
    case 2:
      return skeleton.add(std::move(bone), {kCapitate});
    case 3:
      return skeleton.add(std::move(bone), {kHamate, kCapitate, kMetacarpal1 + 2});
    default:
      return skeleton.add(std::move(bone), {kHamate, kMetacarpal1 + 3});
  }
}

}  // namespace

std::array<Finger, 5> fingers() {
  struct Row {
    Vec base, along, up;
    std::array<float, 4> lengths, flexDeg;  ///< Metacarpal, then phalanges; the thumb has one less.
    float size;
  };
  const Row rows[] = {
      {at(24, -9, 27), towards(0.52f, -0.36f, 0.78f), towards(0.62f, 0.78f, 0), {45, 32, 23, 0}, {0, 10, 18, 0}, 1.06f},
      {at(12.5f, 1.5f, 28.5f), towards(0.13f, -0.02f, 1), towards(0, 1, 0), {66, 41, 24, 17}, {0, 16, 24, 8}, 0.97f},
      {at(1, 2, 31), towards(0.01f, 0.03f, 1), towards(0, 1, 0), {64, 45, 28, 18}, {0, 24, 32, 13}, 1.0f},
      {at(-8, 1, 30), towards(-0.12f, 0.0f, 1), towards(0, 1, 0), {57, 41, 26, 18}, {0, 22, 30, 12}, 0.9f},
      {at(-15.5f, -1, 28), towards(-0.25f, -0.06f, 1), towards(-0.1f, 1, 0), {53, 33, 19, 16}, {0, 16, 22, 9}, 0.8f}};
  std::array<Finger, 5> all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Row& row = rows[i];
    std::size_t bones = i == 0 ? 3 : 4;
    Joint start{row.base, glm::normalize(row.along), {}};
    start.up = glm::normalize(row.up - glm::dot(row.up, start.along) * start.along);
    all[i] = {walk(start, std::span(row.lengths).first(bones), std::span(row.flexDeg).first(bones)), row.size};
  }
  return all;
}

void addBones(Skeleton& skeleton, const std::array<Finger, 5>& fingers) {
  addCarpals(skeleton);
  addForearm(skeleton);
  for (int finger : {2, 1, 3, 4, 0}) {
    const auto& [joints, size] = fingers[std::size_t(finger)];
    auto metacarpal = std::uint16_t(kMetacarpal1 + finger);
    const Sizes& sizes = finger == 0 ? kFirstMetacarpal : kMetacarpal;
    addMetacarpal(skeleton, finger, boneBetween(metacarpal, joints[0], joints[1], sizes, size, 1.5f));
    std::uint16_t before = metacarpal;
    for (std::size_t bone = 1; bone + 1 < joints.size(); ++bone) {
      auto label = std::uint16_t(phalanx(finger) + bone - 1);
      bool isLast = bone + 2 == joints.size();
      const Sizes& ofPhalanx = kPhalanges[isLast ? 2 : bone - 1];
      float scale = finger == 0 && isLast ? 1.3f : size;
      skeleton.add(boneBetween(label, joints[bone], joints[bone + 1], ofPhalanx, scale, isLast ? 0.8f : 1.4f),
                   {before});
      before = label;
    }
  }
}

}  // namespace velum::io::hand
