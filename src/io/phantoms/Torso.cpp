#include "io/phantoms/Torso.h"

#include <algorithm>

namespace velum::io {

namespace torso {

namespace {

using Knots = glm::vec2[];

/// A rounded square: an ellipse that bulges towards its corners, as a trunk's section does.
float trunkSection(glm::vec2 p, glm::vec2 radii, float bulge) {
  glm::vec2 q = p / radii, q2 = q * q;
  float f = std::sqrt(std::sqrt(q2.x * q2.x + q2.y * q2.y + 2.0f * (1.0f - bulge) * q2.x * q2.y));
  if (f < 1e-3f) return -std::min(radii.x, radii.y);
  return std::max(glm::length(p) * (1.0f - 1.0f / f), -std::min(radii.x, radii.y));
}

float fatThickness(Vec p) {
  float belly = smoothStep(40.0f, -60.0f, p.z);
  return 8.0f + belly * (5.0f + 5.0f * smoothStep(20.0f, -60.0f, p.y)) + 1.5f * noise(p / 40.0f, 91);
}

Layer everywhere(std::uint16_t label, float value, Distance distance) {
  Layer layer{label, value};
  layer.solids.push_back({kEverywhere, std::move(distance)});
  return layer;
}

}  // namespace

std::vector<LabelInfo> partTable() {
  const glm::vec3 bone(0.93f, 0.88f, 0.76f), blood(0.85f, 0.14f, 0.12f), vein(0.25f, 0.40f, 0.78f);
  return {{kSkin, "skin", {0.93f, 0.74f, 0.62f}, 0.2f},
          {kFat, "subcutaneous fat", {0.96f, 0.86f, 0.55f}, 0.1f},
          {kMuscle, "muscle", {0.70f, 0.28f, 0.24f}, 0.4f},
          {kVisceralFat, "visceral fat", {0.98f, 0.90f, 0.60f}, 0.05f},
          {kRibsLeft, "ribs left", bone},
          {kRibsRight, "ribs right", bone},
          {kCartilage, "costal cartilage", {0.72f, 0.84f, 0.88f}},
          {kSternum, "sternum", bone * 0.97f},
          {kVertebrae, "vertebrae", bone * 0.94f},
          {kDiscs, "intervertebral discs", {0.58f, 0.74f, 0.80f}},
          {kSacrum, "sacrum", bone * 0.92f},
          {kHips, "hip bones", bone * 0.96f},
          {kScapulae, "scapulae", bone * 0.95f},
          {kClavicles, "clavicles", bone},
          {kHumeri, "humeri", bone},
          {kSpinalCanal, "spinal canal", {0.95f, 0.95f, 0.55f}},
          {kLungLeft, "lung left", {0.93f, 0.66f, 0.66f}, 0.3f},
          {kLungRight, "lung right", {0.90f, 0.60f, 0.62f}, 0.3f},
          {kAirways, "trachea and bronchi", {0.60f, 0.85f, 0.92f}},
          {kLungVessels, "pulmonary vessels", {0.55f, 0.35f, 0.75f}},
          {kPulmonaryArtery, "pulmonary artery", {0.35f, 0.35f, 0.80f}},
          {kHeartMuscle, "heart muscle", {0.72f, 0.22f, 0.22f}},
          {kLeftVentricle, "left ventricle", {0.90f, 0.25f, 0.22f}},
          {kRightVentricle, "right ventricle", {0.40f, 0.45f, 0.85f}},
          {kLeftAtrium, "left atrium", {0.95f, 0.45f, 0.40f}},
          {kRightAtrium, "right atrium", {0.50f, 0.60f, 0.90f}},
          {kAorta, "aorta", blood},
          {kArteries, "arteries", blood * 0.9f},
          {kVenaCava, "vena cava", vein},
          {kPortalVein, "portal and hepatic veins", {0.35f, 0.55f, 0.75f}},
          {kLiver, "liver", {0.58f, 0.25f, 0.18f}},
          {kGallbladder, "gallbladder", {0.45f, 0.65f, 0.25f}},
          {kKidneyLeft, "kidney left", {0.75f, 0.35f, 0.28f}},
          {kKidneyRight, "kidney right", {0.72f, 0.32f, 0.26f}},
          {kMedulla, "renal medulla", {0.88f, 0.55f, 0.42f}},
          {kSpleen, "spleen", {0.52f, 0.20f, 0.35f}},
          {kPancreas, "pancreas", {0.92f, 0.76f, 0.48f}},
          {kStomach, "stomach", {0.88f, 0.60f, 0.55f}},
          {kGas, "gas", {0.75f, 0.85f, 0.90f}, 0.2f},
          {kSmallBowel, "small bowel", {0.90f, 0.66f, 0.52f}},
          {kColon, "colon", {0.78f, 0.55f, 0.42f}},
          {kOesophagus, "oesophagus", {0.80f, 0.55f, 0.50f}}};
}

float spineY(float z) {
  // Kyphosis of the chest, lordosis of the loins, and the sacrum's backward turn.
  static constexpr Knots kY = {{-240, 74}, {-205, 62}, {-170, 42}, {-125, 34}, {-60, 41}, {0, 52},
                               {70, 60},   {125, 54},  {170, 40},  {205, 26},  {240, 16}};
  return curve(kY, z);
}

float skinDistance(Vec p) {
  static constexpr Knots kWidth = {{-224, 174}, {-160, 162}, {-95, 149}, {-20, 152},
                                   {60, 161},   {125, 170},  {180, 174}, {224, 166}};
  static constexpr Knots kDepth = {{-224, 114}, {-150, 107}, {-90, 103}, {0, 112},
                                   {80, 116},   {140, 108},  {180, 92},  {224, 66}};
  float d = trunkSection({p.x, p.y}, {curve(kWidth, p.z), curve(kDepth, p.z)}, 0.22f);
  // The furrow over the spine, and the navel.
  if (p.y > 0.0f) d += 7.0f * std::exp(-p.x * p.x / 500.0f);
  Vec navel = p - Vec(0.0f, -104.0f, -118.0f);
  return d + 9.0f * std::exp(-glm::dot(navel, navel) / 90.0f);
}

glm::vec3 cageEllipse(float z) {
  static constexpr Knots kWidth = {{-224, 92}, {-180, 112}, {-140, 125}, {-90, 123}, {-30, 125}, {40, 127},
                                   {95, 117},  {135, 99},   {165, 76},   {188, 52},  {206, 30}};
  static constexpr Knots kDepth = {{-224, 62}, {-150, 66}, {-90, 67}, {-30, 74}, {20, 82},
                                   {80, 84},   {120, 77},  {155, 62}, {188, 42}, {206, 26}};
  static constexpr Knots kMiddle = {{-224, -18}, {-120, -14}, {-60, -10}, {0, 0},
                                    {60, 2},     {120, 4},    {188, 4},   {206, 8}};
  return {curve(kWidth, z), curve(kDepth, z), curve(kMiddle, z)};
}

glm::vec2 onCage(float z, float angle, float outMm) {
  glm::vec3 e = cageEllipse(z);
  return {(e.x + outMm) * std::sin(angle), e.z + (e.y + outMm) * std::cos(angle)};
}

float cavityDistance(Vec p) {
  glm::vec3 e = cageEllipse(p.z);
  return smoothMax(trunkSection({p.x, p.y - e.z}, {e.x, e.y}, 0.12f), p.z - 194.0f, 30.0f);
}

float diaphragmZ(float x, float y) {
  auto dome = [&](float side, float top) {
    // Steep towards the chest wall, gentle towards the central tendon.
    float u = (x - side * 62.0f) / (side * x < 62.0f ? 125.0f : 74.0f), v = (y + 4.0f) / 86.0f,
          q = std::min(u * u + v * v, 2.0f);
    return top - 24.0f * q - 32.0f * q * q;
  };
  return -smoothMin(-dome(-1.0f, 16.0f), -dome(1.0f, 4.0f), 22.0f);
}

float bellyDistance(Vec p) { return smoothMax(cavityDistance(p), 0.7f * (p.z - diaphragmZ(p.x, p.y)), 6.0f); }

float lungDistance(Vec p, float side) {
  // The mediastinum: a pillar from breastbone to spine, widest where the great vessels leave the heart.
  static constexpr Knots kHalfWidth = {{-60, 24}, {40, 24}, {90, 30}, {135, 32}, {165, 30}, {200, 34}};
  float pillar = ellipse({p.x, p.y}, {2.0f, 4.0f}, {curve(kHalfWidth, p.z), 48.0f});
  float septum = std::max(std::abs(p.x - 3.0f) - 6.0f, p.y);
  pillar = smoothMin(pillar, septum, 22.0f);
  float spine = glm::length(glm::vec2(p.x, p.y - spineY(p.z) - 4.0f)) - 25.0f;
  float inside = smoothMax(cavityDistance(p) + 3.0f, 0.7f * (diaphragmZ(p.x, p.y) + 3.0f - p.z), 5.0f);
  inside = smoothMax(inside, -smoothMin(pillar, spine, 14.0f), 7.0f);
  return smoothMax(inside, 4.0f - side * p.x, 4.0f);
}

void addBodyWall(std::vector<Layer>& layers) {
  Layer skin = everywhere(kSkin, 40.0f, skinDistance);
  skin.edge = 1.7f;  // wide and even: each voxel would be seen
  layers.push_back(skin);
  layers.push_back(everywhere(kFat, -100.0f, [](Vec p) { return skinDistance(p) + 2.6f; }));
  Layer muscle = everywhere(kMuscle, 55.0f, [](Vec p) { return skinDistance(p) + 2.6f + fatThickness(p); });
  muscle.texture = [](Vec p) { return 7.0f * noise(p / Vec(7.0f, 7.0f, 22.0f), 31); };
  layers.push_back(muscle);

  // Fat between the muscles: two sheets that part the back muscles and the layers of the flank.
  Layer septa{kFat, -90.0f};
  septa.solids.push_back({kEverywhere, [](Vec p) {
                            float wall = std::max(-cavityDistance(p) + 9.0f, skinDistance(p) + 14.0f);
                            float sheet = std::abs(cavityDistance(p) - 13.0f + 3.0f * noise(p / 26.0f, 47)) - 0.7f;
                            float gap = 2.6f - 5.0f * std::abs(noise(p / 34.0f, 53));
                            return smoothMax(smoothMax(sheet, wall, 2.0f), -gap, 2.0f);
                          }});
  layers.push_back(septa);

  Layer inner = everywhere(kVisceralFat, -95.0f, cavityDistance);
  inner.texture = [](Vec p) { return 6.0f * noise(p / 6.0f, 37); };
  layers.push_back(inner);
  layers.push_back(everywhere(kMuscle, 50.0f, [](Vec p) {  // the diaphragm
    return smoothMax(0.75f * std::abs(p.z - diaphragmZ(p.x, p.y)) - 1.7f, cavityDistance(p), 3.0f);
  }));

  // Psoas and the crura beside the lumbar spine.
  Layer psoas{kMuscle, 60.0f};
  for (float side : {-1.0f, 1.0f}) {
    auto at = [&](float x, float z, float dy, float r) { return glm::vec4(side * x, spineY(z) + dy, z, r); };
    glm::vec4 path[] = {at(23, -20, -2, 6),   at(31, -55, 0, 13),    at(37, -95, 0, 17),
                        at(42, -135, -2, 19), at(52, -180, -22, 18), at(66, -228, -52, 17)};
    append(psoas.tubes, tube(path));
    glm::vec4 crus[] = {at(10, 10, -16, 3), at(15, -20, -17, 5), at(14, -60, -18, 4)};
    append(psoas.tubes, tube(crus));
  }
  layers.push_back(psoas);
}

}  // namespace torso

/// A contrast-enhanced CT of chest and belly, in Hounsfield units.
Sample makeTorso(int size, Progress& progress) {
  using namespace torso;
  constexpr float kWidthMm = 400.0f, kDepthMm = 272.0f, kHeightMm = 448.0f, kNoiseHu = 12.0f;
  float across = kWidthMm / float(size);
  Grid grid{{size, std::max(1, int(kDepthMm / across + 0.5f)), size}, Vec(across, across, kHeightMm / float(size))};

  std::vector<Layer> layers;
  addBodyWall(layers);
  addLungs(layers, across);
  addHeart(layers);
  addBowel(layers);
  addBellyOrgans(layers, across);
  addGreatVessels(layers);
  addBones(layers);

  Description description{"torso", SampleType::Int16, Modality::CT, "HU", partTable()};
  return fill(description, grid, progress, [&](const Slice& slice) {
    std::fill(slice.values.begin(), slice.values.end(), -1000.0f);
    paint(slice, layers);
    std::uint64_t first = grid.index(0, 0, slice.z);
    for (std::size_t i = 0; i < slice.values.size(); ++i) {
      float hu = slice.values[i] + kNoiseHu * gaussian(hash(0xc7, first + i));
      slice.values[i] = std::max(hu, -1024.0f);  // As scanners clip.
    }
  });
}

}  // namespace velum::io
