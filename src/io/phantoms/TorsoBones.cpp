#include <algorithm>
#include <array>

#include "io/phantoms/Torso.h"

namespace velum::io::torso {

namespace {

constexpr float kCortical = 700.0f, kMarrow = 250.0f, kBelowSkinMm = 8.0f;

/// One vertebra: where it is and how big. Index 0 is the first thoracic, 12 the first lumbar.
struct Vertebra {
  float top, height;  ///< Of body and disc together, mm.
  float discPart;     ///< Of the height, at the lower end.
  float halfWidth, halfDepth;
  bool isLumbar;
  float bodyMiddle() const { return top - 0.5f * height * (1.0f - discPart); }
};

constexpr int kVertebraCount = 17;

std::array<Vertebra, kVertebraCount> makeSpine() {
  std::array<Vertebra, kVertebraCount> spine{};
  float top = 206.0f;
  for (int i = 0; i < kVertebraCount; ++i) {
    bool lumbar = i >= 12;
    float t = lumbar ? float(i - 12) / 4.0f : float(i) / 11.0f;
    Vertebra v{top,
               lumbar ? 30.0f + t * 2.0f : 15.0f + 6.5f * t,
               lumbar ? 0.27f : 0.2f,
               lumbar ? 20.0f + 4.0f * t : 12.5f + 6.5f * t,
               lumbar ? 15.0f + 1.5f * t : 10.0f + 5.0f * t,
               lumbar};
    spine[std::size_t(i)] = v;
    top -= v.height;
  }
  return spine;
}

/// Shrinks a bone to its marrow.
std::vector<Segment> shrink(std::vector<Segment> segments, float byMm, float leastMm) {
  for (auto& s : segments) s.radiusA -= byMm, s.radiusB -= byMm;
  std::erase_if(segments, [&](const Segment& s) { return std::min(s.radiusA, s.radiusB) < leastMm; });
  return segments;
}

/// Cortical bone with marrow inside, as two layers.
void addBone(std::vector<Layer>& layers, std::uint16_t label, std::vector<Solid> solids, std::vector<Segment> tubes,
             float cortexMm, Vec squash = Vec(1.0f)) {
  Layer cortex{label, kCortical}, marrow{label, kMarrow};
  cortex.squash = marrow.squash = squash;
  cortex.edge = marrow.edge = 1.1f;
  marrow.tubes = shrink(tubes, cortexMm, 0.8f);
  for (const auto& solid : solids)
    marrow.solids.push_back({solid.box, [d = solid.distance, cortexMm](Vec p) { return d(p) + cortexMm; }});
  marrow.texture = [](Vec p) { return 45.0f * noise(p / 4.0f, 61); };
  cortex.solids = std::move(solids);
  cortex.tubes = std::move(tubes);
  layers.push_back(std::move(cortex));
  layers.push_back(std::move(marrow));
}

float bodyDistance(Vec p, const Vertebra& v, float top, float bottom, float waist) {
  float half = 0.5f * (top - bottom), z = (p.z - 0.5f * (top + bottom)) / half;
  float size = 1.0f - waist * (1.0f - std::min(z * z, 1.0f));
  float column = ellipse({p.x, p.y - spineY(p.z)}, {0.0f, 0.0f}, {v.halfWidth * size, v.halfDepth * size});
  // The back of the body is hollowed for the canal.
  float canal = glm::length(glm::vec2(p.x, p.y - spineY(p.z) - v.halfDepth - 7.0f)) - 9.5f;
  return smoothMax(smoothMax(column, -canal, 3.0f), std::abs(p.z - 0.5f * (top + bottom)) - half, 2.5f);
}

/// Pedicles, arch, transverse, articular and spinous processes.
std::vector<Segment> makeArch(const Vertebra& v) {
  float z = v.bodyMiddle() + 2.0f, back = spineY(z) + v.halfDepth, s = v.isLumbar ? 1.3f : 0.75f + 0.012f * v.halfWidth;
  std::vector<Segment> out;
  for (float side : {-1.0f, 1.0f}) {
    auto at = [&](float x, float y, float dz, float r) { return glm::vec4(side * x, back + y, z + dz, r); };
    glm::vec4 arch[] = {at(11 * s, -4, 1, 4.2f * s), at(12.5f * s, 4, 0, 3.8f * s), at(10.5f * s, 12 * s, -3, 3.6f * s),
                        at(1, 18 * s, -6, 3.6f * s)};
    float reach = v.isLumbar ? 40.0f : 29.0f;
    glm::vec4 wing[] = {at(11 * s, 6, 0, 4.0f * s), at(0.65f * reach, v.isLumbar ? 9.0f : 15.0f, 1, 3.4f * s),
                        at(reach, v.isLumbar ? 11.0f : 21.0f, 3, 3.6f * s)};
    glm::vec4 joint[] = {at(11 * s, 10 * s, 0.42f * v.height, 3.2f * s), at(11 * s, 11 * s, 0, 4.2f * s),
                         at(10 * s, 13 * s, -0.48f * v.height, 3.2f * s)};
    append(out, tube(arch, 4));
    append(out, tube(wing, 4));
    append(out, tube(joint, 4));
  }
  // Steep in the chest, level in the loins. Two strands make a loin's blade.
  float drop = v.isLumbar ? 5.0f : 19.0f;
  for (float strand : {0.0f, v.isLumbar ? -8.0f : -2.5f}) {
    glm::vec4 spinous[] = {{0, back + 16 * s, z - 5 + strand, 3.6f * s},
                           {0, back + 26 * s, z - 5 - 0.6f * drop + strand, 3.0f * s},
                           {0, back + 34 * s, z - 6 - drop + strand, 3.8f * s}};
    for (glm::vec4& p : spinous) p.y -= std::max(skinDistance(Vec(p)) + p.w + kBelowSkinMm, 0.0f);
    append(out, tube(spinous, 4));
  }
  return out;
}

void addSpine(std::vector<Layer>& layers) {
  std::vector<Solid> bodies, discs;
  std::vector<Segment> arches;
  for (const auto& v : makeSpine()) {
    float bottom = v.top - v.height, edge = bottom + v.discPart * v.height;
    Vec centre(0.0f, spineY(v.bodyMiddle()), 0.5f * (v.top + bottom)), half(30.0f, 30.0f, 0.5f * v.height + 4.0f);
    bodies.push_back({boxAround(centre, half), [=](Vec p) { return bodyDistance(p, v, v.top, edge, 0.1f); }});
    discs.push_back(
        {boxAround(centre, half), [=](Vec p) { return bodyDistance(p, v, edge + 1.0f, bottom - 1.0f, -0.06f); }});
    append(arches, makeArch(v));
  }
  Layer disc{kDiscs, 90.0f};
  disc.solids = discs;
  layers.push_back(disc);
  addBone(layers, kVertebrae, bodies, arches, 1.9f);

  // The dural sac, and the cord down to the first lumbar vertebra.
  Layer sac{kSpinalCanal, 20.0f}, cord{kSpinalCanal, 42.0f};
  std::vector<glm::vec4> path;
  for (float z = 230.0f; z > -230.0f; z -= 12.0f) {
    float depth = z > -10.0f ? 10.0f + 5.0f * (206.0f - z) / 216.0f : 15.5f;
    path.emplace_back(0.0f, spineY(z) + depth + 7.0f, z, 7.2f);
  }
  sac.tubes = tube(path, 3);
  cord.tubes = shrink(tube(std::span(path).first(21), 3), 3.0f, 0.0f);
  layers.push_back(sac);
  layers.push_back(cord);
}

/// The bony part of one rib: from the vertebra, back over the transverse process, then along the chest wall, falling.
struct Rib {
  std::vector<glm::vec4> path;
  Vec tip() const { return Vec(path.back()); }
};

Rib makeRib(int index, const Vertebra& v, float side) {
  static constexpr float kDrop[] = {34, 52, 66, 76, 85, 93, 98, 102, 104, 98, 84, 66};
  static constexpr float kEnd[] = {2.45f, 2.5f, 2.5f, 2.5f, 2.48f, 2.44f, 2.38f, 2.22f, 2.06f, 1.9f, 1.5f, 1.02f};
  float z = v.top - 1.0f, y = spineY(z), r = index == 0 ? 4.6f : 4.9f;
  Rib rib;
  rib.path.emplace_back(side * (v.halfWidth + 1.0f), y + 0.55f * v.halfDepth, z, r * 0.9f);
  rib.path.emplace_back(side * (v.halfWidth + 11.0f), y + v.halfDepth + 9.0f, z + 1.0f, r * 0.8f);
  float start = index < 2 ? 0.75f : 0.5f;
  for (int k = 0; k <= 14; ++k) {
    float angle = glm::mix(start, kEnd[index], float(k) / 14.0f);
    float fall = 0.5f * (1.0f - std::cos(angle - 0.2f));
    float at = z - kDrop[index] * fall;
    glm::vec2 xy = onCage(at, angle, 6.5f);
    float thin = index > 9 ? 1.0f - 0.3f * float(k) / 14.0f : 1.0f;
    rib.path.emplace_back(side * xy.x, xy.y, at, r * thin);
  }
  return rib;
}

glm::vec3 sternumAt(float z) {
  glm::vec3 e = cageEllipse(z);
  return {0.0f, e.z - e.y - 7.0f + (z > 130.0f ? 4.0f * smoothStep(130.0f, 170.0f, z) : 0.0f), z};
}

/// Not further out than where the wall of the chest has its cartilage.
Vec ontoWall(Vec p) {
  constexpr float kFurthestMm = 10.0f;
  float beyond = cavityDistance(p) - kFurthestMm;
  if (beyond <= 0.0f) return p;
  glm::vec2 out = glm::normalize(glm::vec2(p.x, p.y - cageEllipse(p.z).z));
  return p - beyond * Vec(out, 0.0f);
}

std::vector<glm::vec4> makeCartilage(int index, const Rib& rib, const std::vector<glm::vec4>& above, float side) {
  // The first seven reach the breastbone, the next three lean on the cartilage above.
  static constexpr float kJoint[] = {157, 127, 106, 87, 69, 52, 40};
  Vec end = index < 7 ? sternumAt(kJoint[index]) + Vec(side * (index == 0 ? 24.0f : 15.0f), 0.0f, 0.0f)
                      : Vec(above[above.size() / 2]);
  Vec start = rib.tip(), before = Vec(rib.path[rib.path.size() - 2]);
  Vec on = ontoWall(start + 0.9f * (start - before));
  std::vector<glm::vec4> path{glm::vec4(start, 4.6f), glm::vec4(on, 4.8f)};
  for (float t : {0.3f, 0.6f}) {
    Vec p = glm::mix(on, end, t);
    p.y = std::min(p.y, glm::mix(onCage(p.z, 2.6f, 6.0f).y, sternumAt(p.z).y, t));
    path.emplace_back(ontoWall(p), 4.6f);
  }
  path.emplace_back(end, 4.4f);
  return path;
}

void addRibs(std::vector<Layer>& layers) {
  const Vec squash(1.0f, 1.0f, 0.62f);  // Ribs are flat: taller than thick.
  Layer cartilage{kCartilage, 110.0f};
  cartilage.squash = squash;
  auto spine = makeSpine();
  for (float side : {-1.0f, 1.0f}) {
    std::vector<Segment> bones;
    std::vector<glm::vec4> above;
    for (int i = 0; i < 12; ++i) {
      Rib rib = makeRib(i, spine[std::size_t(i)], side);
      append(bones, tube(rib.path, 4));
      if (i >= 10) continue;  // The last two float.
      above = makeCartilage(i, rib, above, side);
      append(cartilage.tubes, tube(above, 5));
    }
    addBone(layers, side > 0 ? kRibsLeft : kRibsRight, {}, bones, 1.9f, squash);
  }
  layers.push_back(cartilage);
}

void addSternum(std::vector<Layer>& layers) {
  auto plate = [](Vec p) {
    static constexpr glm::vec2 kHalfWidth[] = {{14, 3},   {24, 6},   {40, 15},  {70, 17}, {110, 13},
                                               {124, 13}, {135, 18}, {158, 26}, {166, 22}};
    float y = p.y - sternumAt(glm::clamp(p.z, 14.0f, 166.0f)).y;
    Vec q(std::max(std::abs(p.x) - curve(kHalfWidth, p.z) + 4.0f, 0.0f), std::max(std::abs(y) - 1.2f, 0.0f),
          std::max(std::abs(p.z - 90.0f) - 72.0f, 0.0f));
    return glm::length(q) - 4.2f;
  };
  addBone(layers, kSternum, {{{Vec(-34, -110, 8), Vec(34, -40, 174)}, plate}}, {}, 1.7f);
}

void addShoulders(std::vector<Layer>& layers) {
  std::vector<Segment> clavicles, humeri, spines;
  std::vector<Solid> blades;
  for (float side : {-1.0f, 1.0f}) {
    glm::vec4 clavicle[] = {{side * 20, -62, 168, 7.5f},
                            {side * 45, -62, 180, 6},
                            {side * 80, -42, 193, 5.5f},
                            {side * 108, -22, 203, 5.5f},
                            {side * 124, -12, 207, 6}};
    append(clavicles, tube(clavicle));
    glm::vec4 humerus[] = {{side * 139, 6, 199, 20}, {side * 143, 4, 216, 14}, {side * 148, 2, 240, 12}};
    append(humeri, tube(humerus));
    glm::vec4 ridge[] = {{side * 58, 78, 158, 3},
                         {side * 80, 76, 166, 5},
                         {side * 104, 58, 180, 6},
                         {side * 124, 26, 196, 7},
                         {side * 126, 2, 203, 6}};
    append(spines, tube(ridge));
    glm::vec4 edge[] = {
        {side * 82, 74, 82, 4}, {side * 104, 50, 125, 4.5f}, {side * 118, 26, 172, 8}, {side * 119, 18, 188, 10}};
    append(spines, tube(edge));
    // The blade: a shell at a fixed distance behind the ribs, cut to a triangle.
    blades.push_back({{Vec(side > 0 ? 40 : -130, 10, 66), Vec(side > 0 ? 130 : -40, 110, 196)}, [side](Vec p) {
                        float x = side * p.x, shell = std::abs(cavityDistance(p) - 22.0f) - 1.9f;
                        float medial = 52.0f + 0.22f * (178.0f - p.z) - x;
                        float lateral = 0.9f * (x - 84.0f - 0.36f * (p.z - 78.0f));
                        float upper = 0.95f * (p.z - 176.0f - 0.12f * (x - 60.0f)), lower = 76.0f - p.z;
                        return smoothMax(
                            shell, smoothMax(smoothMax(medial, lateral, 8.0f), smoothMax(upper, lower, 8.0f), 10.0f),
                            2.0f);
                      }});
  }
  addBone(layers, kScapulae, blades, spines, 1.5f);
  addBone(layers, kClavicles, {}, clavicles, 1.9f);
  addBone(layers, kHumeri, {}, humeri, 2.6f);
}

void addPelvis(std::vector<Layer>& layers) {
  auto sacrum = [](Vec p) {
    float y = p.y - spineY(p.z) - 4.0f, taper = smoothStep(-160.0f, -240.0f, p.z);
    float wedge = ellipse({p.x, y + 0.006f * p.x * p.x * 0.7f}, {0, 0}, {56.0f - 10.0f * taper, 19.0f - 5.0f * taper});
    Vec hole(std::abs(p.x) - 20.0f, y - 2.0f, p.z + 200.0f);  // The first pair of foramina.
    return smoothMax(smoothMax(wedge, p.z + 166.0f + 0.18f * std::abs(p.x), 5.0f),
                     5.0f - glm::length(glm::vec2(hole.x, hole.z)), 2.0f);
  };
  std::vector<Solid> wings;
  for (float side : {-1.0f, 1.0f}) {
    wings.push_back(
        {{Vec(side > 0 ? 20 : -170, -90, -240), Vec(side > 0 ? 170 : -20, 110, -120)}, [side](Vec p) {
           // A bowl that flares upwards; its rim, the crest, is highest at the side.
           float x = side * p.x, flare = smoothStep(-240.0f, -140.0f, p.z);
           glm::vec2 radii(102.0f + 30.0f * flare, 70.0f + 12.0f * flare), q = glm::vec2(x, p.y - 8.0f) / radii;
           float angle = std::atan2(q.x, q.y);  // 0 at the back
           float crest = -142.0f - 26.0f * (angle - 1.25f) * (angle - 1.25f) * (angle > 1.25f ? 1.6f : 1.0f);
           float thick = 3.0f + 5.5f * smoothStep(22.0f, 0.0f, crest - p.z) + 6.0f * smoothStep(0.95f, 0.45f, angle);
           float shell = std::abs(ellipse({x, p.y - 8.0f}, {0, 0}, radii)) - thick;
           float ends = std::max(40.0f * (0.5f - angle), 55.0f * (angle - 2.15f));
           return smoothMax(shell, smoothMax(0.85f * (p.z - crest), ends, 8.0f), 6.0f);
         }});
  }
  addBone(layers, kSacrum, {{{Vec(-64, 20, -240), Vec(64, 110, -158)}, sacrum}}, {}, 2.0f);
  addBone(layers, kHips, wings, {}, 2.0f);
}

}  // namespace

void addBones(std::vector<Layer>& layers) {
  addShoulders(layers);
  addPelvis(layers);
  addRibs(layers);
  addSternum(layers);
  addSpine(layers);
}

}  // namespace velum::io::torso
