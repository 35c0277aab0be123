// One ray a pixel through the volume, from stretch to stretch between the cuts, from segment to segment between the
// samples, leaping over cells that the transfer function leaves empty. The only ray march in the program.
//
// MODE 0 volume, 1 maximum, 2 isosurface; LABELS 0 none, 1 over a volume, 2 alone; COLOR 1 for colour volumes, 2 for mixed
// channels;
// GRADIENTS 1 looks gradients up in a texture; MEMBRANES is there when some cut is a membrane.
layout(local_size_x = 8, local_size_y = 8) in;

#include "common/frame.glsl"
#include "common/cuts.glsl"
#include "common/volume.glsl"
#include "common/shade.glsl"

layout(binding = kSkipUnit) uniform usampler3D skipTexture;  // r, g: cells to the nearest with content, with exempt content
layout(binding = kNoiseUnit) uniform sampler2D noiseTexture;
layout(binding = kSurfaceColorUnit) uniform sampler2D surfaceColorTexture;
layout(binding = kSurfaceAuxUnit) uniform sampler2D surfaceAuxTexture;  // xyz normal, w distance along the ray
layout(std430, binding = kCellBinding) readonly buffer CellBlock { vec2 cellRange[]; };

layout(binding = 0, rgba32f) uniform image2D sumImage;          // premultiplied colour, averaged over the samples so far
layout(binding = 1, rgba32f) uniform writeonly image2D hitImage;  // distance along the ray, mm; normal, octahedral; structure id + 1, 0: no hit

layout(location = 0) uniform ivec4 tile;     // x, y: corner in the image; z, w: its size
layout(location = 1) uniform ivec4 window_;  // x, y: the image's corner in the whole picture; z: stride of the groups

struct Hit {
  vec4 color;      // premultiplied
  float distance;  // kFar: nothing
  vec3 normal;
  uint structure;
};

vec3 texFrom(vec3 p) { return (frame.texFromScene * vec4(p, 1.0)).xyz; }

/// Part of the ray inside the volume's box.
vec2 boxInterval(Ray ray) {
  vec3 o = texFrom(ray.origin);
  vec3 d = (frame.texFromScene * vec4(ray.direction, 0.0)).xyz;
  d = mix(d, vec3(1e-12), lessThan(abs(d), vec3(1e-12)));
  vec3 a = -o / d;
  vec3 b = (1.0 - o) / d;
  vec3 low = min(a, b);
  vec3 high = max(a, b);
  return vec2(max(max(low.x, low.y), max(low.z, 0.0)), min(min(high.x, high.y), high.z));
}

/// Walks the lattice of samples t_k = first + k dt and says which of them may be left out.
struct Walk {
  vec3 tex0;       // texture coordinates at t = 0
  vec3 texPerMm;
  vec3 cell0;      // the same in cells
  vec3 cellPerMm;  // never 0
  vec3 mmPerCell;
  vec3 forward;    // signs of the ray's way through the cells, half of 1
  float first;     // t of lattice point 0
  float dt;
};

Walk walkAlong(Ray ray, float first) {
  Walk walk;
  walk.tex0 = texFrom(ray.origin);
  walk.texPerMm = (frame.texFromScene * vec4(ray.direction, 0.0)).xyz;
  walk.cell0 = walk.tex0 * frame.cellsPerTex.xyz;
  walk.cellPerMm = walk.texPerMm * frame.cellsPerTex.xyz;
  walk.cellPerMm = mix(walk.cellPerMm, vec3(1e-12), lessThan(abs(walk.cellPerMm), vec3(1e-12)));
  walk.mmPerCell = 1.0 / walk.cellPerMm;
  walk.forward = mix(vec3(-0.5), vec3(0.5), greaterThan(walk.cellPerMm, vec3(0.0)));
  walk.first = first;
  walk.dt = frame.step.x;
  return walk;
}

vec3 texAt(Walk walk, float t) { return walk.tex0 + t * walk.texPerMm; }

ivec3 cellAt(Walk walk, float t) {
  return ivec3(clamp(walk.cell0 + t * walk.cellPerMm, vec3(0.0), frame.cellGrid.xyz - 0.5));
}

/// Distance, in cells, to the next cell with content; 0 in one.
uint cellsToContent(ivec3 cell, bool exemptOnly) {
  uvec2 d = texelFetch(skipTexture, cell, 0).rg;
  return exemptOnly ? d.g : d.r;
}

/// Where the ray leaves the cube of empty cells around a cell.
float leaveEmpty(Walk walk, float t, ivec3 cell, uint reach) {
  vec3 target = vec3(cell) + 0.5 + walk.forward * (2.0 * float(reach) - 1.0);
  vec3 exit = (target - walk.cell0) * walk.mmPerCell;
  return max(min(exit.x, min(exit.y, exit.z)), t);
}

