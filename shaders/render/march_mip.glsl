// The largest value along a ray. In front of an image, of an inlay or of the section on a cut's face, the larger of it and
// the values shows, so that what stands out is seen on it, and what is behind an opaque one is not; sheets are drawn over
// all that.
#include "common/volume.glsl"
#include "render/data_color.glsl"
#include "render/hit.glsl"
#include "render/walk.glsl"

layout(std430, binding = kCellBinding) readonly buffer CellBlock { vec2 cellRange[]; };

float gBest = -1.0;  // the largest value, table positions 0..1; where there are images how it shows, see gBehind
vec2 gBehind = vec2(1.0, 0.0);         // how a grey value behind the images so far shows: x times it, and y
vec4 gImages = vec4(vec3(0.0), kFar);  // all of them; a: where the first is
int gImageFace = -1;                   // of the first
vec4 gSheets = vec4(0.0);

bool hasImages() { return hasFlag(kFlagInlays) || hasFlag(kFlagFaces); }

/// A value as it is compared. Table positions 0..1, or what shows of their grey.
float shownAs(float value, float share) {
  return hasImages() ? gBehind.x * greyAt(value * float(kTransferSize - 1)) * share + gBehind.y : value;
}

/// Largest table position, 0..1, that a cell's texel values reach.
float largestIn(vec2 texels) {
  vec2 mapped = texels * frame.tablePerTexel + frame.tableOffset;
  return clamp(max(mapped.x, mapped.y), 0.0, 1.0);
}

/// Leaps over cells whose largest value is not above the best so far.
float leapLower(Walk walk, float t, float b) {
  bool leaping;
  do {
    ivec3 cell = cellAt(walk, t);
    float largest = largestIn(cellRange[(cell.z * int(frame.cellGrid.y) + cell.y) * int(frame.cellGrid.x) + cell.x]);
    float leave = leaveCube(walk, t, cell, 1u);
    float target = min(walk.first + floor((leave - walk.first) / walk.dt + 1.0 - 1e-4) * walk.dt, b);
    leaping = hasFlag(kFlagSkipEmpty) && shownAs(largest, 1.0) <= gBest && target > t;
    t = leaping ? target : t;
  } while (leaping && t < b);
  return t;
}

/// Keeps the sample at t if it is the best. What is removed ends before the face, whose place rounding may put on either side.
void addValue(inout Hit hit, Ray ray, Walk walk, float t, Span span) {
  float value = tableAt(texAt(walk, t)) / float(kTransferSize - 1);
  bool shown = !(span.sparedOnly && t >= span.b);
  uint structure = 0u;
  float share = 1.0;
  vec3 p = ray.origin + t * ray.direction;
#if LABELS == 1
  structure = ownerAt(p, span.sparedOnly ? kSpared : kShown).id;
  if (usesShares(span.sparedOnly)) shown = shown && shareAt(p, span.sparedOnly) >= 0.5;
#endif
  if (hasFlag(kFlagSpares) && span.sparedOnly) shown = shown && cutsKeep(p, structure);
#ifdef MEMBRANES
  if (hasFlag(kFlagInlays)) share = inlayShare(p, structure);
#endif
  value = shownAs(value, share);
  bool better = shown && value > gBest;
  gBest = better ? value : gBest;
  hit.distance = better ? t : hit.distance;
  hit.structure = better ? structure : hit.structure;
  hit.face = better ? (t == span.a ? span.face.cut : -1) : hit.face;
  hit.faceT = better ? t : hit.faceT;
}

/// An image that the ray passes.
void addImage(inout Hit hit, float t, vec3 color, float alpha, vec3 normal, uint structure, int face) {
  gImageFace = t < gImages.a ? face : gImageFace;
  gImages = vec4(gImages.rgb + gBehind.x * alpha * color, min(gImages.a, t));
  gBehind = vec2(gBehind.x * (1.0 - alpha), max(gImages.r, max(gImages.g, gImages.b)));
}

/// Keeps the largest value of one stretch. Leaping and sampling have loops of their own: see march_volume.glsl.
void marchStretch(inout Hit hit, Ray ray, Walk walk, Span span) {
  const int kBlock = 16;
  float t = span.a;
  addFaceData(hit, ray, t, span.face);
  bool more = true;
  do {
    if (!span.sparedOnly) t = leapLower(walk, t, span.b);
    int n = 0;
    do {
      addValue(hit, ray, walk, t, span);
      more = more && t < span.b;
      t = min(nextSample(walk, t), span.b);
    } while (more && ++n < kBlock);
  } while (more);
}

bool isDone(Hit hit) { return false; }

#ifdef MEMBRANES
void addSheet(inout Hit hit, float t, vec3 color, float alpha, vec3 normal) {
  gSheets += (1.0 - gSheets.a) * vec4(color, 1.0) * alpha;
}
#endif

/// From the largest value to a colour.
void finishRay(inout Hit hit, Ray ray, Walk walk) {
  if (gBest >= 0.0) {
    float grey = hasImages() ? gBest : greyAt(gBest * float(kTransferSize - 1));
    hit.color = vec4(vec3(grey), 1.0);
    float best = gBest * float(kTransferSize - 1);
    if (hasFlag(kFlagValueColors) && !hasImages()) hit.color.rgb = colorBetween(best, best);
#if COLOR
    hit.color.rgb = volumeColorAt(texAt(walk, hit.distance)) * (COLOR == 2 ? grey : 1.0);
#endif
#if LABELS == 1
    if (hit.structure != 0u) hit.color.rgb = mix(vec3(grey), structureRow(hit.structure).rgb * grey, structureTint(hit.structure));
#endif
    hit.color *= smoothstep(0.0, 0.02, grey);
  }
  if (hasImages() && gBest <= gBehind.y && gImages.a < kFar) {
    hit.color = vec4(gImages.rgb, 1.0 - gBehind.x);
    hit.distance = gImages.a;
    hit.structure = structureAt(ray.origin + hit.distance * ray.direction, kAnybody);
    hit.face = gImageFace;
    hit.faceT = gImages.a;
  }
  hit.color = gSheets + (1.0 - gSheets.a) * hit.color;
}
