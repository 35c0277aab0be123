// The sheet of a membrane: what lies above it, and where a line crosses it. C++ and GLSL compile this text.
#ifndef VELUM_SHARED_SHEET_H
#define VELUM_SHARED_SHEET_H
#include "shared/bindings.h"
#include "shared/types.h"
SHARED_BEGIN

// The rows of a sheet, each a vec4, one part after the other; whole numbers are exact in floats.
//   places   a row a particle, x fastest: x, y, z in the frame
//   normals  a row a particle: unit, towards what lies above where the sheet is not folded
//   cells    a row a cell: first entry of its list, number of entries, lowest and highest z of its meshes with a margin
//   lists    four entries a row: the lower left particles of meshes that may touch the cell
// Cells stand around the places that the particles have when the sheet hangs flat, as many as particles: a mesh that
// has not moved touches four of them, and no rounding makes it more.

SHARED_CONST float kSheetFar = 1e30f;
SHARED_CONST int kSheetGroup = 64;           // threads of the groups that index a sheet
SHARED_CONST int kSheetScanGroup = 64;       // of the one that sums up
SHARED_CONST int kSheetEntriesPerCell = 16;  // room in the lists on the GPU; a sheet that hangs flat needs four
SHARED_CONST float kSheetMargin = 1e-5f;     // of the rest plane's edges: how far rounding may take a line from its cell

/// Which rows, and the frame that the sheet hangs in.
struct SheetPlan {
  ivec4 rows;  ///< x: first row of the sheet; y, z: particles along the rest plane's width and height
  vec3 halfSize;  ///< half edges of the rest plane's box
  float scale;    ///< what lengths in the rows are multiplied with to be in the unit of halfSize
};

/// Where a line crosses a sheet: triangle 2 v or 2 v + 1 is the lower or upper one of the mesh whose lower left particle
/// is v; -1: none.
struct SheetHit {
  float t;
  int triangle;
};

SHARED_FN int sheetParticles(SheetPlan plan) { return plan.rows.y * plan.rows.z; }

/// First row of the cells' lists.
SHARED_FN int sheetLists(SheetPlan plan) { return plan.rows.x + 3 * sheetParticles(plan); }

/// A place of the rest plane in cells.
SHARED_FN vec2 sheetCellAt(SheetPlan plan, vec2 place) {
  vec2 edges = vec2(float(plan.rows.y - 1), float(plan.rows.z - 1));
  return (place / vec2(plan.halfSize.x, plan.halfSize.y) + 1.0f) * 0.5f * edges + 0.5f;
}

SHARED_FN int sheetCellIndex(float at, int count) { return clamp(int(at), 0, count - 1); }

/// The cells x, y to z, w that the meshes between two corners of the rest plane may touch.
SHARED_FN ivec4 sheetCellsWithin(SheetPlan plan, vec2 low, vec2 high) {
  vec2 a = sheetCellAt(plan, low) - 1e-3f;
  vec2 b = sheetCellAt(plan, high) + 1e-3f;
  return ivec4(sheetCellIndex(a.x, plan.rows.y), sheetCellIndex(a.y, plan.rows.z), sheetCellIndex(b.x, plan.rows.y),
               sheetCellIndex(b.y, plan.rows.z));
}

/// Slack of a cell's lowest and highest z.
SHARED_FN float sheetSlack(SheetPlan plan) { return kSheetMargin * (plan.halfSize.x + plan.halfSize.y + plan.halfSize.z); }

/// True over the rest plane's rectangle. Half open, as the edges of the meshes are counted.
SHARED_FN bool sheetHolds(SheetPlan plan, vec3 p) {
  return p.x >= -plan.halfSize.x && p.x < plan.halfSize.x && p.y >= -plan.halfSize.y && p.y < plan.halfSize.y;
}

SHARED_FN float sheetCross(vec3 a, vec3 b) {
  SHARED_EXACT float e = a.x * b.y - a.y * b.x;
  return e;
}