/// The first lattice point after t. From afar t is so coarse that rounding would give t itself again, and the ray would
/// never end.
float nextSample(Walk walk, float t) {
  float k = floor((t - walk.first) / walk.dt + 1.0 + 1e-4);
  float next = walk.first + k * walk.dt;
  return next > t ? next : next + walk.dt;
}

vec3 lightTexAt(vec3 p, vec3 normal) { return texFrom(p + normal * frame.lightGrid.w); }

float greyAt(float table) { return clamp(table / float(kTransferSize - 1) * frame.window.x + frame.window.y, 0.0, 1.0); }

#if MODE == 0 || defined(MEMBRANES)
void addSample(inout Hit hit, vec4 premultiplied, float t, vec3 normal, uint structure) {
  float left = 1.0 - hit.color.a;
  // The layers (position, normal, id) are those of the sample that makes the ray half opaque, or of the first one.
  bool half_ = hit.color.a < 0.5 && hit.color.a + left * premultiplied.a >= 0.5;
  if (hit.distance == kFar || half_) {
    hit.distance = t;
    hit.normal = normal;
    hit.structure = structure;
  }
  hit.color += left * premultiplied;
}


/// How the data looks on a slice: grey values by the window, or colours, tinted by structures. a: 0 where it is black.
vec4 sliceColor(vec3 p, uint structure) {
  vec3 tex = texFrom(p);
#if COLOR
  vec4 color = vec4(volumeColorAt(tex) * (COLOR == 2 ? texelAt(tex) : 1.0), texelAt(tex) > 0.02 ? 1.0 : 0.0);
#elif LABELS == 2
  vec4 color = vec4(0.0);
#else
  float value = greyAt(tableAt(tex));
  vec4 color = vec4(vec3(value), smoothstep(0.0, 0.02, value));
#endif
#if LABELS != 0
  vec4 row = structureRow(structure);
  if (structure != 0u && row.a > 0.0) color = vec4(mix(color.rgb, row.rgb * (0.35 + 0.65 * color.rgb), 0.6 * frame.window.z), 1.0);
#endif
  return color;
}

uint structureAt(vec3 p) {
#if LABELS != 0
  return labelAt(p);
#else
  return 0u;
#endif
}
#endif

/// A face that a stretch begins on.
struct Face {
  int cut;       // -1: none
  int triangle;  // of a membrane; -1: the plane around it
};

vec3 faceNormalAt(Face face, vec3 p, vec3 direction) {
#ifdef MEMBRANES
  if (cuts[face.cut].kind.x == kCutMembrane) return sheetNormalAt(face.cut, face.triangle, p, direction);
#endif
  return convexNormal(face.cut, p);
}

#if MODE == 0

/// The slice's grey values on a cut face, over everything behind it.
void addSliceFace(inout Hit hit, Ray ray, float t, int cut, vec3 normal) {
  vec3 p = ray.origin + t * ray.direction;
  uint structure = structureAt(p);
  vec4 color = sliceColor(p, structure);
  float alpha = color.a * cuts[cut].face.x;
  if (alpha > 0.0) addSample(hit, vec4(color.rgb * alpha, alpha), t, normal, structure);
}

/// A stretch of one ray between two samples, or between the first and the last of a group.
struct Segment {
  float t0;
  float t1;
  float x0;     // values at its ends, table positions
  float x1;
  float depth;  // optical depth by the transfer function
};

