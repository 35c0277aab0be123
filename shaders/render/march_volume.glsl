// Direct volume rendering: material composited front to back, segment by segment between the samples.
#include "common/select.glsl"
#include "common/shade.glsl"
#include "common/volume.glsl"
#include "render/composite.glsl"
#include "render/data_color.glsl"
#include "render/entry.glsl"
#include "render/hit.glsl"
#include "render/walk.glsl"

/// A stretch of one ray between two samples, or between the first and the last of a group.
struct Segment {
  float t0;
  float t1;
  float x0;     // values at its ends, table positions
  float x1;
  float depth;  // optical depth by the transfer function, of the part that shows
  float share0;  // shares of what shows at its ends
  float share1;
  vec2 solids0;  // of solidsOf() there
  vec2 solids1;
};

/// Whether each sample asks whose it is. Where structures have no say in what is seen, only what is hit is asked in the end.
bool asksStructures() {
  return hasFlag(kFlagInlays) || hasFlag(kFlagSheets) || (LABELS == 1 && hasFlag(kFlagStructureLooks));
}

#if LABELS != 0
/// Whether anything between two places may belong to a surface.
bool mayBeSolid(vec2 a, vec2 b) { return max(a.y, b.y) > 0.5; }
#endif

/// What is left of the extinction of a segment's material where it begins. @param depth  of all of it
float shownOf(Segment segment, float depth) { return segment.share0 > 0.5 ? depth / max(segment.depth, 1e-12) : 0.0; }

