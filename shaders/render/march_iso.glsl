// The first surface of one value along a ray, opaque where no inlay fades it.
#include "common/shade.glsl"
#include "common/volume.glsl"
#include "render/composite.glsl"
#include "render/data_color.glsl"
#include "render/hit.glsl"
#include "render/walk.glsl"

#if LABELS == 1
/// Share of what is solid. @param shown  of what shows
float solidAt(vec3 scenePoint, float shown) {
  vec3 p = labelVoxelAt(scenePoint);
  return solidsOf(isBeyondLabels(p) ? frame.sharesBeyond : sharesIn(p), shown).x;
}
#endif

/// The value on a ray, a table position; below the surface's where only what cuts spare shows and they do not spare it, so
/// that where an extrusion ends there is a surface, too.
float shownValueAt(Ray ray, Walk walk, float t, bool sparedOnly) {
  float x = tableAt(texAt(walk, t));
  vec3 p = ray.origin + t * ray.direction;
  float iso = frame.isoValue * float(kTransferSize - 1);
  bool isMissing = hasFlag(kFlagSpares) && sparedOnly && x >= iso && !cutsKeep(p, structureAt(p, kSpared));
#if LABELS == 1
  if (usesShares(sparedOnly)) {
    float shown = shareAt(p, sparedOnly);
    // A structure's surface is one of the value, too.
    if (hasSolids()) x = max(x, iso + 200.0 * (solidAt(p, shown) - 0.5));
    isMissing = isMissing || shown < 0.5;
  }
#endif
  return isMissing ? min(x, iso - 1.0) : x;
}

/// What the surface looks like where the ray meets it; nothing when its structure is not shown.
void addSurface(inout Hit hit, Ray ray, Walk walk, float t, Face face, bool sparedOnly) {
  float iso = frame.isoValue * float(kTransferSize - 1);
  vec3 p = ray.origin + t * ray.direction;
  vec3 tex = texAt(walk, t);
  uint structure = 0u;
#if LABELS == 1
  bool isSolid = false;
  if (hasSolids()) isSolid = solidAt(p, shareAt(p, sparedOnly)) > 0.49;
  structure = ownerAt(p, (sparedOnly ? sparedOf(classesAt(p)) : kShown) | (isSolid ? kSolid : 0)).id;
#endif
  if (hasFlag(kFlagSpares) && sparedOnly && !cutsKeep(p, structure)) return;
  vec3 gradient = gradientAt(tex);
  float len = length(gradient);
  vec3 normal = len > 0.0 ? -gradient / len : -ray.direction;
  if (dot(normal, ray.direction) > 0.0) normal = -normal;
#if LABELS == 1
  if (usesShares(sparedOnly)) {
    // Where what shows ends before the value does the surface is the border's.
    vec3 slope = shareSlopeAt(p, isSolid ? kOfSolids : kOfAll, sparedOnly, sparedOnly ? classesAt(p) : vec2(1.0));
    float onBorder = smoothstep(0.02, 0.12, length(slope)) * (isSolid ? 1.0 : smoothstep(0.7, 0.55, shareAt(p, sparedOnly)));
    float isAlike = isSolid ? 0.0 : smoothstep(0.3, 0.8, dot(normal, normalize(slope + 1e-9)));
    normal = normalize(mix(normal, normalize(slope + 1e-9), onBorder * (1.0 - isAlike)) + 1e-6);
  }
#endif
  if (isOnFace(face)) normal = faceNormalAt(face, p, ray.direction);
  EndFace end = EndFace(kCutFar, -1, false);
  if (hasFlag(kFlagSpareDepths) && sparedOnly) {
    end = endFaceAt(p, structure);
    bool isOnEnd = end.cut >= 0 && end.left * frame.voxelsPerLength < 0.25;
    vec3 endNormal = isOnEnd ? endNormalAt(end.cut, p) : normal;
    normal = dot(endNormal, ray.direction) < 0.0 ? endNormal : normal;
  }
  vec3 albedo = extinctionAt(iso) > 0.0 ? colorBetween(iso, iso) : vec3(0.9, 0.85, 0.78);
#if COLOR
  albedo = volumeColorAt(tex);
#endif
#if LABELS == 1
  if (isSolid) albedo = structureRow(structure).rgb;
  else albedo = tinted(albedo, p, isOnFace(face) || sparedOnly ? vec3(0.0) : normal, structure);
  if (hasFlag(kFlagOverlaps) && end.isShared) albedo = mix(albedo, kOverlapColor, kOverlapShare);
#endif
  vec3 color = shadeSurface(albedo, normal, -ray.direction, lightTexAt(p, normal, 1.0));
  float share = 1.0;
#ifdef MEMBRANES
  if (hasFlag(kFlagInlays)) share = inlayShare(p, structure);
#endif
  if (share > 0.0) addSample(hit, vec4(color, 1.0) * share, t, normal, structure, face.cut);
}

/// True when nothing further along the ray can show.
bool isDone(Hit hit) { return hit.color.a >= frame.opaqueAlpha; }

void finishRay(inout Hit hit, Ray ray, Walk walk) {}

/// Stops at the first crossing of the iso value, found by bisection of its segment, or at once on a cut's face inside.
/// Leaping, sampling and bisection have loops of their own: see march_volume.glsl.
void marchStretch(inout Hit hit, Ray ray, Walk walk, Span span) {
  const int kBlock = 8;
  float iso = frame.isoValue * float(kTransferSize - 1);
  float b = span.b;
  float t = span.a;
  addFaceData(hit, ray, t, span.face);
  float low = t;
  float high = t;
  float x = iso;
  bool crosses = false;
  bool enters = isOnFace(span.face) || (hasFlag(kFlagSpares) && span.sparedOnly);
  bool isEntry = false;
  do {
    // Go on to the next segment that crosses the value. The first sample after a leap is asked for in the loop, as a segment
    // without length: what is called in two places is compiled twice.
    do {
      // A place to enter by lies within the material, where cells without a crossing count as empty. What has been found is
      // found again when the turn is repeated.
      isEntry = crosses ? isEntry : enters && t == span.a;
      t = isEntry ? t : leapEmpty(walk, t, b, walk.dt, 1.0 / walk.dt, span.sparedOnly);
      bool isFirst = !crosses || isEntry;
      int n = 0;
      do {
        float next = nextSample(walk, t);
        next = isFirst ? t : min(next > t ? next : t + walk.dt, b);
        float value = shownValueAt(ray, walk, next, span.sparedOnly);
        x = !isFirst ? x : isEntry ? iso - 1.0 : value;
        crosses = (x < iso) != (value < iso);
        low = t;
        high = next;
        isEntry = isEntry && isFirst;
        isFirst = isFirst && crosses;
        x = crosses ? x : value;
        t = crosses ? t : next;
      } while (!crosses && t < b && ++n <= kBlock);
    } while (!crosses && t < b);
    t = high;
    // Find the place in it.
    for (int i = 0; i < 12; ++i) {
      float mid = 0.5 * (low + high);
      bool sameSide = (shownValueAt(ray, walk, mid, span.sparedOnly) < iso) == (x < iso);
      low = sameSide ? mid : low;
      high = sameSide ? high : mid;
    }
    // Of what is spared the side that is.
    float place = span.sparedOnly ? (x < iso ? high : low) : 0.5 * (low + high);
    Face face = isEntry ? span.face : kNoFace;
    if (crosses && !isDone(hit)) addSurface(hit, ray, walk, place, face, span.sparedOnly);
    crosses = false;
    enters = false;
  } while (!isDone(hit) && t < b);
}
