// Rays and positions against all cuts of the scene.
#include "common/frame.glsl"
#include "shared/cuts.h"

layout(std430, binding = kCutBinding) readonly buffer CutBlock { CutData cuts[]; };
// What cuts spare. First how many structures follow; for each of these where its spares begin, or 0; then how deep each cut leaves
// it, as bits of floats.
layout(binding = kSpareUnit) uniform usamplerBuffer spareTexture;

layout(std430, binding = kCutGridBinding) readonly buffer CutGridBlock { uint cutGrid[]; };

// Software drivers read storage blocks, and what is indexed by a variable, lane by lane. Where all cuts are a few planes,
// programs are compiled for their number, and what is asked of them at every step lies in the frame.
#ifdef PLANES
vec4 planeAt(int i) {
  vec4 plane = frame.planes[0];
  for (int k = 1; k < PLANES; ++k) plane = i == k ? frame.planes[k] : plane;
  return plane;
}

CutData cutAt(int i) {
  vec4 plane = planeAt(i);
  CutData cut;
  cut.localFromScene = mat4(0.0, 0.0, plane.x, 0.0, 0.0, 0.0, plane.y, 0.0, 0.0, 0.0, plane.z, 0.0, 0.0, 0.0, plane.w, 1.0);
  cut.halfSize = vec4(0.0, 0.0, 0.0, (frame.planeBits.y >> i & 1) != 0 ? -1.0 : 1.0);
  cut.kind = ivec4(kCutPlane, 0, (frame.planeBits.x >> i & 1) != 0 ? kCutJoined : 0, 0);
  cut.face = vec4(0.0);
  cut.sheet = ivec4(0);
  cut.inlay = vec4(0.0);
  return cut;
}
const int kCuts = PLANES;
#else
CutData cutAt(int i) { return cuts[i]; }
#define kCuts frame.cutCount
#endif

/// Cuts that one after the other are looked at: those of a cell of the grid, or all.
struct CutList {
  int begin;
  int end;
};

/// Place of a position in the grid of cuts, in cells.
vec3 cutCellsFrom(vec3 scenePoint) { return (frame.texFromScene * vec4(scenePoint, 1.0)).xyz * float(kCutGrid); }

CutList listOf(ivec3 cell) {
  int at = cell.x + kCutGrid * (cell.y + kCutGrid * cell.z);
  return CutList(int(cutGrid[at]), int(cutGrid[at + 1]));
}

/// The cuts that may remove a position. Material lies in the box; surfaces may lie outside.
CutList cutsAt(vec3 scenePoint) {
  if (!hasFlag(kFlagCutGrid)) return CutList(0, kCuts);
  vec3 place = cutCellsFrom(scenePoint);
  bool isOutside = any(lessThan(place, vec3(0.0))) || any(greaterThan(place, vec3(kCutGrid)));
  return listOf(isOutside ? ivec3(0, 0, kCutGrid) : min(ivec3(place), ivec3(kCutGrid - 1)));
}

/// The cut in the i-th place.
int cutIn(int i) { return hasFlag(kFlagCutGrid) ? int(cutGrid[i]) : i; }

/// Where a structure's spares begin; -1: no cut spares it.
int sparesOf(uint structure) {
  if (!hasFlag(kFlagSpares) || structure >= texelFetch(spareTexture, 0).r) return -1;
  return int(texelFetch(spareTexture, 1 + int(structure)).r) - 1;
}

/// How deep a cut leaves something in its removed side. @param first  sparesOf() its structure
float sparedDepth(int first, int cut) {
  if (!hasFlag(kFlagSpares) || first < 0) return 0.0;
  return uintBitsToFloat(texelFetch(spareTexture, first + cut).r);
}

/// What a cut is to others, as cutPart() says.
int partOf(int cut) {
  if (hasFlag(kFlagJoined) && (cutAt(cut).kind.z & kCutJoined) != 0) return kFoldJoined;
#ifdef MEMBRANES
  return hasFlag(kFlagInlays) && cutIsInlay(cutAt(cut)) ? kFoldInlay : kFoldAlone;
#else
  return kFoldAlone;
#endif
}

bool isInlay(int cut) { return partOf(cut) == kFoldInlay; }