/// Shades and composites one segment.
/// @param slot  of groupSlot(), of its group
void addSegment(inout Hit hit, Ray ray, Walk walk, Segment segment, int slot, inout Entry entry, bool sparedOnly) {
  vec3 faceNormal = entry.normal;
  float tm = 0.5 * (segment.t0 + segment.t1);
  vec2 classes = vec2(1.0, 0.0);
  bool isSolid = false;
#if LABELS != 0
  if (hasFlag(kFlagSpareClasses) && sparedOnly) {
    // What was asked for is what some cut spares: here it is known which of it all of them leave.
    float part = shownPart(segment.share0, segment.share1);
    classes = classesAt(ray.origin + tm * ray.direction);
    segment.share0 = shareIn(labelVoxelAt(ray.origin + segment.t0 * ray.direction), true, classes);
    segment.share1 = shareIn(labelVoxelAt(ray.origin + segment.t1 * ray.direction), true, classes);
    segment.depth *= shownPart(segment.share0, segment.share1) / max(part, 1e-6);
    segment.solids0 = min(segment.solids0, segment.share0);
    segment.solids1 = min(segment.solids1, segment.share1);
  }
  if (hasSolids()) isSolid = mayBeSolid(segment.solids0, segment.solids1);
  if (usesShares(sparedOnly)) {
    // The middle of the part that shows; of what is opaque where it begins.
    bool isOpaque = isSolid && max(segment.solids0.x, segment.solids1.x) > 0.5;
    float s0 = isOpaque ? segment.solids0.x : isSolid ? segment.solids0.y : segment.share0;
    float s1 = isOpaque ? segment.solids1.x : isSolid ? segment.solids1.y : segment.share1;
    float part = 0.5 * (segment.t1 - segment.t0) * shownPart(s0, s1);
    tm = s1 > s0 ? segment.t1 - part : segment.t0 + part;
    if (isOpaque) tm -= part;
  }
#endif
  vec3 p = ray.origin + tm * ray.direction;
  vec3 tex = texAt(walk, tm);
  uint structure = 0u;
  float depth = segment.depth, surface = 0.0, alpha = 1.0 - exp(-depth);
  bool asksGradient = hasFlag(kFlagShaded) || hasFlag(kFlagGradientOpacity);
  // Whose material it is.
#if LABELS != 0
  vec3 slope = vec3(0.0);
  int what = !isSolid ? kOfAll : max(segment.solids0.x, segment.solids1.x) > 0.5 ? kOfSolids : kOfSurfaces;
  if (asksGradient && usesShares(sparedOnly)) slope = shareSlopeAt(p, what, sparedOnly, classes);
  if (asksStructures() || sparedOnly || hasSolids()) {
    int who = (sparedOnly ? sparedOf(classes) : kShown) | (isSolid ? kSolid : 0);
    structure = ownerAt(p, who, isSolid || alpha * (1.0 - hit.color.a) > 0.01, leanOutwards(slope)).id;
  }
#endif
  if (hasFlag(kFlagSpares) && sparedOnly && !cutsKeep(p, structure)) return;
  // Where its surface looks to.
  vec3 gradient = vec3(0.0);
  float steepness = 1.0;
#if LABELS == 2
  gradient = -slope;
#else
  if (asksGradient) {
    gradient = gradientIn(gradientStoredInGroup(slot, tex), tex);
    // Where the value hardly changes the gradient is noise: less of it counts.
    steepness = smoothstep(0.0, 1.0, length(gradient) * frame.tablePerValue * 60.0 / frame.voxelsPerLength);
  }
#endif
  float len = length(gradient);
  vec3 outwards = len > 0.0 ? -gradient / len : -ray.direction;
  float away = dot(outwards, ray.direction);
#if LABELS == 2
  // At a rim it may look away a little: then it is seen from its side.
  if (away > 0.0) outwards = normalize(outwards - (away + 1e-3) * ray.direction);
#else
  if (away > 0.0) outwards = -outwards;
#endif
#if LABELS == 1
  if (asksGradient && usesShares(sparedOnly)) {
    // On the border of what shows the surface is the border's, unless the data has one that runs alike: that one is smoother.
    float fall = length(slope);
    float onBorder = smoothstep(0.02, 0.12, fall);
    vec3 borderNormal = slope / max(fall, 1e-6);
    float isAlike = isSolid ? 0.0 : steepness * smoothstep(0.3, 0.8, dot(outwards, borderNormal));
    outwards = normalize(mix(outwards, borderNormal, onBorder * (1.0 - isAlike)) + 1e-6);
    steepness = isSolid ? onBorder : max(steepness, onBorder);
  }
#endif
  // Of what colour it is.
#if LABELS == 2
  vec4 row = structureRow(structure);
  vec3 albedo = row.rgb;
  depth = solidDepth(segment.solids0, segment.solids1, segment.t1 - segment.t0, row.a);
#else
#if COLOR
  vec3 albedo = volumeColorAt(tex);
#else
  vec3 albedo = colorBetween(segment.x0, segment.x1);
#endif
#if LABELS == 1
  if (hasFlag(kFlagGradientOpacity) && hasSolids()) depth *= gradientFactor(gradient);
  if (isSolid) {
    // What is before the surface, or behind it, belongs to nobody here.
    vec4 row = structureRow(structure);
    surface = solidDepth(segment.solids0, segment.solids1, segment.t1 - segment.t0, row.a);
    depth *= frame.unlabelledOpacity;
    albedo = mix(albedo, row.rgb, surface / max(depth + surface, 1e-9));
    depth += surface;
  } else if (hasFlag(kFlagStructureLooks)) {
    depth *= structure == 0u ? frame.unlabelledOpacity : structureRow(structure).a;
    bool isByFace = entry.t >= 0.0 && (tm - entry.t) * frame.voxelsPerLength < 1.5;
    // What is spared alone borders on what is not there.
    albedo = tinted(albedo, p, isByFace || sparedOnly || !asksGradient ? vec3(0.0) : outwards * steepness, structure);
  }
#endif
#endif
#ifdef MEMBRANES
  if (hasFlag(kFlagInlays)) depth = fadedDepth(depth, segment.t1 - segment.t0, inlayShare(p, structure));
#endif
  // Where an extrusion ends there is a face, too.
  float faceDepth = entry.t >= 0.0 ? (tm - entry.t) * -dot(faceNormal, ray.direction) : kFar;
  if (hasFlag(kFlagSpareDepths) && sparedOnly) {
    EndFace end = endFaceAt(p, structure);
    vec3 endNormal = end.cut < 0 ? faceNormal : endNormalAt(end.cut, p);
    // As far as the ray has come from it: rays that meet the wall beside it have come from elsewhere.
    float along = end.left / max(-dot(endNormal, ray.direction), 1e-4);
    bool isNearer = end.cut >= 0 && dot(endNormal, ray.direction) < 0.0 && along < faceDepth;
    faceNormal = isNearer ? endNormal : faceNormal;
    faceDepth = isNearer ? along : faceDepth;
    if (hasFlag(kFlagOverlaps) && end.isShared) albedo = mix(albedo, kOverlapColor, kOverlapShare);
  }
  // The light on it.
  vec3 normal = -ray.direction;
  vec3 color = albedo;
  if (asksGradient) {
#if LABELS != 2
    if (hasFlag(kFlagGradientOpacity) && !hasSolids()) depth *= gradientFactor(gradient);
#endif
    normal = normalize(mix(-ray.direction, outwards, steepness) + 1e-6);
    // On a cut the surface is the cut's; a voxel and a half behind it the data's own again, and so where a membrane lies
    // along an edge of the data: it has steps as large as voxels.
    if (hasFlag(kFlagCuts) && faceDepth < kFar) {
      float own = smoothstep(0.25, 1.5, faceDepth * frame.voxelsPerLength);
#if defined(MEMBRANES) && LABELS != 2
      float edge = smoothstep(0.5, 1.5, len * frame.tablePerValue * 60.0 / frame.voxelsPerLength);
      own = max(own, edge * smoothstep(0.6, 0.9, dot(outwards, faceNormal)));
#endif
      normal = normalize(mix(faceNormal, normal, own) + 1e-6);
    }
    color = shadeSurface(albedo, normal, -ray.direction, lightTexAt(p, normal, steepness));
  }
  if (hasFlag(kFlagGradientOpacity) || hasFlag(kFlagInlays) || LABELS != 0) alpha = 1.0 - exp(-depth);
  float voxels = max((segment.t1 - segment.t0) * frame.voxelsPerLength, 1e-6), solid = hasFlag(kFlagFinish) ? 1.0 - exp(-depth / voxels) : 1.0;
  int face = faceSeen(entry, ray, segment.t0, tm, shownOf(segment, depth - surface), isSolid && segment.solids0.x > 0.5);
  if (alpha > 0.0) addSample(hit, vec4(color * alpha, alpha), tm, normal, structure, solid, face, entry.t);
}

