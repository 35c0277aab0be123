// What a ray has met so far, and the face that a stretch of it begins on.
#include "common/cuts.glsl"

struct Hit {
  vec4 color;      // premultiplied
  float distance;  // kFar: nothing
  vec3 normal;
  uint structure;
  float solid;     // opacity of a voxel of it: what is hit in a haze is no surface
  int face;        // the cut on whose face that is; -1: none
  float faceT;     // where the ray has met that face
};

/// A face that a stretch begins on.
struct Face {
  int cut;       // -1: none
  int triangle;  // of a membrane; -1: the plane around it
};

const Face kNoFace = Face(-1, -1);

bool isOnFace(Face face) { return hasFlag(kFlagCuts) && face.cut >= 0; }

bool showsData(Face face) { return hasFlag(kFlagFaces) && cuts[face.cut].kind.y == 1; }

vec3 faceNormalAt(Face face, vec3 p, vec3 direction) {
#ifdef MEMBRANES
  if (cuts[face.cut].kind.x == kCutMembrane) return sheetNormalAt(face.cut, face.triangle, p, direction);
#endif
  return shapeNormal(face.cut, p);
}

/// A stretch of a ray to march: a < b, all of it kept, or, where only what cuts spare is to be shown, all of it removed.
struct Span {
  float a;
  float b;
  Face face;  // that it begins on
  bool sparedOnly;
};