/// Shades and composites one segment.
void addSegment(inout Hit hit, Ray ray, Walk walk, Segment segment, float faceT, vec3 faceNormal, bool exemptOnly) {
  float tm = 0.5 * (segment.t0 + segment.t1);
  vec3 p = ray.origin + tm * ray.direction;
  vec3 tex = texAt(walk, tm);
  uint structure = 0u;
  float depth = segment.depth;
  float alpha = 1.0 - exp(-depth);
#if LABELS == 2
  structure = labelAt(p);
  if (exemptOnly && !cutsKeep(p, structure)) return;
  vec4 material = labelMaterial(p);
  vec3 albedo = material.rgb / max(material.a, 1e-6);
#else
#if COLOR
  vec3 albedo = volumeColorAt(tex);
#else
  vec3 albedo = colorBetween(segment.x0, segment.x1);
#endif
#if LABELS == 1
  structure = labelAt(p);
  if (exemptOnly && !cutsKeep(p, structure)) return;
  vec4 row = structureRow(structure);
  depth *= structure == 0u ? frame.window.w : row.a;
  if (structure != 0u) albedo = mix(albedo, row.rgb, frame.window.z);
#endif
#endif
#ifdef MEMBRANES
  if (hasFlag(kFlagSlices)) depth = fadedDepth(depth, segment.t1 - segment.t0, sliceShare(p, structure));
#endif
  vec3 normal = -ray.direction;
  vec3 color = albedo;
  if (hasFlag(kFlagShaded) || hasFlag(kFlagGradientOpacity)) {
#if LABELS == 2
    float h = 0.9 / frame.cellGrid.w;
    vec3 gradient = vec3(labelMaterial(p + vec3(h, 0, 0)).a - labelMaterial(p - vec3(h, 0, 0)).a,
                         labelMaterial(p + vec3(0, h, 0)).a - labelMaterial(p - vec3(0, h, 0)).a,
                         labelMaterial(p + vec3(0, 0, h)).a - labelMaterial(p - vec3(0, 0, h)).a);
    float steepness = 1.0;
#else
    // What is seen of opaque material is its front, and just within a thin plate the gradient already turns round.
    float front = 0.75 * alpha / frame.cellGrid.w;
    vec3 gradient = gradientAt(texAt(walk, tm - front));
    if (hasFlag(kFlagGradientOpacity)) depth *= gradientFactor(gradient);
    // Where the value hardly changes the gradient is noise: less of it counts.
    float steepness = smoothstep(0.0, 1.0, length(gradient) * frame.valueFromTexel.z * 60.0 / frame.cellGrid.w);
#endif
    float len = length(gradient);
    vec3 out_ = len > 0.0 ? -gradient / len : -ray.direction;
    if (dot(out_, ray.direction) > 0.0) out_ = -out_;
    normal = normalize(mix(-ray.direction, out_, steepness) + 1e-6);
    // On a cut the surface is the cut's; a voxel and a half behind it the data's own again.
    if (hasFlag(kFlagCuts) && faceT >= 0.0)
      normal = normalize(mix(faceNormal, normal, smoothstep(0.25, 1.5, (tm - faceT) * frame.cellGrid.w * -dot(faceNormal, ray.direction))) + 1e-6);
    color = shadeSurface(albedo, normal, -ray.direction, lightTexAt(p, normal));
  }
  if (hasFlag(kFlagGradientOpacity) || hasFlag(kFlagSlices) || LABELS == 1) alpha = 1.0 - exp(-depth);
  if (alpha > 0.0) addSample(hit, vec4(color * alpha, alpha), tm, normal, structure);
}

#if LABELS == 2
/// Extinction by the structures around a position. Half coverage is the surface; a narrow ramp keeps it smooth.
float labelExtinction(vec3 scenePoint) {
  float coverage = labelMaterial(scenePoint).a;
  return smoothstep(0.35, 0.65, coverage) * coverage * 6.0 * frame.cellGrid.w;
}
#endif

/// Segments between neighbouring samples of the lattice, cut off at a stretch's ends.
const int kGroup = 8;
struct Group {
  float lattice;  // t of its first lattice point
  float from;
  float to;
  float x[kGroup + 1];  // values, table positions
};

float timeIn(Group group, Walk walk, int i) { return clamp(group.lattice + float(i) * walk.dt, group.from, group.to); }

Group groupAt(Walk walk, float lattice, float from, float to) {
  Group group;
  group.lattice = lattice;
  group.from = from;
  group.to = to;
#if LABELS != 2
  for (int i = 0; i <= kGroup; ++i) group.x[i] = tableAt(texAt(walk, timeIn(group, walk, i)));
#endif
  return group;
}

/// False when the group holds no material. May err on the other side.
bool mayShow(Group group, Walk walk, Ray ray) {
#if LABELS == 2
  bool shows = false;
  for (int i = 0; i < kGroup; ++i) {
    float middle = 0.5 * (timeIn(group, walk, i) + timeIn(group, walk, i + 1));
    shows = shows || labelMaterial(ray.origin + middle * ray.direction).a > 0.35;
  }
  return shows;
#else
  float low = group.x[0];
  float high = group.x[0];
  for (int i = 1; i <= kGroup; ++i) {
    low = min(low, group.x[i]);
    high = max(high, group.x[i]);
  }
  return high >= frame.tableScale.y && low < frame.tableScale.z;
#endif
}

float depthOf(Group group, int i, Walk walk, Ray ray) {
  float t0 = timeIn(group, walk, i);
  float t1 = timeIn(group, walk, i + 1);
#if LABELS == 2
  return labelExtinction(ray.origin + 0.5 * (t0 + t1) * ray.direction) * (t1 - t0);
#else
  return extinctionBetween(group.x[i], group.x[i + 1]) * (t1 - t0);
#endif
}

/// One of eight by selections: what is indexed by a variable would have to lie in memory.
float oneOf(float v0, float v1, float v2, float v3, float v4, float v5, float v6, float v7, int i) {
  bool odd = (i & 1) != 0;
  float a = odd ? v1 : v0;
  float b = odd ? v3 : v2;
  float c = odd ? v5 : v4;
  float d = odd ? v7 : v6;
  bool second = (i & 2) != 0;
  a = second ? b : a;
  c = second ? d : c;
  return (i & 4) != 0 ? c : a;
}

/// Optical depth below which segments are shaded together: what hides less than this share of what is behind it needs no
/// gradient at every half voxel.
const float kThin = 0.08;

