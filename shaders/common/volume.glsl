// Samples of the volume and of its labels.
#include "common/cuts.glsl"
#include "common/frame.glsl"
#include "shared/structure.h"

// PACKED: see common/packed.glsl.
#if PACKED != 0
layout(binding = kVolumeUnit) uniform usamplerBuffer volumeTexture;
#include "common/packed.glsl"
#else
layout(binding = kVolumeUnit) uniform sampler3D volumeTexture;
#endif
#if GRADIENTS
layout(binding = kGradientUnit) uniform sampler3D gradientTexture;  // xyz: direction, w: root of the magnitude
#endif
// Running sums of the transfer table in fixed point: differences of unsigned sums are exact, however long the sum.
layout(binding = kTransferUnit) uniform usamplerBuffer transferTexture;  // rgb: colour*sigma, a: sigma; then, in r, factors by gradient
layout(binding = kExtinctionUnit) uniform usamplerBuffer extinctionTexture;  // sigma alone: r up to the entry, g to the next
// By structure: StructureRow. A software driver fetches texels of eight rays at once, rows of a block ray by ray.
layout(binding = kStructureUnit) uniform samplerBuffer structureTexture;

#include "common/texels.glsl"

#include "common/labels.glsl"

vec4 structureRow(uint label) {
  return label < uint(frame.structureCount) ? texelFetch(structureTexture, 2 * int(label)) : vec4(0.6, 0.6, 0.6, 1.0);
}

/// How far a structure takes its own colour rather than the transfer function's.
vec4 structureLook(uint label) {
  return label < uint(frame.structureCount) ? texelFetch(structureTexture, 2 * int(label) + 1) : vec4(1.0, 0.0, float(LABELS == 2 ? kSetShown | kSetSolid : kSetShown), 0.0);
}

float structureTint(uint label) {
  if (label == 0u) return 0.0;
  return hasFlag(kFlagTints) ? frame.labelTint * structureLook(label).x : frame.labelTint;
}

/// A value as one end of a stretch of the transfer table.
struct TableEnd {
  int entry;
  uvec2 sums;  // of extinction, up to the entry and to the next
};

TableEnd tableEndAt(float x) {
  int entry = int(x);
  return TableEnd(entry, texelFetch(extinctionTexture, entry).rg);
}

/// Mean extinction, 1/length, of the material between two table positions: the value is taken to run evenly from one to the
/// other, so a thin peak of the transfer function is never stepped over (pre-integration by running sums).
float extinctionBetween(TableEnd a, TableEnd b) {
  uint sum = a.entry > b.entry ? a.sums.y - b.sums.x : b.sums.y - a.sums.x;
  return float(sum) * frame.extinctionUnit / float(abs(b.entry - a.entry) + 1);
}

/// The same of a single value.
float extinctionAt(float x) { return extinctionBetween(tableEndAt(x), tableEndAt(x)); }

/// Mean colour between two table positions, weighted by extinction.
vec3 colorBetween(float a, float b) {
  uvec4 sum = texelFetch(transferTexture, int(max(a, b)) + 1) - texelFetch(transferTexture, int(min(a, b)));
  return vec3(sum.rgb) / max(float(sum.a), 1.0);
}

float gradientFactor(vec3 gradient) {
  float x = clamp(length(gradient) * frame.gradientTableScale, 0.0, 1.0) * float(kTransferSize - 1);
  return uintBitsToFloat(texelFetch(transferTexture, kTransferSize + 1 + int(x)).r);
}

/// Who may own a place: anybody, or those that are in a set of each kind that is named.
const int kAnybody = 0;
const int kShown = kSetShown;                // structures that are not hidden
const int kSpared = kSetShown | kSetSpared;  // those of them that cuts spare
const int kSolid = kSetShown | kSetSolid;    // that are shown as surfaces

/// Whether some structures are shown as surfaces, and whether shares say what shows: some structures do not.
bool hasSolids() { return LABELS == 2 || (LABELS == 1 && (hasFlag(kFlagSolids) || hasFlag(kFlagVeils))); }
bool usesShares(bool sparedOnly) { return hasSolids() || (LABELS == 1 && ((hasFlag(kFlagSpares) && sparedOnly) || hasFlag(kFlagHides))); }

