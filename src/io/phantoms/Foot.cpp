#include "io/phantoms/Foot.h"

#include <algorithm>

namespace velum::io {

namespace foot {

namespace {

const Box kAll{Vec(-70, -150, -75), Vec(70, 150, 80)};

/// Flesh around leg, heel, sole and toes.
struct Outline {
  std::vector<Segment> body;
  std::array<std::vector<Segment>, 5> toes;
  float distance(Vec p) const {
    float d = distanceTo(body, p, 12.0f);
    for (const auto& toe : toes) d = smoothMin(d, distanceTo(toe, p, 0.0f), 4.0f);
    // The leg, and the flat ground.
    Vec q = p - at(-2, -14, 0);
    float leg =
        smoothMax(ellipse({q.x, q.y}, {0.0f, 0.0f}, {36.0f + 0.04f * (q.z - 80.0f), 40.0f}), 62.0f - q.z, 20.0f);
    return smoothMax(smoothMin(d, leg, 22.0f), -q.z, 7.0f);
  }
};

Outline outlineOf(const std::array<Toe, 5>& toes) {
  Outline outline;
  for (std::size_t i = 0; i < toes.size(); ++i) {
    const auto& joints = toes[i].joints;
    std::vector<glm::vec4> path;
    for (std::size_t j = 1; j < joints.size(); ++j) {
      bool isTip = j + 1 == joints.size();
      float radius =
          i == 0 ? (isTip ? 10.0f : 13.5f - 1.2f * float(j)) : (isTip ? 6.8f : 10.8f - 0.8f * float(j)) * toes[i].size;
      path.emplace_back(joints[j].place - joints[j].up * 0.5f - (isTip ? joints[j].along * 5.0f : Vec(0)), radius);
    }
    outline.toes[i] = tube(path, 4);
    float width = i == 0 ? 16.5f : 13.2f;
    outline.body.push_back({joints[0].place + towards(0, 0, i == 0 ? -4.0f : -2.0f),
                            joints[1].place + towards(0, 0, -1), width + 3.0f, width});
  }
  outline.body.push_back({at(-3, -48, 24), at(-8, -6, 30), 22.0f, 23.0f});
  outline.body.push_back({at(-8, -6, 30), at(-16, 50, 24), 23.0f, 19.0f});
  outline.body.push_back({at(-16, 50, 24), at(-30, 108, 14), 18.0f, 13.0f});
  outline.body.push_back({at(4, 10, 62), at(12, 55, 50), 25.0f, 19.0f});
  outline.body.push_back({at(18, 15, 52), at(21, 58, 46), 15.0f, 17.0f});
  outline.body.push_back({at(0, -20, 55), at(0, -8, 90), 28.0f, 30.0f});
  return outline;
}

void addMuscles(std::vector<Layer>& layers, const std::array<Toe, 5>& toes) {
  std::vector<Segment> tubes;
  auto add = [&](std::vector<glm::vec4> path) { append(tubes, tube(path, 5)); };
  // Three bellies of the sole, two above them.
  add({at(8, -48, 16, 3), at(20, -10, 20, 9), at(27, 40, 22, 9), at(28, 100, 13, 4)});
  add({at(-4, -48, 14, 4), at(-4, -10, 14, 9), at(-4, 40, 18, 8), at(-4, 92, 13, 4)});
  add({at(-14, -46, 14, 3), at(-22, -8, 14, 8), at(-30, 40, 14, 7), at(-34, 96, 10, 4)});
  add({at(2, -20, 24, 3), at(4, 15, 26, 8), at(2, 55, 26, 6), at(2, 80, 20, 3)});
  add({at(14, 60, 26, 3), at(20, 85, 20, 7), at(22, 112, 13, 4)});
  // Between the metatarsals, and on the back of the foot.
  for (std::size_t i = 0; i < 4; ++i) {
    auto between = [&](float t, float radius) {
      return glm::vec4(0.5f * (glm::mix(toes[i].joints[0].place, toes[i].joints[1].place, t) +
                               glm::mix(toes[i + 1].joints[0].place, toes[i + 1].joints[1].place, t)),
                       radius);
    };
    add({between(0.15f, 2.5f), between(0.45f, 5.0f), between(0.8f, 3.5f), between(0.97f, 1.5f)});
  }
  add({at(-12, 22, 50, 4), at(-12, 45, 53, 6), at(-8, 75, 50, 3)});
  // Of the leg: bellies that end above the ankle.
  add({at(2, 16, 170, 10), at(0, 17, 120, 8), at(0, 18, 95, 2)});
  add({at(-18, 10, 170, 8), at(-16, 12, 120, 6), at(-14, 14, 92, 2)});
  add({at(6, -26, 170, 13), at(10, -24, 120, 9), at(14, -20, 90, 3)});
  add({at(-14, -28, 170, 12), at(-10, -26, 115, 9), at(-4, -24, 84, 3)});
  add({at(-30, -14, 170, 7), at(-30, -16, 120, 6), at(-29, -18, 90, 2)});
  addFlesh(layers, kMuscle, kMuscleHu, std::move(tubes), {kFat});
}

void addTendons(std::vector<Layer>& layers, const std::array<Toe, 5>& toes, float least) {
  std::vector<Segment> extensors, flexors;
  for (std::size_t i = 0; i < toes.size(); ++i) {
    const auto& joints = toes[i].joints;
    float thick = std::max(i == 0 ? 2.2f : 1.5f, least), side = float(i);
    std::vector<glm::vec4> above{at(8 - 5 * side, 20, 170, thick), at(7 - 4.5f * side, 24, 86, thick),
                                 at(9 - 6 * side, 42, 76, thick)};
    std::vector<glm::vec4> below{at(20 - 3 * side, -24, 170, thick), at(22 - 2 * side, -20, 74, thick),
                                 at(20 - 2 * side, -2, 38, thick), at(12 - 3 * side, 40, 24, thick)};
    float size = i == 0 ? 1.5f : toes[i].size;
    Vec middle = glm::mix(joints[0].place, joints[1].place, 0.5f);
    above.push_back({middle + joints[0].up * (i == 0 ? 12.0f : 9.0f), thick});
    below.push_back({middle - joints[0].up * (i == 0 ? 14.0f : 11.0f), thick});
    const float over[] = {0, 8.2f, 6.2f, 5.0f, 4.0f}, under[] = {0, -9.5f, -6.6f, -5.4f, -4.0f};
    auto onTop = along(joints, over, thick * 0.85f), underneath = along(joints, under, thick * 0.85f);
    for (std::size_t j = 1; j + 1 < joints.size(); ++j) {
      above.push_back({joints[j].place + (Vec(onTop[j]) - joints[j].place) * size, onTop[j].w});
      below.push_back({joints[j].place + (Vec(underneath[j]) - joints[j].place) * size, underneath[j].w});
    }
    append(extensors, tube(above, 6));
    append(flexors, tube(below, 6));
  }
  // Of the front of the leg to the inner side of the foot, and of its outer side to the fifth metatarsal.
  glm::vec4 tibialis[] = {at(14, 16, 170, 3.4f), at(16, 22, 88, 3.2f), at(24, 42, 68, 3), at(32, 62, 46, 2.6f)};
  glm::vec4 peroneus[] = {at(-32, -18, 170, 2.6f), at(-32, -20, 80, 2.6f), at(-32, -6, 46, 2.4f), at(-36, 30, 28, 2.2f),
                          at(-39, 50, 25, 2.0f)};
  append(extensors, tube(tibialis));
  append(extensors, tube(peroneus));
  addFlesh(layers, kExtensors, kTendonHu, std::move(extensors), {kFat, kMuscle});
  addFlesh(layers, kFlexors, kTendonHu, std::move(flexors), {kFat, kMuscle});
  std::vector<Segment> achilles;
  for (float x : {-8.0f, -3.5f, 1.0f, 5.5f}) {  // flat: several strands
    glm::vec4 strand[] = {at(x * 1.5f, -44, 190, 4), at(x, -46, 110, 3.4f), at(x, -52, 70, 3.4f),
                          at(x * 1.3f, -61, 36, 3.4f), at(x * 1.3f, -64, 22, 2.6f)};
    append(achilles, tube(strand));
  }
  addFlesh(layers, kAchilles, kTendonHu, std::move(achilles), {kFat, kMuscle});
}

/// @param blocked  distance to where vessels cannot be
void addVessels(std::vector<Layer>& layers, const std::array<Toe, 5>& toes, const Distance& blocked, float least) {
  Layer artery{kArtery, kArteryHu}, vein{kVein, kVeinHu};
  auto add = [least](Layer& layer, std::vector<glm::vec4> path) {
    for (auto& p : path) p.w = std::max(p.w, least);
    append(layer.tubes, tube(path, 6));
  };
  // The dorsal artery of the foot, which dives between the first two metatarsals; its arch and branches to the toes.
  add(artery, {at(-4, 22, 190, 1.8f), at(-1, 25, 90, 1.7f), at(1, 44, 76, 1.6f), at(14, 68, 68, 1.5f)});
  add(artery, {at(14, 68, 68, 1.5f), at(13.5f, 80, 60, 1.4f), at(14.2f, 93, 47, 1.4f), at(14.2f, 96, 32, 1.3f),
               at(6, 90, 26, 1.3f), at(-8, 84, 25, 1.3f), at(-22, 74, 22, 1.2f)});
  // The tibial artery behind the inner ankle, to the sole and that arch.
  add(artery, {at(12, -30, 190, 1.9f), at(22, -25, 84, 1.8f), at(22, -8, 44, 1.6f), at(10, 12, 26, 1.5f),
               at(-10, 45, 24, 1.4f), at(-22, 74, 22, 1.2f)});
  const Vec roots[] = {at(14.2f, 96, 32), at(6, 90, 26), at(-8, 84, 25), at(-22, 74, 22)};
  for (std::size_t i = 0; i < 4; ++i) {
    Vec web = 0.5f * (toes[i].joints[1].place + toes[i + 1].joints[1].place) + towards(0, 4, -6);
    add(artery, {{roots[i], 1.2f}, {web, 1.1f}});
    for (auto [toe, side] : {std::pair(i, 1.0f), {i + 1, -1.0f}}) {
      const auto& joints = toes[toe].joints;
      std::vector<glm::vec4> path{{web, 1.1f}};
      for (std::size_t j = 2; j < joints.size(); ++j) {
        bool isTip = j + 1 == joints.size();
        // Of a right foot's toe, to the little toe's side.
        Vec outward = glm::normalize(glm::cross(joints[j].along, joints[j].up));
        if (outward.x > 0.0f) outward = -outward;
        float out = (isTip ? 3.0f : 7.4f) * (toe == 0 ? 1.5f : toes[toe].size);
        path.emplace_back(
            joints[j].place + outward * side * out - joints[j].up * 2.5f - joints[j].along * (isTip ? 5.0f : 0.0f),
            0.9f);
      }
      add(artery, path);
    }
  }
  // The great saphenous vein in front of the inner ankle, and the arch on the back of the foot.
  add(vein,
      {at(26, 2, 190, 2.2f), at(26, 12, 90, 2.1f), at(26, 36, 66, 1.9f), at(23, 68, 63, 1.7f), at(22, 104, 38, 1.6f),
       at(8, 110, 38.5f, 1.5f), at(-6, 107, 36, 1.5f), at(-22, 95, 31, 1.5f), at(-31, 60, 33, 1.6f),
       at(-22, 12, 43, 1.7f), at(-23, -26, 66, 1.8f), at(-22, -36, 100, 1.9f), at(-17, -42, 190, 2.0f)});
  artery.onto = vein.onto = {kFat, kMuscle, kExtensors, kFlexors, kSkin, kCartilage};
  limb::addVessels(layers, std::move(artery), std::move(vein), blocked, least);
}

std::vector<LabelInfo> partTable() {
  std::vector<LabelInfo> table{{kSkin, "skin", {0.93f, 0.74f, 0.62f}, 0.15f},
                               {kFat, "subcutaneous fat", {0.96f, 0.86f, 0.55f}, 0.1f},
                               {kMuscle, "muscle", {0.70f, 0.28f, 0.24f}, 0.5f},
                               {kAchilles, "Achilles tendon", {0.92f, 0.93f, 0.90f}},
                               {kExtensors, "extensor tendons", {0.74f, 0.84f, 0.90f}},
                               {kFlexors, "flexor tendons", {0.86f, 0.90f, 0.92f}},
                               {kArtery, "artery", {0.85f, 0.14f, 0.12f}},
                               {kVein, "vein", {0.25f, 0.40f, 0.78f}},
                               {kCartilage, "cartilage", {0.62f, 0.84f, 0.88f}}};
  constexpr const char* kNames[] = {"tibia",
                                    "fibula",
                                    "talus",
                                    "calcaneus",
                                    "navicular",
                                    "cuboid",
                                    "medial cuneiform",
                                    "intermediate cuneiform",
                                    "lateral cuneiform"};
  constexpr const char* kToes[] = {"great toe", "second toe", "third toe", "fourth toe", "fifth toe"};
  addBoneNames(table, kTibia, kNames, "metatarsal", kToes);
  return table;
}

}  // namespace

}  // namespace foot

/// A CT angiography of a right foot with its ankle, in Hounsfield units.
Sample makeFoot(int size, Progress& progress) {
  using namespace foot;
  constexpr float kWidthMm = 112.0f, kLengthMm = 272.0f, kHeightMm = 138.0f, kGapMm = 1.7f;
  float spacing = kLengthMm / float(size);
  auto voxels = [&](float mm) { return std::max(1, int(mm / spacing + 0.5f)); };
  Grid grid{{voxels(kWidthMm), size, voxels(kHeightMm)}, Vec(spacing)};
  auto all = toes();
  Skeleton skeleton(kGapMm);
  addBones(skeleton, all);
  Outline outline = outlineOf(all);
  auto layers = layersOf(
      {kAll, [&outline](Vec p) { return outline.distance(p); }, kSkin, kFat, kCartilage, spacing}, skeleton,
      [&all](std::vector<Layer>& to, float least) {
        addMuscles(to, all);
        addTendons(to, all, least);
      },
      [&all](std::vector<Layer>& to, const Distance& blocked, float least) { addVessels(to, all, blocked, least); });
  Description description{"foot", SampleType::Int16, Modality::CT, "HU", partTable()};
  return scan(description, grid, layers, 0xf007, progress);
}

}  // namespace velum::io
