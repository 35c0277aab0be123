#include "io/phantoms/Limb.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace velum::io::limb {

namespace {

constexpr float kCorticalHu = 1300.0f, kSpongyHu = 330.0f, kMarrowHu = -10.0f, kCartilageHu = 115.0f;
constexpr float kNoiseHu = 14.0f;
/// A tube of a smaller radius, in voxels, would fall apart between them.
constexpr float kLeastVoxels = 0.75f;
/// Where a bone is further away than this nobody asks to whom it gives way.
constexpr float kFarMm = 5.0f;

/// A place in the frame of a long bone: across, up, and along it, mm.
struct InBone {
  float x, y, s;
};

struct Frame {
  Vec base, along, up, across;
  float length;
  explicit Frame(const LongBone& b) : base(b.base), length(glm::length(b.head - b.base)) {
    along = (b.head - b.base) / length;
    up = glm::normalize(b.up - glm::dot(b.up, along) * along);
    across = glm::cross(along, up);
  }
  InBone of(Vec p) const { return {glm::dot(p - base, across), glm::dot(p - base, up), glm::dot(p - base, along)}; }
};

float profile(float base, float shaft, float head, float t) {
  const glm::vec2 knots[] = {{0.0f, base * 0.96f}, {0.08f, base},       {0.27f, glm::mix(shaft, base, 0.25f)},
                             {0.45f, shaft},       {0.62f, shaft},      {0.78f, glm::mix(shaft, head, 0.35f)},
                             {0.92f, head},        {1.0f, head * 0.97f}};
  return curve(knots, t);
}

float longDistance(const LongBone& b, const Frame& frame, Vec p) {
  InBone q = frame.of(p);
  float t = glm::clamp(q.s / frame.length, 0.0f, 1.0f);
  glm::vec2 radii(profile(b.baseRadii.x, b.shaftRadii.x, b.headRadii.x, t),
                  profile(b.baseRadii.y, b.shaftRadii.y, b.headRadii.y, t));
  float bow = b.bow * 4.0f * t * (1.0f - t);
  // The palm's side of a shaft is flatter than its back.
  float y = q.y - bow;
  float d = ellipse({q.x, y}, {0.0f, 0.0f}, radii);
  float end = std::abs(q.s - 0.5f * frame.length) - 0.5f * frame.length;
  bool isHead = q.s > 0.5f * frame.length;
  float rounding = isHead ? 2.0f + (1.3f * std::min(b.headRadii.x, b.headRadii.y) - 2.0f) * b.round : 3.0f;
  d = smoothMax(d, end, rounding);
  if (b.notch > 0.0f && isHead) {
    float radius = 2.2f * b.notch;
    float groove = glm::length(glm::vec2(q.x, q.s - frame.length - radius + b.notch)) - radius;
    d = smoothMax(d, -groove, 1.2f);
  }
  return d;
}

Box around(std::span<const Vec> points, float margin) {
  Box box{points[0], points[0]};
  for (Vec p : points) box.low = glm::min(box.low, p), box.high = glm::max(box.high, p);
  return {box.low - margin, box.high + margin};
}

Box common(const Box& a, const Box& b) { return {glm::max(a.low, b.low), glm::min(a.high, b.high)}; }
bool isEmpty(const Box& box) { return glm::any(glm::greaterThan(box.low, box.high)); }

/// Moves tubes until their middles are `clearMm` from what is blocked, where they can. Ends that meet still do.
void clear(std::span<Segment> tubes, const Distance& blocked, float clearMm) {
  constexpr float kDelta = 0.2f;
  constexpr int kSteps = 30;
  auto slope = [&](Vec p, Vec step) { return blocked(p + step) - blocked(p - step); };
  auto moved = [&](Vec p) {
    for (int i = 0; i < kSteps; ++i) {
      float lack = clearMm - blocked(p);
      if (lack <= 0.0f) break;
      Vec away(slope(p, {kDelta, 0, 0}), slope(p, {0, kDelta, 0}), slope(p, {0, 0, kDelta}));
      if (away == Vec(0.0f)) break;
      p += glm::normalize(away) * std::min(lack, 1.0f);
    }
    return p;
  };
  for (Segment& s : tubes) s.a = moved(s.a), s.b = moved(s.b);
}

}  // namespace

Bone longBone(std::uint16_t label, const LongBone& b, float cortexMm, float shaftMm) {
  Frame frame(b);
  Bone bone;
  bone.label = label;
  float widest = std::max({b.baseRadii.x, b.baseRadii.y, b.headRadii.x, b.headRadii.y}) + std::abs(b.bow) + 2.0f;
  bone.box = around(std::array{b.base, b.head}, widest);
  bone.distance = [b, frame](Vec p) { return longDistance(b, frame, p); };
  bone.cortexMm = cortexMm;
  bone.shaftMm = shaftMm;
  bone.shaft = [frame](Vec p) {
    float t = frame.of(p).s / frame.length;
    return smoothStep(0.12f, 0.4f, t) * smoothStep(0.9f, 0.65f, t);
  };
  return bone;
}