#if LABELS != 0
bool mayOwn(uint label, int who) {
  int sets = int(structureLook(label).z) & who;
  bool isSpared = (sets & kSetSpared) != 0 || (who & kSetSpared) == 0;
  bool isSolid = (sets & kSetSolid) != 0 || (who & kSetSolid) == 0;
  return (sets & kSetShown) != 0 && isSpared && isSolid || who == kAnybody;
}

/// kSpared, of classes that cuts leave alone. @param classes  of classesAt()
int sparedOf(vec2 classes) {
  if (!hasFlag(kFlagSpareClasses)) return kSpared;
  return kSetShown | (classes.x > 0.5 ? kSetSparedFirst : 0) | (classes.y > 0.5 ? kSetSparedSecond : 0);
}

/// Whose a place is: shared/structure.h. Where nobody who may owns any of it, or it is not worth while, the voxel's own
/// structure.
/// @param lean  towards where the votes are weighed, label voxels, within the eight of the place: on a surface outwards, or
///              what lies under a thin layer would show through it
Owner ownerAt(vec3 scenePoint, int who, bool isWorthWhile, vec3 lean) {
  if (hasFlag(kFlagOneSpared) && (who & kSetSpared) != 0) return Owner(uint(frame.spareClasses.z), 1.0);
  vec3 p = labelVoxelAt(scenePoint);
  ivec3 last = lastLabel();
  uint nearest = labelIn(p);
  vec3 q = clamp(p - 0.5, vec3(0.0), vec3(last));
  ivec3 base = ivec3(q);
  vec3 f = q - vec3(base);
  f = clamp(f + lean, min(f, vec3(0.02)), max(f, vec3(0.98)));
  if (isBeyondLabels(p)) return Owner(nearest, 1.0);
  Votes votes = noVotes();
  // Of a voxel that is wholly inside all eight are its own.
  int corners = coverIn(p) > 0.9999 && mayOwn(nearest, who) || !isWorthWhile ? 0 : 8;
  ivec3 shift = corners == 0 ? ivec3(0) : labelShift(base);
  for (int corner = 0; corner < corners; ++corner) {
    ivec3 step3 = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    ivec3 texel = min(base + step3, last) + shift;
    vec3 w = mix(1.0 - f, f, vec3(step3));
    uint label = texelFetch(labelTexture, texel, 0).r;
    float weight = w.x * w.y * w.z * texelFetch(coverTexture, texel, 0).r;
    if (mayOwn(label, who)) votes = addVote(votes, label, weight);
  }
  Owner owner = ownerOf(votes);
  if (owner.id == kNobody) owner = Owner(nearest, 1.0);
  return owner;
}

Owner ownerAt(vec3 scenePoint, int who) { return ownerAt(scenePoint, who, true, vec3(0.0)); }

/// Where the votes of a place on a surface are weighed. @param slope  shareSlopeAt() there
vec3 leanOutwards(vec3 slope) {
  vec3 way = mat3(frame.labelFromScene) * slope;
  float len = length(way);
  return len > 0.0 ? way * (0.2 * smoothstep(0.02, 0.12, length(slope)) / len) : vec3(0.0);
}

/// What part of a place shows: all that is not hidden, or of what is removed what cuts spare. Half of it is the border.
/// @param classes  of spared structures, those that all cuts together leave: 1 or 0
float shareOf(vec4 shares, bool sparedOnly, vec2 classes) {
  if (!hasFlag(kFlagSpareClasses)) return sparedOnly ? shares.r : shares.a;
  return sparedOnly ? min(dot(classes, shares.rg), 1.0) : shares.a;
}
float shareIn(vec3 p, bool sparedOnly, vec2 classes) {
  return shareOf(isBeyondLabels(p) ? frame.sharesBeyond : sharesIn(p), sparedOnly, classes);
}