/// True when no cut removes a position of a structure. Inlays add up: one of them that keeps it is enough.
bool cutsKeep(vec3 scenePoint, uint structure) {
  CutFold fold = emptyFold();
  int first = sparesOf(structure);
  CutList list = cutsAt(scenePoint);
  for (int i = list.begin; i < list.end && !fold.isRemoved; ++i) {
    int cut = cutIn(i);
    fold = foldCut(fold, cutAt(cut), partOf(cut), sparedDepth(first, cut), hasFlag(kFlagSpareDepths), scenePoint);
  }
  return foldKeeps(fold);
}

/// The same of something that some cuts spare whole. @param spared  a bit for each
bool cutsKeepSpared(vec3 scenePoint, uint spared) {
  CutFold fold = emptyFold();
  CutList list = cutsAt(scenePoint);
  for (int i = list.begin; i < list.end && !fold.isRemoved; ++i) {
    int cut = cutIn(i);
    float depth = (spared >> cut & 1u) != 0u ? kCutFar : 0.0;
    fold = foldCut(fold, cutAt(cut), partOf(cut), depth, false, scenePoint);
  }
  return foldKeeps(fold);
}

/// Marks what two extrusions share ([ACS] fig. 6).
const vec3 kOverlapColor = vec3(0.25, 0.8, 0.35);
const float kOverlapShare = 0.55;

/// Where a piece of a structure that cuts spare up to a depth ends ([ACS] Prop. 1).
struct EndFace {
  float left;  // how far off the end is, along the cut's depth; kCutFar: it has none here
  int cut;     // whose depth that is; -1: none
  bool isShared;  // more than one of the cuts that are joined spare the place: extrusions that overlap
};

/// The nearest end of what cuts spare of a structure, in a place that they keep: cuts that are joined let it go only where
/// the last of them does.
EndFace endFaceAt(vec3 scenePoint, uint structure) {
  EndFace nearest = EndFace(kCutFar, -1, false);
  EndFace joined = nearest;
  int count = 0;
  int first = sparesOf(structure);
  CutList list = cutsAt(scenePoint);
  for (int i = list.begin; i < list.end && first >= 0; ++i) {
    int cut = cutIn(i);
    float inside = -cutDistance(cutAt(cut), scenePoint);
    float depth = sparedDepth(first, cut);
    // Outside of what it removes a cut has no end to offer.
    float left = inside > 0.0 && depth < kCutFar ? depth - inside : kCutFar;
    bool isJoined = partOf(cut) == kFoldJoined;
    if (!isJoined && joined.left < nearest.left) nearest = EndFace(joined.left, joined.cut, nearest.isShared);
    count = (isJoined ? count : 0) + (inside > 0.0 && depth > 0.0 && left >= 0.0 ? 1 : 0);
    nearest.isShared = nearest.isShared || count > 1;
    bool isLater = !isJoined || left > joined.left;
    joined = isLater ? EndFace(left, cut, false) : joined;
  }
  if (joined.left < nearest.left) nearest = EndFace(joined.left, joined.cut, nearest.isShared);
  return nearest;
}

#ifdef MEMBRANES
/// The cuts against a position: kCutKeeps, kCutRemoves, or kCutNear where meshes of a sheet must be looked at. As a software
/// driver looks at them whether it needs to or not, this is for those who ask for many positions.
int cutsGuess(vec3 scenePoint, uint structure) {
  CutFold fold = emptyFold();
  int first = sparesOf(structure);
  CutList list = cutsAt(scenePoint);
  for (int i = list.begin; i < list.end; ++i) {
    int cut = cutIn(i);
    fold = foldAnswer(fold, partOf(cut), cutGuess(cutAt(cut), sparedDepth(first, cut), hasFlag(kFlagSpareDepths), scenePoint));
  }
  return foldSays(fold);
}
#endif

/// The unit normal of the face of a cut, other than a membrane, out of the material.
vec3 shapeNormal(int cut, vec3 p) {
#ifdef PLANES
  return cutAt(cut).halfSize.w * planeAt(cut).xyz;
#else
  float e = 0.01 * frame.step;
  vec3 gradient = vec3(0.0);
  for (int axis = 0; axis < 3; ++axis)
    for (float side = -1.0; side < 2.0; side += 2.0) {
      vec3 step3 = side * vec3(equal(ivec3(axis), ivec3(0, 1, 2)));
      gradient += step3 * shapeDistance(cutAt(cut), p + e * step3);
    }
  float len = length(gradient);
  return len > 0.0 ? -gradient / len : vec3(0.0, 0.0, 1.0);
#endif
}