Bone shortBone(std::uint16_t label, std::vector<Lump> lumps, float fillet, float cortexMm) {
  Bone bone;
  bone.label = label;
  bone.box = {lumps[0].centre - lumps[0].radii, lumps[0].centre + lumps[0].radii};
  for (const Lump& lump : lumps) {
    bone.box.low = glm::min(bone.box.low, lump.centre - lump.radii);
    bone.box.high = glm::max(bone.box.high, lump.centre + lump.radii);
  }
  bone.box = {bone.box.low - 2.0f, bone.box.high + 2.0f};
  bone.cortexMm = cortexMm;
  bone.distance = [lumps = std::move(lumps), fillet, seed = std::uint64_t(900 + label)](Vec p) {
    float d = ellipsoid(p, lumps[0].centre, lumps[0].radii);
    for (std::size_t i = 1; i < lumps.size(); ++i)
      d = smoothMin(d, ellipsoid(p, lumps[i].centre, lumps[i].radii), fillet);
    return d + 0.5f * noise(p / 7.0f, seed);
  };
  return bone;
}

void join(Bone& bone, Box box, Distance part, float fillet) {
  bone.box = {glm::min(bone.box.low, box.low), glm::max(bone.box.high, box.high)};
  bone.distance = [whole = std::move(bone.distance), part = std::move(part), fillet](Vec p) {
    return smoothMin(whole(p), part(p), fillet);
  };
}

void Skeleton::add(Bone bone, std::initializer_list<std::uint16_t> touches) {
  mPlaces[bone.label] = mBones.size();
  mBones.push_back({std::move(bone), touches});
}

float Skeleton::distanceTo(std::uint16_t label, Vec p) const {
  const Placed& placed = mBones[mPlaces.at(label)];
  float d = placed.bone.distance(p);
  if (d > kFarMm) return d;
  for (std::uint16_t other : placed.touches) d = smoothMax(d, mGapMm - distanceTo(other, p), 1.0f);
  return d;
}

float Skeleton::distanceTo(Vec p) const {
  float d = 1e6f;
  for (const Placed& placed : mBones) {
    Box box{placed.bone.box.low - kFarMm, placed.bone.box.high + kFarMm};
    bool isNear = glm::all(glm::greaterThan(p, box.low)) && glm::all(glm::lessThan(p, box.high));
    if (isNear) d = std::min(d, distanceTo(placed.bone.label, p));
  }
  return d;
}

void Skeleton::addCartilage(std::vector<Layer>& layers, std::uint16_t cartilage) const {
  Layer layer{cartilage, kCartilageHu};
  layer.edge = 1.1f;
  for (const Placed& placed : mBones)
    for (std::uint16_t other : placed.touches) {
      Box box = common(placed.bone.box, mBones[mPlaces.at(other)].bone.box);
      if (isEmpty(box)) continue;
      layer.solids.push_back({box, [this, one = placed.bone.label, other](Vec p) {
                                float d = distanceTo(one, p) - mGapMm;
                                return d > kFarMm ? d : smoothMax(d, distanceTo(other, p) - mGapMm, 0.8f);
                              }});
    }
  layers.push_back(std::move(layer));
}

void Skeleton::addLayers(std::vector<Layer>& layers, std::uint16_t cartilage) const {
  addCartilage(layers, cartilage);
  for (const Placed& placed : mBones) {
    const Bone& bone = placed.bone;
    Layer shell{bone.label, kCorticalHu}, inside{bone.label, kSpongyHu};
    shell.edge = inside.edge = 1.6f;
    shell.solids.push_back({bone.box, [this, label = bone.label](Vec p) { return distanceTo(label, p); }});
    inside.solids.push_back({bone.box, [this, &bone](Vec p) {
                               float shaft = bone.shaft ? bone.shaft(p) : 0.0f;
                               return distanceTo(bone.label, p) + bone.cortexMm + shaft * bone.shaftMm;
                             }});
    inside.texture = [&bone](Vec p) {
      float shaft = bone.shaft ? bone.shaft(p) : 0.0f;
      return (kMarrowHu - kSpongyHu) * shaft + (1.0f - 0.7f * shaft) * 95.0f * roughNoise(p / 2.2f, 811);
    };
    layers.push_back(std::move(shell));
    layers.push_back(std::move(inside));
  }
}

std::vector<Joint> walk(Joint start, std::span<const float> lengths, std::span<const float> flexDeg) {
  std::vector<Joint> joints;
  Joint at = start;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    float c = std::cos(glm::radians(flexDeg[i])), s = std::sin(glm::radians(flexDeg[i]));
    Vec along = at.along * c - at.up * s, up = at.along * s + at.up * c;
    joints.push_back({at.place, along, up});
    at = {at.place + along * lengths[i], along, up};
  }
  joints.push_back(at);
  return joints;
}

Bone boneBetween(std::uint16_t label, const Joint& from, const Joint& to, const Sizes& sizes, float scale, float into) {
  LongBone shape{from.place - from.along * into,
                 to.place - to.along * 0.4f,
                 from.up,
                 sizes.base * scale,
                 sizes.shaft * scale,
                 sizes.head * scale};
  shape.bow = sizes.bow, shape.notch = sizes.notch * scale, shape.round = sizes.round;
  return longBone(label, shape, sizes.cortex, sizes.shell * scale);
}

