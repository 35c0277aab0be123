// The one function that says what a cut removes. C++ and GLSL compile this text.
#ifndef VELUM_SHARED_CUT_H
#define VELUM_SHARED_CUT_H
#include "shared/sheet.h"
#include "shared/types.h"
SHARED_BEGIN

SHARED_CONST int kCutPlane = 0;
SHARED_CONST int kCutBox = 1;
SHARED_CONST int kCutSphere = 2;
SHARED_CONST int kCutCylinder = 3;
SHARED_CONST int kCutCone = 4;
SHARED_CONST int kCutMembrane = 5;
SHARED_CONST int kMembraneClip = 0;   // removes what is above its sheet
SHARED_CONST int kMembraneInlay = 1;  // removes all but what lies between its sheet and the plane z = 0
// Bits of kind.z.
SHARED_CONST int kCutWalks = 1;   // goes along rays by cutWalk()
SHARED_CONST int kCutJoined = 2;  // removes only what the one before it removes, too
SHARED_CONST float kCutFar = 1e30f;
// What a cut does with a point.
SHARED_CONST int kCutKeeps = 0;
SHARED_CONST int kCutRemoves = 1;
SHARED_CONST int kCutNear = 2;  // only the meshes of a sheet tell

/// One enabled cut. Frame: the scene's (world minus its origin, in its unit).
struct CutData {
  mat4 localFromScene;  ///< rigid
  vec4 halfSize;        ///< xyz: half edges, radius in x; w: 1 removes the inside, -1 the outside
  ivec4 kind;           ///< x: kCut*; y: 1 shows the section on its face; z: bits kCutWalks, kCutJoined; w: kMembrane*
  vec4 face;            ///< x: opacity of a section face; y: membranes: SheetPlan::scale
  ivec4 sheet;          ///< membranes: x: first row; y, z: particles across, up; w: 1 shown as lines, 2 as a surface
  vec4 inlay;           ///< membranes: x: opacity of the inlay's image; y: 1/length of the fall-off; z, w: factors above, below
};
SHARED_CONST int kCutTexels = 9;

/// Whether a line has one stretch in the shape at most, which cutShapeInterval() then knows. Other shapes need no more than
/// their distance.
SHARED_FN bool cutIsConvex(int kind) { return kind != kCutMembrane; }

/// Signed distance from a point in the cut's local frame to the shape: < 0 inside. Exact for every shape.
SHARED_FN float cutShapeDistance(int anyKind, vec3 halfSize, vec3 p) {
  int kind = SHARED_SHAPE(anyKind);
  if (kind == kCutPlane) return -p.z;
  if (kind == kCutSphere) return length(p) - halfSize.x;
  if (kind == kCutBox) {
    vec3 q = abs(p) - halfSize;
    return length(max(q, vec3(0.0f))) + min(max(q.x, max(q.y, q.z)), 0.0f);
  }
  float r = sqrt(p.x * p.x + p.y * p.y);
  if (kind == kCutCylinder) {
    float dr = r - halfSize.x;
    float dz = abs(p.z) - halfSize.z;
    float ox = max(dr, 0.0f);
    float oz = max(dz, 0.0f);
    return sqrt(ox * ox + oz * oz) + min(max(dr, dz), 0.0f);
  }
  // Cone: apex at the origin, opening along +z to radius halfSize.x at height 2 halfSize.z. In the (r, z) half plane it is a
  // triangle: distance to the slanted side and to the base disc.
  float h = 2.0f * halfSize.z;
  float len = sqrt(halfSize.x * halfSize.x + h * h);
  float along = clamp((r * halfSize.x + p.z * h) / (len * len), 0.0f, 1.0f);
  float sx = r - along * halfSize.x;
  float sz = p.z - along * h;
  float toSide = sqrt(sx * sx + sz * sz);
  float bx = max(r - halfSize.x, 0.0f);
  float bz = p.z - h;
  float toBase = sqrt(bx * bx + bz * bz);
  float away = (r * h - p.z * halfSize.x) / len;
  bool inside = away < 0.0f && p.z < h;
  return (inside ? -1.0f : 1.0f) * min(toSide, toBase);
}