/// Crossing number: the edge from a to b passes the z axis on its +x side. Meshes agree about an edge that they share,
/// as its two ends taken the other way round only change the sign of `edgeCross`.
SHARED_FN bool sheetEdgePasses(vec3 a, vec3 b, float edgeCross) {
  return (a.y > 0.0f) != (b.y > 0.0f) && (b.y > 0.0f ? edgeCross > 0.0f : edgeCross < 0.0f);
}

/// z of a triangle on the z axis, by the areas of the triangles that the axis makes with its edges.
SHARED_FN float sheetDepth(vec3 a, vec3 b, vec3 c, float overA, float overB, float overC) {
  float area = overA + overB + overC;
  float z = area != 0.0f ? (overA * a.z + overB * b.z + overC * c.z) / area : a.z;
  // A triangle that the axis lies in has a height between those of its corners, however badly its area is known.
  return clamp(z, min(a.z, min(b.z, c.z)), max(a.z, max(b.z, c.z)));
}

/// Where the z axis meets the two triangles of a mesh (corners lower left, lower right, upper right, upper left): their
/// z, kSheetFar where it misses.
SHARED_FN vec2 sheetMeets(vec3 a, vec3 b, vec3 c, vec3 d) {
  float ab = sheetCross(a, b);
  float bc = sheetCross(b, c);
  float ca = sheetCross(c, a);
  float cd = sheetCross(c, d);
  float da = sheetCross(d, a);
  bool diagonal = sheetEdgePasses(c, a, ca);
  bool lower = (sheetEdgePasses(a, b, ab) != sheetEdgePasses(b, c, bc)) != diagonal;
  bool upper = (sheetEdgePasses(c, d, cd) != sheetEdgePasses(d, a, da)) != diagonal;
  return vec2(lower ? sheetDepth(a, b, c, bc, ca, ab) : kSheetFar, upper ? sheetDepth(a, c, d, cd, da, -ca) : kSheetFar);
}

#if SHARED_HAS_SHEETS
SHARED_SHEET_BLOCK(kSheetUnit)

SHARED_FN vec3 sheetPlace(SheetPlan plan, int particle SHARED_SHEETS) {
  return plan.scale * vec3(SHARED_SHEET_ROW(plan.rows.x + particle));
}

SHARED_FN vec4 sheetCell(SheetPlan plan, int x, int y SHARED_SHEETS) {
  vec4 row = SHARED_SHEET_ROW(plan.rows.x + 2 * sheetParticles(plan) + y * plan.rows.y + x);
  return vec4(row.x, row.y, plan.scale * row.z, plan.scale * row.w);
}

/// An entry of the cells' lists: the lower left particle of a mesh.
SHARED_FN int sheetEntry(SheetPlan plan, int entry SHARED_SHEETS) {
  return int(SHARED_SHEET_ROW(sheetLists(plan) + (entry >> 2))[entry & 3]);
}

/// Cosine between a triangle's normal and z.
SHARED_FN float sheetSteepness(vec3 a, vec3 b, vec3 c) {
  vec3 n = cross(b - a, c - a);
  float len = length(n);
  return len > 0.0f ? abs(n.z) / len : 1.0f;
}

/// Everything that a line along z through a point meets.
struct SheetColumn {
  int over;        ///< how often it meets the sheet above the point
  int all;         ///< how often at all: odd over the rest plane
  float distance;  ///< to the plane of the triangle that it meets nearest
};