/// Classes of spared structures that cuts leave in a place, however deep. Structures of a class are spared by the same cuts.
vec2 classesAt(vec3 scenePoint) {
  if (!hasFlag(kFlagSpareClasses)) return vec2(1.0, 0.0);
  bool isFirst = cutsKeepSpared(scenePoint, uint(frame.spareClasses.x));
  bool isSecond = cutsKeepSpared(scenePoint, uint(frame.spareClasses.y));
  return vec2(isFirst ? 1.0 : 0.0, isSecond ? 1.0 : 0.0);
}

float shareAt(vec3 scenePoint, bool sparedOnly) {
  return shareIn(labelVoxelAt(scenePoint), sparedOnly, sparedOnly ? classesAt(scenePoint) : vec2(1.0));
}

/// What shares are of: all that shows, what is opaque of it, what has a surface.
const int kOfAll = 0;
const int kOfSolids = 1;
const int kOfSurfaces = 2;

/// Shares of what is solid (x) and of all that has a surface, that one can look through, too (y), of what shows.
vec2 solidsOf(vec4 shares, float shown) {
  float surfaces = hasFlag(kFlagVeils) ? shares.b + shares.g : shares.b;
  return min(vec2(shares.b, surfaces), shown);
}

float shareOf(vec4 shares, int what, bool sparedOnly, vec2 classes) {
  float shown = shareOf(shares, sparedOnly, classes);
  if (!hasSolids() || what == kOfAll) return shown;
  vec2 solids = solidsOf(shares, shown);
  return what == kOfSolids ? solids.x : solids.y;
}

/// The way out of what shows, scene frame, about as long as the share falls over a voxel.
vec3 shareSlopeAt(vec3 scenePoint, int what, bool sparedOnly, vec2 classes) {
  vec3 p = labelVoxelAt(scenePoint);
  // Differences across a cube's corners, along all three axes at once. Most of it of means: a border that slants a little to
  // the voxels goes down in steps of theirs, as terraces, and these hardly show in means. The rest of what lies near: the
  // means alone would fill what is between two ribs. A software driver runs a loop as often as one of its rays wants it, and
  // once more.
  const float kOfMeans = 0.75;
  const float kReach = 1.0;
  vec3 rise = vec3(0.0);
  // Where the data ends that is solid its surface is the end's.
  vec3 toEnd = min(p, frame.labelSize.xyz - p);
  bool isAtEnd = min(toEnd.x, min(toEnd.y, toEnd.z)) < 0.3;
  int corners = isAtEnd || shareOf(sharesIn(p), what, sparedOnly, classes) < 0.98 ? 4 : 0;
  for (int i = 0; i < corners; ++i) {
    vec3 way = vec3((i & 1) == 0 ? 1.0 : -1.0, (i & 2) == 0 ? 1.0 : -1.0, i == 0 || i == 3 ? 1.0 : -1.0);
    float means = shareOf(coarseSharesIn(p + kReach * way, isAtEnd), what, sparedOnly, classes) - shareOf(coarseSharesIn(p - kReach * way, isAtEnd), what, sparedOnly, classes);
    float near = shareOf(sharesIn(p + 0.5 * way), what, sparedOnly, classes) - shareOf(sharesIn(p - 0.5 * way), what, sparedOnly, classes);
    rise += (0.125 / kReach * kOfMeans * means + 0.25 * (1.0 - kOfMeans) * near) * way;
  }
  vec3 out3 = -(transpose(mat3(frame.labelFromScene)) * rise);
  float len = length(out3);
  return len > 0.0 ? out3 * (length(rise) / len) : vec3(0.0);
}

/// Part of a stretch between two places that shows, by the shares there.
float shownPart(float a, float b) {
  float high = max(a, b);
  return clamp((high - 0.5) / max(high - min(a, b), 1e-6), 0.0, 1.0);
}

/// How far a way has come through a surface whose share is interpolated: 0 before it, 1 behind it.
float surfacePassed(float share) { return clamp(5.0 * (share - 0.5), 0.0, 1.0); }
/// How much of a surface lies between two places: its opacity is the same however obliquely and finely it is passed.
float surfaceBetween(float a, float b) { return abs(surfacePassed(a) - surfacePassed(b)); }

/// Extinction within what is solid, which is seen where something takes its surface away.
float solidExtinction() { return 6.0 * frame.voxelsPerLength; }
const float kSurfaceDepth = 8.0;  // of an opaque surface