/// Segments between neighbouring samples of the lattice, cut off at a stretch's ends.
const int kGroup = 8;
struct Group {
  float lattice;  // t of its first lattice point
  float dt;
  float from;
  float to;
  float x[kGroup + 1];       // values, table positions
  float shares[kGroup + 1];  // of what shows there
  vec2 solids[kGroup + 1];   // of solidsOf() there
};

float timeIn(Group group, Walk walk, int i) { return clamp(group.lattice + float(i) * group.dt, group.from, group.to); }

float shownPartOf(Group group, int i, bool sparedOnly) {
#if LABELS != 0
  if (usesShares(sparedOnly)) return shownPart(group.shares[i], group.shares[i + 1]);
#endif
  return 1.0;
}

float middleOf(Group group, Walk walk, int i) { return 0.5 * (timeIn(group, walk, i) + timeIn(group, walk, i + 1)); }

Group groupAt(Walk walk, Ray ray, GroupPlace place, float to, bool sparedOnly) {
  Group group;
  group.lattice = place.lattice;
  group.dt = place.dt;
  group.from = place.from;
  group.to = to;
#if LABELS != 2
  GroupBrick brick = groupBrick(texBetween(walk, timeIn(group, walk, 0), timeIn(group, walk, kGroup)));
  for (int i = 0; i <= kGroup; ++i) group.x[i] = tableIn(storedInGroup(brick, texAt(walk, timeIn(group, walk, i))));
#endif
#if LABELS != 0
  if (usesShares(sparedOnly)) {
    vec3 first = labelVoxelAt(ray.origin);
    vec3 perLength = mat3(frame.labelFromScene) * ray.direction;
    for (int i = 0; i <= kGroup; ++i) {
      vec3 at = first + timeIn(group, walk, i) * perLength;
      vec4 shares = isBeyondLabels(at) ? frame.sharesBeyond : sharesIn(at);
      group.shares[i] = shareOf(shares, sparedOnly, vec2(1.0));
      if (hasSolids()) group.solids[i] = solidsOf(shares, group.shares[i]);
    }
  }
#endif
  return group;
}

/// False when the group holds no material. May err on the other side.
bool mayShow(Group group) {
#if LABELS == 2
  return true;
#else
  float low = group.x[0];
  float high = group.x[0];
  for (int i = 1; i <= kGroup; ++i) {
    low = min(low, group.x[i]);
    high = max(high, group.x[i]);
  }
  bool shows = high >= frame.shownFrom && low < frame.shownTo;
#if LABELS == 1
  if (hasSolids())
    for (int i = 0; i < kGroup; ++i) shows = shows || mayBeSolid(group.solids[i], group.solids[i + 1]);
#endif
  return shows;
#endif
}

/// Optical depth below which segments are shaded together: what hides less than this share of what is behind it needs no
/// gradient at every half voxel.
const float kThin = 0.08;

/// The segments of a group that show anything, thin ones taken together by the half group or the whole.
struct Depths {
  float of[kGroup];
  float nearHalf;
  float farHalf;
  bool isThin;
  bool isNearThin;
  bool isFarThin;
  uint marks;  // bit i: a segment begins with the i-th
};