/// Composites one stretch, front to back; a < b. Rays of a SIMD group go in step, and a software driver runs both sides of
/// every branch and every loop once more than it is needed when the condition stands at its head. So each kind of work has
/// a loop of its own, with the condition at its foot, in which nearly all rays have something to do: leaping over empty
/// cells; fetching groups of samples until one holds material; shading its segments, thin ones by
/// the half group or the whole. Groups and leaps keep to
/// the same lattice, so leaping changes no picture. A ray that has left a loop is still computed, though not stored, while
/// others go on, and Mesa 22 takes what it computes last as the value after the loop: so nothing that is used after a loop
/// may change when its last turn is repeated.
void marchStretch(inout Hit hit, Ray ray, Walk walk, float a, float b, Face face, bool exemptOnly) {
  vec3 faceNormal = vec3(0.0);
  float faceT = -1.0;
  if (hasFlag(kFlagCuts) && face.cut >= 0) {
    faceT = a;
    faceNormal = faceNormalAt(face, ray.origin + a * ray.direction, ray.direction);
    if (cuts[face.cut].kind.y == 1) addSliceFace(hit, ray, a, face.cut, faceNormal);
  }
  float cutoff = hasFlag(kFlagStopOpaque) ? frame.step.y : 2.0;
  float groupMm = float(kGroup) * walk.dt;
  float perGroup = 1.0 / groupMm;
  float t = a;
  do {
    Group group;
    bool found;
    float end;
    do {
      if (hasFlag(kFlagSkipEmpty)) {
        bool leaping;
        do {
          ivec3 cell = cellAt(walk, t);
          uint reach = cellsToContent(cell, exemptOnly);
          // To the last group that begins inside the empty cube: the segment that leaves it is still looked at.
          float leave = leaveEmpty(walk, t, cell, reach);
          float target = leave >= b ? b : walk.first + floor((leave - walk.first) * perGroup - 1e-4) * groupMm;
          leaping = reach > 0u && target > t;
          t = leaping ? target : t;
        } while (leaping && t < b);
      }
      group = groupAt(walk, walk.first + floor((t - walk.first) * perGroup + 1e-4) * groupMm, t, b);
      found = mayShow(group, walk, ray);
      end = max(timeIn(group, walk, kGroup), t + 1e-5 * walk.dt);
      t = found ? t : end;
    } while (!found && t < b);
    t = end;
    float d[kGroup];
    uint marks = 0u;
    for (int i = 0; i < kGroup; ++i) {
      d[i] = depthOf(group, i, walk, ray);
      marks |= found && d[i] > 0.0 ? 1u << i : 0u;
    }
    float nearHalf = d[0] + d[1] + d[2] + d[3];
    float farHalf = d[4] + d[5] + d[6] + d[7];
    bool isThin = LABELS == 0 && nearHalf + farHalf < kThin;
    bool isNearThin = LABELS == 0 && nearHalf < 2.0 * kThin;
    bool isFarThin = LABELS == 0 && farHalf < 2.0 * kThin;
    marks = isNearThin && (marks & 15u) != 0u ? marks & ~15u | 1u : marks;
    marks = isFarThin && (marks & 240u) != 0u ? marks & ~240u | 16u : marks;
    marks = isThin && marks != 0u ? 1u : marks;
    do {
      int n = max(findLSB(marks), 0);
      bool isHalf = n < 4 ? isNearThin : isFarThin;
      int count = isThin ? kGroup : isHalf ? 4 : 1;
      float depth = oneOf(d[0], d[1], d[2], d[3], d[4], d[5], d[6], d[7], n);
      depth = isHalf ? n < 4 ? nearHalf : farHalf : depth;
      depth = isThin ? nearHalf + farHalf : depth;
      int m = n + count - 1;
      float x0 = oneOf(group.x[0], group.x[1], group.x[2], group.x[3], group.x[4], group.x[5], group.x[6], group.x[7], n);
      float x1 = oneOf(group.x[1], group.x[2], group.x[3], group.x[4], group.x[5], group.x[6], group.x[7], group.x[8], m);
      Segment segment = Segment(timeIn(group, walk, n), timeIn(group, walk, m + 1), x0, x1, depth);
      if (marks != 0u) addSegment(hit, ray, walk, segment, faceT, faceNormal, exemptOnly);
      marks &= marks - 1u;
    } while (marks != 0u && hit.color.a < cutoff);
  } while (t < b && hit.color.a < cutoff);
}

#elif MODE == 1

float gBest = -1.0;  // the largest value, table positions 0..1; of slices how it shows, see gBehind

#ifdef MEMBRANES
/// How a grey value behind the slices so far shows: x times it, and y. In front of a slice the larger of it and the value
/// shows, so that what stands out is seen on it, and what is behind an opaque one is not.
vec2 gBehind = vec2(1.0, 0.0);
vec4 gSlices = vec4(vec3(0.0), kFar);  // the images of slices; a: where the first is
vec4 gSheets = vec4(0.0);              // sheets, which are drawn over all that
#endif