SHARED_FN SheetColumn sheetColumn(SheetPlan plan, vec3 p, vec4 cell SHARED_SHEETS) {
  SheetColumn column;
  column.over = 0;
  column.all = 0;
  column.distance = abs(p.z);
  float nearest = kSheetFar;
  int first = int(cell.x);
  int count = int(cell.y);
  for (int i = 0; i < count; ++i) {
    int v = sheetEntry(plan, first + i SHARED_PASS_SHEETS);
    vec3 a = sheetPlace(plan, v SHARED_PASS_SHEETS) - p;
    vec3 b = sheetPlace(plan, v + 1 SHARED_PASS_SHEETS) - p;
    vec3 c = sheetPlace(plan, v + plan.rows.y + 1 SHARED_PASS_SHEETS) - p;
    vec3 d = sheetPlace(plan, v + plan.rows.y SHARED_PASS_SHEETS) - p;
    vec2 z = sheetMeets(a, b, c, d);
    bool lower = z.x < kSheetFar;
    bool upper = z.y < kSheetFar;
    column.all += (lower ? 1 : 0) + (upper ? 1 : 0);
    column.over += (lower && z.x > 0.0f ? 1 : 0) + (upper && z.y > 0.0f ? 1 : 0);
    if (abs(z.x) < nearest) {
      nearest = abs(z.x);
      column.distance = nearest * sheetSteepness(a, b, c);
    }
    if (abs(z.y) < nearest) {
      nearest = abs(z.y);
      column.distance = nearest * sheetSteepness(a, c, d);
    }
  }
  return column;
}

/// The cell of a place over the rest plane.
SHARED_FN vec4 sheetCellOf(SheetPlan plan, vec3 p SHARED_SHEETS) {
  vec2 at = sheetCellAt(plan, vec2(p.x, p.y));
  return sheetCell(plan, sheetCellIndex(at.x, plan.rows.y), sheetCellIndex(at.y, plan.rows.z) SHARED_PASS_SHEETS);
}

/// An even number of crossings above the point. The rim may be off the frame by a rounding error, and then nothing is met.
SHARED_FN bool sheetColumnIsAbove(SheetColumn column, vec3 p) {
  return (column.all & 1) == 0 ? p.z > 0.0f : (column.over & 1) == 0;
}

SHARED_CONST int kSheetBelow = 0;
SHARED_CONST int kSheetAbove = 1;
SHARED_CONST int kSheetNear = 2;  // only the meshes tell

/// Which side of the sheet a point is on, as far as one fetch tells.
SHARED_FN int sheetSide(SheetPlan plan, vec3 p, vec4 cell) {
  if (!sheetHolds(plan, p)) return p.z > 0.0f ? kSheetAbove : kSheetBelow;
  return p.z > cell.w ? kSheetAbove : p.z < cell.z ? kSheetBelow : kSheetNear;
}

/// True where a line from the point along +z meets the sheet an even number of times; beyond the rest plane the plane z = 0
/// goes on. Cost: a few fetches away from the sheet, the meshes of one cell near it.
SHARED_FN bool sheetIsAbove(SheetPlan plan, vec3 p SHARED_SHEETS) {
  vec4 cell = sheetCellOf(plan, p SHARED_PASS_SHEETS);
  int side = sheetSide(plan, p, cell);
  if (side != kSheetNear) return side == kSheetAbove;
  return sheetColumnIsAbove(sheetColumn(plan, p, cell SHARED_PASS_SHEETS), p);
}

/// Distance to the sheet, negative above it. Exact in sign; in size only near a sheet that is hardly curved: along z
/// to the next crossing, times the cosine of its slope.
SHARED_FN float sheetDistance(SheetPlan plan, vec3 p SHARED_SHEETS) {
  if (!sheetHolds(plan, p)) return -p.z;
  SheetColumn column = sheetColumn(plan, p, sheetCellOf(plan, p SHARED_PASS_SHEETS) SHARED_PASS_SHEETS);
  return sheetColumnIsAbove(column, p) ? -column.distance : column.distance;
}

/// Coordinates in which a line is the z axis.
struct SheetLine {
  vec3 origin;
  vec3 x;
  vec3 y;
  vec3 z;  ///< along it, unit
};

SHARED_FN vec3 sheetFromLine(SheetLine line, vec3 place) {
  SHARED_EXACT vec3 p = place - line.origin;
  SHARED_EXACT float x = line.x.x * p.x + line.x.y * p.y + line.x.z * p.z;
  SHARED_EXACT float y = line.y.x * p.x + line.y.y * p.y + line.y.z * p.z;
  return vec3(x, y, dot(line.z, p));
}

