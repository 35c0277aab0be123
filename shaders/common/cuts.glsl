// Rays and positions against all cuts of the scene.
#include "shared/cut.h"
#include "common/frame.glsl"

layout(std430, binding = kCutBinding) readonly buffer CutBlock { CutData cuts[]; };
// Bit i % 32 of word i / 32 of a structure's mask: cut i spares it. kCutBinding's order; (cutCount + 31) / 32 words a structure.
layout(std430, binding = kExemptBinding) readonly buffer ExemptBlock { uint exemptMask[]; };

bool isExempt(uint structure, int cut) {
  if (!hasFlag(kFlagExemptions) || structure >= uint(frame.structureCount)) return false;
  uint word = exemptMask[structure * uint((frame.cutCount + 31) / 32) + uint(cut >> 5)];
  return (word >> uint(cut & 31) & 1u) != 0u;
}

bool isSlice(int cut) {
#ifdef MEMBRANES
  return hasFlag(kFlagSlices) && cuts[cut].kind.x == kCutMembrane && cuts[cut].kind.w == kMembraneSlice;
#else
  return false;
#endif
}

/// True when no cut removes a position of a structure. Slices add up: one of them that keeps it is enough.
bool cutsKeep(vec3 scenePoint, uint structure) {
  bool hasSlice = false;
  bool inSlice = false;
  for (int i = 0; i < frame.cutCount; ++i) {
    bool keeps = !cutRemoves(cuts[i], scenePoint) || isExempt(structure, i);
    hasSlice = hasSlice || isSlice(i);
    inSlice = inSlice || (keeps && isSlice(i));
    if (!keeps && !isSlice(i)) return false;
  }
  return inSlice || !hasSlice;
}

#ifdef MEMBRANES
/// The cuts against a position, 1 kept, 0 removed, 2 where meshes of a sheet must be looked at. As a software driver looks at
/// them whether it needs to or not, this is for those who ask for many positions.
int cutsGuess(vec3 scenePoint, uint structure) {
  bool removed = false;
  bool isNear = false;
  bool hasSlice = false;
  bool inSlice = false;
  bool nearSlice = false;
  for (int i = 0; i < frame.cutCount; ++i) {
    int guess = convexDistance(cuts[i], scenePoint) < 0.0 ? kCutRemoves : kCutKeeps;
    if (cuts[i].kind.x == kCutMembrane) guess = membraneGuess(cuts[i], (cuts[i].localFromScene * vec4(scenePoint, 1.0)).xyz);
    if (isExempt(structure, i)) guess = kCutKeeps;
    hasSlice = hasSlice || isSlice(i);
    inSlice = inSlice || (isSlice(i) && guess == kCutKeeps);
    nearSlice = nearSlice || (isSlice(i) && guess == kCutNear);
    removed = removed || (!isSlice(i) && guess == kCutRemoves);
    isNear = isNear || (!isSlice(i) && guess == kCutNear);
  }
  if (removed || (hasSlice && !inSlice && !nearSlice)) return 0;
  return isNear || (hasSlice && !inSlice) ? 2 : 1;
}
#endif

/// The unit normal of the face of a cut of convex shape, out of the material.
vec3 convexNormal(int cut, vec3 p) {
  float e = 0.01 * frame.step;
  vec3 gradient = vec3(convexDistance(cuts[cut], p + vec3(e, 0, 0)) - convexDistance(cuts[cut], p - vec3(e, 0, 0)),
                       convexDistance(cuts[cut], p + vec3(0, e, 0)) - convexDistance(cuts[cut], p - vec3(0, e, 0)),
                       convexDistance(cuts[cut], p + vec3(0, 0, e)) - convexDistance(cuts[cut], p - vec3(0, 0, e)));
  float len = length(gradient);
  return len > 0.0 ? -gradient / len : vec3(0.0, 0.0, 1.0);
}

#ifdef MEMBRANES
/// The normal of a sheet, or of the plane around it (triangle -1), in a place on it, towards the eye.
vec3 sheetNormalAt(int cut, int triangle, vec3 p, vec3 direction) {
  CutData c = cuts[cut];
  mat3 toLocal = mat3(c.localFromScene);
  return membraneNormal(c, triangle, (c.localFromScene * vec4(p, 1.0)).xyz, toLocal * direction) * toLocal;
}

/// Share of its opacity that slices leave to a position of a structure: that of the slice that leaves it most.
float sliceShare(vec3 scenePoint, uint structure) {
  float share = 0.0;
  for (int i = 0; i < frame.cutCount; ++i) {
    if (!isSlice(i)) continue;
    vec3 p = (cuts[i].localFromScene * vec4(scenePoint, 1.0)).xyz;
    float own = isExempt(structure, i) ? 1.0 : membraneRemoves(cuts[i], p) ? 0.0 : membraneShare(cuts[i], p.z);
    share = max(share, own);
  }
  return share;
}

/// Optical depth of a length of material, mm, whose opacity has been reduced: the opacity of a voxel of it is.
float fadedDepth(float depth, float thickness, float share) {
  float voxels = max(thickness * frame.voxelsPerLength, 1e-6);
  float opacity = 1.0 - exp(-depth / voxels);
  return share >= 1.0 ? depth : -log(max(1.0 - share * opacity, 1e-6)) * voxels;
}

