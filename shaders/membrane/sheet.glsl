// What the programs that index a sheet have in common.
#define MEMBRANES 1
#define WRITES_SHEET 1
#include "shared/sheet.h"

layout(std430, binding = kSheetCountsBinding) buffer CountBlock { uint counts[]; };

layout(location = 0) uniform ivec4 particles;  // x, y: along the rest plane's width and height; z: room in the lists
layout(location = 1) uniform vec4 halfSize;    // half edges of the rest plane's box

SheetPlan thePlan() { return SheetPlan(ivec4(0, particles.xy, 0), halfSize.xyz, 1.0); }

/// The particle, or the lower left one of a mesh, that this invocation works on; -1: none.
int theParticle(bool isMesh) {
  int v = int(gl_GlobalInvocationID.x);
  if (v >= particles.x * particles.y) return -1;
  return isMesh && (v % particles.x == particles.x - 1 || v >= particles.x * (particles.y - 1)) ? -1 : v;
}

/// Two corners of the box around a mesh.
struct MeshBox {
  vec3 low;
  vec3 high;
};

MeshBox boxOf(int v) {
  vec3 a = sheetRows[v].xyz;
  vec3 b = sheetRows[v + 1].xyz;
  vec3 c = sheetRows[v + particles.x].xyz;
  vec3 d = sheetRows[v + particles.x + 1].xyz;
  return MeshBox(min(min(a, b), min(c, d)), max(max(a, b), max(c, d)));
}
