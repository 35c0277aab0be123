// Rays and positions against all cuts of the scene.
#include "shared/cut.h"
#include "common/frame.glsl"

layout(std430, binding = kCutBinding) readonly buffer CutBlock { CutData cuts[]; };
// Bit i % 32 of word i / 32 of a structure's mask: cut i spares it. kCutBinding's order; frame.counts.y words a structure.
layout(std430, binding = kExemptBinding) readonly buffer ExemptBlock { uint exemptMask[]; };

bool isExempt(uint structure, int cut) {
  if (!hasFlag(kFlagExemptions) || structure >= uint(frame.counts.z)) return false;
  uint word = exemptMask[structure * uint(frame.counts.y) + uint(cut >> 5)];
  return (word >> uint(cut & 31) & 1u) != 0u;
}

/// True when no cut removes a position of a structure.
bool cutsKeep(vec3 scenePoint, uint structure) {
  for (int i = 0; i < frame.counts.x; ++i)
    if (cutDistance(cuts[i], scenePoint) < 0.0 && !isExempt(structure, i)) return false;
  return true;
}

/// The unit normal of a cut's face, out of the material.
vec3 cutNormal(int cut, vec3 p) {
  float e = 0.01 * frame.step.x;
  vec3 gradient = vec3(cutDistance(cuts[cut], p + vec3(e, 0, 0)) - cutDistance(cuts[cut], p - vec3(e, 0, 0)),
                       cutDistance(cuts[cut], p + vec3(0, e, 0)) - cutDistance(cuts[cut], p - vec3(0, e, 0)),
                       cutDistance(cuts[cut], p + vec3(0, 0, e)) - cutDistance(cuts[cut], p - vec3(0, 0, e)));
  float len = length(gradient);
  return len > 0.0 ? -gradient / len : vec3(0.0, 0.0, 1.0);
}

/// A stretch of a ray: all of it kept, or all of it removed by at least one cut.
struct Stretch {
  float end;    // where it ends, along the ray
  bool kept;
  int face;     // kept stretches: the cut whose face it starts on; -1 when it starts elsewhere
};

/// The stretch that begins at t. A ray is walked stretch by stretch; each costs one look at every cut.
Stretch stretchFrom(Ray ray, float t, float tEnd, int previousRemover) {
  Stretch stretch = Stretch(tEnd, true, previousRemover);
  float removedTo = t;
  float e = 1e-5 * max(1.0, abs(t));
  for (int i = 0; i < frame.counts.x; ++i) {
    vec2 inside = cutInterval(cuts[i], ray.origin, ray.direction);
    bool hit = inside.x < inside.y;
    bool removesInside = cuts[i].half_.w > 0.0;
    // Where this cut's removed part that holds t ends, or, when t is kept, where its next one begins.
    float end = t;
    float next = kFar;
    if (removesInside) {
      if (hit && t >= inside.x - e && t < inside.y - e) end = inside.y;
      else if (hit && t < inside.x) next = inside.x;
    } else if (!hit) {
      end = kFar;
    } else {
      if (t < inside.x - e) end = inside.x;
      else if (t >= inside.y - e) end = kFar;
      else next = inside.y;
    }
    if (end > removedTo) {
      removedTo = end;
      stretch.face = i;
      stretch.kept = false;
    }
    if (stretch.kept) stretch.end = min(stretch.end, next);
  }
  if (!stretch.kept) stretch.end = min(removedTo, tEnd);
  return stretch;
}