/// A value as it is compared. Table positions 0..1, or what shows of their grey.
float shownAs(float value, float share) {
#ifdef MEMBRANES
  if (hasFlag(kFlagSlices)) return gBehind.x * greyAt(value * float(kTransferSize - 1)) * share + gBehind.y;
#endif
  return value;
}

/// Largest table position, 0..1, that a cell's texel values reach.
float largestIn(vec2 texels) {
  vec2 mapped = texels * frame.valueFromTexel.x + frame.valueFromTexel.y;
  return clamp(max(mapped.x, mapped.y), 0.0, 1.0);
}

/// Keeps the largest value of one stretch; a < b. A cell whose largest value is not above it is left out.
void marchStretch(inout Hit hit, Ray ray, Walk walk, float a, float b, Face face, bool exemptOnly) {
  const int kBlock = 16;
  float t = a;
  bool more = true;
  do {
    if (hasFlag(kFlagSkipEmpty) && !exemptOnly) {
      bool leaping;
      do {
        ivec3 cell = cellAt(walk, t);
        float largest = largestIn(cellRange[(cell.z * int(frame.cellGrid.y) + cell.y) * int(frame.cellGrid.x) + cell.x]);
        float leave = leaveEmpty(walk, t, cell, 1u);
        float target = min(walk.first + floor((leave - walk.first) / walk.dt + 1.0 - 1e-4) * walk.dt, b);
        leaping = shownAs(largest, 1.0) <= gBest && target > t;
        t = leaping ? target : t;
      } while (leaping && t < b);
    }
    int n = 0;
    do {
      float value = tableAt(texAt(walk, t)) / float(kTransferSize - 1);
      bool shown = true;
      uint structure = 0u;
      float share = 1.0;
      vec3 p = ray.origin + t * ray.direction;
#if LABELS == 1
      structure = labelAt(p);
      shown = structure == 0u ? frame.window.w > 0.0 : structureRow(structure).a > 0.0;
      if (exemptOnly) shown = shown && cutsKeep(p, structure);
#endif
#ifdef MEMBRANES
      if (hasFlag(kFlagSlices)) share = sliceShare(p, structure);
#endif
      value = shownAs(value, share);
      bool better = shown && value > gBest;
      gBest = better ? value : gBest;
      hit.distance = better ? t : hit.distance;
      hit.structure = better ? structure : hit.structure;
      more = more && t < b;
      t = min(nextSample(walk, t), b);
    } while (more && ++n < kBlock);
  } while (more);
}

#else

/// What the surface looks like where the ray meets it; nothing when its structure is not shown.
void addSurface(inout Hit hit, Ray ray, Walk walk, float t, Face face, bool exemptOnly) {
  float iso = frame.step.z * float(kTransferSize - 1);
  vec3 p = ray.origin + t * ray.direction;
  vec3 tex = texAt(walk, t);
  uint structure = 0u;
#if LABELS == 1
  structure = labelAt(p);
  bool shown = structure == 0u ? frame.window.w > 0.0 : structureRow(structure).a > 0.0;
  if (!shown || (exemptOnly && !cutsKeep(p, structure))) return;
#endif
  vec3 gradient = gradientAt(tex);
  float len = length(gradient);
  vec3 normal = len > 0.0 ? -gradient / len : -ray.direction;
  if (dot(normal, ray.direction) > 0.0) normal = -normal;
  if (hasFlag(kFlagCuts) && face.cut >= 0) normal = faceNormalAt(face, p, ray.direction);
  vec3 albedo = extinctionBetween(iso, iso) > 0.0 ? colorBetween(iso, iso) : vec3(0.9, 0.85, 0.78);
#if COLOR
  albedo = volumeColorAt(tex);
#endif
#if LABELS == 1
  if (structure != 0u) albedo = mix(albedo, structureRow(structure).rgb, frame.window.z);
#endif
  vec3 color = shadeSurface(albedo, normal, -ray.direction, lightTexAt(p, normal));
  if (hasFlag(kFlagCuts) && face.cut >= 0 && cuts[face.cut].kind.y == 1) color = vec3(greyAt(tableAt(tex)));
#ifdef MEMBRANES
  float share = hasFlag(kFlagSlices) ? sliceShare(p, structure) : 1.0;
  if (share > 0.0) addSample(hit, vec4(color, 1.0) * share, t, normal, structure);
#else
  hit = Hit(vec4(color, 1.0), t, normal, structure);
#endif
}

bool isCovered(Hit hit) {
#ifdef MEMBRANES
  return hit.color.a >= frame.step.y;
#else
  return hit.distance < kFar;
#endif
}

