// What cuts leave of instances by where these stand.
#include "mesoscale/instances.glsl"

layout(std430, binding = kCutBinding) readonly buffer CutBlock { CutData cuts[]; };
layout(std430, binding = kTypeSpareBinding) readonly buffer TypeSpareBlock { TypeSpareRow typeSpares[]; };
layout(binding = kTypeUnit) uniform samplerBuffer typeTexture;

float reachFor(int cut, float radius) { return cut < 32 && (view.wholeInstances >> cut & 1u) != 0u ? radius : 0.0; }

/// What the cuts together leave: shaders/shared/cuts.h.
bool cutsLeave(uint instance, uint type, vec3 p, float radius) {
  CutFold fold = emptyFold();
  float u = instanceRandom(instance, 0u);
  for (int i = 0; i < view.cutCount; ++i) {
    float depth = typeSpareDepth(typeSpares[int(type) * view.cutCount + i], u);
    fold = foldAnswer(fold, cutPart(cuts[i]), instanceAnswer(cuts[i], depth, reachFor(i, radius), p));
  }
  return foldKeeps(fold);
}
