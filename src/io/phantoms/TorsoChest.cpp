#include <algorithm>

#include "io/phantoms/Torso.h"
#include "io/phantoms/Tree.h"

namespace velum::io::torso {

namespace {

std::vector<Segment> growInLung(float side, Vec root, float radius, float least, float pitch, std::uint64_t seed) {
  auto lung = [side](Vec p) { return lungDistance(p, side); };
  Box box{Vec(side > 0 ? 0 : -135, -95, -70), Vec(side > 0 ? 135 : 0, 95, 195)};
  TreeOptions options;
  options.root = root;
  options.direction = glm::normalize(Vec(side, 0.0f, -0.15f));
  options.rootRadiusMm = radius;
  options.leastRadiusMm = least;
  options.seed = seed;
  return segments(growTree(scatter(box, pitch, lung, 4.0f, seed), options));
}

/// Vessels first, then the airways with their walls, on lung tissue only: the roots are painted with the heart.
void addLungTrees(std::vector<Layer>& layers, float spacing) {
  float least = std::max(0.9f, 0.55f * spacing);
  Layer vessels{kLungVessels, 230.0f}, walls{kKeepLabel, -150.0f}, lumen{kAirways, -990.0f};
  vessels.onto = {kLungLeft, kLungRight};
  walls.onto = {kLungLeft, kLungRight};
  for (float side : {-1.0f, 1.0f}) {
    std::uint64_t seed = side > 0 ? 100 : 200;
    append(vessels.tubes, growInLung(side, Vec(side * 26.0f, 4.0f, 84.0f), 8.5f, least, 17.0f, seed));
    append(vessels.tubes, growInLung(side, Vec(side * 22.0f, 16.0f, 60.0f), 7.0f, least, 21.0f, seed + 1));
    append(lumen.tubes, growInLung(side, Vec(side * 30.0f, 18.0f, 86.0f), 5.6f, 1.1f, 36.0f, seed + 2));
  }
  glm::vec4 trachea[] = {{0, 6, 240, 8.5f}, {0, 8, 200, 8.5f}, {1, 14, 150, 8.5f}, {2, 18, 108, 8.5f}, {1, 18, 101, 8}};
  glm::vec4 right[] = {{1, 18, 106, 7.5f}, {-12, 19, 97, 7}, {-30, 18, 86, 5.8f}};
  glm::vec4 left[] = {{2, 18, 106, 7}, {16, 20, 96, 6.4f}, {30, 18, 86, 5.8f}};
  append(lumen.tubes, tube(trachea));
  append(lumen.tubes, tube(right));
  append(lumen.tubes, tube(left));
  walls.tubes = lumen.tubes;
  for (auto& s : walls.tubes) s.radiusA += 1.2f, s.radiusB += 1.2f;
  layers.push_back(vessels);
  layers.push_back(walls);
  layers.push_back(lumen);
}

/// An ellipsoid with its own axis.
struct Egg {
  Vec centre, axis;
  float half, across;  ///< Half length along the axis and half width, mm.
  float operator()(Vec p, float growMm = 0.0f) const {
    Vec q = p - centre;
    float along = glm::dot(q, axis), away = glm::length(q - along * axis);
    return ellipse({along, away}, {0, 0}, {half + growMm, across + growMm});
  }
};

const Vec kHeartAxis = glm::normalize(Vec(0.66f, -0.58f, -0.48f));  // base to apex: left, forward, down
const Egg kLeftOuter{Vec(33, -32, 36), kHeartAxis, 48.0f, 33.0f};
const Egg kLeftInner{Vec(29, -28, 39), kHeartAxis, 39.0f, 21.0f};

/// Inner surfaces of the chambers; `grow` gives the walls. They keep apart by walls of their own thickness.
float rightVentricle(Vec p, float grow) {
  float body = ellipsoid(p, Vec(0, -50, 34), Vec(36 + grow, 27 + grow, 29 + grow));
  float outflow = distance({Vec(6, -52, 45), Vec(14, -50, 78), 19 + grow, 12 + grow}, p);
  return smoothMax(smoothMin(body, outflow, 12.0f), -kLeftOuter(p, 0.0f), 4.0f);
}
float rightAtrium(Vec p, float grow) { return ellipsoid(p, Vec(-33, -22, 46), Vec(22 + grow, 25 + grow, 29 + grow)); }
float leftAtrium(Vec p, float grow) {
  float body = ellipsoid(p, Vec(2, 12, 58), Vec(30 + grow, 17 + grow, 21 + grow));
  float veins = 1e3f;
  for (float side : {-1.0f, 1.0f})
    for (float z : {50.0f, 66.0f})
      veins = std::min(veins, distance({Vec(side * 14, 14, z), Vec(side * 34, 18, z), 7 + grow, 5.5f + grow}, p));
  return smoothMin(body, veins, 6.0f);
}
float heartOuter(Vec p) {
  float v = smoothMin(kLeftOuter(p), rightVentricle(p, 4.0f), 8.0f);
  return smoothMin(smoothMin(v, rightAtrium(p, 2.5f), 10.0f), leftAtrium(p, 2.5f), 8.0f);
}

Layer solidLayer(std::uint16_t label, float value, Box box, Distance distance) {
  Layer layer{label, value};
  layer.solids.push_back({box, std::move(distance)});
  return layer;
}

Layer tubeLayer(std::uint16_t label, float value, std::initializer_list<std::vector<glm::vec4>> paths) {
  Layer layer{label, value};
  for (const auto& path : paths) append(layer.tubes, tube(path));
  return layer;
}

/// A point in front of the spine: `dx` to the left of its middle, at `gapMm` in front of the vertebra.
glm::vec4 beforeSpine(float dx, float z, float gapMm, float radius) {
  return {dx, spineY(z) - 17.0f - gapMm - radius, z, radius};
}

}  // namespace

void addLungs(std::vector<Layer>& layers, float spacing) {
  for (float side : {-1.0f, 1.0f}) {
    Layer lung = solidLayer(side > 0 ? kLungLeft : kLungRight, -850.0f, kEverywhere,
                            [side](Vec p) { return lungDistance(p, side); });
    // Denser towards the back, where a lying patient's lung is pressed by its own weight.
    // The oblique fissure is a thin sheet that falls forward.
    lung.texture = [](Vec p) {
      float fissure = std::abs(p.z - 62.0f - 0.85f * p.y + 5.0f * noise(p / 40.0f, 71));
      return 0.35f * p.y + 14.0f * roughNoise(p / 5.0f, 67) + 110.0f * smoothStep(1.6f, 0.4f, fissure * 0.75f);
    };
    layers.push_back(lung);
  }
  addLungTrees(layers, spacing);
}

void addHeart(std::vector<Layer>& layers) {
  Box box{Vec(-75, -100, -25), Vec(95, 50, 110)};
  // The pericardial fat clears a bed in the lungs and rests on the diaphragm.
  auto bed = solidLayer(kVisceralFat, -95.0f, box, [](Vec p) {
    return smoothMax(smoothMax(heartOuter(p) - 4.0f, cavityDistance(p) + 1.0f, 5.0f),
                     0.7f * (diaphragmZ(p.x, p.y) - p.z), 4.0f);
  });
  auto above = [](Distance d) {
    return [d = std::move(d)](Vec p) {
      return smoothMax(smoothMax(d(p), cavityDistance(p) + 2.0f, 5.0f), 0.7f * (diaphragmZ(p.x, p.y) + 2.0f - p.z),
                       4.0f);
    };
  };
  layers.push_back(bed);
  layers.push_back(solidLayer(kHeartMuscle, 100.0f, box, above(heartOuter)));
  layers.back().texture = [](Vec p) { return 5.0f * noise(p / 5.0f, 73); };
  layers.push_back(solidLayer(kRightAtrium, 260.0f, box, [](Vec p) { return rightAtrium(p, 0.0f); }));
  layers.push_back(
      solidLayer(kRightVentricle, 280.0f, box, above([](Vec p) { return rightVentricle(p, 0.0f) + 1.5f; })));
  layers.push_back(solidLayer(kLeftAtrium, 340.0f, box, [](Vec p) { return leftAtrium(p, 0.0f); }));
  // Trabeculae roughen the ventricle; two papillary muscles stand in it.
  layers.push_back(solidLayer(kLeftVentricle, 340.0f, box, [](Vec p) {
    float papillary = std::min(distance({Vec(50, -32, 12), Vec(34, -24, 30), 5.5f, 3.5f}, p),
                               distance({Vec(54, -50, 34), Vec(36, -42, 46), 5.5f, 3.5f}, p));
    return smoothMax(kLeftInner(p) + 1.3f * noise(p / 6.0f, 79), -papillary, 3.0f);
  }));
  // Coronary arteries on the surface.
  layers.push_back(
      tubeLayer(kArteries, 340.0f,
                {{{10, -28, 74, 2}, {22, -46, 70, 2}, {34, -66, 52, 1.8f}, {52, -78, 28, 1.6f}, {66, -70, 6, 1.3f}},
                 {{10, -28, 74, 2}, {32, -18, 66, 1.8f}, {54, -8, 50, 1.6f}, {62, -10, 28, 1.3f}},
                 {{-6, -36, 72, 2}, {-22, -52, 62, 1.9f}, {-34, -50, 38, 1.7f}, {-22, -40, 14, 1.4f}}}));
}

void addGreatVessels(std::vector<Layer>& layers) {
  // Pulmonary trunk and its two arteries; the right one passes behind the ascending aorta.
  layers.push_back(tubeLayer(kPulmonaryArtery, 280.0f,
                             {{{13, -51, 74, 12.5f}, {16, -42, 92, 13}, {17, -26, 101, 12}},
                              {{17, -28, 100, 11}, {4, -10, 96, 10.5f}, {-16, -4, 90, 10}, {-34, 4, 84, 8.5f}},
                              {{17, -28, 100, 11}, {24, -8, 100, 10.5f}, {36, 6, 92, 8.5f}}}));
  layers.push_back(tubeLayer(kOesophagus, 40.0f,
                             {{{3, 22, 240, 6},
                               {4, 27, 180, 6.5f},
                               {6, 34, 130, 6.5f},
                               {4, 35, 80, 7},
                               {10, 30, 40, 7},
                               {18, 14, 8, 7},
                               {34, 2, -12, 8}}}));

  // Veins: the upper cava from both arms, the lower one from both legs, and the kidneys'.
  auto cava = [](float z, float r) { return beforeSpine(-19, z, 1, r); };
  layers.push_back(
      tubeLayer(kVenaCava, 180.0f,
                {{{-70, -34, 196, 6},
                  {-40, -30, 176, 7},
                  {-24, -26, 152, 8.5f},
                  {-26, -24, 120, 9.5f},
                  {-30, -22, 90, 10},
                  {-32, -22, 66, 10}},
                 {{76, -34, 196, 6}, {44, -40, 172, 7}, {8, -38, 158, 7.5f}, {-22, -28, 144, 8}},
                 {{-30, -18, 34, 11.5f},
                  {-27, -6, 16, 11.5f},
                  {-24, 10, -4, 11.5f},
                  cava(-32, 11),
                  cava(-62, 11),
                  cava(-100, 10.5f),
                  cava(-140, 9)},
                 {cava(-138, 8), {-30, 8, -172, 7.5f}, {-52, -8, -205, 7}, {-66, -26, -240, 6.5f}},
                 {cava(-138, 8), {2, 14, -158, 7.5f}, {30, 10, -182, 7}, {52, -6, -212, 7}, {64, -24, -240, 6.5f}},
                 {cava(-58, 5), {-32, 26, -57, 4.5f}, {-46, 34, -58, 4}},
                 {cava(-46, 5), {-2, -1, -46, 4.2f}, {20, 12, -45, 4.2f}, {46, 34, -44, 4}}}));

  // The aorta: out of the left ventricle, over the left bronchus, down in front of the spine, a little to the left.
  layers.push_back(tubeLayer(kAorta, 350.0f,
                             {{{8, -22, 60, 13},
                               {1, -25, 72, 15.5f},
                               {-7, -28, 92, 15},
                               {-8, -25, 114, 15},
                               {-2, -13, 130, 14},
                               {9, 6, 136, 13.5f},
                               {19, 24, 130, 13},
                               {24, 36, 112, 12.5f},
                               {24, 42, 80, 12},
                               {22, 41, 45, 11.5f},
                               beforeSpine(15, 12, -7, 11),
                               beforeSpine(10, -20, -1, 10.5f),
                               beforeSpine(8, -60, 0.5f, 9.5f),
                               beforeSpine(5, -100, 0.5f, 9),
                               beforeSpine(3, -130, 0.5f, 8.8f)}}));
  auto root = [](float z) { return beforeSpine(8, z, 4, 4); };
  auto fork = beforeSpine(3, -128, 0.5f, 7.2f);
  layers.push_back(tubeLayer(
      kArteries, 340.0f,
      {{{-3, -14, 132, 6.5f},
        {-14, -8, 152, 6.5f},
        {-24, -2, 176, 6},
        {-26, 0, 205, 5},
        {-28, 2, 240, 4.5f}},  // brachiocephalic
       {{-22, -2, 172, 5.5f}, {-42, -4, 190, 5}, {-72, -16, 204, 4.6f}, {-112, -6, 214, 4.2f}},
       {{6, 2, 138, 4.6f}, {14, 2, 165, 4.4f}, {20, 2, 200, 4.2f}, {24, 2, 240, 4}},  // left carotid
       {{15, 16, 136, 5.4f},
        {26, 10, 165, 5.2f},
        {44, -2, 190, 5},
        {74, -16, 204, 4.6f},
        {114, -6, 214, 4.2f}},                         // left subclavian
       {root(-24), {7, 0, -22, 4}, {5, -12, -20, 4}},  // coeliac
       {{5, -11, -20, 3.4f}, {-12, -14, -26, 3.2f}, {-28, -14, -26, 3}, {-44, -16, -20, 2.6f}},
       {{5, -11, -20, 3.6f}, {24, 4, -14, 3.4f}, {42, 15, -3, 3.2f}, {60, 19, 2, 3.1f}, {80, 26, -6, 2.6f}},
       {root(-40),
        {6, -7, -44, 4},
        {4, -17, -60, 4},
        {0, -22, -90, 3.7f},
        {-8, -22, -120, 3.2f},
        {-30, -18, -148, 2.4f}},  // mesenteric
       {{0, -22, -92, 2.6f}, {18, -26, -110, 2.2f}, {36, -30, -128, 1.9f}},
       {{-2, -22, -100, 2.6f}, {-26, -28, -106, 2.2f}, {-50, -26, -116, 1.9f}},
       {beforeSpine(4, -54, -4, 3.4f), {-14, 25, -55, 3.2f}, {-32, 30, -57, 3}, {-48, 35, -57, 2.6f}},  // renal
       {beforeSpine(12, -48, -4, 3.4f), {26, 24, -46, 3.2f}, {38, 31, -44, 3}, {50, 36, -43, 2.6f}},
       {fork, {-14, 8, -152, 6.4f}, {-34, 6, -184, 5.8f}, {-54, -14, -212, 5.4f}, {-66, -32, -240, 5}},  // iliac
       {fork, {18, 8, -152, 6.4f}, {36, 6, -184, 5.8f}, {54, -14, -212, 5.4f}, {66, -32, -240, 5}},
       {{-33, 7, -182, 4}, {-38, 24, -206, 3.6f}, {-40, 36, -240, 3}},
       {{35, 7, -182, 4}, {38, 24, -206, 3.6f}, {40, 36, -240, 3}}}));
}

}  // namespace velum::io::torso