/// Stops at the first crossing of the iso value, found by bisection of its segment, or at once on a cut's face inside;
/// a < b.
void marchStretch(inout Hit hit, Ray ray, Walk walk, float a, float b, Face face, bool exemptOnly) {
  const int kBlock = 8;
  float iso = frame.step.z * float(kTransferSize - 1);
  if (hasFlag(kFlagCuts) && face.cut >= 0 && tableAt(texAt(walk, a)) >= iso) addSurface(hit, ray, walk, a, face, exemptOnly);
  float t = a;
  float low;
  float high;
  float x;
  bool crosses = false;
  do {
    do {
      if (hasFlag(kFlagSkipEmpty)) {
        bool leaping;
        do {
          ivec3 cell = cellAt(walk, t);
          uint reach = cellsToContent(cell, exemptOnly);
          float leave = leaveEmpty(walk, t, cell, reach);
          float target = leave >= b ? b : walk.first + floor((leave - walk.first) / walk.dt - 1e-4) * walk.dt;
          leaping = reach > 0u && target > t;
          t = leaping ? target : t;
        } while (leaping && t < b);
      }
      x = tableAt(texAt(walk, t));
      int n = 0;
      do {
        float next = nextSample(walk, t);
        next = min(next > t ? next : t + walk.dt, b);
        float value = tableAt(texAt(walk, next));
        crosses = (x < iso) != (value < iso);
        low = t;
        high = next;
        x = crosses ? x : value;
        t = crosses ? t : next;
      } while (!crosses && t < b && ++n < kBlock);
    } while (!crosses && t < b);
    t = high;
    for (int i = 0; i < 12; ++i) {
      float mid = 0.5 * (low + high);
      bool sameSide = (tableAt(texAt(walk, mid)) < iso) == (x < iso);
      low = sameSide ? mid : low;
      high = sameSide ? high : mid;
    }
    if (crosses && !isCovered(hit)) addSurface(hit, ray, walk, 0.5 * (low + high), Face(-1, -1), exemptOnly);
  } while (!isCovered(hit) && t < b);
}
#endif

/// True when nothing further along the ray can show.
bool isDone(Hit hit) {
#if MODE == 0
  return hasFlag(kFlagStopOpaque) && hit.color.a >= frame.step.y;
#elif MODE == 2
  return isCovered(hit);
#else
  return false;
#endif
}

#ifdef MEMBRANES

/// The image of a slice.
void addSlice(inout Hit hit, Ray ray, Mark mark) {
  vec3 p = ray.origin + mark.t * ray.direction;
  uint structure = structureAt(p);
  if (!sliceShows(p, structure)) return;
  float alpha = cuts[mark.cut].slice.x;
  vec3 color = sliceColor(p, structure).rgb;
#if MODE == 1
  gSlices = vec4(gSlices.rgb + gBehind.x * alpha * color, min(gSlices.a, mark.t));
  gBehind = vec2(gBehind.x * (1.0 - alpha), max(gSlices.r, max(gSlices.g, gSlices.b)));
#else
  if (alpha > 0.0) addSample(hit, vec4(color * alpha, alpha), mark.t, sheetNormalAt(mark.cut, -1, p, ray.direction), structure);
#endif
}

/// How a place on a sheet runs through the picture.
struct SheetPlace {
  vec2 at;        // in meshes
  vec2 perPixel;  // meshes a pixel, at most
};

SheetPlace sheetPlaceAt(int cut, int triangle, vec3 p, vec3 direction, float pixelMm) {
  SheetPlan plan = cutSheet(cuts[cut]);
  ivec3 corner = sheetCorners(plan, triangle);
  vec3 a = sheetPlace(plan, corner.x);
  vec3 b = sheetPlace(plan, corner.y);
  vec3 c = sheetPlace(plan, corner.z);
  vec3 w = sheetShares(plan, triangle, p);
  bool isLower = (triangle & 1) == 0;
  vec2 base = vec2(corner.x % plan.rows.y, corner.x / plan.rows.y);
  vec3 alongX = isLower ? b - a : b - c;
  vec3 alongY = isLower ? c - b : c - a;
  vec3 n = cross(alongX, alongY);
  float nn = max(dot(n, n), 1e-20);
  // Gradients on the triangle, then of what a step across the ray does to the place that it meets.
  vec3 gx = cross(alongY, n) / nn;
  vec3 gy = cross(n, alongX) / nn;
  float nd = sheetNonZero(dot(n, direction));
  gx -= n * (dot(gx, direction) / nd);
  gy -= n * (dot(gy, direction) / nd);
  return SheetPlace(base + (isLower ? vec2(w.y + w.z, w.z) : vec2(w.y, w.y + w.z)), pixelMm * vec2(length(gx), length(gy)));
}

/// Cover of a pixel by the lines of the mesh, about 50 across the frame.
float gridCover(SheetPlan plan, SheetPlace place) {
  vec2 meshes = vec2(plan.rows.yz - 1);
  vec2 every = max(floor(meshes / 50.0 + 0.5), 1.0);
  vec2 off = abs(place.at - every * floor(place.at / every + 0.5));
  off = min(off, abs(meshes - place.at));  // the rim has a line, whatever the number of meshes
  vec2 lines = clamp(vec2(1.15) - off / place.perPixel, 0.0, 1.0);
  // Lines closer than three pixels are grey together.
  lines = mix(min(1.3 * place.perPixel / every, 1.0), lines, smoothstep(1.0, 3.0, every / place.perPixel));
  return max(lines.x, lines.y);
}