/// Optical depth of a stretch of structures with surfaces. @param a, b  of solidsOf() at its ends, of what part is inside
/// @param opacity  of the surface
float solidDepth(vec2 a, vec2 b, float span, float opacity) {
  float inside = shownPart(a.x, b.x);
  float veil = -log(max(1.0 - opacity, 1e-4));
  if (opacity < 0.995 && hasFlag(kFlagVeils)) return veil * surfaceBetween(a.y, b.y);
  // What fades by its thickness is as thick as it is.
  if (hasFlag(kFlagInlays)) return kSurfaceDepth * surfaceBetween(a.x, b.x) + inside * span * solidExtinction();
  return inside > 0.0 ? kSurfaceDepth : 0.0;
}
#endif

#if LABELS == 1
float rawTexelFrom(vec3 scenePoint) { return rawTexelAt((frame.texFromScene * vec4(scenePoint, 1.0)).xyz); }

/// The middle of the label voxel around a place.
vec3 labelMiddleAt(vec3 scenePoint) {
  vec3 voxel = labelVoxelAt(scenePoint);
  return scenePoint + inverse(mat3(frame.labelFromScene)) * (floor(voxel) + 0.5 - voxel);
}

/// The colour of material, by its structure. A surface may lie a little before the label of what it bounds, where it is
/// chance whose a voxel is: who is behind it lends his colour where the voxel's own value lies between what is before it
/// and what is behind it, on the slope from one to the other. On a thin vessel or a thin skin it is the top.
/// @param outwards  from the surface, not longer than 1; shorter where there hardly is one, 0 on the face of a cut
vec3 tinted(vec3 albedo, vec3 scenePoint, vec3 outwards, uint structure) {
  vec3 across = outwards * (1.2 / frame.voxelsPerLength);
  float least = structure == 0u ? 0.5 : 1.0;
  uint inner = labelAt(scenePoint - least * across);
  if (inner == structure) inner = labelAt(scenePoint - (least + 0.5) * across);
  if (inner != structure && inner != 0u && structureRow(inner).a > 0.0) {
    float before = rawTexelFrom(scenePoint + across);
    float a = rawTexelFrom(scenePoint - 0.5 * across), b = rawTexelFrom(scenePoint - across);
    float top = abs(a - before) > abs(b - before) ? a : b;
    float down = (top - rawTexelFrom(labelMiddleAt(scenePoint))) / (top - before);
    // What has nothing before it is itself what the slope leads to, unless most of the voxel is air.
    bool isOuter = structure != 0u && labelAt(scenePoint + across) == 0u;
    if (down > (isOuter ? 0.5 : 0.25) && down < 1.25) structure = inner;
  }
  return mix(albedo, structureRow(structure).rgb, structureTint(structure));
}
#endif

/// Gradient of the data value per, scene frame: differences over two voxels of values that are smoothed across by 1 2 1.
/// Looked up in a texture of them, where there is room for one (`GradientPlanes`, which smooth them further); else on demand.
/// @param stored  of gradientStoredAt()
vec3 gradientIn(Stored stored, vec3 tex) {
#if GRADIENTS
  vec4 texel = textureLod(gradientTexture, inTexture(stored), 0.0);
  vec3 g = (texel.xyz - 128.0 / 255.0) * (texel.w * texel.w * frame.gradientUnit);
#else
  vec3 h = 1.0 / frame.volumeSize.xyz;
  vec3 g = vec3(0.0);
  for (int i = 0; i < 27; ++i) {
    vec3 at = vec3(i % 3, i / 3 % 3, i / 9) - 1.0;
    vec3 across = 0.5 - 0.25 * abs(at);
    g += texelAt(tex + at * h) * at * vec3(across.y * across.z, across.x * across.z, across.x * across.y);
  }
#endif
  return vec3(dot(frame.normalX.xyz, g), dot(frame.normalY.xyz, g), dot(frame.normalZ.xyz, g));
}
vec3 gradientAt(vec3 tex) { return gradientIn(gradientStoredAt(tex), tex); }
