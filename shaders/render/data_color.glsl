// How the data itself looks where it is shown as on a section: on a cut's face and on the image of an inlay.
#include "common/volume.glsl"
#include "render/hit.glsl"
#include "render/walk.glsl"

float greyAt(float table) { return clamp(table / float(kTransferSize - 1) * frame.greyScale + frame.greyOffset, 0.0, 1.0); }

/// @param who  of ownerAt()
uint structureAt(vec3 p, int who) {
#if LABELS != 0
  return ownerAt(p, who).id;
#else
  return 0u;
#endif
}

/// Grey values by the window, or colours, tinted by structures. a: 1 wherever there is data, whatever its value; beside
/// labels that stand alone there is none.
vec4 dataColor(vec3 p, uint structure) {
  vec3 tex = texFrom(p);
#if COLOR
  vec4 color = vec4(volumeColorAt(tex) * (COLOR == 2 ? texelAt(tex) : 1.0), 1.0);
#elif LABELS == 2
  vec4 color = vec4(0.0);
#else
  vec4 color = vec4(vec3(greyAt(tableAt(tex))), 1.0);
#endif
#if LABELS != 0
  vec4 row = structureRow(structure);
  if (structure != 0u && row.a > 0.0) color = vec4(mix(color.rgb, row.rgb * (0.35 + 0.65 * color.rgb), 0.6 * structureTint(structure)), 1.0);
#endif
  return color;
}

/// An image in a place on the ray, on the face of a cut, over everything behind it: each mode has its own.
void addImage(inout Hit hit, float t, vec3 color, float alpha, vec3 normal, uint structure, int face);

/// The data on a cut's face that shows it: all of the face that lies within the data.
void addFaceData(inout Hit hit, Ray ray, float t, Face face) {
  if (!isOnFace(face) || !showsData(face)) return;
  vec3 p = ray.origin + t * ray.direction;
  uint structure = structureAt(p, kAnybody);
  vec4 color = dataColor(p, structure);
  addImage(hit, t, color.rgb, color.a * cuts[face.cut].face.x, faceNormalAt(face, p, ray.direction), structure, face.cut);
}
