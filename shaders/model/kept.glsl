// What cuts leave of instances by where these stand.
#include "model/instances.glsl"

layout(binding = kCutUnit) uniform samplerBuffer cutTexture;
layout(binding = kTypeSpareUnit) uniform samplerBuffer typeSpareTexture;
layout(binding = kTypeUnit) uniform samplerBuffer typeTexture;

/// What a cut leaves of a type. As texels: software drivers read a storage block lane by lane, which took most of the time
/// of culling.
TypeSpareRow typeSpareOf(uint type, int cut) {
  int at = 2 * (int(type) * view.cutCount + cut);
  vec4 a = texelFetch(typeSpareTexture, at);
  vec4 b = texelFetch(typeSpareTexture, at + 1);
  return TypeSpareRow(a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w);
}

/// A cut, as texels likewise.
CutData cutAt(int i) {
  CutData cut;
  for (int k = 0; k < 4; ++k) cut.localFromScene[k] = texelFetch(cutTexture, kCutTexels * i + k);
  cut.halfSize = texelFetch(cutTexture, kCutTexels * i + 4);
  cut.kind = floatBitsToInt(texelFetch(cutTexture, kCutTexels * i + 5));
  cut.face = texelFetch(cutTexture, kCutTexels * i + 6);
  cut.sheet = floatBitsToInt(texelFetch(cutTexture, kCutTexels * i + 7));
  cut.inlay = texelFetch(cutTexture, kCutTexels * i + 8);
  return cut;
}

float reachFor(int cut, float radius) { return cut < 32 && (view.wholeInstances >> cut & 1u) != 0u ? radius : 0.0; }

/// What the cuts together leave: shaders/shared/cuts.h. @param number  numberOf() the instance
bool cutsLeave(uint number, uint type, vec3 p, float radius) {
  CutFold fold = emptyFold();
  float u = instanceRandom(number, 0u);
  for (int i = 0; i < view.cutCount; ++i) {
    float depth = typeSpareDepth(typeSpareOf(type, i), u);
    CutData cut = cutAt(i);
    fold = foldAnswer(fold, cutPart(cut), instanceAnswer(cut, depth, reachFor(i, radius), p));
  }
  return foldKeeps(fold);
}