#if SHARED_HAS_SHEETS
SHARED_FN SheetPlan cutSheet(CutData cut) {
  SheetPlan plan;
  plan.rows = cut.sheet;
  plan.halfSize = vec3(cut.halfSize);
  plan.scale = cut.face.y;
  return plan;
}

SHARED_FN bool membraneRemovesSide(CutData cut, vec3 p, bool isAbove) {
  if (cut.kind.w == kMembraneInlay) return isAbove == (p.z > 0.0f) || !sheetHolds(cutSheet(cut), p);
  return isAbove == (cut.halfSize.w > 0.0f);
}

/// What membraneRemoves() says, as far as one fetch tells.
SHARED_FN int membraneGuess(CutData cut, vec3 p SHARED_SHEETS) {
  SheetPlan plan = cutSheet(cut);
  int side = sheetSide(plan, p, sheetCellOf(plan, p SHARED_PASS_SHEETS));
  if (side == kSheetNear) return kCutNear;
  return membraneRemovesSide(cut, p, side == kSheetAbove) ? kCutRemoves : kCutKeeps;
}

/// Whether a membrane removes a point of its rest plane: what is above the sheet (inverted: below it), or, as an inlay,
/// everything but what lies between the sheet and the inlay.
SHARED_FN bool membraneRemoves(CutData cut, vec3 p SHARED_SHEETS) {
  return membraneRemovesSide(cut, p, sheetIsAbove(cutSheet(cut), p SHARED_PASS_SHEETS));
}

/// Its distance to what is removed: < 0 is removed. As exact as sheetDistance().
SHARED_FN float membraneDistance(CutData cut, vec3 p SHARED_SHEETS) {
  SheetPlan plan = cutSheet(cut);
  float toSheet = sheetDistance(plan, p SHARED_PASS_SHEETS);
  if (cut.kind.w != kMembraneInlay) return cut.halfSize.w * toSheet;
  bool removes = (toSheet < 0.0f) == (p.z > 0.0f) || !sheetHolds(plan, p);
  float nearest = min(abs(toSheet), abs(p.z));
  return removes ? -nearest : nearest;
}

/// The first place between two t, exclusive, at which what a membrane removes of a scene-local ray may change: a crossing
/// with its sheet or with the plane z = 0, which goes on beyond a frame and lies in that of an inlay.
SHARED_FN SheetHit membraneCrossing(CutData cut, vec3 origin, vec3 direction, float from, float to SHARED_SHEETS) {
  vec3 o = vec3(cut.localFromScene * vec4(origin, 1.0f));
  vec3 d = vec3(cut.localFromScene * vec4(direction, 0.0f));
  SheetPlan plan = cutSheet(cut);
  SheetHit hit = sheetCrossing(plan, o, d, from, to SHARED_PASS_SHEETS);
  float t = -o.z / sheetNonZero(d.z);
  bool isFace = sheetHolds(plan, o + t * d) == (cut.kind.w == kMembraneInlay);
  if (isFace && t > from && t < min(to, hit.t)) {
    hit.t = t;
    hit.triangle = -1;
  }
  return hit;
}

/// Unit normal of a membrane's face at a crossing, in its frame, against the ray: the sheet's, or that of the plane.
SHARED_FN vec3 membraneNormal(CutData cut, int triangle, vec3 p, vec3 direction SHARED_SHEETS) {
  vec3 n = vec3(0.0f, 0.0f, 1.0f);
  if (triangle >= 0) n = sheetNormal(cutSheet(cut), triangle, p SHARED_PASS_SHEETS);
  n = n / max(length(n), 1e-12f);
  return dot(n, direction) > 0.0f ? -n : n;
}

/// Share of its opacity that material keeps at a height over an inlay: it fades with the distance, and the two sides
/// differ by the emphasis.
SHARED_FN float membraneShare(CutData cut, float z) {
  return (1.0f - smoothstep(0.0f, 1.0f, abs(z) * cut.inlay.y)) * (z > 0.0f ? cut.inlay.z : cut.inlay.w);
}
#endif