SHARED_FN SheetLine sheetLine(vec3 origin, vec3 direction) {
  SheetLine line;
  line.origin = origin;
  line.z = direction;
  line.x = normalize(abs(direction.z) > 0.5f ? vec3(direction.z, 0.0f, -direction.x) : vec3(-direction.y, direction.x, 0.0f));
  line.y = cross(direction, line.x);
  return line;
}

SHARED_FN float sheetNonZero(float x) { return abs(x) < 1e-12f ? (x < 0.0f ? -1e-12f : 1e-12f) : x; }

/// The nearest crossing after `from` with the meshes of a cell that is nearer than `best`.
SHARED_FN SheetHit sheetNearest(SheetPlan plan, vec4 cell, bool look, SheetLine line, float from, SheetHit best SHARED_SHEETS) {
  int first = int(cell.x);
  int count = look ? int(cell.y) : 0;
  int i = 0;
  do {
    int v = sheetEntry(plan, first + max(min(i, count - 1), 0) SHARED_PASS_SHEETS);
    vec2 t = sheetMeets(sheetFromLine(line, sheetPlace(plan, v SHARED_PASS_SHEETS)),
                        sheetFromLine(line, sheetPlace(plan, v + 1 SHARED_PASS_SHEETS)),
                        sheetFromLine(line, sheetPlace(plan, v + plan.rows.y + 1 SHARED_PASS_SHEETS)),
                        sheetFromLine(line, sheetPlace(plan, v + plan.rows.y SHARED_PASS_SHEETS)));
    bool lower = count > 0 && t.x > from && t.x < best.t;
    best.triangle = lower ? 2 * v : best.triangle;
    best.t = lower ? t.x : best.t;
    bool upper = count > 0 && t.y > from && t.y < best.t;
    best.triangle = upper ? 2 * v + 1 : best.triangle;
    best.t = upper ? t.y : best.t;
  } while (++i < count);
  return best;
}

/// The first crossing of the line o + t d (frame-local, d unit) with the sheet between two t, exclusive; kSheetFar when
/// there is none. Walks the cells under the line, and looks into those whose meshes are as high as the line.
SHARED_FN SheetHit sheetCrossing(SheetPlan plan, vec3 o, vec3 d, float from, float to SHARED_SHEETS) {
  SheetHit best;
  best.t = kSheetFar;
  best.triangle = -1;
  // The part of the line inside the rest plane's box, a little enlarged.
  vec3 inv = 1.0f / vec3(sheetNonZero(d.x), sheetNonZero(d.y), sheetNonZero(d.z));
  vec3 h = plan.halfSize + sheetSlack(plan);
  vec3 t0 = (-h - o) * inv;
  vec3 t1 = (h - o) * inv;
  vec3 enters = min(t0, t1);
  vec3 leaves = max(t0, t1);
  float start = max(max(enters.x, enters.y), max(enters.z, from));
  float end = min(min(leaves.x, leaves.y), min(leaves.z, to));
  if (!(start < end)) return best;
  // From here on t is counted from `start`: the eye may be far off.
  vec3 p = o + start * d;
  SheetLine line = sheetLine(p, d);
  float last = end - start;
  vec2 at = sheetCellAt(plan, vec2(p.x, p.y));
  vec2 perLength = 0.5f * vec2(float(plan.rows.y - 1) / plan.halfSize.x, float(plan.rows.z - 1) / plan.halfSize.y) * vec2(d.x, d.y);
  vec2 mmPer = 1.0f / vec2(sheetNonZero(perLength.x), sheetNonZero(perLength.y));
  int stepX = perLength.x < 0.0f ? -1 : 1;
  int stepY = perLength.y < 0.0f ? -1 : 1;
  int x = sheetCellIndex(at.x, plan.rows.y);
  int y = sheetCellIndex(at.y, plan.rows.z);
  float t = 0.0f;
  int guard = plan.rows.y + plan.rows.z;
  // As in the ray march, conditions stand at the foot, and a turn too many changes nothing.
  bool more;
  do {
    vec4 cell;
    float next;
    bool looks;
    bool leaps;
    do {
      float nextX = (float(x + (stepX > 0 ? 1 : 0)) - at.x) * mmPer.x;
      float nextY = (float(y + (stepY > 0 ? 1 : 0)) - at.y) * mmPer.y;
      bool isX = nextX < nextY;
      next = min(isX ? nextX : nextY, last);
      cell = sheetCell(plan, x, y SHARED_PASS_SHEETS);
      float z0 = p.z + t * d.z;
      float z1 = p.z + next * d.z;
      looks = max(z0, z1) >= cell.z && min(z0, z1) <= cell.w;
      int nextCellX = isX ? x + stepX : x;
      int nextCellY = isX ? y : y + stepY;
      bool isInside = nextCellX >= 0 && nextCellY >= 0 && nextCellX < plan.rows.y && nextCellY < plan.rows.z;
      leaps = !looks && isInside && next < last && guard > 0;
      guard -= leaps ? 1 : 0;
      x = leaps ? nextCellX : x;
      y = leaps ? nextCellY : y;
      t = leaps ? max(next, t) : t;
    } while (leaps);
    best = sheetNearest(plan, cell, looks, line, from - start, best SHARED_PASS_SHEETS);
    float edgeX = (float(x + (stepX > 0 ? 1 : 0)) - at.x) * mmPer.x;
    float edgeY = (float(y + (stepY > 0 ? 1 : 0)) - at.y) * mmPer.y;
    int afterX = edgeX < edgeY ? x + stepX : x;
    int afterY = edgeX < edgeY ? y : y + stepY;
    bool goesOn = afterX >= 0 && afterY >= 0 && afterX < plan.rows.y && afterY < plan.rows.z;
    more = goesOn && next < last && best.t > next && guard > 0;
    guard -= more ? 1 : 0;
    x = more ? afterX : x;
    y = more ? afterY : y;
    t = more ? max(next, t) : t;
  } while (more);
  best.t = best.t < last ? best.t + start : kSheetFar;
  best.triangle = best.t < kSheetFar ? best.triangle : -1;
  return best;
}