/// The normal of an end face: the cut's own.
vec3 endNormalAt(int cut, vec3 scenePoint) {
#ifdef MEMBRANES
  // Differs: that of the rest plane, not of the sheet so far off.
  if (cutAt(cut).kind.x == kCutMembrane) return normalize(cutAt(cut).halfSize.w * (vec3(0.0, 0.0, 1.0) * mat3(cutAt(cut).localFromScene)));
#endif
  return shapeNormal(cut, scenePoint);
}

#ifdef MEMBRANES
/// The normal of a sheet, or of the plane around it (triangle -1), in a place on it, towards the eye.
vec3 sheetNormalAt(int cut, int triangle, vec3 p, vec3 direction) {
  CutData c = cutAt(cut);
  mat3 toLocal = mat3(c.localFromScene);
  return membraneNormal(c, triangle, (c.localFromScene * vec4(p, 1.0)).xyz, toLocal * direction) * toLocal;
}

/// Share of its opacity that inlays leave to a position of a structure: that of the inlay that leaves it most.
float inlayShare(vec3 scenePoint, uint structure) {
  float share = 0.0;
  int first = sparesOf(structure);
  CutList list = cutsAt(scenePoint);
  for (int i = list.begin; i < list.end; ++i) {
    int cut = cutIn(i);
    if (isInlay(cut)) share = foldShare(share, cutAt(cut), sparedDepth(first, cut), hasFlag(kFlagSpareDepths), scenePoint);
  }
  return share;
}

/// Optical depth of a length of material, whose opacity has been reduced: the opacity of a voxel of it is.
float fadedDepth(float depth, float thickness, float share) {
  float voxels = max(thickness * frame.voxelsPerLength, 1e-6);
  float opacity = 1.0 - exp(-depth / voxels);
  return share >= 1.0 ? depth : -log(max(1.0 - share * opacity, 1e-6)) * voxels;
}

/// Whether an inlay's image shows in a place: what cuts, other than inlays, remove takes the image with it. On a face of
/// theirs it shows.
bool inlayShows(vec3 scenePoint, uint structure) {
  CutFold fold = emptyFold();
  int first = sparesOf(structure);
  float onFace = 0.01 / frame.voxelsPerLength;
  for (int i = 0; i < kCuts; ++i) {
    if (isInlay(i)) continue;
    bool removes = cutDistance(cutAt(i), scenePoint) < -max(onFace, sparedDepth(first, i));
    fold = foldAnswer(fold, partOf(i), removes ? kCutRemoves : kCutKeeps);
  }
  return foldKeeps(fold);
}

/// Something thin that a ray passes.
struct Mark {
  float t;  // kFar: nothing
  int cut;
  int triangle;
};

/// The image of an inlay that comes next after one; those in one place in the order of the cuts.
Mark nextInlay(Ray ray, Mark before) {
  Mark mark = Mark(kFar, -1, -1);
  for (int i = 0; i < kCuts; ++i) {
    if (!isInlay(i)) continue;
    vec3 o = (cutAt(i).localFromScene * vec4(ray.origin, 1.0)).xyz;
    vec3 d = mat3(cutAt(i).localFromScene) * ray.direction;
    float t = -o.z / sheetNonZero(d.z);
    bool isLater = t > before.t || (t == before.t && i > before.cut);
    if (isLater && t < mark.t && sheetHolds(cutSheet(cutAt(i)), o + t * d)) mark = Mark(t, i, -1);
  }
  return mark;
}

/// The sheet to be shown that comes next after t.
Mark nextSheet(Ray ray, float t, float tEnd) {
  Mark mark = Mark(kFar, -1, -1);
  for (int i = 0; i < kCuts; ++i) {
    if (cutAt(i).kind.x != kCutMembrane || cutAt(i).sheet.w == 0) continue;
    vec3 o = (cutAt(i).localFromScene * vec4(ray.origin, 1.0)).xyz;
    vec3 d = mat3(cutAt(i).localFromScene) * ray.direction;
    SheetHit hit = sheetCrossing(cutSheet(cutAt(i)), o, d, t, min(tEnd, mark.t));
    if (hit.t < mark.t) mark = Mark(hit.t, i, hit.triangle);
  }
  return mark;
}
#endif