/// Signed distance to what a cut, other than a membrane, removes: < 0 is removed.
SHARED_FN float shapeDistance(CutData cut, vec3 scenePoint) {
  vec3 p = vec3(cut.localFromScene * vec4(scenePoint, 1.0f));
  return cut.halfSize.w * cutShapeDistance(cut.kind.x, vec3(cut.halfSize), p);
}

/// Whether a cut removes a point.
SHARED_FN bool cutRemoves(CutData cut, vec3 scenePoint SHARED_SHEETS) {
#if SHARED_HAS_SHEETS
  if (cut.kind.x == kCutMembrane)
    return membraneRemoves(cut, vec3(cut.localFromScene * vec4(scenePoint, 1.0f)) SHARED_PASS_SHEETS);
#endif
  return shapeDistance(cut, scenePoint) < 0.0f;
}

/// Signed distance to what the cut removes: < 0 is removed.
SHARED_FN float cutDistance(CutData cut, vec3 scenePoint SHARED_SHEETS) {
#if SHARED_HAS_SHEETS
  if (cut.kind.x == kCutMembrane)
    return membraneDistance(cut, vec3(cut.localFromScene * vec4(scenePoint, 1.0f)) SHARED_PASS_SHEETS);
#endif
  return shapeDistance(cut, scenePoint);
}

/// A coordinate that is never zero, so that slab tests do not divide by it.
SHARED_FN float cutNonZero(float x) { return abs(x) < 1e-12f ? (x < 0.0f ? -1e-12f : 1e-12f) : x; }

/// Part of the line o + t d that lies between two planes at +-h on one axis.
SHARED_FN vec2 cutSlab(float o, float d, float h) {
  float inv = 1.0f / cutNonZero(d);
  float a = (-h - o) * inv;
  float b = (h - o) * inv;
  return vec2(min(a, b), max(a, b));
}

/// Roots of a t^2 + 2 b t + c = 0 in order, empty (1, -1) where there are none. Neither root loses its digits when a is
/// small, and when a vanishes one of them goes off to the far end of the line, as it should.
SHARED_FN vec2 cutQuadric(float a, float b, float c) {
  float discriminant = b * b - a * c;
  if (discriminant < 0.0f) return vec2(1.0f, -1.0f);
  float q = -(b + (b < 0.0f ? -1.0f : 1.0f) * sqrt(discriminant));
  float t0 = q / cutNonZero(a);
  float t1 = c / cutNonZero(q);
  return vec2(min(t0, t1), max(t0, t1));
}

/// The stretch of the line o + t d inside a convex shape (local frame): x > y when it misses.
SHARED_FN vec2 cutShapeInterval(int anyKind, vec3 halfSize, vec3 o, vec3 d) {
  int kind = SHARED_SHAPE(anyKind);
  if (kind == kCutPlane) {
    float dz = cutNonZero(d.z);
    float t = -o.z / dz;
    return dz > 0.0f ? vec2(t, kCutFar) : vec2(-kCutFar, t);
  }
  if (kind == kCutSphere) return cutQuadric(dot(d, d), dot(o, d), dot(o, o) - halfSize.x * halfSize.x);
  if (kind == kCutBox) {
    vec2 x = cutSlab(o.x, d.x, halfSize.x);
    vec2 y = cutSlab(o.y, d.y, halfSize.y);
    vec2 z = cutSlab(o.z, d.z, halfSize.z);
    return vec2(max(x.x, max(y.x, z.x)), min(x.y, min(y.y, z.y)));
  }
  if (kind == kCutCylinder) {
    vec2 z = cutSlab(o.z, d.z, halfSize.z);
    float a = d.x * d.x + d.y * d.y;
    float c = o.x * o.x + o.y * o.y - halfSize.x * halfSize.x;
    if (a < 1e-12f) return c <= 0.0f ? z : vec2(1.0f, -1.0f);
    vec2 side = cutQuadric(a, o.x * d.x + o.y * d.y, c);
    return vec2(max(side.x, z.x), min(side.y, z.y));
  }
  // Cone: x^2 + y^2 <= k^2 z^2, 0 <= z <= h.
  float h = 2.0f * halfSize.z;
  float k2 = halfSize.x * halfSize.x / max(h * h, 1e-24f);
  vec2 z = cutSlab(o.z - halfSize.z, d.z, halfSize.z);
  float a = cutNonZero(d.x * d.x + d.y * d.y - k2 * d.z * d.z);
  float b = o.x * d.x + o.y * d.y - k2 * o.z * d.z;
  float c = o.x * o.x + o.y * o.y - k2 * o.z * o.z;
  vec2 sides = cutQuadric(a, b, c);
  if (sides.x > sides.y) return a < 0.0f ? z : sides;
  if (a > 0.0f) return vec2(max(sides.x, z.x), min(sides.y, z.y));
  // The line runs inside the double cone before and after its two crossings; the slab keeps the upper nappe.
  return d.z > 0.0f ? vec2(max(sides.y, z.x), z.y) : vec2(z.x, min(sides.x, z.y));
}

