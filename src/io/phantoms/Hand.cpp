#include "io/phantoms/Hand.h"

#include <algorithm>

namespace velum::io {

namespace hand {

namespace {

const Box kAll{at(85, -75, -60), at(-75, 40, 190)};
Box wholeBox() { return {glm::min(kAll.low, kAll.high), glm::max(kAll.low, kAll.high)}; }

/// Flesh around fingers, palm, thumb and wrist.
struct Outline {
  std::array<std::vector<Segment>, 5> fingers;
  std::vector<Segment> palm;
  float distance(Vec p) const {
    float d = distanceTo(palm, p, 9.0f);
    for (const auto& finger : fingers) d = smoothMin(d, distanceTo(finger, p, 0.0f), 5.0f);
    // The wrist: broad and flat.
    Vec q = p - at(0, 0, 0);
    float wrist =
        smoothMax(ellipse({q.x, q.y}, {0.0f, 0.5f}, {28.0f + 0.06f * q.z, 19.5f + 0.05f * q.z}), -q.z - 8.0f, 10.0f);
    return smoothMin(d, wrist, 16.0f);
  }
};

Outline outlineOf(const std::array<Finger, 5>& fingers) {
  Outline outline;
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    const auto& joints = fingers[i].joints;
    float size = fingers[i].size;
    std::vector<glm::vec4> path;
    for (std::size_t j = 1; j < joints.size(); ++j) {
      bool isTip = j + 1 == joints.size();
      float radius = (isTip ? 7.2f : 12.3f - 1.25f * float(j)) * (0.25f + 0.75f * size);
      Vec place = joints[j].place - joints[j].up * 0.9f - (isTip ? joints[j].along * 3.5f : Vec(0));
      path.emplace_back(place, radius);
    }
    outline.fingers[i] = tube(path, 4);
    if (i > 0)
      outline.palm.push_back({joints[0].place - joints[0].up * 2.2f, joints[1].place - joints[1].up * 2.0f, 14.0f,
                              13.6f * (0.3f + 0.7f * size)});
  }
  const auto& thumb = fingers[0].joints;
  outline.palm.push_back({thumb[0].place - thumb[0].up * 2.0f, thumb[1].place - thumb[1].up * 1.0f, 13.5f, 12.0f});
  outline.palm.push_back({at(15, -11, 22), at(30, -17, 48), 13.0f, 11.0f});  // the ball of the thumb
  outline.palm.push_back({at(-15, -9, 20), at(-20, -8, 62), 13.0f, 10.5f});  // and of the little finger
  outline.palm.push_back({at(27, -14, 44), at(20, -6, 72), 7.0f, 6.0f});     // the web between
  outline.palm.push_back({at(0, -2, 5), at(0, -4, 60), 17.0f, 13.0f});
  return outline;
}

void addMuscles(std::vector<Layer>& layers, const std::array<Finger, 5>& fingers) {
  std::vector<Segment> tubes;
  auto add = [&](std::vector<glm::vec4> path) { append(tubes, tube(path, 5)); };
  // The balls of thumb and little finger.
  add({at(13, -12, 20, 4), at(21, -15, 30, 9), at(30, -18, 44, 9), at(42, -22, 58, 4)});
  add({at(8, -13, 26, 3), at(19, -18, 36, 7), at(32, -22, 50, 6), at(43, -25, 60, 3)});
  add({at(-15, -11, 18, 4), at(-20, -10, 32, 8), at(-23, -9, 50, 8), at(-28, -8, 72, 4)});
  // From the third metacarpal to the thumb.
  for (float t : {0.2f, 0.4f, 0.6f, 0.8f})
    add({at(2, -6, 40 + 34 * t, 3.5f), at(18, -11, 46 + 24 * t, 4.5f), at(38, -17, 52 + 12 * t, 3.5f)});
  // Between the metacarpals.
  for (std::size_t i = 1; i < 4; ++i) {
    auto between = [&](float t, float radius) {
      Vec a = glm::mix(fingers[i].joints[0].place, fingers[i].joints[1].place, t);
      Vec b = glm::mix(fingers[i + 1].joints[0].place, fingers[i + 1].joints[1].place, t);
      return glm::vec4(0.5f * (a + b), radius);
    };
    add({between(0.2f, 3.2f), between(0.45f, 5.6f), between(0.75f, 4.8f), between(0.95f, 2.0f)});
  }
  add({at(18, -2, 36, 3), at(23, -4, 48, 6), at(18, 0, 66, 5), at(21, 0, 86, 2)});
  // Of the forearm: bellies that end above the wrist.
  for (auto [x, y] :
       {std::pair(-17.0f, -9.0f), {-8.0f, -10.0f}, {2.0f, -10.5f}, {11.0f, -9.0f}, {-4.0f, 10.0f}, {-13.0f, 9.0f}})
    add({at(x, y, -80, 6), at(x, y, -30, 5.2f), at(x, y, -12, 1.5f)});
  add({at(-14, -5, -30, 4), at(-2, -6.5f, -28, 4.5f), at(8, -6, -26, 4)});
  addFlesh(layers, kMuscle, kMuscleHu, std::move(tubes), {kFat});
}

void addTendons(std::vector<Layer>& layers, const std::array<Finger, 5>& fingers, float least) {
  std::vector<Segment> flexors, extensors;
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    const auto& joints = fingers[i].joints;
    float size = fingers[i].size, thick = std::max(2.0f * size, least), thin = std::max(1.2f * size, least);
    float side = float(i) - 2.0f;
    // Through the carpal tunnel, two above two, and the thumb's beside them.
    std::vector<glm::vec4> below{at(4 - 3 * side, -10, -75, thick), at(2.5f - 2.6f * side, -10.5f, -12, thick),
                                 at(2.5f - 2.4f * side, -11.5f - (i % 2 ? 2.5f : 0), 14, thick)};
    std::vector<glm::vec4> above{at(2 - 5 * side, 10, -75, thin), at(1 - 5 * side, 13, -6, thin)};
    if (i == 0) {
      below.push_back(at(15, -15.5f, 28, thick));
      above = {at(12, 11, -75, thin), at(12, 12.5f, -6, thin), at(21, 6, 16, thin)};
    } else {
      Vec middle = glm::mix(joints[0].place, joints[1].place, 0.5f);
      below.push_back({middle - joints[0].up * 9.5f, thick});
      above.push_back({middle + joints[0].up * 7.6f, thin});
    }
    const float under[] = {0, -10.0f, -8.0f, -6.0f, -4.0f}, over[] = {0, 9.0f, 6.1f, 5.2f, 4.0f};
    auto underneath = along(joints, under, thick * 0.85f), onTop = along(joints, over, thin);
    for (std::size_t j = 1; j + 1 < joints.size(); ++j) {
      below.push_back({Vec(joints[j].place) + (Vec(underneath[j]) - joints[j].place) * size, underneath[j].w});
      above.push_back({Vec(joints[j].place) + (Vec(onTop[j]) - joints[j].place) * size, onTop[j].w});
    }
    const Joint& last = joints[joints.size() - 2];
    below.push_back({last.place + last.along * 5.0f - last.up * 3.2f * size, thin});
    above.push_back({last.place + last.along * 4.0f + last.up * 4.2f * size, thin});
    append(flexors, tube(below, 6));
    append(extensors, tube(above, 6));
  }
  addFlesh(layers, kFlexors, kTendonHu, std::move(flexors), {kFat, kMuscle});
  addFlesh(layers, kExtensors, kTendonHu, std::move(extensors), {kFat, kMuscle});
}

/// To the tip along one side of a finger, from a place in the palm.
std::vector<glm::vec4> alongFinger(const Finger& finger, Vec from, float side, float radius) {
  const auto& joints = finger.joints;
  std::vector<glm::vec4> path{{from, radius * 1.25f}};
  for (std::size_t j = 1; j < joints.size(); ++j) {
    bool isTip = j + 1 == joints.size();
    Vec across = glm::cross(joints[j].along, joints[j].up);
    float out = (isTip ? 3.0f : 9.6f - 1.0f * float(j)) * (0.2f + 0.8f * finger.size);
    path.emplace_back(
        joints[j].place + across * side * out - joints[j].up * 3.2f - joints[j].along * (isTip ? 5.0f : 0.0f),
        radius * (isTip ? 0.8f : 1.0f));
  }
  return path;
}

/// @param blocked  distance to where vessels cannot be
void addVessels(std::vector<Layer>& layers, const std::array<Finger, 5>& fingers, const Distance& blocked,
                float least) {
  Layer artery{kArtery, kArteryHu}, vein{kVein, kVeinHu};
  auto arterial = [&](std::vector<glm::vec4> path) {
    for (auto& p : path) p.w = std::max(p.w, least);
    append(artery.tubes, tube(path, 6));
  };
  auto venous = [&](std::vector<glm::vec4> path) {
    for (auto& p : path) p.w = std::max(p.w, least);
    append(vein.tubes, tube(path, 6));
  };
  // The ulnar artery and its arch in the palm, below the tendons; the radial one joins it around the thumb's ball.
  arterial({at(-15, -12, -75, 1.7f), at(-14, -13, -10, 1.6f), at(-14, -18, 12, 1.5f), at(-14, -18, 34, 1.5f),
            at(-9, -17.5f, 52, 1.5f), at(2, -17, 60, 1.4f), at(12, -17, 56, 1.3f), at(20, -20, 44, 1.3f)});
  arterial({at(17, -11, -75, 1.7f), at(18, -12.5f, -10, 1.6f), at(20, -15, 6, 1.4f), at(20, -19, 28, 1.3f),
            at(20, -20, 44, 1.3f)});
  const Vec roots[] = {at(20, -20, 44), at(12, -17, 56), at(2, -17, 60), at(-9, -17.5f, 52), at(-14, -18, 34)};
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    arterial(alongFinger(fingers[i], roots[i], 1.0f, 0.95f));
    arterial(alongFinger(fingers[i], roots[i], -1.0f, 0.95f));
  }
  // Veins of the back: from between the fingers to an arch, and on to the forearm.
  const Vec arch[] = {at(22, 10, 62), at(12, 14.5f, 70), at(-2, 15.5f, 72), at(-14, 13.5f, 66), at(-22, 9.5f, 56)};
  venous({{arch[0], 1.3f}, {arch[1], 1.4f}, {arch[2], 1.4f}, {arch[3], 1.4f}, {arch[4], 1.3f}});
  venous({{arch[0], 1.4f}, at(21, 10, 40, 1.6f), at(22, 9, 15, 1.7f), at(22, 9.5f, -20, 1.8f), at(22, 9, -75, 1.9f)});
  venous({{arch[4], 1.3f}, at(-22, 9, 30, 1.5f), at(-23, 9, 0, 1.6f), at(-22, 10, -75, 1.7f)});
  for (std::size_t i = 1; i < 4; ++i) {
    Vec a = fingers[i].joints[1].place, b = fingers[i + 1].joints[1].place;
    Vec web = 0.5f * (a + b) + towards(0, 9, 2);
    venous({{arch[i], 1.2f}, {web, 1.1f}});
    const Joint& knuckle = fingers[i].joints[2];
    venous({{web, 1.1f}, {knuckle.place + knuckle.up * 7.0f * fingers[i].size, 1.0f}});
  }
  artery.onto = vein.onto = {kFat, kMuscle, kFlexors, kExtensors, kSkin, kCartilage};
  limb::addVessels(layers, std::move(artery), std::move(vein), blocked, least);
}