/// What all segments of a group have in common, as far as structures have a say in it.
struct Whole {
  bool isOne;     // they are all of one structure, and all of it shows
  float opacity;  // that the structure gives its material
};

Whole wholeOf(Group group, Walk walk, Ray ray, bool sparedOnly) {
  Whole whole = Whole(true, 1.0);
#if LABELS == 1
  if (asksStructures()) {
    uint first = labelAt(ray.origin + middleOf(group, walk, 0) * ray.direction);
    for (int i = 1; i < kGroup; ++i)
      whole.isOne = whole.isOne && labelAt(ray.origin + middleOf(group, walk, i) * ray.direction) == first;
    if (hasFlag(kFlagStructureLooks)) whole.opacity = first == 0u ? frame.unlabelledOpacity : structureRow(first).a;
  }
  if (usesShares(sparedOnly))
    for (int i = 0; i <= kGroup; ++i) whole.isOne = whole.isOne && group.shares[i] > 0.98;
#elif LABELS == 2
  whole.isOne = false;
#endif
  return whole;
}

/// Bit i: a part of the i-th segment of a group shows, as far as structures have a say in it.
uint shownIn(Group group, bool sparedOnly) {
  uint marks = 0u;
#if LABELS != 0
  for (int i = 0; i < kGroup; ++i) marks |= shownPartOf(group, i, sparedOnly) > 0.0 ? 1u << i : 0u;
#else
  marks = !sparedOnly || sparesOf(0u) >= 0 ? 255u : 0u;
#endif
  return marks;
}

/// @param asked  bits of the segments that may show; 0: the group is only computed because its neighbours' are
Depths depthsOf(Group group, Walk walk, Ray ray, uint asked, bool sparedOnly) {
  Depths depths;
  depths.marks = 0u;
  bool hasSolid = false;
#if LABELS != 2
  TableEnd before = tableEndAt(group.x[0]);
#endif
  for (int i = 0; i < kGroup; ++i) {
    float span = timeIn(group, walk, i + 1) - timeIn(group, walk, i);
    bool isEmpty = !(span > 0.0);
    span *= shownPartOf(group, i, sparedOnly);
    bool isSolid = false;
#if LABELS != 0
    if (hasSolids()) {
      isSolid = !isEmpty && mayBeSolid(group.solids[i], group.solids[i + 1]);
      hasSolid = hasSolid || isSolid;
      span *= 1.0 - shownPart(group.solids[i].y, group.solids[i + 1].y);
    }
#endif
#if LABELS == 2
    depths.of[i] = 0.0;
#else
    TableEnd after = tableEndAt(group.x[i + 1]);
    depths.of[i] = extinctionBetween(before, after) * span;
    before = after;
#endif
    depths.marks |= depths.of[i] > 0.0 || isSolid ? 1u << i : 0u;
  }
  depths.marks &= asked;
  depths.nearHalf = depths.of[0] + depths.of[1] + depths.of[2] + depths.of[3];
  depths.farHalf = depths.of[4] + depths.of[5] + depths.of[6] + depths.of[7];
  Whole whole = wholeOf(group, walk, ray, sparedOnly);
  depths.isThin = (depths.nearHalf + depths.farHalf) * whole.opacity < kThin;
  depths.isNearThin = depths.nearHalf * whole.opacity < 2.0 * kThin;
  depths.isFarThin = depths.farHalf * whole.opacity < 2.0 * kThin;
  bool isJoined = whole.isOne && !hasSolid;
  depths.isThin = isJoined && depths.isThin;
  depths.isNearThin = isJoined && depths.isNearThin;
  depths.isFarThin = isJoined && depths.isFarThin;
  uint marks = depths.marks;
  marks = depths.isNearThin && (marks & 15u) != 0u ? marks & ~15u | 1u : marks;
  marks = depths.isFarThin && (marks & 240u) != 0u ? marks & ~240u | 16u : marks;
  depths.marks = depths.isThin && marks != 0u ? 1u : marks;
  return depths;
}