/// The sheet of a membrane, as a grid or as a surface.
void addSheet(inout Hit hit, Ray ray, Mark mark) {
  vec3 p = ray.origin + mark.t * ray.direction;
  CutData cut = cuts[mark.cut];
  vec3 normal = sheetNormalAt(mark.cut, mark.triangle, p, ray.direction);
  float facing = -dot(normal, ray.direction);
  bool isGrid = cut.sheet.w == 1;
  vec3 albedo = isGrid ? vec3(0.97, 0.86, 0.55) : vec3(0.42, 0.66, 0.92);
  float alpha = 0.28 + 0.45 * pow(1.0 - facing, 3.0);
  if (isGrid) {
    float depth = hasFlag(kFlagOrthographic) ? 1.0 : mark.t * dot(ray.direction, frame.forward.xyz);
    float pixelMm = 2.0 * length(frame.up.xyz) / frame.picture.y * depth;
    vec3 local = (cut.localFromScene * vec4(p, 1.0)).xyz;
    SheetPlace place = sheetPlaceAt(mark.cut, mark.triangle, local, mat3(cut.localFromScene) * ray.direction, pixelMm);
    alpha = 0.7 * gridCover(cutSheet(cut), place);
  }
  vec3 color = shadeSurface(albedo, normal, -ray.direction, lightTexAt(p, normal));
#if MODE == 1
  gSheets += (1.0 - gSheets.a) * vec4(color, 1.0) * alpha;
#else
  if (alpha > 0.0) addSample(hit, vec4(color, 1.0) * alpha, mark.t, normal, 0u);
#endif
}

/// A picture of parts is without this one.
bool isHidden(bool isBehind) { return isBehind ? hasFlag(kFlagHideBehind) : hasFlag(kFlagHideFront); }

/// Everything along one ray, stretch by stretch, and what is drawn in places on it.
void castMarked(inout Hit hit, Ray ray, Walk walk, float from, float tEnd) {
  float t = from;
  Face face = Face(-1, -1);
  Stretch stretch = Stretch(t, true, -1, -1);
  // The marks ahead are looked for at one place of the loop: what is called twice is compiled twice.
  Mark slice = Mark(t, -1, -1);
  Mark sheet = Mark(t, -1, -1);
  bool seeksSlice = true;
  bool seeksSheet = true;
  bool isBehind = false;
  int guard = 256 + 8 * frame.counts.x;
  do {
    bool wasRemoved = !stretch.kept;
    if (t >= stretch.end) {
      face = wasRemoved ? Face(stretch.face, stretch.triangle) : Face(-1, -1);
      stretch = stretchFrom(ray, t, tEnd);
    }
    float e = 1e-5 * max(1.0, abs(t));
    if (seeksSlice) slice = hasFlag(kFlagSlices) ? nextSlice(ray, slice) : Mark(kFar, -1, -1);
    if (seeksSheet) sheet = hasFlag(kFlagSheets) ? nextSheet(ray, sheet.t + (sheet.cut < 0 ? 0.0 : e), tEnd) : Mark(kFar, -1, -1);
    seeksSlice = false;
    seeksSheet = false;
    // A sheet that lies in the slice is drawn on it, not now before and now behind it.
    bool sliceIsNext = slice.t <= sheet.t - 0.1 / frame.cellGrid.w;
    float mark = min(slice.t, sheet.t);
    if (mark <= t + e) {
      if (sliceIsNext) {
        if (!hasFlag(kFlagHideSlice)) addSlice(hit, ray, slice);
        isBehind = true;
        seeksSlice = true;
      } else {
        if (!isHidden(isBehind)) addSheet(hit, ray, sheet);
        seeksSheet = true;
      }
    } else {
      float end = min(stretch.end, mark);
      bool exemptOnly = !stretch.kept;
      if (end > t && (stretch.kept || hasFlag(kFlagExemptions)) && !isHidden(isBehind))
        marchStretch(hit, ray, walk, t, end, exemptOnly ? Face(-1, -1) : face, exemptOnly);
      face = Face(-1, -1);
      t = max(end, t + 1e-6);
    }
  } while (t < tEnd && --guard > 0 && !isDone(hit));
}
#endif

/// Everything along one ray, stretch by stretch.
void castStretches(inout Hit hit, Ray ray, Walk walk, float from, float tEnd) {
  float t = from;
  Face face = Face(-1, -1);
  int guard = 4 * frame.counts.x + 2;  // each stretch ends at a face of some cut, and a ray meets each at most twice
#ifdef MEMBRANES
  guard += 256;  // but a folded sheet more often
#endif
  do {
    Stretch stretch = stretchFrom(ray, t, tEnd);
    if (stretch.end > t) {
      if (stretch.kept) marchStretch(hit, ray, walk, t, stretch.end, face, false);
      else if (hasFlag(kFlagExemptions)) marchStretch(hit, ray, walk, t, stretch.end, Face(-1, -1), true);
    }
    face = stretch.kept ? Face(-1, -1) : Face(stretch.face, stretch.triangle);
    t = stretch.kept ? stretch.end : max(stretch.end, t + 1e-6);
  } while (t < tEnd && --guard > 0 && !isDone(hit));
}

