// Compositing front to back, for marches that see what lies behind.
#include "render/hit.glsl"
#include "render/walk.glsl"

#if MODE != 1

/// Puts a sample behind what there is.
/// @param solid  opacity of a voxel of it
/// @param face  the cut on whose face it is, or -1
/// @param faceT  where the ray has met the face
void addSample(inout Hit hit, vec4 premultiplied, float t, vec3 normal, uint structure, float solid, int face, float faceT) {
  float left = 1.0 - hit.color.a;
  // The layers (position, normal, id) are those of the sample that makes the ray half opaque, or of the first one.
  bool isHalfOpaque = hit.color.a < 0.5 && hit.color.a + left * premultiplied.a >= 0.5;
  if (hit.distance == kFar || isHalfOpaque) {
    hit.distance = t;
    hit.normal = normal;
    hit.structure = structure;
    hit.solid = solid;
    hit.face = face;
    hit.faceT = faceT;
  }
  hit.color += left * premultiplied;
}
void addSample(inout Hit hit, vec4 premultiplied, float t, vec3 normal, uint structure, int face) {
  addSample(hit, premultiplied, t, normal, structure, 1.0, face, t);
}

/// An image, of an inlay or on a face.
void addImage(inout Hit hit, float t, vec3 color, float alpha, vec3 normal, uint structure, int face) {
  if (alpha > 0.0) addSample(hit, vec4(color, 1.0) * alpha, t, normal, structure, face);
}

/// The sheet of a membrane.
void addSheet(inout Hit hit, float t, vec3 color, float alpha, vec3 normal) {
  if (alpha > 0.0) addSample(hit, vec4(color, 1.0) * alpha, t, normal, 0u, -1);
}

#endif