/// The stretch of a scene-local ray that the cut's shape holds inside it. Of convex shapes; others have cutWalk(),
/// membranes membraneCrossing().
SHARED_FN vec2 cutInterval(CutData cut, vec3 origin, vec3 direction) {
  vec4 o = cut.localFromScene * vec4(origin, 1.0f);
  vec4 d = cut.localFromScene * vec4(direction, 0.0f);
  return cutShapeInterval(cut.kind.x, vec3(cut.halfSize.x, cut.halfSize.y, cut.halfSize.z), vec3(o.x, o.y, o.z), vec3(d.x, d.y, d.z));
}

/// How a cut goes on along a ray from t: where its removed part that holds t ends, t where there is none, and otherwise
/// where its next one begins.
struct CutRun {
  float end;
  float next;
  int triangle;  ///< of a membrane, where it ends; -1: none
};

SHARED_CONST int kWalkSteps = 128;
// Near a face steps are ten times the smallest length that counts, and grow, so that rays that graze come to an end: all
// steps together are a hundred thousand times that length, which is the data's diameter.
SHARED_CONST float kWalkLeast = 10.0f;
SHARED_CONST float kWalkGrowth = 1.05f;
SHARED_CONST int kWalkRefinements = 4;

/// How a cut of any shape but a membrane goes on along a scene-local ray from t: by steps as long as its distance, to where
/// that changes its sign. Parts that are thinner than a step near a face may be stepped over; a run that is out of steps
/// ends early, and whoever walks on from there goes on with it.
/// @param direction  unit  @param e  the smallest length that counts
SHARED_FN CutRun cutWalk(CutData cut, vec3 origin, vec3 direction, float t, float e, float tEnd) {
  float least = kWalkLeast * e;
  float a = t;
  float b = t + least;
  float atA = 0.0f;
  float atB = shapeDistance(cut, origin + b * direction);
  int steps = kWalkSteps;
  bool goesOn = true;
  // What is used after the loop stays when a software driver repeats its last turn.
  do {
    a = goesOn ? b : a;
    atA = goesOn ? atB : atA;
    b = goesOn ? a + max(abs(atA), least) : b;
    atB = shapeDistance(cut, origin + b * direction);
    least *= kWalkGrowth;
    --steps;
    goesOn = goesOn && (atA < 0.0f) == (atB < 0.0f) && b < tEnd && steps > 0;
  } while (goesOn);
  bool removes = atA < 0.0f;
  float change = b < tEnd ? b : kCutFar;
  if (removes != (atB < 0.0f)) {
    // Regula falsi and halves by turns.
    for (int i = 0; i < kWalkRefinements; ++i) {
      float middle = a + (i % 2 == 0 ? atA / (atA - atB) : 0.5f) * (b - a);
      float atMiddle = shapeDistance(cut, origin + middle * direction);
      bool isBefore = (atMiddle < 0.0f) == removes;
      a = isBefore ? middle : a;
      atA = isBefore ? atMiddle : atA;
      b = isBefore ? b : middle;
      atB = isBefore ? atB : atMiddle;
    }
    change = a + atA / (atA - atB) * (b - a);
  }
  CutRun run;
  run.end = removes ? change : t;
  run.next = removes ? kCutFar : change;
  run.triangle = -1;
  return run;
}

SHARED_END
#endif