CutRun convexRun(int cut, Ray ray, float t, float e) {
  vec2 inside = cutInterval(cutAt(cut), ray.origin, ray.direction);
  bool hit = inside.x < inside.y;
  CutRun run = CutRun(t, kFar, -1);
  if (cutAt(cut).halfSize.w > 0.0) {
    if (hit && t >= inside.x - e && t < inside.y - e) run.end = inside.y;
    else if (hit && t < inside.x) run.next = inside.x;
  } else if (!hit) {
    run.end = kFar;
  } else {
    if (t < inside.x - e) run.end = inside.x;
    else if (t >= inside.y - e) run.end = kFar;
    else run.next = inside.y;
  }
  return run;
}

#ifdef MEMBRANES
/// What a membrane does as far as its next crossing is asked in the middle between: rays that graze the sheet, or meet it
/// on the edge of two triangles, go wrong for a hair at most.
CutRun membraneRun(int cut, Ray ray, float t, float e, float tEnd) {
  SheetHit crossing = membraneCrossing(cutAt(cut), ray.origin, ray.direction, t + e, tEnd);
  float middle = 0.5 * (t + min(crossing.t, tEnd));
  vec3 p = (cutAt(cut).localFromScene * vec4(ray.origin + middle * ray.direction, 1.0)).xyz;
  bool removes = membraneRemoves(cutAt(cut), p);
  return CutRun(removes ? crossing.t : t, removes ? kFar : crossing.t, crossing.triangle);
}
#endif

CutRun runFrom(int cut, Ray ray, float t, float e, float tEnd) {
#ifdef MEMBRANES
  if (cutAt(cut).kind.x == kCutMembrane) return membraneRun(cut, ray, t, e, tEnd);
#endif
  if (hasFlag(kFlagWalks) && (cutAt(cut).kind.z & kCutWalks) != 0) return cutWalk(cutAt(cut), ray.origin, ray.direction, t, e, tEnd);
  return convexRun(cut, ray, t, e);
}

/// Where a ray leaves the cell of the grid in which it is at t.
float leaveCutCell(Ray ray, float t) {
  vec3 place = cutCellsFrom(ray.origin);
  vec3 perLength = (frame.texFromScene * vec4(ray.direction, 0.0)).xyz * float(kCutGrid);
  perLength = mix(perLength, vec3(1e-12), lessThan(abs(perLength), vec3(1e-12)));
  vec3 cell = floor(clamp(place + t * perLength, vec3(0.0), vec3(float(kCutGrid) - 0.5)));
  vec3 exit = (cell + vec3(greaterThan(perLength, vec3(0.0))) - place) / perLength;
  return max(t, min(exit.x, min(exit.y, exit.z)));
}

/// The stretch that begins at t. A ray is walked stretch by stretch; each costs one look at every cut, or, with a grid, at
/// those of the cells on its way.
Stretch stretchFrom(Ray ray, float t, float tEnd) {
  float e = 1e-5 * max(1.0, abs(t));
  float from = t;
  Stretch stretch;
  bool goesOn;
  do {
    RunFold fold = emptyRuns(from);
    float leave = hasFlag(kFlagCutGrid) ? leaveCutCell(ray, from + e) : tEnd;
    CutList list = cutsAt(ray.origin + (from + e) * ray.direction);
    for (int i = list.begin; i < list.end; ++i) {
      int cut = cutIn(i);
      fold = foldRun(fold, cut, partOf(cut), runFrom(cut, ray, from, e, tEnd), from);
    }
    stretch = stretchOf(fold, tEnd);
    // What is kept beyond its cell may be removed by cuts of the next one.
    goesOn = hasFlag(kFlagCutGrid) && stretch.kept && stretch.end > leave && leave < tEnd;
    if (!stretch.kept && from > t) stretch = Stretch(from, true, -1, -1);
    from = goesOn ? leave : from;
  } while (goesOn);
  return stretch;
}