std::vector<glm::vec4> along(std::span<const Joint> joints, std::span<const float> heights, float radius) {
  std::vector<glm::vec4> path;
  for (std::size_t i = 0; i < joints.size() && i < heights.size(); ++i) {
    // The direction between the bones before and behind.
    Vec up = i == 0 ? joints[0].up : glm::normalize(joints[i].up + joints[i - 1].up);
    path.emplace_back(joints[i].place + up * heights[i], radius);
  }
  return path;
}

float distanceTo(std::span<const Segment> tubes, Vec p, float fillet) {
  float d = 1e6f;
  for (const Segment& s : tubes) d = fillet > 0.0f ? smoothMin(d, distance(s, p), fillet) : std::min(d, distance(s, p));
  return d;
}

glm::vec3 boneColor(int index) {
  constexpr glm::vec3 kTints[] = {{0.95f, 0.88f, 0.72f}, {0.82f, 0.78f, 0.62f}, {0.93f, 0.76f, 0.62f},
                                  {0.76f, 0.82f, 0.74f}, {0.88f, 0.82f, 0.86f}, {0.72f, 0.78f, 0.86f},
                                  {0.97f, 0.93f, 0.84f}};
  return kTints[std::size_t(index) % std::size(kTints)];
}

void addBoneNames(std::vector<LabelInfo>& table, int first, std::span<const char* const> names, const char* middle,
                  std::span<const char* const, 5> rays) {
  int id = first;
  auto add = [&](std::string name) {
    table.push_back({std::uint16_t(id), std::move(name), boneColor(id)});
    ++id;
  };
  for (const char* name : names) add(name);
  for (const char* order : {"first", "second", "third", "fourth", "fifth"}) add(fmt::format("{} {}", order, middle));
  for (std::size_t i = 0; i < rays.size(); ++i)
    for (const char* which : {"proximal", "middle", "distal"})
      if (i > 0 || which[0] != 'm') add(fmt::format("{} phalanx of {}", which, rays[i]));
}

void addSkin(std::vector<Layer>& layers, const Box& box, const Distance& skin, std::uint16_t skinLabel,
             std::uint16_t fatLabel) {
  constexpr float kSkinMm = 2.2f;
  Layer outside{skinLabel, kSkinHu}, fat{fatLabel, kFatHu};
  outside.solids.push_back({box, skin});
  fat.solids.push_back({box, [skin](Vec p) { return skin(p) + kSkinMm; }});
  fat.texture = [](Vec p) { return 25.0f * roughNoise(p / 4.0f, 821); };
  layers.push_back(std::move(outside));
  layers.push_back(std::move(fat));
}

void addFlesh(std::vector<Layer>& layers, std::uint16_t label, float value, std::vector<Segment> tubes,
              std::initializer_list<std::uint16_t> onto) {
  Layer layer{label, value};
  layer.tubes = std::move(tubes);
  layer.onto = onto;
  layer.texture = [](Vec p) { return 7.0f * noise(p / Vec(3.0f, 3.0f, 9.0f), 823); };
  layers.push_back(std::move(layer));
}

void addVessels(std::vector<Layer>& layers, Layer artery, Layer vein, const Distance& blocked, float leastMm) {
  float clearMm = leastMm + 0.3f;
  clear(artery.tubes, blocked, clearMm);
  auto besideArteries = [&](Vec p) { return std::min(blocked(p), distanceTo(artery.tubes, p, 0.0f)); };
  clear(vein.tubes, besideArteries, clearMm);
  layers.push_back(std::move(vein));
  layers.push_back(std::move(artery));
}

std::vector<Layer> layersOf(const Tissues& tissues, const Skeleton& skeleton,
                            const std::function<void(std::vector<Layer>&, float)>& addFleshTo,
                            const std::function<void(std::vector<Layer>&, const Distance&, float)>& addVesselsTo) {
  std::vector<Layer> layers;
  addSkin(layers, tissues.box, tissues.skin, tissues.skinLabel, tissues.fatLabel);
  addFleshTo(layers, kLeastVoxels * tissues.spacingMm);
  skeleton.addLayers(layers, tissues.cartilageLabel);
  auto blocked = [&](Vec p) { return std::min(skeleton.distanceTo(p), -tissues.skin(p)); };
  addVesselsTo(layers, blocked, kThinnestVoxels * tissues.spacingMm);
  return layers;
}

Sample scan(const Description& description, const Grid& grid, const std::vector<Layer>& layers, std::uint64_t seed,
            Progress& progress) {
  return fill(description, grid, progress, [&](const Slice& slice) {
    std::fill(slice.values.begin(), slice.values.end(), kAir);
    paint(slice, layers);
    std::uint64_t first = grid.index(0, 0, slice.z);
    for (std::size_t i = 0; i < slice.values.size(); ++i)
      slice.values[i] = std::max(slice.values[i] + kNoiseHu * gaussian(hash(seed, first + i)), -1024.0f);
  });
}

}  // namespace velum::io::limb