/// The segment that begins with the n-th of a group.
Segment segmentAt(Group group, Walk walk, Depths depths, int n, bool sparedOnly) {
  bool isHalf = n < 4 ? depths.isNearThin : depths.isFarThin;
  int count = depths.isThin ? kGroup : isHalf ? 4 : 1;
  float depth = oneOf(depths.of[0], depths.of[1], depths.of[2], depths.of[3], depths.of[4], depths.of[5], depths.of[6], depths.of[7], n);
  depth = isHalf ? n < 4 ? depths.nearHalf : depths.farHalf : depth;
  depth = depths.isThin ? depths.nearHalf + depths.farHalf : depth;
  int m = n + count - 1;
  float x0 = 0.0;
  float x1 = 0.0;
#if LABELS != 2
  x0 = oneOf(group.x[0], group.x[1], group.x[2], group.x[3], group.x[4], group.x[5], group.x[6], group.x[7], n);
  x1 = oneOf(group.x[1], group.x[2], group.x[3], group.x[4], group.x[5], group.x[6], group.x[7], group.x[8], m);
#endif
  float s0 = 1.0;
  float s1 = 1.0;
  vec2 solids0 = vec2(0.0);
  vec2 solids1 = vec2(0.0);
#if LABELS != 0
  if (hasSolids()) {
    // Surfaces are never joined.
    for (int i = 0; i < kGroup; ++i) {
      solids0 = i == n ? group.solids[i] : solids0;
      solids1 = i == m ? group.solids[i + 1] : solids1;
    }
  }
  if (usesShares(sparedOnly)) {
    s0 = oneOf(group.shares[0], group.shares[1], group.shares[2], group.shares[3], group.shares[4], group.shares[5], group.shares[6], group.shares[7], n);
    s1 = oneOf(group.shares[1], group.shares[2], group.shares[3], group.shares[4], group.shares[5], group.shares[6], group.shares[7], group.shares[8], m);
  }
#endif
  return Segment(timeIn(group, walk, n), timeIn(group, walk, m + 1), x0, x1, depth, s0, s1, solids0, solids1);
}

/// Composites a stretch front to back. Rays of a SIMD group go in step, and a software driver runs both sides of every
/// branch and every loop once more than it is needed when the condition stands at its head. So each kind of work has a loop
/// of its own, with the condition at its foot, in which nearly all rays have something to do: leaping over empty cells;
/// fetching groups of samples until one holds material; shading its segments. Groups and leaps keep to the same lattice, so
/// leaping changes no picture. A ray that has left a loop is still computed, though not stored, while others go on, and Mesa
/// 22 takes what it computes last as the value after the loop: so nothing that is used after a loop may change when its last
/// turn is repeated.
void march(inout Hit hit, Ray ray, Walk walk, float a, float b, Face face, bool sparedOnly) {
  Entry entry = entryBy(face, ray, walk, a);
  float cutoff = hasFlag(kFlagStopOpaque) ? frame.opaqueAlpha : 2.0;
  float t = a;
  do {
    // Go on to the next group with material.
    Group group;
    uint asked;
    float end;
    do {
      GroupPlace place = nextGroup(walk, t, b, kGroup, sparedOnly);
      t = place.from;
      group = groupAt(walk, ray, place, b, sparedOnly);
      asked = mayShow(group) ? 255u : 0u;
      if (sparedOnly || usesShares(sparedOnly)) asked &= shownIn(group, sparedOnly);
      end = max(timeIn(group, walk, kGroup), afterAll(t));
      t = asked != 0u ? t : end;
    } while (asked == 0u && t < b);
    t = end;
    // Shade it.
    Depths depths = depthsOf(group, walk, ray, asked, sparedOnly);
    uint marks = depths.marks;
    int slot = groupSlot(texBetween(walk, timeIn(group, walk, 0), timeIn(group, walk, kGroup)));
    do {
      Segment segment = segmentAt(group, walk, depths, max(findLSB(marks), 0), sparedOnly);
      if (marks != 0u) addSegment(hit, ray, walk, segment, slot, entry, sparedOnly);
      marks &= marks - 1u;
    } while (marks != 0u && hit.color.a < cutoff);
  } while (t < b && hit.color.a < cutoff);
}

void marchStretch(inout Hit hit, Ray ray, Walk walk, Span span) {
  addFaceData(hit, ray, span.a, span.face);
  march(hit, ray, walk, span.a, span.b, span.face, span.sparedOnly);
}

/// Whose it is that was hit.
void finishRay(inout Hit hit, Ray ray, Walk walk) {
#if LABELS != 0
  bool isKnown = asksStructures() || hit.structure != 0u;  // what cuts spare is
  if (!isKnown && hit.distance < kFar) hit.structure = ownerAt(ray.origin + hit.distance * ray.direction, kShown).id;
#endif
}

/// True when nothing further along the ray can show.
bool isDone(Hit hit) { return hasFlag(kFlagStopOpaque) && hit.color.a >= frame.opaqueAlpha; }