/// The three corners of a triangle, as particles.
SHARED_FN ivec3 sheetCorners(SheetPlan plan, int triangle) {
  int v = triangle >> 1;
  int upper = v + plan.rows.y;
  return (triangle & 1) == 0 ? ivec3(v, v + 1, upper + 1) : ivec3(v, upper + 1, upper);
}

/// Shares of a triangle's corners in a place on it; they add up to 1.
SHARED_FN vec3 sheetShares(SheetPlan plan, int triangle, vec3 p SHARED_SHEETS) {
  ivec3 corner = sheetCorners(plan, triangle);
  vec3 a = sheetPlace(plan, corner.x SHARED_PASS_SHEETS);
  vec3 b = sheetPlace(plan, corner.y SHARED_PASS_SHEETS);
  vec3 c = sheetPlace(plan, corner.z SHARED_PASS_SHEETS);
  vec3 n = cross(b - a, c - a);
  vec3 w = vec3(dot(n, cross(b - p, c - p)), dot(n, cross(c - p, a - p)), dot(n, cross(a - p, b - p)));
  w = max(w, vec3(0.0f));
  float sum = w.x + w.y + w.z;
  return sum > 0.0f ? w / sum : vec3(1.0f / 3.0f);
}

/// The sheet's normal in a place on a triangle, between those of its corners; not unit.
SHARED_FN vec3 sheetNormal(SheetPlan plan, int triangle, vec3 p SHARED_SHEETS) {
  ivec3 corner = sheetCorners(plan, triangle) + plan.rows.x + sheetParticles(plan);
  vec3 w = sheetShares(plan, triangle, p SHARED_PASS_SHEETS);
  return w.x * vec3(SHARED_SHEET_ROW(corner.x)) + w.y * vec3(SHARED_SHEET_ROW(corner.y)) + w.z * vec3(SHARED_SHEET_ROW(corner.z));
}

#endif

SHARED_END
#endif
