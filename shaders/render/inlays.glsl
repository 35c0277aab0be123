// What is drawn in places on a ray: the images of inlays, and the sheets of membranes.
#include "common/shade.glsl"
#include "render/data_color.glsl"
#include "render/hit.glsl"

#ifdef MEMBRANES

/// The image of an inlay.
void addInlayAt(inout Hit hit, Ray ray, Mark mark) {
  vec3 p = ray.origin + mark.t * ray.direction;
  uint structure = structureAt(p, kAnybody);
  if (!inlayShows(p, structure)) return;
  vec3 normal = sheetNormalAt(mark.cut, -1, p, ray.direction);
  addImage(hit, mark.t, dataColor(p, structure).rgb, cuts[mark.cut].inlay.x, normal, structure, mark.cut);
}

/// How a place on a sheet runs through the picture.
struct SheetPlace {
  vec2 at;        // in meshes
  vec2 perPixel;  // meshes a pixel, at most
};

SheetPlace sheetPlaceAt(int cut, int triangle, vec3 p, vec3 direction, float pixelSize) {
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
  return SheetPlace(base + (isLower ? vec2(w.y + w.z, w.z) : vec2(w.y, w.y + w.z)), pixelSize * vec2(length(gx), length(gy)));
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
void addSheetAt(inout Hit hit, Ray ray, Mark mark) {
  vec3 p = ray.origin + mark.t * ray.direction;
  CutData cut = cuts[mark.cut];
  vec3 normal = sheetNormalAt(mark.cut, mark.triangle, p, ray.direction);
  float facing = -dot(normal, ray.direction);
  bool isGrid = cut.sheet.w == 1;
  vec3 albedo = isGrid ? vec3(0.97, 0.86, 0.55) : vec3(0.42, 0.66, 0.92);
  float alpha = 0.28 + 0.45 * pow(1.0 - facing, 3.0);
  if (isGrid) {
    float depth = hasFlag(kFlagOrthographic) ? 1.0 : mark.t * dot(ray.direction, frame.forward.xyz);
    float pixelSize = 2.0 * length(frame.up.xyz) / frame.pictureSize.y * depth;
    vec3 local = (cut.localFromScene * vec4(p, 1.0)).xyz;
    SheetPlace place = sheetPlaceAt(mark.cut, mark.triangle, local, mat3(cut.localFromScene) * ray.direction, pixelSize);
    alpha = 0.7 * gridCover(cutSheet(cut), place);
  }
  addSheet(hit, mark.t, shadeSurface(albedo, normal, -ray.direction, lightTexAt(p, normal, 1.0)), alpha, normal);
}

/// A picture of parts is without this one.
bool isHidden(bool isBehind) { return isBehind ? hasFlag(kFlagHideBehind) : hasFlag(kFlagHideFront); }

/// Everything along one ray, stretch by stretch, and what is drawn in places on it.
void castMarked(inout Hit hit, Ray ray, Walk walk, float from, float tEnd) {
  float t = from;
  Face face = kNoFace;
  Stretch stretch = Stretch(t, true, -1, -1);
  // The marks ahead are looked for at one place of the loop: what is called twice is compiled twice.
  Mark inlay = Mark(t, -1, -1);
  Mark sheet = Mark(t, -1, -1);
  bool seeksInlay = true;
  bool seeksSheet = true;
  bool isBehind = false;
  int guard = 256 + 8 * frame.cutCount;
  do {
    // What comes next: the end of a stretch, an inlay's image or a sheet.
    bool wasRemoved = !stretch.kept;
    if (t >= stretch.end) {
      face = wasRemoved ? Face(stretch.face, stretch.triangle) : kNoFace;
      stretch = stretchFrom(ray, t, tEnd);
    }
    float e = 1e-5 * max(1.0, abs(t));
    if (seeksInlay) inlay = hasFlag(kFlagInlays) ? nextInlay(ray, inlay) : Mark(kFar, -1, -1);
    if (seeksSheet) sheet = hasFlag(kFlagSheets) ? nextSheet(ray, sheet.t + (sheet.cut < 0 ? 0.0 : e), tEnd) : Mark(kFar, -1, -1);
    seeksInlay = false;
    seeksSheet = false;
    // A sheet that lies in the inlay is drawn on its image, not now before and now behind it.
    bool inlayIsNext = inlay.t <= sheet.t - 0.1 / frame.voxelsPerLength;
    float mark = min(inlay.t, sheet.t);
    if (mark <= t + e) {
      if (inlayIsNext) {
        if (!hasFlag(kFlagHideInlay)) addInlayAt(hit, ray, inlay);
        isBehind = true;
        seeksInlay = true;
      } else {
        if (!isHidden(isBehind)) addSheetAt(hit, ray, sheet);
        seeksSheet = true;
      }
    } else {
      float end = min(stretch.end, mark);
      bool sparedOnly = !stretch.kept;
      if (end > t && (stretch.kept || hasFlag(kFlagSpares)) && !isHidden(isBehind))
        marchStretch(hit, ray, walk, Span(t, end, sparedOnly ? kNoFace : face, sparedOnly));
      face = kNoFace;
      t = max(end, t + 1e-6 * max(1.0, abs(t)));
    }
  } while (t < tEnd && --guard > 0 && !isDone(hit));
}

#endif