std::vector<LabelInfo> partTable() {
  std::vector<LabelInfo> table{{kSkin, "skin", {0.93f, 0.74f, 0.62f}, 0.15f},
                               {kFat, "subcutaneous fat", {0.96f, 0.86f, 0.55f}, 0.1f},
                               {kMuscle, "muscle", {0.70f, 0.28f, 0.24f}, 0.5f},
                               {kFlexors, "flexor tendons", {0.86f, 0.90f, 0.92f}},
                               {kExtensors, "extensor tendons", {0.74f, 0.84f, 0.90f}},
                               {kArtery, "artery", {0.85f, 0.14f, 0.12f}},
                               {kVein, "vein", {0.25f, 0.40f, 0.78f}},
                               {kCartilage, "cartilage", {0.62f, 0.84f, 0.88f}}};
  constexpr const char* kNames[] = {"radius",   "ulna",      "scaphoid",  "lunate",   "triquetrum",
                                    "pisiform", "trapezium", "trapezoid", "capitate", "hamate"};
  constexpr const char* kFingers[] = {"thumb", "index finger", "middle finger", "ring finger", "little finger"};
  addBoneNames(table, kRadius, kNames, "metacarpal", kFingers);
  return table;
}

}  // namespace

}  // namespace hand

/// A CT angiography of a right hand, in Hounsfield units.
Sample makeHand(int size, Progress& progress) {
  using namespace hand;
  constexpr float kWidthMm = 132.0f, kDepthMm = 108.0f, kHeightMm = 216.0f, kGapMm = 1.5f;
  float spacing = kHeightMm / float(size);
  auto voxels = [&](float mm) { return std::max(1, int(mm / spacing + 0.5f)); };
  Grid grid{{voxels(kWidthMm), voxels(kDepthMm), size}, Vec(spacing)};
  auto all = fingers();
  Skeleton skeleton(kGapMm);
  addBones(skeleton, all);
  Outline outline = outlineOf(all);
  auto layers = layersOf(
      {wholeBox(), [&outline](Vec p) { return outline.distance(p); }, kSkin, kFat, kCartilage, spacing}, skeleton,
      [&all](std::vector<Layer>& to, float least) {
        addMuscles(to, all);
        addTendons(to, all, least);
      },
      [&all](std::vector<Layer>& to, const Distance& blocked, float least) { addVessels(to, all, blocked, least); });
  Description description{"hand", SampleType::Int16, Modality::CT, "HU", partTable()};
  return scan(description, grid, layers, 0x4a2d, progress);
}

}  // namespace velum::io
