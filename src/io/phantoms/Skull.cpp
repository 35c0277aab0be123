#include <algorithm>
#include <array>

#include "io/phantoms/Phantom.h"

namespace velum::io {

namespace {

using namespace phantom;

// The head of an adult that looks forward: world LPS in mm, origin in the middle of the scan. Eyes at z = -4, chin at
// -88, crown at 100; the glabella at y = -82.

enum Part : std::uint16_t {
  kSkin = 1,
  kSoftTissue,
  kAirways,
  kSkull,
  kMandible,
  kVertebrae,
  kTeeth,
  kBrain,
  kVentricles,
  kEyes,
  kFrontalSinus,
  kMaxillarySinuses,
  kSphenoidSinus
};

constexpr float kAir = -1000.0f, kCortical = 1250.0f, kDiploe = 420.0f, kDentine = 1700.0f, kEnamel = 2700.0f;
constexpr float kCortexMm = 1.8f;
const Box kAll{Vec(-100.0f, -125.0f, -125.0f), Vec(100.0f, 125.0f, 125.0f)};
/// The middle of the braincase and its outer radii.
const Vec kCase(0.0f, 12.0f, 26.0f), kCaseRadii(72.0f, 92.0f, 74.0f);

Vec mirrored(Vec p) { return {std::abs(p.x), p.y, p.z}; }

float tubesAt(std::span<const Segment> tubes, Vec p) {
  float d = 1e6f;
  for (const Segment& s : tubes) d = std::min(d, distance(s, p));
  return d;
}

/// To the vault's outside: narrower in front than at the back, with a flattened crown.
float vaultDistance(Vec p) {
  float narrower = 1.0f + 0.16f * smoothStep(30.0f, -70.0f, p.y);
  float d = ellipsoid({p.x * narrower, p.y, p.z}, kCase, kCaseRadii);
  return smoothMax(d, p.z - 97.0f - 0.04f * (p.y - kCase.y), 20.0f);
}

/// The braincase's outside: flat below, where the base of the skull is.
float caseDistance(Vec p) {
  float vault = vaultDistance(p);
  return smoothMax(vault, -(p.z + 27.0f + 0.12f * (p.y - kCase.y)), 16.0f);
}

/// The room of the brain: the vault is 6 to 7 mm thick, the base steps down from front to back.
float roomDistance(Vec p) {
  static constexpr glm::vec2 kFloor[] = {{-90, 8}, {-48, 2}, {-38, -14}, {-8, -18}, {4, -24}, {40, -28}, {80, -26}};
  float vault = vaultDistance(p) + 6.5f + 0.8f * noise(p / 24.0f, 311);
  // The frontal bone is thick where its sinus lies.
  vault = smoothMax(vault, -ellipsoid(p, {0.0f, -74.0f, 20.0f}, {36.0f, 17.0f, 26.0f}), 6.0f);
  return smoothMax(vault, 0.8f * (curve(kFloor, p.y) + 2.5f * noise(p / 18.0f, 317) - p.z), 8.0f);
}

/// Two lobes in the forehead, scalloped, with a wall between them that is not quite in the middle.
float frontalSinusDistance(Vec p) {
  struct Lobe {
    Vec centre;
    float radius;
  };
  static constexpr std::array kLobes = {
      Lobe{{9, -72, 14}, 7.5f},   Lobe{{17, -71, 23}, 7.0f}, Lobe{{8, -73, 27}, 7.0f},
      Lobe{{25, -69, 17}, 5.5f},  Lobe{{14, -72, 35}, 5.0f}, Lobe{{-8, -72, 14}, 7.0f},
      Lobe{{-15, -71, 21}, 6.5f}, Lobe{{-7, -73, 26}, 5.5f}, Lobe{{-22, -69, 15}, 5.0f}};
  float d = 1e6f;
  for (const Lobe& lobe : kLobes) {
    Vec q = (p - lobe.centre) * Vec(1.0f, 1.35f, 1.0f);
    d = smoothMin(d, (glm::length(q) - lobe.radius) / 1.35f, 3.0f);
  }
  float septum = std::abs(p.x - 0.8f - 0.06f * (p.z - 20.0f)) - 0.9f;
  return smoothMax(d, -septum, 1.0f);
}

float maxillarySinusDistance(Vec p) {
  return ellipsoid(mirrored(p), {28.0f, -50.0f, -29.0f}, {12.0f, 16.0f, 14.0f}) + 1.2f * noise(p / 9.0f, 331);
}

float sphenoidSinusDistance(Vec p) {
  float d = ellipsoid(p, {0.0f, -18.0f, -20.0f}, {13.0f, 11.0f, 7.5f}) + noise(p / 7.0f, 337);
  return smoothMax(d, -(std::abs(p.x + 2.0f) - 0.8f), 1.0f);
}

float orbitDistance(Vec p) {
  // A cone with a rounded mouth, which points inwards.
  Vec q = mirrored(p) - Vec(31.0f, -84.0f, -4.0f);
  float back = q.y, x = q.x + 0.34f * back;
  float radius = 18.5f - 0.36f * back;
  return smoothMax(0.9f * (glm::length(glm::vec2(x, 1.1f * q.z)) - radius), back - 42.0f, 6.0f);
}

/// The way of the breath: from the nose past the turbinates to the throat.
float airwayDistance(Vec p) {
  float nose = ellipsoid(p, {0.0f, -58.0f, -33.0f}, {13.0f, 36.0f, 19.0f});
  float septum = std::abs(p.x - 0.8f * noise(p / 20.0f, 347)) - 1.1f;
  float turbinates = 1e6f;
  for (float z : {-42.0f, -31.0f, -21.0f})
    turbinates = std::min(turbinates, ellipsoid(mirrored(p), {9.0f, -50.0f, z}, {4.5f, 22.0f, 3.4f}));
  nose = smoothMax(smoothMax(nose, -septum, 1.0f), -turbinates, 2.0f);
  static const std::vector<Segment> kThroat = [] {
    glm::vec4 path[] = {{0, -30, -34, 8}, {0, -14, -40, 9}, {0, -8, -62, 8}, {0, -6, -90, 9}, {0, -4, -125, 10}};
    return tube(path);
  }();
  return smoothMin(nose, tubesAt(kThroat, p), 4.0f);
}

/// Cheekbones with their arches, brows, and the processes of the base.
float archesDistance(Vec p) {
  static const std::vector<Segment> kArches = [] {
    const std::vector<glm::vec4> paths[] = {
        {{36, -68, -26, 9}, {50, -58, -24, 7.5f}, {61, -36, -22, 5}, {66.5f, -12, -20, 4}, {64, 10, -18, 5}},
        {{8, -79, 11, 6}, {22, -84, 15, 5}, {40, -79, 12, 5}, {49, -67, 2, 5}, {49, -62, -13, 5.5f}, {43, -64, -26, 8}},
        {{56, 18, -18, 11}, {38, 8, -20, 9}, {18, -6, -20, 7}},
        {{57, 24, -26, 11}, {55, 20, -46, 6}},
        {{48, 10, -30, 3}, {42, 0, -56, 1.4f}},
        {{16, -26, -24, 4}, {16, -28, -50, 3}}};
    std::vector<Segment> all;
    for (const auto& path : paths) append(all, tube(path));
    return all;
  }();
  return tubesAt(kArches, mirrored(p));
}

/// Upper jaw, forehead and bridge of the nose.
float faceDistance(Vec p) {
  float maxilla = ellipsoid(mirrored(p), {13.0f, -54.0f, -34.0f}, {27.0f, 25.0f, 26.0f});
  float alveolar = ellipsoid(p, {0.0f, -56.0f, -52.0f}, {29.0f, 29.0f, 8.5f});
  float palate = smoothMax(alveolar, -ellipsoid(p, {0.0f, -50.0f, -62.0f}, {19.0f, 26.0f, 11.0f}), 3.0f);
  float forehead = ellipsoid(p, {0.0f, -66.0f, 20.0f}, {34.0f, 18.0f, 24.0f});
  float nasal = ellipsoid(p, {0.0f, -82.0f, -8.0f}, {6.5f, 8.0f, 14.0f});
  return smoothMin(smoothMin(smoothMin(maxilla, palate, 6.0f), nasal, 6.0f), forehead, 8.0f);
}

/// The skull without its air and its soft parts, to the outer surface of the bone.
float skullDistance(Vec p) {
  static const std::vector<Segment> kForamen = {{{0, 40, -20}, {0, 44, -60}, 15.0f, 16.0f}};
  float bone = smoothMin(caseDistance(p), faceDistance(p), 6.0f);
  // The hollow of the temple, in which the chewing muscle lies, within the arch.
  float temple = ellipsoid(mirrored(p), {54.0f, -34.0f, -22.0f}, {9.0f, 24.0f, 24.0f});
  bone = smoothMin(smoothMax(bone, -temple, 6.0f), archesDistance(p), 5.0f);
  bone = smoothMax(bone, -std::min(roomDistance(p), tubesAt(kForamen, p)), 2.0f);
  bone = smoothMax(bone, -orbitDistance(p), 2.0f);
  float air =
      std::min({airwayDistance(p), maxillarySinusDistance(p), frontalSinusDistance(p), sphenoidSinusDistance(p)});
  return smoothMax(bone, -air, 1.0f);
}

std::vector<Segment> mandible() {
  std::vector<Segment> both;
  for (float side : {-1.0f, 1.0f}) {
    auto at = [&](float x, float y, float z, float r) { return glm::vec4(side * x, y, z, r); };
    const std::vector<glm::vec4> paths[] = {
        {at(47, -6, -70, 7), at(44, -26, -77, 7), at(34, -52, -82, 7), at(18, -73, -84, 7.5f), at(0, -79, -85, 8)},
        {at(42, -24, -66, 6), at(32, -50, -71, 6), at(17, -69, -73, 6), at(0, -74, -73, 6)},
        {at(52, 0, -27, 5), at(50, -3, -42, 4.5f), at(47, -6, -70, 6.5f)},
        {at(48, -29, -33, 2.5f), at(47, -25, -46, 4.5f), at(44, -24, -68, 6)},
        {at(49, -9, -45, 4.5f), at(47, -12, -68, 5.5f)},
        {at(48, -19, -47, 4.5f), at(46, -18, -68, 5.5f)}};
    for (const auto& path : paths) append(both, tube(path));
  }
  return both;
}

/// Crowns and roots along both arches, the molars broader.
void addTeeth(std::vector<Layer>& layers) {
  Layer dentine{kTeeth, kDentine}, enamel{kTeeth, kEnamel};
  for (float side : {-1.0f, 1.0f})
    for (int i = 0; i < 8; ++i) {
      // Along a parabola, from the middle to the last molar.
      static constexpr float kX[] = {4.0f, 11.5f, 18.0f, 22.5f, 25.5f, 28.5f, 31.0f, 32.5f};
      static constexpr float kY[] = {-83.0f, -80.5f, -75.5f, -69.5f, -63.0f, -54.5f, -45.0f, -36.0f};
      float crown = i < 2 ? 3.0f : i < 5 ? 3.3f : 4.4f;
      for (bool isUpper : {true, false}) {
        float in = isUpper ? 0.0f : 1.5f, up = isUpper ? 1.0f : -1.0f, bite = isUpper ? -60.5f : -62.5f;
        Vec neck(side * (kX[i] - in), kY[i] + in, bite + up * 6.5f),
            edge(neck.x, neck.y - 0.5f, bite + up * crown * 0.6f);
        enamel.tubes.push_back({neck, edge, crown, i < 2 ? 0.7f * crown : crown});
        Vec tip(neck.x * 0.94f, neck.y + 3.0f, neck.z + up * (i == 2 ? 17.0f : 12.0f));
        if (i < 5) {
          dentine.tubes.push_back({neck, tip, crown - 0.8f, 1.0f});
        } else {
          for (float apart : {-3.0f, 3.0f}) dentine.tubes.push_back({neck, tip + Vec(0, apart, 0), crown - 1.6f, 1.0f});
        }
      }
    }
  layers.push_back(dentine);
  layers.push_back(enamel);
}

float skinDistance(Vec p) {
  float scalp = vaultDistance(p) - 7.0f;
  float face = ellipsoid(p, {0.0f, -40.0f, -38.0f}, {60.0f, 57.0f, 60.0f});
  float neck = 0.9f * (glm::length(glm::vec2(p.x, 1.1f * (p.y - 22.0f))) - 58.0f);
  neck = smoothMax(neck, p.z + 20.0f, 20.0f);
  float nose = ellipsoid(p, {0.0f, -96.0f, -30.0f}, {13.0f, 16.0f, 17.0f});
  float lips = ellipsoid(p, {0.0f, -86.0f, -63.0f}, {24.0f, 12.0f, 12.0f});
  float ears = ellipsoid(mirrored(p), {80.0f, 18.0f, -12.0f}, {6.0f, 17.0f, 28.0f});
  float d = smoothMin(smoothMin(scalp, face, 24.0f), neck, 24.0f);
  // Cheeks over the arches and the jaw.
  static const std::vector<Segment> kJaw = mandible();
  d = smoothMin(d, archesDistance(p) - 6.0f, 14.0f);
  d = smoothMin(d, tubesAt(kJaw, p) - 5.0f, 16.0f);
  return smoothMin(smoothMin(smoothMin(d, nose, 12.0f), lips, 10.0f), ears, 5.0f);
}

Layer layerOf(std::uint16_t label, float value, Distance distance, float edge = 1.3f) {
  Layer layer{label, value};
  layer.solids.push_back({kAll, std::move(distance)});
  layer.edge = edge;
  return layer;
}

void addSoftParts(std::vector<Layer>& layers) {
  layers.push_back(layerOf(kSkin, 45.0f, skinDistance, 1.7f));
  layers.push_back(layerOf(kSoftTissue, -95.0f, [](Vec p) { return skinDistance(p) + 2.2f; }));
  Layer muscle =
      layerOf(kSoftTissue, 55.0f, [](Vec p) { return skinDistance(p) + 5.0f + 1.5f * noise(p / 30.0f, 353); });
  muscle.texture = [](Vec p) { return 8.0f * noise(p / Vec(6.0f, 8.0f, 18.0f), 359); };
  layers.push_back(muscle);
  layers.push_back(
      layerOf(kSoftTissue, -90.0f, [](Vec p) { return std::max(orbitDistance(p) + 1.0f, skinDistance(p) + 2.2f); }));
  layers.push_back(layerOf(kAirways, kAir, airwayDistance));
}

void addBones(std::vector<Layer>& layers) {
  auto diploe = [](Layer layer) {
    layer.texture = [](Vec p) { return 90.0f * roughNoise(p / 2.6f, 367); };
    return layer;
  };
  layers.push_back(layerOf(kSkull, kCortical, skullDistance, 1.8f));
  layers.push_back(diploe(layerOf(
      kSkull, kDiploe, [](Vec p) { return skullDistance(p) + kCortexMm; }, 1.8f)));
  Layer jaw{kMandible, kCortical}, marrow{kMandible, kDiploe};
  jaw.tubes = marrow.tubes = mandible();
  for (Segment& s : marrow.tubes) s.radiusA -= kCortexMm, s.radiusB -= kCortexMm;
  jaw.edge = marrow.edge = 1.8f;
  layers.push_back(jaw);
  layers.push_back(diploe(marrow));
  Layer neck{kVertebrae, kCortical * 0.8f};
  for (int i = 0; i < 4; ++i) {
    float z = -56.0f - 17.0f * float(i), y = 26.0f + float(i);
    neck.solids.push_back({kAll, [=](Vec p) { return roundBox(p, {0.0f, y, z}, {13.0f, 8.5f, 6.5f}, 4.0f); }});
    for (float side : {-1.0f, 1.0f}) {
      glm::vec4 arch[] = {{side * 12, y + 4, z, 4},
                          {side * 24, y + 8, z, 4.5f},
                          {side * 17, y + 24, z - 3, 3.5f},
                          {0, y + 36, z - 6, 4}};
      append(neck.tubes, tube(arch));
    }
  }
  layers.push_back(neck);
  addTeeth(layers);
}

void addInside(std::vector<Layer>& layers) {
  layers.push_back(layerOf(kKeepLabel, 8.0f, roomDistance));
  auto brain = [](Vec p) {
    // Folds: sulci along the zeros of a noise.
    float fold = std::abs(noise(p / 11.0f, 373) + 0.5f * noise(p / 6.0f, 379));
    float sulcus = 6.0f * smoothStep(0.16f, 0.0f, fold) * smoothStep(-22.0f, -2.0f, roomDistance(p));
    float fissure = smoothMax(std::abs(p.x) - 1.2f, 34.0f - p.z, 4.0f);
    return 0.7f * smoothMax(roomDistance(p) + 2.6f + sulcus, -fissure, 2.0f);
  };
  layers.push_back(layerOf(kBrain, 38.0f, brain));
  Layer white = layerOf(kBrain, 28.0f, [brain](Vec p) { return brain(p) + 4.0f; });
  white.edge = 2.5f;
  layers.push_back(white);
  layers.push_back(layerOf(kVentricles, 6.0f, [](Vec p) {
    Vec q = mirrored(p);
    float horn = ellipsoid(q, {9.0f, 2.0f, 30.0f}, {6.0f, 32.0f, 8.0f});
    float third = ellipsoid(p, {0.0f, 6.0f, 14.0f}, {2.5f, 14.0f, 10.0f});
    return smoothMin(horn, third, 3.0f);
  }));
  layers.push_back(layerOf(kEyes, 12.0f, [](Vec p) { return sphere(mirrored(p), {31.0f, -80.0f, -4.0f}, 12.0f); }));
  layers.push_back(layerOf(kEyes, 110.0f, [](Vec p) {
    return ellipsoid(mirrored(p), {31.0f, -88.0f, -4.0f}, {5.0f, 2.4f, 5.0f});
  }));
  layers.push_back(layerOf(kFrontalSinus, kAir, frontalSinusDistance, 1.8f));
  layers.push_back(layerOf(kMaxillarySinuses, kAir, maxillarySinusDistance, 1.8f));
  layers.push_back(layerOf(kSphenoidSinus, kAir, sphenoidSinusDistance, 1.8f));
}

}  // namespace

/// A CT of a head with its sinuses and teeth, in Hounsfield units.
Sample makeSkull(int size, Progress& progress) {
  constexpr float kWidthMm = 184.0f, kDepthMm = 224.0f, kHeightMm = 224.0f, kNoiseHu = 14.0f;
  float spacing = kHeightMm / float(size);
  auto along = [&](float mm) { return std::max(1, int(mm / spacing + 0.5f)); };
  Grid grid{{along(kWidthMm), along(kDepthMm), size}, Vec(spacing)};
  std::vector<Layer> layers;
  addSoftParts(layers);
  addBones(layers);
  addInside(layers);
  const glm::vec3 bone(0.93f, 0.88f, 0.76f), air(0.60f, 0.85f, 0.92f);
  Description description{"skull",
                          SampleType::Int16,
                          Modality::CT,
                          "HU",
                          {{kSkin, "skin", {0.93f, 0.74f, 0.62f}, 0.2f},
                           {kSoftTissue, "muscle and fat", {0.75f, 0.38f, 0.32f}, 0.3f},
                           {kAirways, "airways", air, 0.3f},
                           {kSkull, "skull", bone},
                           {kMandible, "mandible", bone * 0.96f},
                           {kVertebrae, "vertebrae", bone * 0.93f},
                           {kTeeth, "teeth", {0.98f, 0.96f, 0.90f}},
                           {kBrain, "brain", {0.90f, 0.68f, 0.66f}},
                           {kVentricles, "ventricles", {0.45f, 0.65f, 0.90f}},
                           {kEyes, "eyes", {0.85f, 0.88f, 0.95f}},
                           {kFrontalSinus, "frontal sinus", air},
                           {kMaxillarySinuses, "maxillary sinuses", air * 0.95f},
                           {kSphenoidSinus, "sphenoid sinus", air * 0.9f}}};
  return fill(description, grid, progress, [&](const Slice& slice) {
    std::fill(slice.values.begin(), slice.values.end(), kAir);
    paint(slice, layers);
    std::uint64_t first = grid.index(0, 0, slice.z);
    for (std::size_t i = 0; i < slice.values.size(); ++i)
      slice.values[i] = std::max(slice.values[i] + kNoiseHu * gaussian(hash(0x5c11, first + i)), -1024.0f);
  });
}

}  // namespace velum::io