/// Everything along one ray, up to an opaque surface at `stop`.
Hit castRay(Ray ray, float jitter, float stop) {
  Hit hit = Hit(vec4(0.0), kFar, -ray.direction, 0u);
  vec2 box = boxInterval(ray);
  float tEnd = min(box.y, stop);
  if (box.x >= tEnd) return hit;
  Walk walk = walkAlong(ray, box.x + jitter * frame.step.x);
  if (!hasFlag(kFlagCuts)) {
    marchStretch(hit, ray, walk, box.x, tEnd, Face(-1, -1), false);
#ifdef MEMBRANES
  } else if (hasFlag(kFlagSlices) || hasFlag(kFlagSheets)) {
    castMarked(hit, ray, walk, box.x, tEnd);
#endif
  } else {
    castStretches(hit, ray, walk, box.x, tEnd);
  }
#if MODE == 1
  if (gBest >= 0.0) {
    float grey = hasFlag(kFlagSlices) ? gBest : greyAt(gBest * float(kTransferSize - 1));
    hit.color = vec4(vec3(grey), 1.0);
#if COLOR
    hit.color.rgb = volumeColorAt(texAt(walk, hit.distance)) * (COLOR == 2 ? grey : 1.0);
#endif
#if LABELS == 1
    if (hit.structure != 0u) hit.color.rgb = mix(vec3(grey), structureRow(hit.structure).rgb * grey, frame.window.z);
#endif
    hit.color *= smoothstep(0.0, 0.02, grey);
  }
#ifdef MEMBRANES
  if (hasFlag(kFlagSlices) && gBest <= gBehind.y && gSlices.a < kFar) {
    hit.color = vec4(gSlices.rgb, 1.0 - gBehind.x);
    hit.distance = gSlices.a;
    hit.structure = structureAt(ray.origin + hit.distance * ray.direction);
  }
  hit.color = gSheets + (1.0 - gSheets.a) * hit.color;
#endif
#endif
  return hit;
}

/// A unit vector on the square -1..1: octahedral mapping.
vec2 octahedral(vec3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  vec2 folded = (1.0 - abs(n.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(n.xy, vec2(0.0)));
  return n.z >= 0.0 ? n.xy : folded;
}

void main() {
  // Neighbours in a SIMD group are neighbours in the picture: runs of eight are blocks of four by two.
  int i = int(gl_LocalInvocationIndex);
  ivec2 inGroup = ivec2(i & 3 | i >> 1 & 4, i >> 2 & 1 | i >> 3 & 6);
  // A software driver gives each of its threads a run of groups: strides spread each run over the tile.
  ivec2 groups = ivec2(gl_NumWorkGroups.xy);
  int group = (int(gl_WorkGroupID.y) * groups.x + int(gl_WorkGroupID.x)) * window_.z % (groups.x * groups.y);
  ivec2 inTile = ivec2(group % groups.x, group / groups.x) * kTileGroup + inGroup;
  if (inTile.x >= tile.z || inTile.y >= tile.w) return;
  ivec2 pixel = tile.xy + inTile;
  ivec2 inPicture = pixel + window_.xy;
  Ray ray = rayThrough(vec2(inPicture) + 0.5 + frame.picture.zw);

  vec4 surface = texelFetch(surfaceColorTexture, min(pixel, textureSize(surfaceColorTexture, 0) - 1), 0);
  vec4 surfaceAux = texelFetch(surfaceAuxTexture, min(pixel, textureSize(surfaceAuxTexture, 0) - 1), 0);
  float stop = surface.a > 0.0 ? surfaceAux.w : kFar;
  float jitter = hasFlag(kFlagJitter) ? fract(texelFetch(noiseTexture, inPicture & (textureSize(noiseTexture, 0) - 1), 0).r + frame.step.w) : 0.5;

  Hit hit = castRay(ray, jitter, stop);
  if (surface.a > 0.0 && !hasFlag(kFlagHideBehind)) {
    if (hit.color.a < 0.5) {
      hit.distance = surfaceAux.w;
      hit.normal = surfaceAux.xyz;
      hit.structure = 0u;
    }
    hit.color += (1.0 - hit.color.a) * vec4(surface.rgb, 1.0) * surface.a;
  }
  if (frame.counts.w == 0) {
    bool found = hit.distance < kFar && hit.color.a > 0.0;
    imageStore(hitImage, pixel, found ? vec4(hit.distance, octahedral(hit.normal), float(hit.structure) + 1.0) : vec4(0.0));
  }
  vec4 before = frame.counts.w == 0 ? vec4(0.0) : imageLoad(sumImage, pixel);
  imageStore(sumImage, pixel, before + hit.color);
}