/// Whether a slice's image shows in a place: what cuts, other than slices, remove takes the image with it.
bool sliceShows(vec3 scenePoint, uint structure) {
  for (int i = 0; i < frame.cutCount; ++i)
    if (!isSlice(i) && cutDistance(cuts[i], scenePoint) < -0.01 / frame.voxelsPerLength && !isExempt(structure, i)) return false;
  return true;
}

/// Something thin that a ray passes.
struct Mark {
  float t;  // kFar: nothing
  int cut;
  int triangle;
};

/// The image of a slice that comes next after one; those in one place in the order of the cuts.
Mark nextSlice(Ray ray, Mark before) {
  Mark mark = Mark(kFar, -1, -1);
  for (int i = 0; i < frame.cutCount; ++i) {
    if (!isSlice(i)) continue;
    vec3 o = (cuts[i].localFromScene * vec4(ray.origin, 1.0)).xyz;
    vec3 d = mat3(cuts[i].localFromScene) * ray.direction;
    float t = -o.z / sheetNonZero(d.z);
    bool isLater = t > before.t || (t == before.t && i > before.cut);
    if (isLater && t < mark.t && sheetHolds(cutSheet(cuts[i]), o + t * d)) mark = Mark(t, i, -1);
  }
  return mark;
}

/// The sheet to be shown that comes next after t.
Mark nextSheet(Ray ray, float t, float tEnd) {
  Mark mark = Mark(kFar, -1, -1);
  for (int i = 0; i < frame.cutCount; ++i) {
    if (cuts[i].kind.x != kCutMembrane || cuts[i].sheet.w == 0) continue;
    vec3 o = (cuts[i].localFromScene * vec4(ray.origin, 1.0)).xyz;
    vec3 d = mat3(cuts[i].localFromScene) * ray.direction;
    SheetHit hit = sheetCrossing(cutSheet(cuts[i]), o, d, t, min(tEnd, mark.t));
    if (hit.t < mark.t) mark = Mark(hit.t, i, hit.triangle);
  }
  return mark;
}
#endif

/// A stretch of a ray: all of it kept, or all of it removed by at least one cut.
struct Stretch {
  float end;     // where it ends, along the ray
  bool kept;
  int face;      // removed stretches: the cut on whose face they end
  int triangle;  // and, of a membrane, the triangle there; -1: none
};

/// How a cut goes on along a ray from t: where its removed part that holds t ends, t where there is none, and otherwise
/// where its next one begins.
struct Run {
  float end;
  float next;
  int triangle;  // of a membrane, where it ends; -1: none
};

Run convexRun(int cut, Ray ray, float t, float e) {
  vec2 inside = cutInterval(cuts[cut], ray.origin, ray.direction);
  bool hit = inside.x < inside.y;
  Run run = Run(t, kFar, -1);
  if (cuts[cut].halfSize.w > 0.0) {
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
Run membraneRun(int cut, Ray ray, float t, float e, float tEnd) {
  SheetHit crossing = membraneCrossing(cuts[cut], ray.origin, ray.direction, t + e, tEnd);
  float middle = 0.5 * (t + min(crossing.t, tEnd));
  vec3 p = (cuts[cut].localFromScene * vec4(ray.origin + middle * ray.direction, 1.0)).xyz;
  bool removes = membraneRemoves(cuts[cut], p);
  return Run(removes ? crossing.t : t, removes ? kFar : crossing.t, crossing.triangle);
}
#endif

Run runFrom(int cut, Ray ray, float t, float e, float tEnd) {
#ifdef MEMBRANES
  if (cuts[cut].kind.x == kCutMembrane) return membraneRun(cut, ray, t, e, tEnd);
#endif
  return convexRun(cut, ray, t, e);
}

/// The stretch that begins at t. A ray is walked stretch by stretch; each costs one look at every cut.
Stretch stretchFrom(Ray ray, float t, float tEnd) {
  Stretch stretch = Stretch(tEnd, true, -1, -1);
  float removedTo = t;
  float e = 1e-5 * max(1.0, abs(t));
  // Of the slices together: whether one keeps what follows, and as far as none of them changes.
  bool hasSlice = false;
  bool inSlice = false;
  Run slices = Run(kFar, kFar, -1);
  int sliceCut = -1;
  for (int i = 0; i < frame.cutCount; ++i) {
    Run run = runFrom(i, ray, t, e, tEnd);
    if (isSlice(i)) {
      hasSlice = true;
      inSlice = inSlice || run.end <= t;
      float change = run.end > t ? run.end : run.next;
      if (sliceCut < 0 || change < slices.end) {
        slices.end = change;
        slices.triangle = run.triangle;
        sliceCut = i;
      }
      continue;
    }
    if (run.end > removedTo) {
      removedTo = run.end;
      stretch.face = i;
      stretch.triangle = run.triangle;
      stretch.kept = false;
    }
    if (stretch.kept) stretch.end = min(stretch.end, run.next);
  }
  if (!stretch.kept) {
    stretch.end = min(removedTo, tEnd);
  } else if (hasSlice) {
    stretch = Stretch(min(stretch.end, slices.end), inSlice, sliceCut, slices.triangle);
  }
  return stretch;
}
