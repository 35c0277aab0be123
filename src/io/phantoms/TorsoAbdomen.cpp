#include <algorithm>

#include "io/phantoms/Torso.h"
#include "io/phantoms/Tree.h"

namespace velum::io::torso {

namespace {

/// To the union of segments.
float nearest(std::span<const Segment> segments, Vec p) {
  float d = 1e6f;
  for (const auto& s : segments) d = std::min(d, distance(s, p));
  return d;
}

Box boundsOf(std::span<const Segment> segments, float marginMm) {
  Box box{segments[0].a, segments[0].a};
  for (const auto& s : segments) {
    Vec r(std::max(s.radiusA, s.radiusB) + marginMm);
    box.low = glm::min(box.low, glm::min(s.a, s.b) - r);
    box.high = glm::max(box.high, glm::max(s.a, s.b) + r);
  }
  return box;
}

Layer solidLayer(std::uint16_t label, float value, Box box, Distance distance) {
  Layer layer{label, value};
  layer.solids.push_back({box, std::move(distance)});
  return layer;
}

// --- Bowel ----------------------------------------------------------------------------------------------------------

/// Coils that fill the middle of the belly: a path over jittered lattice rows, there and back.
std::vector<Segment> makeSmallBowel() {
  std::vector<glm::vec4> path;
  Random random(31);
  int row = 0;
  for (float z = -92.0f; z > -216.0f; z -= 25.0f)
    for (float y = -56.0f; y < 16.0f; y += 25.0f, ++row)
      for (int k = 0; k < 5; ++k) {
        float x = (row % 2 ? 2 - k : k - 2) * 29.0f * (1.0f - 0.10f * float(-z - 92.0f) / 100.0f);
        Vec p = Vec(x, y, z) + Vec(9.0f * random.normal(), 8.0f * random.normal(), 11.0f * random.normal());
        // Leave room for spine, psoas and great vessels.
        if (p.y > -6.0f && std::abs(p.x) < 48.0f) continue;
        if (bellyDistance(p) < -13.0f) path.emplace_back(p, 10.0f + random.uniform(-1.2f, 1.8f));
      }
  return tube(path, 6);
}

std::vector<Segment> makeColon() {
  glm::vec4 path[] = {{-84, -16, -190, 21}, {-90, -8, -165, 25}, {-92, 6, -130, 23},   {-92, 8, -98, 22},
                      {-82, -16, -80, 20},  {-58, -46, -86, 18}, {-20, -60, -100, 18}, {20, -61, -104, 18},
                      {58, -50, -86, 18},   {88, -22, -60, 18},  {100, 8, -52, 18},    {98, 24, -80, 16},
                      {96, 22, -120, 15},   {92, 14, -160, 14},  {76, -6, -190, 14},   {44, -14, -206, 14},
                      {16, 2, -214, 14},    {4, 26, -226, 14},   {0, 36, -245, 14}};
  auto segments = tube(path, 14);
  // Haustra: rows of pouches.
  for (std::size_t i = 0; i < segments.size(); ++i) {
    auto pouch = [](std::size_t k) { return 1.0f + 0.13f * std::sin(float(k) * 0.75f); };
    segments[i].radiusA *= pouch(i), segments[i].radiusB *= pouch(i + 1);
  }
  return segments;
}

/// A hollow organ: wall, contents, and gas that has risen to the front of the lying patient.
void addHollow(std::vector<Layer>& layers, std::uint16_t label, const std::vector<Segment>& segments, float wallMm,
               float contentHu, std::uint64_t seed, const std::function<float(Vec)>& gasLevel) {
  auto d = [segments](Vec p) { return smoothMax(nearest(segments, p), bellyDistance(p) + 2.0f, 5.0f); };
  Box box = boundsOf(segments, 2.0f);
  layers.push_back(solidLayer(label, 62.0f, box, d));
  Layer content = solidLayer(label, contentHu, box, [=](Vec p) { return d(p) + wallMm; });
  content.texture = [=](Vec p) { return 9.0f * roughNoise(p / 5.0f, seed); };
  layers.push_back(content);
  if (gasLevel)
    layers.push_back(
        solidLayer(kGas, -980.0f, box, [=](Vec p) { return smoothMax(d(p) + wallMm, gasLevel(p), 1.0f); }));
}

// --- Organs ---------------------------------------------------------------------------------------------------------

float liver(Vec p) {
  float right = ellipsoid(p, Vec(-62, -2, -42), Vec(66, 72, 76));
  float left = ellipsoid(p, Vec(6, -44, -24), Vec(66, 34, 32));
  float body = smoothMin(right, left, 28.0f);
  // The under-surface rises to the left and to the back; kidney and gallbladder press into it.
  float under = glm::dot(p - Vec(-60, -20, -112), glm::normalize(Vec(0.62f, 0.28f, -0.86f)));
  body = smoothMax(body, under, 16.0f);
  body = smoothMax(body, 4.0f - ellipsoid(p, Vec(-54, 44, -62), Vec(30, 28, 50)), 10.0f);
  float spine = 34.0f - glm::length(glm::vec2(p.x, p.y - spineY(p.z) + 2.0f));
  return smoothMax(smoothMax(body, spine, 14.0f), bellyDistance(p) + 3.5f, 8.0f);
}

void addLiver(std::vector<Layer>& layers, float spacing) {
  Box box{Vec(-132, -90, -135), Vec(80, 75, 20)};
  layers.push_back(solidLayer(kLiver, 110.0f, box, liver));
  layers.back().texture = [](Vec p) { return 5.0f * roughNoise(p / 6.0f, 83); };
  auto tree = [&](Vec root, Vec direction, float radius, float pitch, std::uint64_t seed) {
    TreeOptions options;
    options.root = root;
    options.direction = glm::normalize(direction);
    options.rootRadiusMm = radius;
    options.leastRadiusMm = std::max(1.0f, 0.6f * spacing);
    options.seed = seed;
    return growTree(scatter(box, pitch, liver, 7.0f, seed), options);
  };
  Tree portal = tree(Vec(-38, -8, -40), Vec(-0.8f, -0.2f, 0.5f), 6.0f, 26.0f, 41);
  Tree hepatic = tree(Vec(-25, 8, -2), Vec(-0.5f, -0.5f, -0.6f), 6.5f, 30.0f, 43);
  pushApart(hepatic, portal, 2.0f);
  Layer vessels{kPortalVein, 190.0f};
  vessels.tubes = segments(portal);
  vessels.onto = {kLiver};
  append(vessels.tubes, segments(hepatic));
  layers.push_back(vessels);

  // The portal vein's stem, from the mesenteric and the splenic vein behind the pancreas.
  Layer stem{kPortalVein, 190.0f};
  glm::vec4 mesenteric[] = {{-22, -20, -140, 3.5f}, {-12, -24, -105, 4.5f}, {-8, -12, -68, 5.5f},
                            {-12, -6, -52, 6},      {-26, -8, -44, 6.2f},   {-40, -8, -39, 6}};
  glm::vec4 splenic[] = {
      {-11, -6, -54, 5}, {12, -2, -50, 4.6f}, {44, 14, -36, 4.4f}, {66, 22, -24, 4.2f}, {84, 30, -16, 3.5f}};
  append(stem.tubes, tube(mesenteric));
  append(stem.tubes, tube(splenic));
  layers.push_back(stem);
  layers.push_back(solidLayer(kGallbladder, 12.0f, boxAround(Vec(-46, -50, -78), Vec(40)), [](Vec p) {
    return distance({Vec(-50, -56, -88), Vec(-40, -34, -66), 14.5f, 6.0f}, p);
  }));
}

const Vec kKidneyLeftAt(58, 36, -46);

/// A bean: an ellipsoid, tilted so that the upper pole is nearer to the spine, with a dent at the hilum.
float kidney(Vec p, Vec centre, float side, float growMm) {
  Vec q = (p - centre) * Vec(side, 1.0f, 1.0f);
  q = Vec(q.x + 0.22f * q.z, q.y - 0.12f * q.z, q.z);
  float bean = ellipsoid(q, Vec(0.0f), Vec(27 + growMm, 23 + growMm, 52 + growMm));
  return smoothMax(bean, (15.0f - growMm) - glm::length((q - Vec(-30, -6, 0)) * Vec(1, 0.9f, 0.55f)), 9.0f);
}

void addKidney(std::vector<Layer>& layers, std::uint16_t label, Vec centre, float side) {
  Box box = boxAround(centre, Vec(50, 40, 62));
  layers.push_back(solidLayer(label, 200.0f, box, [=](Vec p) { return kidney(p, centre, side, 0.0f); }));
  // Pyramids: cones of medulla around the sinus, parted by columns of cortex.
  Layer medulla{kMedulla, 120.0f};
  medulla.solids.push_back({box, [=](Vec p) {
                              Vec q = (p - centre) * Vec(side, 1.0f, 1.0f) + Vec(9, 3, 0);
                              float around = std::atan2(q.y, q.x + 6.0f), along = q.z / 13.0f;
                              float columns = 2.0f - 4.6f * std::abs(std::cos(1.6f * around + 0.5f)) *
                                                         std::abs(std::cos(along * 1.35f));
                              return smoothMax(smoothMax(kidney(p, centre, side, -8.0f), columns, 3.0f),
                                               0.0f - kidney(p, centre, side, -18.0f), 2.0f);
                            }});
  layers.push_back(medulla);
  Layer sinus{kVisceralFat, -85.0f};
  sinus.solids.push_back({box, [=](Vec p) {
                            Vec q = (p - centre) * Vec(side, 1.0f, 1.0f);
                            return smoothMin(ellipsoid(q, Vec(-8, -3, 0), Vec(9, 7, 26)),
                                             ellipsoid(q, Vec(-20, -5, 0), Vec(14, 7, 13)), 6.0f);
                          }});
  sinus.onto = {label, kMedulla};
  layers.push_back(sinus);
}

float spleen(Vec p) {
  float body = ellipsoid(p, Vec(92, 30, -16), Vec(34, 46, 50));
  body = smoothMax(body, 5.0f - kidney(p, kKidneyLeftAt, 1.0f, 0.0f), 6.0f);
  float hollow = 44.0f - glm::length((p - Vec(44, 8, -18)) * Vec(1, 1, 0.75f));
  return smoothMax(smoothMax(body, hollow, 9.0f), bellyDistance(p) + 3.5f, 7.0f);
}

void addStomach(std::vector<Layer>& layers) {
  glm::vec4 path[] = {{56, -10, -14, 23}, {58, -18, -34, 25}, {58, -32, -52, 23}, {46, -44, -70, 20},
                      {20, -48, -82, 17}, {-6, -44, -78, 14}, {-24, -36, -70, 10}};
  addHollow(layers, kStomach, tube(path, 6), 4.0f, 18.0f, 89, [](Vec p) { return p.y + 26.0f; });
  glm::vec4 duodenum[] = {{-24, -36, -70, 10},  {-40, -20, -66, 12}, {-44, -6, -84, 12}, {-36, -2, -112, 12},
                          {-10, -10, -118, 11}, {22, -8, -108, 11},  {32, -22, -96, 10}};
  addHollow(layers, kSmallBowel, tube(duodenum, 6), 3.0f, 30.0f, 97, {});
}

}  // namespace

void addBowel(std::vector<Layer>& layers) {
  addHollow(layers, kSmallBowel, makeSmallBowel(), 3.0f, 28.0f, 101, {});
  addHollow(layers, kColon, makeColon(), 3.0f, 32.0f, 103, [](Vec p) {
    // Pockets of gas where the bowel lies high: in the transverse part, and a little elsewhere.
    return p.y + 40.0f - 26.0f * noise(p / 55.0f, 107);
  });
}

void addBellyOrgans(std::vector<Layer>& layers, float spacing) {
  addKidney(layers, kKidneyRight, Vec(-58, 36, -60), -1.0f);
  addKidney(layers, kKidneyLeft, kKidneyLeftAt, 1.0f);
  addStomach(layers);
  layers.push_back(solidLayer(kSpleen, 120.0f, {Vec(50, -30, -75), Vec(135, 85, 20)}, spleen));
  layers.back().texture = [](Vec p) { return 4.0f * noise(p / 6.0f, 109); };

  Layer pancreas{kPancreas, 95.0f};
  glm::vec4 path[] = {{-30, -16, -84, 11}, {-26, -16, -66, 13}, {-8, -18, -58, 10},
                      {14, -12, -52, 9},   {44, 4, -42, 9},     {70, 16, -30, 8}};
  pancreas.tubes = tube(path, 8);
  for (std::size_t i = 0; i < pancreas.tubes.size(); ++i)  // Lobules.
    pancreas.tubes[i].radiusA += 1.6f * std::sin(float(i) * 1.9f);
  pancreas.texture = [](Vec p) { return 8.0f * noise(p / 3.5f, 113); };
  layers.push_back(pancreas);
  addLiver(layers, spacing);
}

}  // namespace velum::io::torso
